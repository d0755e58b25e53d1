// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sample.hpp"

namespace samples {

/// Pixels as red, green and blue, in rows from top to bottom.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;

  Image(int wide, int high);
  void place(const Image& part, int x, int y);
  /// Encodes the picture as PNG.
  [[nodiscard]] std::string png() const;
};

/// Draws a sample as the page shows it.
Image painted(const Picture& picture, const View& view, int width, int height);

}  // namespace samples
