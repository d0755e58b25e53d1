// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <type_traits>

#include "oracle/hull_round.hpp"

/// The exact squared distance of two shapes' cores: to be included before headers that handle
/// shapes of any kind.
namespace detent::oracle {

/// The points of a hull in steps of 1 / `under` raw units.
template <int N>
std::vector<Vector<N>> points_over(const Hull<N>& hull, const Integer& under) {
  auto points = hull.over;
  for (auto& point : points) {
    for (auto& component : point) component *= under / hull.under;
  }
  return points;
}

/// Points that are not corners may stay: each candidate is a distance between points of the hulls.
/// Disjoint hulls are closest at a point of one or at two segments between points.
template <int N>
Moment squared_apart(const Hull<N>& a, const Hull<N>& b) {
  if (meet(a, b)) return {};
  const Integer under = lcm(a.under, b.under);
  const auto p = points_over(a, under), q = points_over(b, under);
  auto least = nearest_outside<N>(p, q.front()).squared;
  for (const auto& point : q) least = std::min(least, nearest_outside<N>(p, point).squared);
  for (const auto& point : p) least = std::min(least, nearest_outside<N>(q, point).squared);
  for (std::size_t i = 0; N == 3 && i < p.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto u = difference(p[j], p[i]);
      for (std::size_t k = 0; k < q.size(); ++k) {
        for (std::size_t l = 0; l < k; ++l) {
          const auto across = between_inner_points<N>(p[i], u, q[k], difference(q[l], q[k]));
          if (across) least = std::min(least, *across);
        }
      }
    }
  }
  return {least.over, least.under * under * under};
}

template <Scalar S, int N>
Moment squared_apart(const Plane<S, N>& plane, const Hull<N>& hull) {
  if (meet(plane, hull)) return {};
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  const auto n = widen(raw(plane.normal));
  std::optional<Moment> least;
  for (const auto& point : hull.over) {
    const Integer height = dot(n, point) - raw(plane.offset) * one * hull.under;
    const Moment squared{height * height, dot(n, n) * hull.under * hull.under};
    if (!least || squared < *least) least = squared;
  }
  return *least;
}

/// Of parallel planes, the distance of one to the foot of the origin on the other.
template <Scalar S, int N>
Moment squared_apart(const Plane<S, N>& a, const Plane<S, N>& b) {
  if (meet(a, b)) return {};
  const auto n = widen(raw(b.normal));
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  Hull<N> foot{{n}, dot(n, n)};
  for (auto& component : foot.over.front()) component *= raw(b.offset) * one;
  return squared_apart(a, foot);
}

template <class Shape>
inline constexpr bool is_plane = false;
template <Scalar S, int N>
inline constexpr bool is_plane<Plane<S, N>> = true;
template <class Shape>
inline constexpr bool is_oriented_box = false;
template <Scalar S, int N>
inline constexpr bool is_oriented_box<Obb<S, N>> = true;
/// Points and segments, which read an oriented box as its slabs.
template <class Shape>
inline constexpr bool is_thin = false;
template <Scalar S, int N>
inline constexpr bool is_thin<Vec<S, N>> = true;
template <Scalar S, int N>
inline constexpr bool is_thin<Segment<S, N>> = true;

template <class Shape>
auto core(const Shape& shape) {
  return shape;
}
template <Scalar S, int N>
Vec<S, N> core(const Sphere<S, N>& sphere) {
  return sphere.center;
}
template <Scalar S, int N>
Segment<S, N> core(const Capsule<S, N>& capsule) {
  return {capsule.a, capsule.b};
}

/// The hull in the frame of `box`, in steps of 1 / (one under) raw units.
template <Scalar S, int N>
Hull<N> in_frame(const Obb<S, N>& box, const Hull<N>& hull) {
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  Hull<N> result{{}, one * hull.under};
  for (const auto& point : hull.over) {
    Vector<N> from_center = point, place;
    for (std::size_t i = 0; i < place.size(); ++i) {
      from_center[i] -= raw(box.center)[i] * hull.under;
    }
    for (std::size_t i = 0; i < place.size(); ++i) {
      place[i] = dot(widen(raw(box.rotation.axis(static_cast<int>(i)))), from_center);
    }
    result.over.push_back(place);
  }
  return result;
}
template <Scalar S, int N>
Hull<N> slabs_in_frame(const Obb<S, N>& box) {
  std::array<Vector<N>, N> edges;
  for (std::size_t i = 0; i < edges.size(); ++i) edges[i][i] = raw(box.half_extents)[i];
  return corners<N>(Vector<N>{}, edges, 1);
}

template <class A, class B>
Moment squared_apart_of_cores(const A& a, const B& b) {
  if constexpr (is_plane<A> && is_plane<B>) {
    return squared_apart(a, b);
  } else if constexpr (is_plane<A>) {
    return squared_apart(a, hull_of(b));
  } else if constexpr (is_plane<B>) {
    return squared_apart(b, hull_of(a));
  } else if constexpr (is_oriented_box<A> && is_thin<B>) {
    return squared_apart(slabs_in_frame(a), in_frame(a, hull_of(b)));
  } else if constexpr (is_oriented_box<B> && is_thin<A>) {
    return squared_apart(slabs_in_frame(b), in_frame(b, hull_of(a)));
  } else {
    return squared_apart(hull_of(a), hull_of(b));
  }
}

template <class Shape>
Integer radius(const Shape& shape) {
  if constexpr (requires { shape.radius; }) {
    return raw(shape.radius);
  } else {
    return 0;
  }
}

template <class Shape>
bool has_points(const Shape& shape) {
  if constexpr (requires { shape.radius; }) {
    return shape.radius >= 0;
  } else if constexpr (is_plane<Shape>) {
    return true;
  } else {
    return !hull_of(shape).over.empty();
  }
}

/// The distance of two shapes in raw units, rounded down; nothing if one is empty.
template <class A, class B>
std::optional<Integer> distance_floor(const A& a, const B& b) {
  if (!has_points(a) || !has_points(b)) return {};
  const auto squared = squared_apart_of_cores(core(a), core(b));
  const Integer apart = sqrt(floor_quotient(squared.over, squared.under));
  return std::max<Integer>(apart - radius(a) - radius(b), 0);
}

}  // namespace detent::oracle
