// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "detent/shape/shape.hpp"
#include "oracle/answer.hpp"
#include "oracle/exact.hpp"

/// Shapes in raw numbers, for the messages of failed tests.
namespace detent::oracle {

template <Scalar S, int N>
std::string describe(const Vec<S, N>& v) {
  Raw<N> components{};
  for (int i = 0; i < N; ++i) components[static_cast<std::size_t>(i)] = v[i].raw();
  return text(components);
}
template <Scalar S, int N>
std::string describe(const Sphere<S, N>& s) {
  return "sphere " + describe(s.center) + " radius " + raw(s.radius).str();
}
template <Scalar S, int N>
std::string describe(const Aabb<S, N>& box) {
  return "aabb " + describe(box.min) + " " + describe(box.max);
}
template <Scalar S, int N>
std::string describe(const Obb<S, N>& box) {
  auto out = "obb " + describe(box.center) + " half extents " + describe(box.half_extents);
  for (int i = 0; i < N; ++i) out += " " + text(raw(box.rotation.axis(i)));
  return out;
}
template <Scalar S, int N>
std::string describe(const Plane<S, N>& plane) {
  return "plane " + text(raw(plane.normal)) + " offset " + raw(plane.offset).str();
}
template <Scalar S, int N>
std::string describe(const Segment<S, N>& s) {
  return "segment " + describe(s.start) + " " + describe(s.end);
}
template <Scalar S, int N>
std::string describe(const Ray<S, N>& ray) {
  return "ray " + describe(ray.origin) + " direction " + text(raw(ray.direction)) +
         " max_distance " + raw(ray.max_distance).str();
}
template <Scalar S, int N>
std::string describe(const Triangle<S, N>& t) {
  return "triangle " + describe(t.a) + " " + describe(t.b) + " " + describe(t.c);
}
template <Scalar S, int N>
std::string describe(const Capsule<S, N>& c) {
  return "capsule " + describe(c.a) + " " + describe(c.b) + " radius " + raw(c.radius).str();
}

}  // namespace detent::oracle
