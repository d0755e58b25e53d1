// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/number/filter/short_vector.hpp"
#include "detent/query/closest_points/bodies.hpp"
#include "detent/query/closest_points/boxes.hpp"
#include "detent/query/closest_points/plane.hpp"
#include "detent/query/kernel/argument.hpp"
#include "detent/query/kernel/box_common_point.hpp"
#include "detent/query/kernel/box_filter.hpp"
#include "detent/query/kernel/box_hull_witness.hpp"
#include "detent/query/kernel/box_witness.hpp"
#include "detent/query/kernel/closest_in_frame.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/core.hpp"
#include "detent/query/kernel/point_aabb.hpp"

namespace detent {

namespace detail {

template <class T>
inline constexpr bool is_round = requires(const T& shape) {
  shape.radius;
};

template <class T>
concept HasClosestPoints = (IsShape<T> || IsSegment<T>)&&is_convex<T>;
template <class A, class B>
concept HaveClosestPoints = HasClosestPoints<A> && HasClosestPoints<B> && !MixedArguments<A, B>;

/// The closest points of a sphere and a box that is not empty.
template <Scalar S, int N>
[[nodiscard]] constexpr std::pair<Vec<S, N>, Vec<S, N>> closest_points_of_sphere_and_box(
    const Vec<S, N>& center, const S& radius, const Aabb<S, N>& box) noexcept {
  const auto on_box = clamp_to(box, center);
  const auto to_box = on_box - center;
  if (is_zero(to_box) || squared_length(to_box) <= square(radius)) return {on_box, on_box};
  return {rounded_beyond(center, radius, to_box), on_box};
}

/// The closest points of two spheres. They are written where they are returned: copies of what was
/// just written in parts stall.
template <Scalar S, int N>
[[nodiscard]] constexpr std::pair<Vec<S, N>, Vec<S, N>> closest_points_of_spheres(
    const Vec<S, N>& a, const Vec<S, N>& b, const S& radius_a, const S& radius_b) noexcept {
  std::pair<Vec<S, N>, Vec<S, N>> points{b, b};
  const auto to_a = a - b;
  const auto to_b = narrow_negative(to_a);
  if constexpr (!is_fixed<S>) {
    const auto squared = squared_length(to_a);
    if (squared <= square(radius_a)) return points;
    points.first = rounded_beyond(a, radius_a, to_b);
    points.second =
        squared <= square(radius_a + radius_b) ? points.first : rounded_beyond(b, radius_b, to_a);
  } else {
    // A radius of 0 moves nothing.
    const auto write_both = [&](int i, const S& x) { points.first[i] = points.second[i] = x; };
    const auto write_second = [&](int i, const S& x) { points.second[i] = x; };
    if constexpr (has_short_vectors<S>) {
      if (fits<31>(to_b)) {
        const ShortVector between(to_array(narrow<31>(to_b)));
        if (!between.is_longer_than(radius_a)) return points;
        const auto unit = between.unit();
        write_rounded_beyond(a, radius_a, to_b, unit.steps(radius_a), write_both);
        if (between.is_longer_than(radius_a + radius_b)) {
          write_rounded_beyond(b, radius_b, to_a, unit.steps(narrow_negative(radius_b)),
                               write_second);
        }
        return points;
      }
    }
    const auto squared = squared_length(to_a);
    if (squared <= square(radius_a)) return points;
    const auto shares = shares_of(to_array(to_b));
    write_rounded_beyond(a, radius_a, to_b, step_along(radius_a, to_array(to_b), shares),
                         write_both);
    if (squared > square(radius_a + radius_b)) {
      write_rounded_beyond(b, radius_b, to_a, step_along(radius_b, to_array(to_a), shares),
                           write_second);
    }
  }
  return points;
}

/// Filter: the closest points of an oriented box and a hull, those of the first shape first.
template <bool IsBoxFirst, Scalar S, class Hull>
[[nodiscard]] constexpr Decided<std::pair<Vec<S, 3>, Vec<S, 3>>> closest_points_of_box_and_hull(
    const Obb<S, 3>& box, const Hull& hull) noexcept {
  BoxHullWitness<S> witness(box, hull_corners(hull));
  const auto overlap = witness.find();
  if (overlap == Filtered::unsure) return {{}, false};
  if (overlap == Filtered::yes) {
    const auto box_body = body_of(box);
    const auto hull_body = body_of(hull);
    if constexpr (is_kind<Hull, Triangle>) {
      const auto enter_box = [&] { return first_entry<S>(hull_body, box_body, Sides(box_body)); };
      const auto point = witness.common_point_of_triangle(IsBoxFirst, enter_box);
      if (point.is_sure) return {{point.value, point.value}, true};
    }
    const auto point = [&] {
      if constexpr (IsBoxFirst) {
        return common_point<S>(box_body, hull_body);
      } else {
        return common_point<S>(hull_body, box_body);
      }
    }();
    return {{point, point}, true};
  }
  auto result = witness.closest_points();
  if (!IsBoxFirst) std::swap(result.value.first, result.value.second);
  return result;
}

/// The closest points of two shapes with the cores a and b, which have points.
template <bool AreRound, Scalar S, class A, class B>
[[nodiscard]] constexpr auto closest_points_of_cores(const A& a, const B& b, const S& radius_a,
                                                     const S& radius_b) noexcept {
  constexpr bool is_frame_first = is_kind<A, Obb> && (is_kind<B, Vec> || is_kind<B, Segment>);
  constexpr bool is_frame_last = is_kind<B, Obb> && (is_kind<A, Vec> || is_kind<A, Segment>);
  constexpr bool is_box_first = is_kind<A, Aabb> && is_kind<B, Vec>;
  if constexpr ((is_kind<B, Plane> && !is_kind<A, Plane>) || is_frame_last || is_box_first) {
    const auto points = closest_points_of_cores<AreRound>(b, a, radius_b, radius_a);
    return std::pair{points.second, points.first};
  } else if constexpr (is_kind<B, Plane>) {
    return closest_points_of_planes(a, b);
  } else if constexpr (is_kind<A, Plane>) {
    return closest_points_to_plane(a, body_of(b), radius_b);
  } else if constexpr (is_frame_first) {
    return closest_points_in_frame(a, b, radius_b);
  } else if constexpr (is_kind<A, Vec> && is_kind<B, Vec>) {
    return closest_points_of_spheres(a, b, radius_a, radius_b);
  } else if constexpr (is_kind<A, Vec> && is_kind<B, Aabb>) {
    return closest_points_of_sphere_and_box(a, radius_a, b);
  } else if constexpr (is_kind<A, Aabb> && is_kind<B, Aabb>) {
    return closest_points_of_boxes(a, b);
  } else {
    if constexpr (has_box_witness<A, B>) {
      if (decide_boxes_overlap(a, b) == Filtered::yes) {
        const auto point = common_point_by_words(a, b);
        if (point.is_sure) return std::pair{point.value, point.value};
      } else {
        const auto points = BoxWitness<S>(a, b).closest_points();
        if (points.is_sure) return points.value;
      }
    }
    if constexpr (has_box_hull_witness<A, B>) {
      const auto found = closest_points_of_box_and_hull<true>(a, b);
      if (found.is_sure) return found.value;
    } else if constexpr (has_box_hull_witness<B, A>) {
      const auto found = closest_points_of_box_and_hull<false>(b, a);
      if (found.is_sure) return found.value;
    }
    const auto body_a = body_of(a);
    const auto body_b = body_of(b);
    using Search = ClosestPoints<S, AreRound, std::remove_cvref_t<decltype(body_a)>,
                                 std::remove_cvref_t<decltype(body_b)>>;
    return Search(body_a, body_b, radius_a, radius_b).find();
  }
}

}  // namespace detail

/// The closest points of two shapes or segments, as a pair: the point of `a` and the point of `b`.
/// If the shapes share a point, both are the same point.
///
/// Ties go to the pair whose point of `a` has the least x, then y, then z. The core of a sphere is
/// its center, that of a capsule its axis, that of any other shape the shape itself; the points of
/// round shapes are where the segment between those of the cores, p and q, leaves them.
///
/// If the cores share a point, the common point is the first corner of a's core that is in b's, in
/// the order of the shape's fields (for a box, the lower end first on each axis, x fastest; for a
/// hull, its points); or else the first corner of b's core in a's; or else where the first segment
/// between two corners of a's core, in lexicographic order, enters b's core; or else the same with
/// b's corners. Round shapes that overlap with their cores apart share a point on the segment from
/// p to q: q if it is in `a`, otherwise where the segment leaves `a`.
///
/// Planes have no corners: if they are parallel, and if they meet, the points are those closest to
/// the origin. To segments, spheres and capsules, an oriented box is its slabs, measured in its
/// frame: ties then go to the pair with the least point of the axis, and the common point is where
/// the axis enters the box. To other shapes it is the box that its edges span.
///
/// units:  world units
/// domain: every input; the origin twice if a shape is empty
/// exact:  each coordinate is the exact one rounded to nearest, ties to even, and clamped; only the
///         point of a capsule next to an oriented box is within 1/2 + 2^-12 ULP of the exact one
///         (tests/oracle/closest_points.test.cpp)
/// source: Gilbert, Johnson, Keerthi (1988), for polytopes: see query/kernel/gjk.hpp
template <class A, class B>
requires detail::HaveClosestPoints<A, B>
[[nodiscard]] constexpr auto closest_points(const A& a, const B& b) noexcept {
  using Point = typename detail::PointOf<A>::type;
  if (!detail::has_points(a) || !detail::has_points(b)) return std::pair<Point, Point>();
  constexpr bool are_round = detail::is_round<A> || detail::is_round<B>;
  return detail::closest_points_of_cores<are_round>(detail::core_of(a), detail::core_of(b),
                                                    detail::radius_of(a), detail::radius_of(b));
}

}  // namespace detent
