// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>

#include "detent/number/quadratic.hpp"
#include "detent/query/cast/motion.hpp"
#include "detent/query/cast/point.hpp"
#include "detent/query/kernel/approach.hpp"
#include "detent/query/kernel/box_touch.hpp"
#include "detent/query/kernel/clip.hpp"
#include "detent/query/kernel/differences.hpp"
#include "detent/query/kernel/stab.hpp"
#include "detent/query/kernel/stab_witness.hpp"
#include "detent/query/kernel/touch_direction.hpp"
#include "detent/query/kernel/touch_feature.hpp"
#include "detent/query/kernel/touch_witness.hpp"

// The first touch of a moving body and a target, for each kind of body.

namespace detent::detail {

/// How far a shape moves before it touches a target, the normal there, unless they share a point at
/// the start, and the target's point if it is known.
template <Scalar S, int N>
struct Touch {
  S distance;
  std::optional<Direction<S, N>> normal;
  std::optional<Vec<S, N>> point{};
};

/// The path of a body, clipped to the times at which its box, grown by `radius`, meets the box
/// around another body.
template <class A, class B, class Way, Number R, Scalar S>
[[nodiscard]] constexpr auto clip_of_boxes(const A& a, const B& b, const Way& way, const R& radius,
                                           const S& limit) noexcept {
  const auto low = b.low() - a.high(), high = b.high() - a.low();
  using Gap = std::remove_cvref_t<decltype(high.x + radius)>;
  using Speed = std::remove_cvref_t<decltype(way[0])>;
  RayClip<S, Gap, Speed, bits_of<Gap> + bits_of<Speed>> clip(limit);
  for (int i = 0; i < A::dimension; ++i) {
    clip.keep(i, low[i] - radius, high[i] + radius, way[i]);
  }
  return clip;
}

/// A distance of at most `limit`, rounded down, before which bodies are not within `radius`: until
/// then their boxes are farther apart along some axis. Nothing if they stay apart.
template <class A, class B, class Way, Number R, Scalar S>
[[nodiscard]] constexpr std::optional<S> boxes_within(const A& a, const B& b, const Way& way,
                                                      const R& radius, const S& limit) noexcept {
  return clip_of_boxes(a, b, way, radius, limit).first_distance();
}

/// The first touch of two boxes with the same axes; the normal is that of the axis on which they
/// meet last; ties go to the lowest axis.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Touch<S, N>> touch_of_boxes(const Aabb<S, N>& a,
                                                                  const Aabb<S, N>& b,
                                                                  const Direction<S, N>& direction,
                                                                  const S& limit) noexcept {
  const auto clip = clip_of_boxes(AabbBody(a), AabbBody(b), direction, S(0), limit);
  const auto distance = clip.first_distance();
  if (!distance) return std::nullopt;
  const int axis = clip.entered();
  if (axis == clip.no_slab) return Touch<S, N>{S(0), std::nullopt};
  const auto outward = Direction<S, N>::along(axis);
  return Touch<S, N>{*distance, direction[axis] > 0 ? -outward : outward};
}

/// The first touch of two polytopes: where the ray from 0 along `way` enters the differences of
/// their points. Shapes that are round but for a radius of 0 are too rare for the filter's code.
template <bool WithNormal, bool HasFilter, class A, class B, class Way, class ToWorld, Scalar S,
          int N>
[[nodiscard]] constexpr std::optional<Touch<S, N>> touch_of_polytopes(
    const A& a, const B& b, const Way& way, const ToWorld& to_world,
    const Direction<S, N>& direction, const S& limit) noexcept {
  if (clip_of_boxes(a, b, way, S(0), limit).is_empty()) return std::nullopt;
  if (is_zero(make_vec<N>([&](int i) { return way[i]; }))) {  // in a frame whose axes are parallel
    if (!bodies_overlap(a, b)) return std::nullopt;
    return Touch<S, N>{S(0), std::nullopt};
  }
  const auto outward = [&](const auto& normal) {
    return -direction_of<S>(to_world(normal)).value_or(direction);
  };
  if constexpr (HasFilter && filter_pays<S>) {
    const auto steps = make_vec<N>([&](int i) { return way[i]; });
    using Component = std::remove_cvref_t<decltype(steps.x)>;
    const auto decided = StabWitness<A, B, Component, S>(a, b, steps).entry(limit);
    if (decided.is_sure) {
      if (!decided.value) return std::nullopt;
      const auto& entry = *decided.value;
      Touch<S, N> touch{entry.distance, std::nullopt};
      if constexpr (WithNormal) touch.normal = outward(entry.normal);
      if constexpr (WithNormal && std::is_same_v<ToWorld, SameFrame>) {
        const auto reached = steps * entry.distance;
        touch.point =
            point_under_face<S>(moved_body(a, reached), b, reached, entry.corners, entry.normal);
      }
      return touch;
    }
    if (bodies_overlap(a, b)) return Touch<S, N>{S(0), std::nullopt};
  }
  const auto points = differences(a, b);
  using Point = std::remove_cvref_t<decltype(points[0])>;
  using Component = std::remove_cvref_t<decltype(Point().x)>;
  Stab<Component, N, std::remove_cvref_t<decltype(points)>, Way> stab(Point(), way, points);
  const auto entered = entry(stab, limit);
  if (!entered) return std::nullopt;
  Touch<S, N> touch{entered->distance, std::nullopt};
  if constexpr (WithNormal) {
    if (!entered->starts_inside) {
      touch.normal = stab.is_face() ? outward(stab.normal()) : -direction;
    }
  }
  return touch;
}

