// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/math/projection.hpp"

namespace detent {

namespace detail {

template <Scalar S>
struct slope_of {
  using type = S;
};
template <int Bits, int Frac>
struct slope_of<Fixed<Bits, Frac>> {
  using type = Fixed<31, 28>;
};

}  // namespace detail

/// The view volume in the camera's own frame, looking along -z: the depths from near to far, and
/// half the width and height of the image at each depth.
///
/// At depth d these are slope(i) * d + extent(i), with i = 0 for the width and 1 for the height. A
/// perspective lens has slopes, the tangents of half its angles of view, and no extents; an
/// orthographic one has extents and no slopes. A lens is exactly these numbers, and everything
/// computed from it is exact for them.
template <Scalar S>
class Lens {
 public:
  /// Q3.28 for every `Fixed`, otherwise the scalar itself.
  using Slope = typename detail::slope_of<S>::type;

  /// The lens with a field of view of `fov` from top to bottom; `aspect` is the width of the image
  /// over its height.
  ///
  /// domain: nothing unless `fov` is in (0, 1/2) turn, aspect > 0,
  ///         0 < near_distance < far_distance, and both slopes are at most the greatest `Slope`, just
  ///         below 8, before they are rounded (a field of view below 165.7 degrees), and above 0 after
  /// exact:  slope(1) is tan(fov / 2) rounded to nearest, for every `fov`; slope(0) is
  ///         aspect * slope(1) rounded to nearest, ties to even       (tests/math/lens.test.cpp)
  [[nodiscard]] static constexpr std::optional<Lens> perspective(Angle<S> fov, S aspect,
                                                                 S near_distance,
                                                                 S far_distance) noexcept {
    const auto [sine, cosine] = half_tangent(fov);
    const bool sees = sine > 0 && cosine > 0 && aspect > 0;
    if (!sees || !(near_distance > 0 && near_distance < far_distance)) return std::nullopt;
    if (sine > cosine * largest<Slope>) return std::nullopt;
    const auto high = quotient_nearest<Slope>(sine, cosine);
    const auto wide = aspect * high;
    if (wide > largest<Slope>) return std::nullopt;
    Lens lens(near_distance, far_distance);
    lens.slopes_ = {nearest_to<Slope>(wide), high};
    if (!(lens.slopes_.x > 0 && lens.slopes_.y > 0)) return std::nullopt;
    return lens;
  }

  /// The orthographic lens, which sees a box: from -half_width to half_width, from -half_height to
  /// half_height, and from near to far.
  ///
  /// domain: nothing unless half_width > 0, half_height > 0 and near_distance < far_distance
  [[nodiscard]] static constexpr std::optional<Lens> orthographic(S half_width, S half_height,
                                                                  S near_distance,
                                                                  S far_distance) noexcept {
    const bool sees = half_width > 0 && half_height > 0;
    if (!sees || !(near_distance < far_distance)) return std::nullopt;
    Lens lens(near_distance, far_distance);
    lens.extents_ = {half_width, half_height};
    return lens;
  }

  [[nodiscard]] constexpr bool has_perspective() const noexcept { return slopes_.x > 0; }
  [[nodiscard]] constexpr const Slope& slope(int i) const noexcept { return slopes_[i]; }
  [[nodiscard]] constexpr const S& extent(int i) const noexcept { return extents_[i]; }
  [[nodiscard]] constexpr const S& near_distance() const noexcept { return near_distance_; }
  [[nodiscard]] constexpr const S& far_distance() const noexcept { return far_distance_; }

  [[nodiscard]] friend constexpr bool operator==(const Lens&, const Lens&) noexcept = default;

 private:
  constexpr Lens(const S& near_distance, const S& far_distance) noexcept
      : near_distance_(near_distance), far_distance_(far_distance) {}

  Vec<Slope, 2> slopes_{};
  Vec<S, 2> extents_{};
  S near_distance_;
  S far_distance_;
};

/// Appends to a digest: slopes, extents, near and far.
template <class D, Scalar S>
constexpr void append(D& digest, const Lens<S>& lens) noexcept {
  digest.add(lens.slope(0), lens.slope(1), lens.extent(0), lens.extent(1), lens.near_distance(),
             lens.far_distance());
}

/// The matrix of a lens, for a renderer: the camera's frame to x and y in [-1, 1] and a depth in
/// [0, 1]. Component types as for `perspective`.
///
/// exact: components rounded to nearest, ties to even, and clamped (tests/math/lens.test.cpp)
template <class To = void, Scalar S>
[[nodiscard]] constexpr auto projection_matrix(const Lens<S>& lens) noexcept {
  using T = detail::to_or_own<To, S>;
  const auto &near_distance = lens.near_distance(), &far_distance = lens.far_distance();
  const auto back = near_distance - far_distance;
  const bool narrows = lens.has_perspective();
  Mat<T, 4, 4> m;
  for (int i = 0; i < 2; ++i) {
    m(i, i) = narrows ? quotient_nearest<T>(S(1), lens.slope(i))
                      : quotient_nearest<T>(S(1), lens.extent(i));
  }
  m(2, 2) = narrows ? quotient_nearest<T>(far_distance, back) : quotient_nearest<T>(S(1), back);
  m(2, 3) = narrows ? quotient_nearest<T>(near_distance * far_distance, back)
                    : quotient_nearest<T>(near_distance, back);
  m(3, narrows ? 2 : 3) = narrows ? T(-1) : T(1);
  return m;
}

}  // namespace detent
