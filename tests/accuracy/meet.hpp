// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "accuracy/question.hpp"
#include "oracle/hull.hpp"
#include "oracle/linear.hpp"
#include "oracle/near_segment.hpp"
#include "oracle/point.hpp"
#include "oracle/segment_box.hpp"

namespace detent::accuracy {

// Whether two shapes in the carrier overlap, by the tests' oracles.

namespace exact = detent::oracle;

/// For shapes whose closest points the oracles know.
template <class Shape>
bool meet(const Sphere<Carrier, 3>& sphere, const Shape& shape) {
  const auto near = exact::nearest(as_shape(shape), sphere.center);
  if (!near || sphere.radius < 0) return false;
  const exact::Integer reach = exact::raw(sphere.radius) + near->radius;
  return near->core.squared.over <= reach * reach * near->core.squared.under;
}
template <class Shape>
bool meet(const Shape& shape, const Capsule<Carrier, 3>& capsule) {
  return capsule.radius >= 0 &&
         exact::near_segment(shape, Segment{capsule.a, capsule.b}, exact::raw(capsule.radius));
}
inline bool meet(const Sphere<Carrier, 3>& sphere, const Capsule<Carrier, 3>& capsule) {
  return capsule.radius >= 0 &&
         exact::near_point(Segment{capsule.a, capsule.b}, sphere.center,
                           exact::raw(sphere.radius) + exact::raw(capsule.radius));
}
inline bool meet(const Capsule<Carrier, 3>& a, const Capsule<Carrier, 3>& b) {
  return a.radius >= 0 && b.radius >= 0 &&
         exact::near_segment(Segment{a.a, a.b}, Segment{b.a, b.b},
                             exact::raw(a.radius) + exact::raw(b.radius));
}
/// Compares the distance of their Minkowski difference from 0 with the radius.
inline bool meet(const Capsule<Carrier, 3>& capsule, const Points<Carrier, 3>& hull) {
  const Segment core{capsule.a, capsule.b};
  if (exact::meet(exact::hull_of(as_shape(hull)), exact::hull_of(core))) return true;
  std::vector<exact::Vector<3>> differences;
  for (const auto& point : hull.points) {
    differences.push_back(exact::difference(exact::raw(point), exact::raw(core.start)));
    differences.push_back(exact::difference(exact::raw(point), exact::raw(core.end)));
  }
  const auto near = exact::nearest_outside<3>(differences, {});
  const exact::Integer radius = exact::raw(capsule.radius);
  return near.squared.over <= radius * radius * near.squared.under;
}

inline exact::Hull<3> corners(const Aabb<Carrier, 3>& box) { return exact::hull_of(box); }
inline exact::Hull<3> corners(const Obb<Carrier, 3>& box) { return exact::hull_of(box); }
inline exact::Hull<3> corners(const Triangle<Carrier, 3>& t) { return exact::hull_of(t); }
inline exact::Hull<3> corners(const Segment<Carrier, 3>& s) { return exact::hull_of(s); }
inline exact::Hull<3> corners(const Points<Carrier, 3>& p) { return exact::hull_of(as_shape(p)); }

template <class Shape>
concept Cornered = requires(const Shape& shape) {
  corners(shape);
};

/// Whether there are corners on both sides of the plane or on it.
template <Cornered Shape>
bool meet(const Plane<Carrier, 3>& plane, const Shape& shape) {
  const auto hull = corners(shape);
  const auto normal = exact::widen(exact::raw(plane.normal));
  const exact::Integer one = exact::Integer(1) << unsigned{direction_frac};
  const exact::Integer offset = exact::raw(plane.offset) * one * hull.under;
  bool above = false, below = false;
  for (const auto& corner : hull.over) {
    const int side = exact::Integer(exact::dot(normal, corner) - offset).sign();
    above = above || side >= 0;
    below = below || side <= 0;
  }
  return above && below;
}
template <Cornered Shape>
bool meet(const Shape& shape, const Plane<Carrier, 3>& plane) {
  return meet(plane, shape);
}
template <Cornered A, Cornered B>
bool meet(const A& a, const B& b) {
  return exact::meet(corners(a), corners(b));
}
inline bool meet(const Aabb<Carrier, 3>& a, const Aabb<Carrier, 3>& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.max[i].raw() < b.min[i].raw() || b.max[i].raw() < a.min[i].raw()) return false;
  }
  return true;
}
inline bool meet(const Segment<Carrier, 3>& segment, const Sphere<Carrier, 3>& sphere) {
  return meet(sphere, segment);
}
/// For rays and segments an oriented box is three slabs.
inline bool meet(const Segment<Carrier, 3>& segment, const Obb<Carrier, 3>& box) {
  return exact::meets(segment, box);
}

}  // namespace detent::accuracy
