// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/number/angle.hpp"

namespace detent {

namespace detail {

/// The binary angle in (-1/2, 1/2] turn, as an integer that does not wrap.
template <int B, int F>
[[nodiscard]] constexpr std::int64_t signed_angle(Angle<Fixed<B, F>> angle) noexcept {
  constexpr auto half_turn = std::int64_t{1} << 31;
  const std::int64_t raw = angle.raw();
  return raw > half_turn ? raw - 2 * half_turn : raw;
}

}  // namespace detail

/// angle + step, at least `low` and at most `high`. All four are taken in (-1/2, 1/2] turn and the
/// sum does not wrap, so a large step ends at a limit. If low > high, the result is `low`.
///
/// exact: always                                                   (tests/number/angle_range.test.cpp)
template <int B, int F>
[[nodiscard]] constexpr Angle<Fixed<B, F>> sum_within(Angle<Fixed<B, F>> angle,
                                                      Angle<Fixed<B, F>> step,
                                                      Angle<Fixed<B, F>> low,
                                                      Angle<Fixed<B, F>> high) noexcept {
  const auto sum = detail::signed_angle(angle) + detail::signed_angle(step);
  const auto below = (std::min)(sum, detail::signed_angle(high));
  const auto within = (std::max)(below, detail::signed_angle(low));
  return Angle<Fixed<B, F>>::from_raw(static_cast<std::uint32_t>(within));
}

#if __STDC_HOSTED__
template <std::floating_point F>
[[nodiscard]] constexpr Angle<F> sum_within(Angle<F> angle, Angle<F> step, Angle<F> low,
                                            Angle<F> high) noexcept {
  const F sum = angle.raw() + step.raw();
  return Angle<F>::from_raw((std::max)((std::min)(sum, high.raw()), low.raw()));
}
#endif

}  // namespace detent
