// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/plane.hpp"
#include "oracle/half_spaces.hpp"

namespace detent::oracle {

/// The plane as the intersection of its two half-spaces.
template <Scalar S, int N>
Expected<N> expected_raycast(const Ray<S, N>& ray, const Plane<S, N>& plane) {
  const auto line = oracle::line(ray);
  const auto normal = raw(plane.normal);
  const auto up = widen(normal);
  const Integer height = (dot(up, line.origin) - raw(plane.offset) * line.one) * line.one;
  const Integer speed = dot(up, line.direction);
  const auto inside =
      span(std::array{HalfSpace{height, speed}, HalfSpace{-height, -speed}}, line.max);
  if (!inside) return {};
  return hit(line, floor(inside->enter), floor(inside->exit),
             stored<N>(speed > 0 ? negated(normal) : normal));
}

/// Whether the ray runs against the normal, as Facing::front requires.
template <Scalar S, int N>
bool meets_front(const Ray<S, N>& ray, const Plane<S, N>& plane) {
  return dot(widen(raw(plane.normal)), widen(raw(ray.direction))) < 0;
}

}  // namespace detent::oracle
