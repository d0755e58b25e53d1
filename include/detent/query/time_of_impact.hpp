// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/math/sweep.hpp"
#include "detent/query/kernel/argument.hpp"
#include "detent/query/kernel/core.hpp"
#include "detent/query/kernel/posed.hpp"
#include "detent/query/time_of_impact/impact.hpp"
#include "detent/query/time_of_impact/plane.hpp"
#include "detent/query/time_of_impact/search.hpp"
#include "detent/query/wrong_call.hpp"

namespace detent {

namespace detail {

template <class T>
inline constexpr bool has_corners = IsShape<T>&& requires(const T& shape) {
  local_corners(core_of(shape));
};
template <class A, class B>
concept HaveImpact = has_corners<A> && has_corners<B> && !MixedArguments<A, B>;

/// The default distance at which bodies count as touching: 8 units, more than rounding adds for
/// bodies of ordinary size.
template <Scalar S>
[[nodiscard]] constexpr S touching_distance() noexcept {
  if constexpr (is_fixed<S>) {
    return S::from_raw(8);
  } else {
    return S(1) / 8192;
  }
}

/// `time_of_impact` of shapes that have points, with the number of its steps.
template <class A, class B, Scalar S, int N>
[[nodiscard]] constexpr auto search_impact(const A& a, const Sweep<S, N>& sweep_a, const B& b,
                                           const Sweep<S, N>& sweep_b, const S& target) noexcept {
  const Swept swept_a(local_corners(core_of(a)), sweep_a);
  const Swept swept_b(local_corners(core_of(b)), sweep_b);
  return ImpactSearch(swept_a, swept_b, radius_of(a) + radius_of(b)).first(target);
}

}  // namespace detail

/// The time in [0, 1] at which two moving shapes first touch, rounded down to a time at which they
/// nearly touch, or nothing if they stay apart. Each shape is given in the frame that its sweep
/// moves.
///
/// units:  times in [0, 1] on the grid of directions (Q2.30; Q2.14 for 16-bit scalars)
/// domain: every input; an empty shape, including a `ConvexHull` without points, touches nothing.
///         An oriented box is the one that its edges span
/// result: apart at every time before `time`, in exact arithmetic for the motions of `Sweep`; time
///         0 if they touch at the start. At `time` the exact distance is at most `distance`, which
///         is at most the greater of `target` and this: 10 units, plus 2^-25 (2^-9 for 16-bit
///         scalars) of the distance of the shapes' points from the origins of their frames, plus
///         the distance that points travel in one unit of time. Shapes that pass each other within
///         that distance may be reported. At most 128 steps; a search that needs more ends with
///         `is_hit` false                                      (tests/oracle/impact_pairs.test.cpp,
///         tests/query/time_of_impact/far.test.cpp)
/// source: conservative advancement; see ImpactSearch
template <class A, class B, Scalar S, int N>
requires detail::HaveImpact<A, B>
[[nodiscard]] constexpr std::optional<Impact<S>> time_of_impact(
    const A& a, const Sweep<S, N>& sweep_a, const B& b, const Sweep<S, N>& sweep_b,
    const S& target = detail::touching_distance<S>()) noexcept {
  if (!detail::has_points(a) || !detail::has_points(b)) return std::nullopt;
  return detail::search_impact(a, sweep_a, b, sweep_b, target).impact;
}

/// The time of impact with a shape of the world that does not move, such as a plane.
///
/// domain: as for two moving shapes; a `Plane` can be met from either side
template <class A, class B, Scalar S, int N>
requires detail::HaveImpact<A, B>
[[nodiscard]] constexpr std::optional<Impact<S>> time_of_impact(
    const A& a, const Sweep<S, N>& sweep_a, const B& b,
    const S& target = detail::touching_distance<S>()) noexcept {
  return time_of_impact(a, sweep_a, b, Sweep<S, N>(), target);
}
template <class A, Scalar S, int N>
requires detail::has_corners<A>
[[nodiscard]] constexpr std::optional<Impact<S>> time_of_impact(
    const A& a, const Sweep<S, N>& sweep_a, const Plane<S, N>& plane,
    const S& target = detail::touching_distance<S>()) noexcept {
  if (!detail::has_points(a)) return std::nullopt;
  const detail::Swept swept(detail::local_corners(detail::core_of(a)), sweep_a);
  const detail::StillPlane still(plane);
  return detail::ImpactSearch(swept, still, detail::radius_of(a)).first(target).impact;
}

}  // namespace detent
