// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene.hpp"

namespace detent::cli {

/// Rows from top to bottom.
class Image {
 public:
  Image(int width, int height, Colour background = {})
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  [[nodiscard]] Colour& at(int x, int y) {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }
  [[nodiscard]] const Colour& at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }

  /// Copies `part` so that its top left corner is at (x, y).
  void place(const Image& part, int x, int y);

  /// Fills the part of the rectangle that is inside the image.
  void fill(int x, int y, int width, int height, Colour colour);

  /// Writes a line of ASCII with its top left corner at (x, y); 14 pixels high.
  void write(int x, int y, const std::string& text, Colour colour);

  /// The bytes of a PNG file.
  [[nodiscard]] std::string png() const;

 private:
  int width_;
  int height_;
  std::vector<Colour> pixels_;
};

}  // namespace detent::cli
