// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <type_traits>

#include "detent/number/rounding.hpp"

namespace detent {

/// The size of an image in pixels. Columns count from the left, rows from the top; all four numbers
/// are clamped to less than 2^24.
struct Viewport {
  std::int32_t width;
  std::int32_t height;

  [[nodiscard]] friend constexpr bool operator==(const Viewport&,
                                                 const Viewport&) noexcept = default;
};

namespace detail {

/// Pixel counts have 24 bits, so that the directions of rays fit their integers.
template <Scalar S>
using PixelCount = std::conditional_t<is_fixed<S>, Fixed<24, 0>, S>;
template <Scalar S>
[[nodiscard]] constexpr PixelCount<S> pixel_count(std::int32_t n) noexcept {
  if constexpr (is_fixed<S>) {
    return saturate_to<PixelCount<S>>(n);
  } else {
    return as_operand<S>(n);
  }
}

/// The number 1 in the shortest type.
template <Scalar S>
inline constexpr auto one = std::conditional_t<is_fixed<S>, Fixed<1, 0>, S>(1);

/// The screen coordinates (x / unit, y / unit), with unit > 0.
template <Number X, Number Unit>
struct OnScreen {
  X x, y;
  Unit unit;
};
template <Number X, Number Unit>
OnScreen(X, X, Unit) -> OnScreen<X, Unit>;

/// The middle of a pixel, or of the image if it has no pixels.
template <Scalar S>
[[nodiscard]] constexpr auto on_screen(const Viewport& viewport, std::int32_t column,
                                       std::int32_t row) noexcept {
  const auto width = pixel_count<S>(viewport.width), height = pixel_count<S>(viewport.height);
  const auto left = pixel_count<S>(column), top = pixel_count<S>(row);
  const auto x = (left + left + one<S> - width) * height;
  const auto y = (height - one<S> - (top + top)) * width;
  using Result = OnScreen<decltype(x + y), decltype(width * height)>;
  if (!(width > 0 && height > 0)) return Result{{}, {}, one<S> * one<S>};
  constexpr int bits = bits_of<decltype(x + y)>;
  return Result{narrow_sum<bits>(x, decltype(y)()), narrow_sum<bits>(y, decltype(x)()),
                width * height};
}

}  // namespace detail

}  // namespace detent
