// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/angle_between.hpp"
#include "detent/math/quat.hpp"

// Rotations between two rotations.

namespace detent {

/// The rotation on the way from `p` to `q`, by the chord between them: fastest in the middle.
///
/// domain: t below 0 counts as 0 and t above 1 as 1
/// result: the shorter way: where dot(p, q) is negative, the way to -q; `p` at 0 and `q` or `-q` at
///         1, as stored
/// exact:  each component that of the unit quaternion along (1 - t) p + t q, rounded to nearest
///        (tests/math/slerp.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr Quat<S> nlerp(const Quat<S>& p, const Quat<S>& q, S t) noexcept {
  const Quat<S> end = dot(p, q) < 0 ? -q : q;
  if (t <= 0) return p;
  if (t >= 1) return end;
  return Quat<S>::along(p.vec() + (end.vec() - p.vec()) * t).value_or(p);
}

/// The rotation on the way from `p` to `q`, at constant speed: at t of the angle between them.
///
/// domain: t below 0 counts as 0 and t above 1 as 1
/// result: as for `nlerp`, and where there is no angle that of `nlerp`
/// exact:  components off by less than 0.5 + 2^-26 of their units      (tests/math/slerp.test.cpp)
/// source: Shoemake, Animating Rotation with Quaternion Curves (1985)
template <Scalar S>
[[nodiscard]] constexpr Quat<S> slerp(const Quat<S>& p, const Quat<S>& q, S t) noexcept {
  const Quat<S> end = dot(p, q) < 0 ? -q : q;
  if (t <= 0) return p;
  if (t >= 1) return end;
  // sin((1 - t) a) p / |p| + sin(t a) q / |q|, times |p| |q|.
  using Ratio = typename detail::Precise<S>::Ratio;
  const auto area = detail::squared_area<2 * detail::cosine_bits<S>>(p.vec(), end.vec());
  const auto weights = arc_weights(area, dot(p, end), t);
  const auto of_p = nearest_to<Ratio>(weights.start * sqrt_floor<Ratio>(squared_length(end)));
  const auto of_end = nearest_to<Ratio>(weights.end * sqrt_floor<Ratio>(squared_length(p)));
  return Quat<S>::along(p.vec() * of_p + end.vec() * of_end).value_or(nlerp(p, q, t));
}

}  // namespace detent
