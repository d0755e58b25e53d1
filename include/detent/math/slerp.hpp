// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/angle_between.hpp"
#include "detent/math/quat.hpp"

// Interpolation between two rotations.

namespace detent {

/// The rotation between `p` and `q` at t, along the chord between them: fastest in the middle.
///
/// domain: t is clamped to [0, 1]
/// result: on the shorter way: if dot(p, q) is negative, towards -q; `p` at 0 and `q` or `-q` at 1,
///         as stored
/// exact:  each component of the unit quaternion along (1 - t) p + t q, rounded to nearest
///         (tests/math/slerp.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr Quat<S> nlerp(const Quat<S>& p, const Quat<S>& q, S t) noexcept {
  const Quat<S> end = dot(p, q) < 0 ? -q : q;
  if (t <= 0) return p;
  if (t >= 1) return end;
  return Quat<S>::along(p.vec() + (end.vec() - p.vec()) * t).value_or(p);
}

/// The rotation between `p` and `q` at constant speed: at t of the angle between them.
///
/// domain: t is clamped to [0, 1]
/// result: as for `nlerp`; if the angle is 0, the result of `nlerp`
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
