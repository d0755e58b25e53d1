// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/query/cast/motion.hpp"
#include "detent/query/kernel/closest_in_frame.hpp"
#include "detent/query/kernel/common_point.hpp"
#include "detent/query/kernel/directions.hpp"
#include "detent/query/kernel/least_common_point.hpp"
#include "detent/query/kernel/point_aabb.hpp"
#include "detent/query/kernel/point_plane.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/query/kernel/stab_witness.hpp"
#include "detent/query/kernel/swept_body.hpp"
#include "detent/query/kernel/thin_in_slabs.hpp"
#include "detent/query/kernel/touch_witness.hpp"
#include "detent/query/kernel/weights.hpp"

// The point of a target closest to a moved shape. The moved pose is exact on a finer grid.

namespace detent::detail {

/// The corners of `b` and `a` that are closest if v leads straight from `a` to `b`, relative to a
/// corner of `a`: its grid is the finer one. `u` is v in a narrower type, times a power of two.
template <Number Corner, class A, class B, Number U, Number V, int N>
[[nodiscard]] constexpr auto closest_features(const A& a, const B& b, const Vec<U, N>& u,
                                              const Vec<V, N>& v) noexcept {
  const auto origin = a.some();
  return std::pair{extreme_corners<Corner>(b, u, v, false, origin),
                   extreme_corners<Corner>(a, u, v, true, origin)};
}

/// The point of `b`, grown by `radius`, that `closest_features` have in common along v.
template <Scalar S, class A, class Features, Number V, int N>
[[nodiscard]] constexpr Vec<S, N> point_of_features(const A& a, const Features& features,
                                                    const Vec<V, N>& v, const S& radius) noexcept {
  const auto origin = a.some();
  return least_common_point(features.first, features.second, [&](const auto& p, const auto&) {
    return nearly_rounded_beyond(RationalPoint{origin * p.under + p.over, p.under}, radius,
                                 narrow_negative(v));
  });
}

/// The point of the body `b`, grown by `radius`, closest to `a`, neither moving. If they share a
/// point, the one that `common_point` chooses.
template <Scalar S, class A, class B, int N = A::dimension>
[[nodiscard]] constexpr Vec<S, N> closest_point_of_body(const A& a, const B& b,
                                                        const S& radius) noexcept {
  return with_gjk(b, a, [&](auto search) {
    if (search.touches()) return common_point<S>(b, a);
    const auto& feature = search.closest_feature();
    using T = std::remove_cvref_t<decltype(feature[0].x)>;
    using V = typename Directions<T, N>::type;
    const auto v = with_direction(feature, [](const auto& u) { return on_grid_of<V>(u); });
    if constexpr (!is_fixed<S>) {
      Vec<S, N> p, q;
      find_by_weights(b, a, feature, p, q);
      return nearly_rounded_beyond(RationalPoint{p, S(1)}, radius, narrow_negative(v));
    } else {
      // Differences between the bodies fit T, and those within a body twice as much.
      using Corner = std::remove_cvref_t<decltype(T() + T())>;
      const auto features = with_direction(
          feature, [&](const auto& u) { return closest_features<Corner>(a, b, u, v); });
      return point_of_features(a, features, v, radius);
    }
  });
}

/// The point of the body `b` closest to `a`, given as many `corners` of a face of their differences
/// as axes before `a` moved by `reached`, and the normal of that face. Nothing unless the face is in
/// front of `a`, `reached` is straight over the corners' simplex, and differences have at most 61
/// bits; then the bodies are closest along the normal.
template <Scalar S, class A, class B, class Reached, Number C, Number U, int N = A::dimension>
[[nodiscard]] constexpr std::optional<Vec<S, N>> point_under_face(
    const A& a, const B& b, const Reached& reached,
    const std::array<Vec<C, N>, static_cast<std::size_t>(N)>& corners,
    const Vec<U, N>& normal) noexcept {
  const auto low = b.low() - a.high(), high = b.high() - a.low();
  constexpr int bits = (std::min)(bits_of<std::remove_cvref_t<decltype(low.x)>>, 61);
  if (!fits<bits>(low) || !fits<bits>(high)) return std::nullopt;
  // Corners of the differences of `a`, where it is now, and `b`; so their edges fit too.
  const auto at = [&](std::size_t k) { return narrow<bits>(corners[k] - reached); };
  const auto now = [&] {
    if constexpr (N == 2) {
      return std::array{at(0), at(1)};
    } else {
      return std::array{at(0), at(1), at(2)};
    }
  }();
  using T = std::remove_cvref_t<decltype(now[0].x)>;
  using Exact = std::remove_cvref_t<decltype(normal_of_face(now).x)>;
  const auto v = narrow<(std::min)(bits_of<U>, bits_of<Exact>)>(normal);
  if (!(dot(v, now[0]) > 0)) return std::nullopt;
  if constexpr (N == 2) {
    if (cross(v, now[0]) < 0 || cross(v, now[1]) > 0) return std::nullopt;
  } else {
    for (std::size_t k = 0; k < 3; ++k) {
      if (dot(v, cross(now[k], now[(k + 1) % 3])) < 0) return std::nullopt;
    }
  }
  using Corner = std::remove_cvref_t<decltype(T() + T())>;
  return point_of_features(a, closest_features<Corner>(a, b, v, v), v, S(0));
}

/// `body`, moved by `offset`.
template <class Body, Number T, int N>
[[nodiscard]] constexpr auto moved_body(const Body& body, const Vec<T, N>& offset) noexcept {
  return SweptBody<Body, T, 0>(body, 0, offset, offset);
}

/// The foot of a point on a plane, p - n h / |n|^2 with its height h, rounded to nearest and clamped;
/// in words.
///
/// 1 / |n|^2 = 1 - e + ... with |e| <= 2^-28, and h < 2^62 steps of 2^-30 S: h (1 - e) is off by less
/// than 2^6 of them, and with its products rounded down, the foot by less than 2^7.
template <Scalar S, Number P, Number Height, int N>
[[nodiscard]] constexpr Decided<Vec<S, N>> decide_foot(const Vec<P, N>& p,
                                                       const Direction<S, N>& normal,
                                                       const Height& height) noexcept {
  using Grid = Fixed<63, S::frac + 30>;
  using Near = Fixed<34, S::frac>;
  const auto squared = squared_length(normal);
  const auto above = floor_to<Grid>(height);
  const auto from = make_vec<N>([&](int i) { return floor_to<Grid>(p[i]); });
  Decided<Vec<S, N>> foot{{}, fits<61>(above) && fits<61>(from)};
  if (!foot.is_sure) return foot;
  const auto scaled =
      narrow<62>(above - floor_to<Grid>(narrow<62>(above) * (squared - decltype(squared)(1))));
  for (int i = 0; i < N; ++i) {
    const auto value = narrow<63>(from[i] - floor_to<Grid>(scaled * normal[i]));
    const auto nearest = decide_nearest<Near>(Approximate{value, Steps<1 << 7>()});
    foot.is_sure = foot.is_sure && nearest.is_sure;
    foot.value[i] = nearest_to<S>(nearest.value);
  }
  return foot;
}

/// The extreme corner of a body along v; ties go to the least one.
template <class Body, Number V, int N>
[[nodiscard]] constexpr auto least_extreme(const Body& body, const Vec<V, N>& v,
                                           bool farthest) noexcept {
  const auto from = body.some();
  constexpr int bits = bits_of<std::remove_cvref_t<decltype(from.x)>> + 1;
  auto least = from;
  const auto keep = [&](const auto& corner, bool is_better) {
    if (is_better || is_before(corner, least)) least = corner;
  };
  if constexpr (requires { body.template find_extreme<bits>(v, from, farthest, keep); }) {
    body.template find_extreme<bits>(v, from, farthest, keep);
  } else {
    bool is_first = true;
    body.template for_each_extreme<bits>(v, from, farthest, [&](const auto& corner) {
      keep(corner, std::exchange(is_first, false));
    });
  }
  return least;
}

/// The point of a plane closest to the body `a`, which is on one side of it or touches it: the foot
/// of the closest corner; ties go to the least one.
template <class A, Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point_of_plane(const A& a,
                                                         const Plane<S, N>& plane) noexcept {
  const auto& n = plane.normal.vec();
  const auto [lowest, highest] = heights_above(plane, a);
  const auto nearest = least_extreme(a, n, !(lowest + highest > 0));
  const auto above = height_above(plane, nearest);
  const auto exact = [&] {
    const auto whole = squared_length(plane.normal);
    return rounded<S>(RationalPoint{nearest * whole - n * above, whole});
  };
  if constexpr (filter_pays<S>) {
    return or_exact(decide_foot(nearest, plane.normal, above), exact);
  } else {
    return exact();
  }
}

/// Returns f(on_box, on_thin, v) for an oriented box and a segment that starts at `place` in the
/// frame of the box: rational points on both, in the frame of the box and in the world, and a
/// vector from the latter to the former in the world. Ties go to the least point of the segment.
template <Scalar S, int N, Number T, class F>
[[nodiscard]] constexpr auto with_closest_in_frame(const Obb<S, N>& box,
                                                   const Segment<S, N>& segment,
                                                   const Vec<T, N>& place, const F& f) noexcept {
  const auto along = segment.end - segment.start;
  const auto d = in_frame(box, along);
  const auto low = -place - box.half_extents, high = -place + box.half_extents;
  const auto t = closest_time(low, high, d, !is_before(segment.end, segment.start));
  const auto& whole = t.denominator;
  const auto offset = d * t.numerator + place * whole;
  using Offset = std::remove_cvref_t<decltype(offset.x)>;
  const auto clamped = make_vec<N>([&](int i) {
    const Offset extent(box.half_extents[i] * whole);
    return offset[i] > extent ? extent : offset[i] < -extent ? narrow_negative(extent) : offset[i];
  });
  return f(RationalPoint{clamped, whole},
           RationalPoint{segment.start * whole + along * t.numerator, whole},
           from_frame(box, clamped - offset));
}

/// The point of an oriented box closest to the one at `place`, both in the frame of the box.
template <Scalar S, int N, Number T>
[[nodiscard]] constexpr Vec<T, N> clamped_to(const Obb<S, N>& box,
                                             const Vec<T, N>& place) noexcept {
  return make_vec<N>([&](int i) { return clamp_to(place[i], box.half_extents[i]); });
}

template <Scalar S, int N>
[[nodiscard]] constexpr const Vec<S, N>& start_of(const Vec<S, N>& point) noexcept {
  return point;
}
template <Scalar S, int N>
[[nodiscard]] constexpr const Vec<S, N>& start_of(const Segment<S, N>& segment) noexcept {
  return segment.start;
}

/// The start of a thin core in the frame of a box, after moving along `direction`; if the distance
/// is negative, the box moved.
template <class Thin, Scalar S, int N, Number D>
[[nodiscard]] constexpr auto place_in_frame(const Obb<S, N>& box, const Thin& thin,
                                            const Direction<S, N>& direction,
                                            const D& distance) noexcept {
  return in_frame(box, start_of(thin) - box.center) + way_in_frame(box, direction) * distance;
}

/// The point of box `b` closest to box `a` moved by `offset`, if finding it takes no search: they
/// are apart, or one has a corner of the other.
template <Scalar S, int N, Number T>
[[nodiscard]] constexpr std::optional<Vec<S, N>> closest_point_of_boxes(
    const Aabb<S, N>& a, const Aabb<S, N>& b, const Vec<T, N>& offset) noexcept {
  const auto low = a.min + offset, high = a.max + offset;
  bool is_apart = false;
  for (int i = 0; i < N; ++i) is_apart |= high[i] < b.min[i] || b.max[i] < low[i];
  if (is_apart) return clamp_to(b, nearest_to<S>(low));
  const auto are_ordered = [](const auto& x, const auto& y, const auto& z) {
    bool are = true;
    for (int i = 0; i < N; ++i) are &= x[i] <= y[i] && y[i] <= z[i];
    return are;
  };
  for (const auto& corner : AabbBody(b).corners()) {
    if (are_ordered(low, corner, high)) return corner;
  }
  for (const auto& corner : AabbBody(a).corners()) {
    const auto moved = corner + offset;
    if (are_ordered(b.min, moved, b.max)) return nearest_to<S>(moved);
  }
  return std::nullopt;
}

/// Filter: the point of a segment, grown by `radius`, closest to a box if the box moves, else the
/// point of the box closest to the segment. `moved` is how far the segment moves along `direction`
/// relative to the box.
template <bool BoxMoves, class Box, Scalar S, int N, Number M>
[[nodiscard]] constexpr Decided<Vec<S, N>> decide_point_in_slabs(const Box& box,
                                                                 const Segment<S, N>& segment,
                                                                 const Direction<S, N>& direction,
                                                                 const M& moved,
                                                                 const S& radius) noexcept {
  const auto along = segment.end - segment.start;
  using Slabs = ThinInSlabs<S, N>;
  using Spot = typename Slabs::Place;
  if constexpr (is_kind<Box, Obb>) {
    const auto place = place_in_frame(box, segment, direction, moved);
    const Slabs closest(-place - box.half_extents, -place + box.half_extents, in_frame(box, along),
                        along);
    if (closest.closest_at() == ClosestAt::unsure) return {{}, false};
    if constexpr (BoxMoves) {
      return decide_on_thin(closest, segment, radius, from_frame(box, closest.excess()));
    } else {
      const auto on_box = from_frame(box, make_vec<N>([&](int i) {
                                       const Spot extent(box.half_extents[i]);
                                       return closest.side(i) < 0 ? narrow_negative(extent)
                                              : closest.side(i) > 0
                                                  ? extent
                                                  : floor_to<Spot>(place[i] + closest.place()[i]);
                                     }));
      return decide_point<S, N>([&](int i) { return floor_to<Spot>(on_box[i] + box.center[i]); },
                                Steps<1 << 12>());
    }
  } else {
    const auto start = segment.start + direction.vec() * moved;
    const Slabs closest(box.min - start, box.max - start, along, along);
    if (closest.closest_at() == ClosestAt::unsure) return {{}, false};
    if constexpr (BoxMoves) {
      return decide_on_thin(closest, segment, radius, closest.excess());
    } else {
      return decide_point<S, N>(
          [&](int i) {
            return closest.side(i) < 0   ? Spot(box.min[i])
                   : closest.side(i) > 0 ? Spot(box.max[i])
                                         : floor_to<Spot>(start[i] + closest.place()[i]);
          },
          Steps<1 << 12>());
    }
  }
}

/// Filter: the point of a sphere closest to a segment that moved along `direction`.
template <Scalar S, int N>
[[nodiscard]] constexpr Decided<Vec<S, N>> decide_point_of_sphere(const Vec<S, N>& center,
                                                                  const Segment<S, N>& segment,
                                                                  const Direction<S, N>& direction,
                                                                  const S& distance,
                                                                  const S& radius) noexcept {
  if (radius == 0) return {center, true};
  // The center is a box without extent.
  const auto to_center = center - segment.start - direction.vec() * distance;
  const auto along = segment.end - segment.start;
  const ThinInSlabs<S, N> closest(to_center, to_center, along, along);
  if (closest.closest_at() == ClosestAt::unsure) return {{}, false};
  const auto spot = make_vec<N>([&](int i) { return Fixed<62, S::frac + 30>(center[i]); });
  return decide_toward(spot, radius, closest.excess());
}

/// The same for shapes that are a box and a segment or capsule, in either order, or a sphere and a
/// segment or capsule; unsure for others.
template <class A, class B, Scalar S, int N>
[[nodiscard]] constexpr Decided<Vec<S, N>> decide_closest_point(
    const A& shape, const B& target, [[maybe_unused]] const Direction<S, N>& direction,
    [[maybe_unused]] const S& distance) noexcept {
  const auto& a = core_of(shape);
  const auto& b = core_of(target);
  using CoreA = std::remove_cvref_t<decltype(a)>;
  using CoreB = std::remove_cvref_t<decltype(b)>;
  constexpr bool is_box_a = is_kind<CoreA, Aabb> || is_kind<CoreA, Obb>;
  constexpr bool is_box_b = is_kind<CoreB, Aabb> || is_kind<CoreB, Obb>;
  if constexpr (!is_fixed<S> || !filter_pays<S>) {
    return {{}, false};
  } else if constexpr (is_box_a && is_kind<CoreB, Segment>) {
    return decide_point_in_slabs<true>(a, b, direction, -distance, S(radius_of(target)));
  } else if constexpr (is_kind<CoreA, Vec> && is_kind<CoreB, Segment>) {
    return decide_point_in_slabs<true>(Aabb<S, N>{a, a}, b, direction, -distance,
                                       S(radius_of(target)));
  } else if constexpr (is_kind<CoreA, Segment> && is_kind<CoreB, Vec>) {
    return decide_point_of_sphere(b, a, direction, distance, S(radius_of(target)));
  } else if constexpr (is_kind<CoreA, Segment> && is_box_b) {
    return decide_point_in_slabs<false>(b, a, direction, distance, S(radius_of(target)));
  } else {
    return {{}, false};
  }
}

/// The point of `target` closest to `shape` moved by `distance`; both have points.
template <class A, class B, Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> find_closest_point_of_target(const A& shape, const B& target,
                                                               const Direction<S, N>& direction,
                                                               const S& distance) noexcept {
  const auto& a = core_of(shape);
  const auto& b = core_of(target);
  using CoreA = std::remove_cvref_t<decltype(a)>;
  using CoreB = std::remove_cvref_t<decltype(b)>;
  const S radius = radius_of(target);
  if constexpr (is_kind<CoreA, Vec> && is_kind<CoreB, Obb>) {
    const auto place = place_in_frame(b, a, direction, distance);
    const auto from_center = from_frame(b, clamped_to(b, place));
    return make_vec<N>([&](int i) { return nearest_to<S>(b.center[i] + from_center[i]); });
  } else if constexpr (is_kind<CoreA, Obb> && is_kind<CoreB, Vec>) {
    const auto place = place_in_frame(a, b, direction, -distance);
    return nearly_rounded_beyond(b, radius, from_frame(a, clamped_to(a, place) - place));
  } else if constexpr (is_kind<CoreA, Segment> && is_kind<CoreB, Obb>) {
    return with_closest_in_frame(
        b, a, place_in_frame(b, a, direction, distance),
        [&](const auto& on_box, const auto&, const auto&) {
          return rounded<S>(
              RationalPoint{b.center * on_box.under + from_frame(b, on_box.over), on_box.under});
        });
  } else if constexpr (is_kind<CoreA, Obb> && is_kind<CoreB, Segment>) {
    return with_closest_in_frame(a, b, place_in_frame(a, b, direction, -distance),
                                 [&](const auto&, const auto& on_thin, const auto& v) {
                                   return nearly_rounded_beyond(on_thin, radius, v);
                                 });
  } else if constexpr (is_kind<CoreA, Vec> && is_kind<CoreB, Aabb>) {
    // The ends of the box are on the grid, so the order of rounding and clamping does not matter.
    return clamp_to(
        b, make_vec<N>([&](int i) { return nearest_to<S>(a[i] + direction[i] * distance); }));
  } else if constexpr (is_kind<CoreA, Vec> && is_kind<CoreB, Vec>) {
    const auto v = a - b + direction.vec() * distance;
    if (is_zero(v)) return b;
    return by_width<62>([&](const auto& u) { return nearly_rounded_beyond(b, radius, u); }, v);
  } else {
    const auto body = body_of(a);
    if constexpr (is_fixed<S> && has_filters && is_thin<CoreA> && !is_kind<CoreB, Plane>) {
      const auto reach = radius_of(shape) + radius;
      if (radius == 0 && reach > 0) {
        const auto other = body_of(b);
        using Body = std::remove_cvref_t<decltype(body)>;
        using Other = std::remove_cvref_t<decltype(other)>;
        using Reach = std::remove_cvref_t<decltype(reach)>;
        TouchWitness<Body, Other, direction_component<S>, S, Reach> witness(body, other,
                                                                            direction.vec(), reach);
        if (const auto point = witness.closest_point(distance)) return *point;
      }
    }
    const auto offset = direction.vec() * distance;
    if constexpr (is_kind<CoreA, Aabb> && is_kind<CoreB, Aabb>) {
      if (const auto point = closest_point_of_boxes(a, b, offset)) return *point;
    }
    if constexpr (is_kind<CoreA, Aabb> && is_kind<CoreB, Vec> && filter_pays<S> && is_fixed<S>) {
      const auto low = a.min + offset, high = a.max + offset;
      const auto v = make_vec<N>([&](int i) {
        const std::remove_cvref_t<decltype(low.x)> x(b[i]);
        return (x < low[i] ? low[i] : x > high[i] ? high[i] : x) - x;
      });
      if (radius == 0) return b;
      if (!is_zero(v)) {
        const auto point =
            by_width<62>([&](const auto& u) { return decide_beyond(b, radius, u); }, v);
        if (point.is_sure) return point.value;
      }
    }
    const auto moved = moved_body(body, offset);
    if constexpr (is_kind<CoreB, Plane>) {
      return closest_point_of_plane(moved, b);
    } else {
      return closest_point_of_body(moved, body_of(b), radius);
    }
  }
}

/// The same, by a filter where it pays.
template <class A, class B, Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point_of_target(const A& shape, const B& target,
                                                          const Direction<S, N>& direction,
                                                          const S& distance) noexcept {
  const auto point = decide_closest_point(shape, target, direction, distance);
  if (point.is_sure) return point.value;
  return find_closest_point_of_target(shape, target, direction, distance);
}

}  // namespace detent::detail
