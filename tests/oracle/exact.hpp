// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/math/direction.hpp"
#include "detent/math/vec.hpp"
#include "detent/shape/frustum.hpp"
#include "detent/shape/hull.hpp"
#include "detent/shape/shape.hpp"
#include "oracle/apart.hpp"
#include "oracle/meet.hpp"
#include "oracle/nearest.hpp"
#include "oracle/solid.hpp"

// The library's numbers and shapes in integers, for the oracle.
namespace detent::oracle {

template <Scalar S, int N>
Vector<N> raw(const Vec<S, N>& v) {
  Vector<N> result;
  for (int i = 0; i < N; ++i) {
    result[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(v[i].raw());
  }
  return result;
}

template <Scalar S, int N>
Raw<N> raw(const Direction<S, N>& direction) {
  Raw<N> result;
  for (int i = 0; i < N; ++i) {
    result[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(direction[i].raw());
  }
  return result;
}

template <Scalar S>
Integer raw(S value) {
  return static_cast<std::int64_t>(value.raw());
}

/// The raw bits of a number of any width.
template <class I>
Integer whole(const I& raw) {
  if constexpr (sizeof(I) <= sizeof(std::int64_t)) {
    return static_cast<std::int64_t>(raw);
  } else {
    constexpr int words = static_cast<int>(sizeof(I) / sizeof(std::uint64_t));
    const Wide<words> wide(raw);
    const Wide<words> magnitude = wide.is_negative() ? -wide : wide;
    Integer result = 0;
    for (int i = words - 1; i >= 0; --i) result = (result << 64) + magnitude.word(i);
    return wide.is_negative() ? Integer(-result) : result;
  }
}

/// The steps of a direction's grid in 1.
template <Scalar S>
Integer one_of() {
  return Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
}

template <Scalar S, int N>
Line<N> exact(const Ray<S, N>& ray) {
  return {raw(ray.origin), widen(raw(ray.direction)), one_of<S>(), raw(ray.max_distance)};
}
template <Scalar S, int N>
Solid<N> exact(const Sphere<S, N>& sphere) {
  return Ball<N>{raw(sphere.center), raw(sphere.radius)};
}
template <Scalar S, int N>
Solid<N> exact(const Aabb<S, N>& box) {
  return Box<N>{raw(box.min), raw(box.max)};
}
template <Scalar S, int N>
Solid<N> exact(const Obb<S, N>& box) {
  TurnedBox<N> result{raw(box.center), raw(box.half_extents), {}, one_of<S>()};
  for (int i = 0; i < N; ++i) {
    result.axes[static_cast<std::size_t>(i)] = widen(raw(box.rotation.axis(i)));
  }
  return result;
}
template <Scalar S, int N>
Solid<N> exact(const Plane<S, N>& plane) {
  return Wall<N>{widen(raw(plane.normal)), raw(plane.offset), one_of<S>()};
}
template <Scalar S, int N>
Solid<N> exact(const Segment<S, N>& segment) {
  return Edge<N>{raw(segment.start), raw(segment.end)};
}
template <Scalar S, int N>
Solid<N> exact(const Triangle<S, N>& triangle) {
  return Face<N>{{raw(triangle.a), raw(triangle.b), raw(triangle.c)}};
}
template <Scalar S, int N>
Solid<N> exact(const Capsule<S, N>& capsule) {
  return Pill<N>{{raw(capsule.a), raw(capsule.b)}, raw(capsule.radius)};
}
template <Scalar S, int N>
Solid<N> exact(const ConvexHull<S, N>& hull) {
  Cloud<N> result;
  for (const auto& point : hull.points) result.points.push_back(raw(point));
  return result;
}

template <Scalar S>
Solid<3> exact(const Frustum<S>& frustum) {
  return exact(frustum.hull());
}

template <Scalar S, int N>
Solid<N> exact(const Vec<S, N>& point) {
  return Cloud<N>{{raw(point)}};
}

template <class Shape>
concept Readable = requires(const Shape& shape) {
  exact(shape);
};

/// Whether two shapes of the library share a point.
template <Readable A, Readable B>
bool meet(const A& a, const B& b) {
  return meet(exact(a), exact(b));
}
/// Their distance in raw units, rounded down; nothing if one is empty.
template <Readable A, Readable B>
std::optional<Integer> distance_floor(const A& a, const B& b) {
  return distance_floor(exact(a), exact(b));
}
/// The point of a shape closest to `point`.
template <Readable Shape, Scalar S, int N>
std::optional<Nearest<N>> nearest(const Shape& shape, const Vec<S, N>& point) {
  return nearest(exact(shape), raw(point));
}

}  // namespace detent::oracle
