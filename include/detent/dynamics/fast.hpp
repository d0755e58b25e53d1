// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/dynamics/compound.hpp"
#include "detent/dynamics/local.hpp"
#include "detent/dynamics/manifold/facet.hpp"
#include "detent/dynamics/manifold/pair.hpp"

// Continuous collision: within a tick, a body marked as fast stops before its center comes too
// close to another body or passes through it.

namespace detent::detail {

/// The radius of a ball about the center of a body that is within its shape; not positive if there
/// is none.
template <Round Shape>
[[nodiscard]] constexpr auto inner_radius(const Shape& shape) noexcept {
  return shape.radius;
}
template <Scalar S, int N>
[[nodiscard]] constexpr S inner_radius(const Obb<S, N>& box) noexcept {
  S least = box.half_extents[0];
  for (int i = 1; i < N; ++i) least = (min)(least, box.half_extents[i]);
  return least;
}
template <Scalar S, int N>
[[nodiscard]] constexpr S inner_radius(const Aabb<S, N>& box) noexcept {
  S least = box.max[0];
  for (int i = 0; i < N; ++i) least = (min)(least, (min)(box.max[i], saturate_to<S>(-box.min[i])));
  return least;
}
template <Scalar S, int N>
[[nodiscard]] constexpr S inner_radius(const BodyHull<S, N>& body) noexcept {
  const auto hull = faces_of(body);
  std::optional<S> least;
  for (const auto& face : hull.faces) {
    const auto height = dot(face.normal, hull.corner(face, 0));
    const auto radius = saturate_to<S>(floor_to<S>(height));
    if (!least || radius < *least) least = radius;
  }
  return least.value_or(S(0));
}

/// Transforms a point of the world to the frame of a body, rounded as in a relative pose.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<typename Formats<S>::Lever, N> seen_from(
    const Standing<S, N>& body, const Vec<typename Formats<S>::Place, N>& point) noexcept {
  using Lever = typename Formats<S>::Lever;
  const auto offset =
      make_vec<N>([&](int i) { return saturate_to<Lever>(point[i] - body.place[i]); });
  return make_vec<N>([&](int i) {
    return nearest_to<Lever>(narrow_dot<62>(body.axes[static_cast<std::size_t>(i)], offset));
  });
}

/// The radius of a ball about the center of a compound that is within a part of this shape, at
/// `pose` in the compound's frame; 0 if the center is not in it.
template <class Shape, Scalar S, int N>
[[nodiscard]] constexpr S inner_radius(const Shape& shape,
                                       const RelativePose<S, N>& pose) noexcept {
  using F = Formats<S>;
  RelativePose<S, N> center;
  for (int i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    center.axes[k] = unit_axis<typename F::Ratio, N>(i);
    center.translation[i] =
        nearest_to<typename F::Lever>(-narrow_dot<62>(pose.axes[k], pose.translation));
  }
  const auto found = manifold(shape, Sphere<S, N>{}, center, typename F::Lever{});
  if (found.count == 0 || found.points[0].separation >= 0) return S(0);
  return saturate_to<S>(floor_to<S>(-found.points[0].separation));
}

/// Where a point stops: the fraction of its path, and the position there.
template <Scalar S, int N>
struct Stop {
  typename Formats<S>::Ratio share{};
  Vec<typename Formats<S>::Lever, N> at{};
};