/// Sets `distance` to how far a point moves before it is within `radius` > 0 of another one: a ray
/// against a ball. Returns false if it does not come that close by `limit`.
template <Scalar S, int N, Number R>
[[nodiscard]] constexpr bool find_distance_to_ball(const Vec<S, N>& point, const Vec<S, N>& center,
                                                   const Direction<S, N>& direction, const S& limit,
                                                   const R& radius, S& distance) noexcept {
  const auto m = point - center;
  const auto squared = squared_length(m);
  const auto beyond = squared - square(radius);
  distance = S(0);
  if (beyond <= 0) return true;
  const auto b = dot(m, direction);
  if (!(b < 0)) return false;
  const Quadratic quadratic(squared_length(direction), b,
                            narrow<bits_of<std::remove_cvref_t<decltype(squared)>>>(beyond));
  return quadratic.has_roots() && quadratic.find_first_root(limit, distance);
}

/// The first touch of two spheres with points. The normal is found like that of other round bodies.
template <bool WithNormal, Scalar S, int N>
[[nodiscard]] constexpr std::optional<Touch<S, N>> touch_of_spheres(
    const Sphere<S, N>& a, const Sphere<S, N>& b, const Direction<S, N>& direction,
    const S& limit) noexcept {
  const auto radius = a.radius + b.radius;
  const auto between = b.center - a.center;
  const auto body_a = body_of(a.center), body_b = body_of(b.center);
  // The result is written where it is returned, which takes one variable for all returns: copies of
  // what was just written in parts stall.
  std::optional<Touch<S, N>> touch;
  if (!(radius > 0)) {
    const auto distance = boxes_within(body_a, body_b, direction, S(0), limit);
    if (!distance) return touch;
    const bool is_at_start = is_zero(between);
    touch.emplace();
    touch->distance = is_at_start ? S(0) : *distance;
    if (!is_at_start) touch->normal.emplace(-direction);
    return touch;
  }
  S distance;
  if (!find_distance_to_ball(a.center, b.center, direction, limit, radius, distance)) return touch;
  touch.emplace();
  touch->distance = distance;
  if constexpr (WithNormal) {
    if (squared_length(between) > square(radius)) {
      if constexpr (filter_pays<S>) {
        const auto found = direction_at_touch<S>(between - direction.vec() * distance,
                                                 direction.vec(), radius, SameFrame());
        if (found.is_sure) {
          touch->normal.emplace(-found.value);
          return touch;
        }
      }
      using Component = direction_component<S>;
      constexpr int most = is_fixed<S> ? bits_of<Component> + 2 : 0;
      using Body = std::remove_cvref_t<decltype(body_a)>;
      const Approach<Body, Body, Component, S, most> fine(body_a, body_b, direction.vec(), radius,
                                                          finer_by<most>(radius));
      touch->normal = -fine.with_touch_of_points(
          between, fine.scaled(distance), fine.scaled(limit),
          [&](const auto& v) { return direction_of<S>(shortened<240>(v)).value_or(direction); });
    }
  }
  return touch;
}

