// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace detent::cli {

/// A vector in doubles, for pictures.
using Double3 = std::array<double, 3>;

[[nodiscard]] inline Double3 minus(const Double3& a, const Double3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

[[nodiscard]] inline double inner(const Double3& a, const Double3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

[[nodiscard]] inline Double3 outer(const Double3& a, const Double3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A camera, to draw over a picture. The point at x, y and depth is position + depth
/// (ahead + x right + y up), with y from -1 to 1, and x too in a square picture.
struct View {
  Double3 position, ahead, right, up;

  /// Depth, right and up of a point, in lengths of `ahead`, `right` and `up`, which are orthogonal.
  [[nodiscard]] Double3 seen(const Double3& point) const {
    const Double3 offset = minus(point, position);
    const auto along = [&](const Double3& axis) { return inner(offset, axis) / inner(axis, axis); };
    return {along(ahead), along(right), along(up)};
  }
};

}  // namespace detent::cli