/// Where a point that moves straight from `from` to `to` must stop before a convex shape, or
/// nothing if it need not. `touch(pose, reach)` is the manifold of the shape and a point at that
/// pose; `radius` is that of a ball around the point.
///
/// The ball stops half a margin before the shape. If it starts within a margin, the contact of the
/// bodies stops it, and here the point may only halve its distance; a point that starts in the
/// shape does not stop. The distance from a convex shape is a convex function of the path, so
/// Newton's method never passes its target distance. After 16 steps the point stops where it is.
///
/// result: a point outside the shape                    (tests/dynamics/fast.test.cpp)
template <Scalar S, int N, class Touch, class Lever = typename Formats<S>::Lever>
[[nodiscard]] constexpr std::optional<Stop<S, N>> stop_on_way(const Touch& touch,
                                                              const Vec<Lever, N>& from,
                                                              const Vec<Lever, N>& to,
                                                              const S& radius,
                                                              const S& margin) noexcept {
  using Gap = typename Formats<S>::Gap;
  using Ratio = typename Formats<S>::Ratio;
  const auto way = to - from;
  const auto close = saturate_to<Gap>(radius + margin);
  auto reach = close;
  for (int i = 0; i < N; ++i) reach = saturate_to<Gap>(reach + abs(way[i]));
  RelativePose<S, N> pose;
  for (int i = 0; i < N; ++i) pose.axes[static_cast<std::size_t>(i)] = unit_axis<Ratio, N>(i);
  pose.translation = from;
  Gap aim{};
  Ratio share{};
  for (int step = 0; step < 16; ++step) {
    const auto found = touch(pose, reach);
    if (found.count == 0) return std::nullopt;
    const auto distance = found.points[0].separation;
    if (step == 0) {
      if (distance <= 0) return std::nullopt;
      aim = distance > close ? saturate_to<Gap>(radius + half(margin))
                             : nearest_to<Gap>(half(distance));
    }
    const auto closing = -dot(found.normal, way);
    if (closing <= 0) return std::nullopt;
    const auto room = distance - aim;
    if (room <= 0) break;
    const auto next = share + quotient_floor<Ratio>(room, closing);
    if (next >= Ratio(1)) return std::nullopt;
    share = nearest_to<Ratio>(next);
    pose.translation =
        make_vec<N>([&](int i) { return nearest_to<Lever>(from[i] + way[i] * share); });
  }
  return Stop<S, N>{share, pose.translation};
}

/// The same for a surface: the earliest stop before the front of any triangle.
template <class Body, Scalar S, class Lever = typename Formats<S>::Lever>
[[nodiscard]] constexpr std::optional<Vec<Lever, 3>> stop_before_surface(const Body& body,
                                                                         const Vec<Lever, 3>& from,
                                                                         const Vec<Lever, 3>& to,
                                                                         const S& radius,
                                                                         const S& margin) noexcept {
  if (body.asset == nullptr) return std::nullopt;
  const auto room = radius + margin;
  const Aabb<S, 3> box{
      make_vec<3>([&](int i) { return saturate_to<S>(floor_to<S>((min)(from[i], to[i]) - room)); }),
      make_vec<3>([&](int i) { return saturate_to<S>(ceil_to<S>((max)(from[i], to[i]) + room)); })};
  std::optional<Stop<S, 3>> first;
  visit_within(surface_of(body), box, [&](std::span<const MeshTriangle<S>> parts) {
    for (const auto& part : parts) {
      if (part.index >= Body::part_limit || !overlaps(bounding_box(part), box)) continue;
      const auto facet = facet_of(part.triangle);
      if (!facet) continue;
      const auto stop = stop_on_way<S, 3>(
          [&](const RelativePose<S, 3>& pose, const auto& reach) {
            const auto point = placed_core(pose, round_core(Sphere<S, 3>{}));
            return facet_manifold(*facet, point, false, reach);
          },
          from, to, radius, margin);
      if (stop && (!first || stop->share < first->share)) first = stop;
    }
    return Walk::go_on;
  });
  return first ? std::optional(first->at) : std::nullopt;
}

/// The same for any shape of a body, in its frame.
template <class Shape, Scalar S, int N, class Lever = typename Formats<S>::Lever>
[[nodiscard]] constexpr std::optional<Vec<Lever, N>> stop_before(
    const Shape& shape, const BodyExtent<S, N>& extent, const Vec<Lever, N>& from,
    const Vec<Lever, N>& to, const S& radius, const S& margin) noexcept {
  if constexpr (is_surface_body<Shape>) {
    return stop_before_surface(shape, from, to, radius, margin);
  } else {
    for (int i = 0; i < N; ++i) {
      const auto edge = extent.half_extents[i] + (extent.radius + (radius + margin));
      if ((min)(from[i], to[i]) > edge || (max)(from[i], to[i]) < -edge) return std::nullopt;
    }
    const auto stop = stop_on_way<S, N>(
        [&](const RelativePose<S, N>& pose, const auto& reach) {
          return manifold(shape, Sphere<S, N>{}, pose, reach);
        },
        from, to, radius, margin);
    return stop ? std::optional(stop->at) : std::nullopt;
  }
}

}  // namespace detent::detail