/// The first touch of bodies within `radius` > 0, of which the target has `beyond`.
///
/// The normal is that of the closest points less than two steps of a time grid earlier. In that
/// time it turns by less than 2 steps / radius: less than a quarter of its own step.
template <bool WithNormal, class A, class B, class Way, class ToWorld, Scalar S, int N, Number R>
[[nodiscard]] constexpr std::optional<Touch<S, N>> touch_of_round(
    const A& a, const B& b, const Way& way, const ToWorld& to_world,
    const Direction<S, N>& direction, const S& limit, const R& radius,
    [[maybe_unused]] const S& beyond) noexcept {
  const auto steps = make_vec<N>([&](int i) { return way[i]; });
  using Component = std::remove_cvref_t<decltype(steps.x)>;
  using Search = Approach<A, B, Component, S, 0>;
  const Search search(a, b, steps, radius, 0);

  constexpr int most = is_fixed<S> ? bits_of<direction_component<S>> + 2 : 0;
  using FineSearch = Approach<A, B, Component, S, most>;
  const auto outward = [&](const auto& v) {
    return direction_of<S>(to_world(shortened<240>(v))).value_or(direction);
  };
  const auto normal_after = [&](const S& distance) -> std::optional<Direction<S, N>> {
    if constexpr (WithNormal) {
      const FineSearch fine(a, b, steps, radius, finer_by<most>(radius));
      return -fine.with_touch(fine.scaled(distance), fine.scaled(limit), outward);
    } else {
      return std::nullopt;
    }
  };
  // The filters of normals are for the time grid of scalars of 32 bits.
  const auto normal_on = [&](const auto& feature, const S& distance) {
    if (feature.is_facet()) {
      const auto normal = facet_normal(feature.simplex());
      return dot(normal, steps) > 0 ? -outward(normal) : outward(normal);
    }
    if constexpr (filter_pays<S>) {
      const auto on_feature = direction_on<S>(feature, steps, distance, radius, to_world);
      if (on_feature.is_sure) return -on_feature.value;
      if constexpr (N == 3 && std::is_same_v<ToWorld, SameFrame>) {
        if (feature.count == 2) {
          const auto& from = feature.corners[0];
          const auto found = direction_across<S>(from - steps * distance, feature.corners[1] - from,
                                                 steps, radius);
          if (found.is_sure) return -found.value;
        }
      }
    }
    const FineSearch fine(a, b, steps, radius, finer_by<most>(radius));
    return -fine.with_touch_on(feature, fine.scaled(distance), fine.scaled(limit), outward);
  };
  const auto start = boxes_within(a, b, steps, radius, limit);
  if (!start) return std::nullopt;
  if constexpr (are_point_and_box<A, B> && is_fixed<S> && filter_pays<S>) {
    BoxTouch<A, B, Component, S, R> box(a, b, steps, radius);
    const auto decided = box.first(*start, limit);
    if (decided.is_sure) {
      if (!decided.value) return std::nullopt;
      const S& distance = *decided.value;
      if constexpr (WithNormal) {
        if (const int axis = box.only_axis(); axis >= 0) {
          Vec<Fixed<2, 0>, N> normal{};
          normal[axis] = Fixed<2, 0>(1);
          return Touch<S, N>{distance, steps[axis] > 0 ? -outward(normal) : outward(normal)};
        }
        if (const auto feature = box.feature()) {
          return Touch<S, N>{distance, normal_on(*feature, distance)};
        }
      }
      return Touch<S, N>{distance, normal_after(distance)};
    }
  }
  if constexpr (is_fixed<S> && has_filters) {
    TouchWitness<A, B, Component, S, R> witness(a, b, steps, radius);
    const auto decided = witness.first(*start, limit);
    if (decided.is_sure) {
      if (!decided.value) return std::nullopt;
      const S& distance = *decided.value;
      if constexpr (WithNormal) {
        if constexpr (lists_corners<A, S> && lists_corners<B, S>) {
          const auto feature = witness.found();
          const TouchFeature<A, B, Component, S> closest(a, b, steps, distance, feature);
          if (closest.is_unique()) {
            return Touch<S, N>{distance, normal_on(feature, distance),
                               closest.point_beyond(beyond)};
          }
        }
        if (const auto feature = witness.feature_from(distance)) {
          return Touch<S, N>{distance, normal_on(*feature, distance)};
        }
      }
      return Touch<S, N>{distance, normal_after(distance)};
    }
  }
  if (!(*start > 0) && search.lead_at(S(0)).clearance != Clearance::apart) {
    return Touch<S, N>{S(0), std::nullopt};
  }
  const auto distance = search.first(*start, limit);
  if (!distance) return std::nullopt;
  return Touch<S, N>{*distance, normal_after(*distance)};
}

}  // namespace detent::detail
