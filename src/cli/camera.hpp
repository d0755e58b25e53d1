// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <type_traits>

#include "detent/detent.hpp"
#include "view.hpp"

namespace detent::cli {

/// The largest width + height of an image: the camera counts half pixels in 15 bits.
inline constexpr int largest_image = 1 << 14;

/// A vector in doubles, which represent the numbers of every scalar.
template <class T>
[[nodiscard]] Double3 in_double(const Vec<T, 3>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// A pinhole camera that computes its rays in its scalar's own arithmetic: sums and products are
/// exact for a `Fixed`, and the resulting direction is rounded once.
template <Scalar S>
class Camera {
 public:
  /// `half_view` is the angle between the middle and the upper edge of the image.
  Camera(const Vec<S, 3>& position, const Direction<S, 3>& forward, const Direction<S, 3>& right,
         const Angle<S>& half_view)
      : position_(position),
        ahead_(forward.vec() * cos<Component>(half_view)),
        right_(right.vec() * sin<Component>(half_view)),
        up_(upward(forward, right).vec() * sin<Component>(half_view)) {}

  /// The ray through the middle of a pixel, counted from the top left.
  [[nodiscard]] Ray<S, 3> ray(int x, int y, int width, int height) const {
    // In half pixels, scaled by 2 as long as they fit 14 bits: the direction stays the same.
    const int shift = 14 - static_cast<int>(std::bit_width(static_cast<unsigned>(width + height)));
    const auto half_pixels = [&](int count) { return Whole(count << shift); };
    const auto toward = ahead_ * half_pixels(height) + right_ * half_pixels(2 * x + 1 - width) +
                        up_ * half_pixels(height - 1 - 2 * y);
    return {position_, direction_of<S>(toward).value_or(Direction<S, 3>())};
  }

  [[nodiscard]] View view() const {
    return {in_double(position_), in_double(ahead_), in_double(right_), in_double(up_)};
  }

 private:
  using Component = direction_component<S>;
  using Whole = std::conditional_t<is_fixed<S>, Fixed<15, 0>, S>;
  using Scaled = Vec<decltype(Component() * Component()), 3>;

  static Direction<S, 3> upward(const Direction<S, 3>& forward, const Direction<S, 3>& right) {
    return direction_of<S>(cross(right.vec(), forward.vec())).value_or(forward);
  }

  Vec<S, 3> position_;
  Scaled ahead_;
  Scaled right_;
  Scaled up_;
};

}  // namespace detent::cli
