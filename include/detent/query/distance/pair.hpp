// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/number/min_max.hpp"
#include "detent/query/distance/aabb.hpp"
#include "detent/query/distance/hull.hpp"
#include "detent/query/distance/obb.hpp"
#include "detent/query/distance/plane.hpp"
#include "detent/query/distance/triangle.hpp"
#include "detent/query/kernel/argument.hpp"
#include "detent/query/kernel/box_filter.hpp"
#include "detent/query/kernel/box_witness.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/core.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/point_obb.hpp"
#include "detent/query/kernel/point_plane.hpp"
#include "detent/query/kernel/segment_in_frame.hpp"
#include "detent/query/kernel/touch_witness.hpp"
#include "detent/query/kernel/within_slabs.hpp"

namespace detent {

namespace detail {

template <class T>
concept HasDistances = (IsShape<T> || IsSegment<T>)&&is_convex<T>;
template <class A, class B>
concept HaveDistance = HasDistances<A> && HasDistances<B> && !MixedArguments<A, B>;

/// How far a body is above `plane`, or below: its nearer extreme corner, times the length of the
/// normal; 0 between them.
template <Scalar S, int N, class Body>
[[nodiscard]] constexpr auto height_of_body(const Plane<S, N>& plane, const Body& body) noexcept {
  const auto [lowest, highest] = heights_above(plane, body);
  using Height = std::remove_cvref_t<decltype(lowest)>;
  return lowest > 0 ? lowest : highest < 0 ? highest : Height();
}

/// The same for a core. A box reaches as far from its center along the normal as its edges together;
/// if its axes are the world's, a corner is lowest if each product is the lesser one of its axis.
template <Scalar S, int N, class Core>
[[nodiscard]] constexpr auto height_of_core(const Plane<S, N>& plane, const Core& core) noexcept {
  if constexpr (is_kind<Core, Vec>) {
    return height_above(plane, core);
  } else if constexpr (is_kind<Core, Obb>) {
    const auto center = height_above(plane, core.center);
    const auto along = [&](int i) {
      return core.half_extents[i] * abs(dot(core.rotation.axis(i), plane.normal));
    };
    auto reach = along(0) + along(1);
    if constexpr (N == 3) reach = narrow<bits_of<decltype(reach)>>(reach + along(2));
    using Height = std::remove_cvref_t<decltype(center - reach)>;
    return center > reach    ? Height(center - reach)
           : center < -reach ? Height(center + reach)
                             : Height();
  } else if constexpr (is_kind<Core, Aabb>) {
    // The bits of height_above(plane, corner), which this is.
    constexpr int bits = bits_of<S> + bits_of<direction_component<S>> + 1;
    const auto along = [&](const S& x, int i) { return x * plane.normal[i]; };
    auto lowest = narrow_difference<bits>(decltype(along(S(), 0))(), plane.offset);
    auto highest = lowest;
    for (int i = 0; i < N; ++i) {
      const auto low = along(core.min[i], i), high = along(core.max[i], i);
      lowest = narrow_sum<bits>(lowest, (min)(low, high));
      highest = narrow_sum<bits>(highest, (max)(low, high));
    }
    return lowest > 0 ? lowest : highest < 0 ? highest : decltype(lowest)();
  } else {
    return height_of_body(plane, body_of(core));
  }
}

/// The squared distance from `plane` to a body.
template <Scalar S, int N, class Body>
[[nodiscard]] constexpr auto squared_gap_to_body(const Plane<S, N>& plane,
                                                 const Body& body) noexcept {
  return Fraction{square(height_of_body(plane, body)), squared_length(plane.normal)};
}

/// The squared distance of two planes, 0 unless they are parallel. Parallel normals may have
/// opposite signs and differ in length: for an axis i on which b's is not 0, the planes are
/// |a.offset b.normal[i] - b.offset a.normal[i]| / (|b.normal[i]| |a.normal|) apart.
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_gap_of_planes(const Plane<S, N>& a,
                                                   const Plane<S, N>& b) noexcept {
  const int i = longest_axis(b.normal.vec());
  const auto apart = a.offset * b.normal[i] - b.offset * a.normal[i];
  using Apart = std::remove_cvref_t<decltype(apart)>;
  const bool is_parallel = are_parallel(a.normal, b.normal.vec());
  return Fraction{square(is_parallel ? apart : Apart()),
                  square(b.normal[i]) * squared_length(a.normal)};
}

/// The squared distance from a box to a segment, in the frame of the box, which is its slabs.
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_gap_in_frame(const Obb<S, N>& box,
                                                  const Segment<S, N>& segment) noexcept {
  const auto center = in_frame(box, box.center - segment.start);
  const auto along = in_frame(box, segment.end - segment.start);
  return squared_distance_from_slabs(center - box.half_extents, center + box.half_extents, along);
}

/// The squared distance of two cores that have points, as a `Fixed` or a `Fraction`.
template <class A, class B>
[[nodiscard]] constexpr auto squared_gap(const A& a, const B& b) noexcept {
  if constexpr ((is_kind<A, Vec> && !is_kind<B, Vec>) ||
                (is_kind<B, Plane> && !is_kind<A, Plane>) ||
                (is_kind<A, Segment> && is_kind<B, Obb>)) {
    return squared_gap(b, a);
  } else if constexpr (is_kind<B, Vec>) {
    return squared_distance(a, b);
  } else if constexpr (is_kind<B, Plane>) {
    return squared_gap_of_planes(a, b);
  } else if constexpr (is_kind<A, Plane>) {
    return squared_gap_to_body(a, body_of(b));
  } else if constexpr (is_kind<A, Obb> && is_kind<B, Segment>) {
    return squared_gap_in_frame(a, b);
  } else if constexpr (is_kind<A, Aabb> && is_kind<B, Aabb>) {
    // From the origin to the box of differences.
    const auto low = a.min - b.max, high = a.max - b.min;
    return squared_length(excess(std::remove_cvref_t<decltype(low)>(), low, high));
  } else {
    return squared_distance_between(body_of(a), body_of(b));
  }
}

/// Whether the gap between two cores is a gap between two bodies: see `squared_gap`.
template <class A, class B>
inline constexpr bool has_gap_of_bodies = [] {
  if (is_kind<A, Vec> || is_kind<B, Vec> || is_kind<A, Plane> || is_kind<B, Plane>) return false;
  if (is_kind<A, Aabb> && is_kind<B, Aabb>) return false;
  return !(is_kind<A, Obb> && is_kind<B, Segment>)&&!(is_kind<A, Segment> && is_kind<B, Obb>);
}();

/// Whether the distance of two cores is found as that of b and a.
template <class A, class B>
inline constexpr bool is_b_first =
    (is_kind<A, Vec> && (is_kind<B, Segment> || is_kind<B, Triangle> || is_kind<B, Obb>)) ||
    (is_kind<B, Plane> && !is_kind<A, Plane>) ||
    (is_kind<A, Segment> && (is_kind<B, Obb> || has_segment_in_frame<B>));

/// The distance of two cores that have points, rounded down.
template <Scalar S, class A, class B>
[[nodiscard]] constexpr Length<S> gap_floor(const A& a, const B& b) noexcept {
  constexpr bool is_plane = is_kind<A, Plane>;
  if constexpr (has_segment_in_frame<A> && is_kind<B, Segment>) {
    const auto distance = SegmentInFrame(a, b).distance_floor();
    if (distance.is_sure) return distance.value;
  }
  if constexpr (is_b_first<A, B>) {
    return gap_floor<S>(b, a);
  } else if constexpr (is_kind<B, Vec> && (is_kind<A, Segment> || is_kind<A, Triangle>)) {
    return distance_to<Length<S>>(a, b);
  } else if constexpr (is_plane && is_kind<B, Plane>) {
    const auto squared = squared_gap_of_planes(a, b);
    return squared.numerator == 0 ? Length<S>(0) : sqrt_floor<Length<S>>(squared);
  } else if constexpr (is_plane && (filter_pays<S> || (is_fixed<S> && !is_kind<B, Obb>))) {
    return divide_by_length<Length<S>>(height_of_core(a, b), squared_length(a.normal));
  } else if constexpr (is_kind<A, Obb> && is_kind<B, Vec>) {
    return gap_in_frame<Length<S>>(a, b);
  } else if constexpr (filter_pays<S> && has_gap_of_bodies<A, B>) {
    if constexpr ((is_kind<A, Obb> || is_kind<A, Aabb>)&&(is_kind<B, Obb> || is_kind<B, Aabb>)) {
      if (decide_boxes_overlap(a, b) == Filtered::yes) return Length<S>(0);
      if constexpr (has_box_witness<A, B>) {
        const auto distance = BoxWitness<S>(a, b).distance_floor();
        if (distance.is_sure) return distance.value;
      }
    }
    const auto body_a = body_of(a);
    const auto body_b = body_of(b);
    const auto distance = still_witness(body_a, body_b).template distance_floor<Length<S>>();
    if (distance.is_sure) return distance.value;
  }
  return sqrt_floor<Length<S>>(squared_gap(a, b));
}

}  // namespace detail

/// The distance between two shapes or segments, 0 if they share a point.
///
/// To segments, spheres and capsules, an oriented box is its slabs, and distances are measured in
/// its frame; to other shapes it is the box that its edges span.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result if a shape is empty
/// exact:  rounded down, error in [0, 1) ULP                (tests/oracle/distance_pairs.test.cpp)
/// source: Gilbert, Johnson, Keerthi (1988), for polytopes: see query/kernel/gjk.hpp
template <class A, class B>
requires detail::HaveDistance<A, B>
[[nodiscard]] constexpr auto distance(const A& a, const B& b) noexcept {
  using S = decltype(detail::radius_of(a));
  if (!detail::has_points(a) || !detail::has_points(b)) return largest<S>;
  const auto gap = detail::gap_floor<S>(detail::core_of(a), detail::core_of(b));
  return detail::less_radius<S>(gap, detail::radius_of(a) + detail::radius_of(b));
}

}  // namespace detent
