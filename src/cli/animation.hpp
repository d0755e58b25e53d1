// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "image.hpp"

namespace detent::cli {

/// An animated PNG that repeats: browsers play it, other programs show its first picture.
///
/// source: PNG specification, third edition, 11.3.2.7 (acTL, fcTL, fdAT)
class Animation {
 public:
  /// Each picture is shown for `numerator / denominator` seconds.
  Animation(int numerator, int denominator) : numerator_(numerator), denominator_(denominator) {}

  /// Adds a picture, which must have the size of the first one.
  void add(const Image& picture);

  /// The bytes of the file; there must be a picture.
  [[nodiscard]] std::string png() const;

 private:
  int numerator_, denominator_;
  int count_ = 0, sequence_ = 0;
  std::optional<Image> last_;
  std::string header_, frames_;
};

}  // namespace detent::cli
