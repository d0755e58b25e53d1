// SPDX-License-Identifier: MIT
#pragma once

#include "bench/question.hpp"

namespace detent::bench {

// The measured queries. To add one, add a line here and one in golden.hpp.

template <Scalar S, int N>
using Point = Vec<S, N>;

inline constexpr auto ask_raycast = [](const auto& ray, const auto& shape) {
  return raycast(as_shape(ray), as_shape(shape));
};
inline constexpr auto ask_raycast_hit = [](const auto& ray, const auto& shape) {
  return raycast_hit(as_shape(ray), as_shape(shape));
};
inline constexpr auto ask_raycast_interval = [](const auto& ray, const auto& shape) {
  return raycast_interval(as_shape(ray), as_shape(shape));
};
inline constexpr auto ask_contains = [](const auto& shape, const auto& point) {
  return contains(as_shape(shape), as_shape(point));
};
inline constexpr auto ask_closest_point = [](const auto& shape, const auto& point) {
  return closest_point(as_shape(shape), as_shape(point));
};
inline constexpr auto ask_distance = [](const auto& shape, const auto& point) {
  return distance(as_shape(shape), as_shape(point));
};
inline constexpr auto ask_overlaps = [](const auto& a, const auto& b) {
  return overlaps(as_shape(a), as_shape(b));
};
inline constexpr auto ask_intersects = [](const auto& segment, const auto& shape) {
  return intersects(as_shape(segment), as_shape(shape));
};

template <class Visit, class Ask = decltype(ask_raycast)>
void visit_solid_raycasts(const Visit& visit, const Ask& ask = ask_raycast) {
  visit(query<Ray, Sphere>("raycast/sphere", ask));
  visit(query<Ray, Aabb>("raycast/aabb", ask));
  visit(query<Ray, Obb>("raycast/obb", ask));
  visit(query<Ray, Plane>("raycast/plane", ask));
  visit(query<Ray, Triangle>("raycast/triangle", ask));
  visit(query<Ray, Capsule>("raycast/capsule", ask));
}
template <class Visit>
void visit_raycasts(const Visit& visit) {
  visit_solid_raycasts(visit);
  visit(query<Ray, Segment>("raycast/segment", ask_raycast));
  visit(query<Ray, Rock>("raycast/hull", ask_raycast));
}

// With normals, and both ends.
template <class Visit>
void visit_raycast_hits(const Visit& visit) {
  visit(query<Ray, Sphere>("raycast_hit/sphere", ask_raycast_hit));
  visit(query<Ray, Aabb>("raycast_hit/aabb", ask_raycast_hit));
  visit(query<Ray, Obb>("raycast_hit/obb", ask_raycast_hit));
  visit(query<Ray, Plane>("raycast_hit/plane", ask_raycast_hit));
  visit(query<Ray, Triangle>("raycast_hit/triangle", ask_raycast_hit));
  visit(query<Ray, Capsule>("raycast_hit/capsule", ask_raycast_hit));
  visit(query<Ray, Segment>("raycast_hit/segment", ask_raycast_hit));
  visit(query<Ray, Rock>("raycast_hit/hull", ask_raycast_hit));
  visit(query<Ray, Sphere>("raycast_interval/sphere", ask_raycast_interval));
  visit(query<Ray, Aabb>("raycast_interval/aabb", ask_raycast_interval));
  visit(query<Ray, Obb>("raycast_interval/obb", ask_raycast_interval));
}

template <class Visit>
void visit_contains(const Visit& visit) {
  visit(query<Sphere, Point>("contains/sphere", ask_contains));
  visit(query<Aabb, Point>("contains/aabb", ask_contains));
  visit(query<Obb, Point>("contains/obb", ask_contains));
  visit(query<Plane, Point>("contains/plane", ask_contains));
  visit(query<Triangle, Point>("contains/triangle", ask_contains));
  visit(query<Capsule, Point>("contains/capsule", ask_contains));
  visit(query<Rock, Point>("contains/hull", ask_contains));
  visit(query<Segment, Point>("contains/segment", ask_contains));
  visit(query<Ray, Point>("contains/ray", ask_contains));
}

template <class Visit>
void visit_closest_points(const Visit& visit) {
  visit(query<Sphere, Point>("closest_point/sphere", ask_closest_point));
  visit(query<Aabb, Point>("closest_point/aabb", ask_closest_point));
  visit(query<Obb, Point>("closest_point/obb", ask_closest_point));
  visit(query<Plane, Point>("closest_point/plane", ask_closest_point));
  visit(query<Triangle, Point>("closest_point/triangle", ask_closest_point));
  visit(query<Capsule, Point>("closest_point/capsule", ask_closest_point));
  visit(query<Rock, Point>("closest_point/hull", ask_closest_point));
  visit(query<Segment, Point>("closest_point/segment", ask_closest_point));
  visit(query<Ray, Point>("closest_point/ray", ask_closest_point));
}

template <class Visit>
void visit_distances(const Visit& visit) {
  visit(query<Point, Point>("distance/point", ask_distance));
  visit(query<Sphere, Point>("distance/sphere", ask_distance));
  visit(query<Aabb, Point>("distance/aabb", ask_distance));
  visit(query<Obb, Point>("distance/obb", ask_distance));
  visit(query<Plane, Point>("distance/plane", ask_distance));
  visit(query<Triangle, Point>("distance/triangle", ask_distance));
  visit(query<Capsule, Point>("distance/capsule", ask_distance));
  visit(query<Rock, Point>("distance/hull", ask_distance));
  visit(query<Segment, Point>("distance/segment", ask_distance));
  visit(query<Ray, Point>("distance/ray", ask_distance));
}

template <class Visit, class Ask = decltype(ask_overlaps)>
void visit_sphere_overlaps(const Visit& visit, const Ask& ask = ask_overlaps) {
  visit(query<Sphere, Sphere>("overlaps/sphere_sphere", ask));
  visit(query<Sphere, Aabb>("overlaps/sphere_aabb", ask));
  visit(query<Sphere, Obb>("overlaps/sphere_obb", ask));
  visit(query<Sphere, Plane>("overlaps/sphere_plane", ask));
  visit(query<Sphere, Triangle>("overlaps/sphere_triangle", ask));
  visit(query<Sphere, Capsule>("overlaps/sphere_capsule", ask));
}

template <class Visit, class Ask = decltype(ask_overlaps)>
void visit_box_overlaps(const Visit& visit, const Ask& ask = ask_overlaps) {
  visit(query<Aabb, Aabb>("overlaps/aabb_aabb", ask));
  visit(query<Aabb, Obb>("overlaps/aabb_obb", ask));
  visit(query<Aabb, Plane>("overlaps/aabb_plane", ask));
  visit(query<Aabb, Triangle>("overlaps/aabb_triangle", ask));
  visit(query<Aabb, Capsule>("overlaps/aabb_capsule", ask));
  visit(query<Obb, Obb>("overlaps/obb_obb", ask));
  visit(query<Obb, Plane>("overlaps/obb_plane", ask));
  visit(query<Obb, Triangle>("overlaps/obb_triangle", ask));
  visit(query<Obb, Capsule>("overlaps/obb_capsule", ask));
}

template <class Visit, class Ask = decltype(ask_overlaps)>
void visit_other_overlaps(const Visit& visit, const Ask& ask = ask_overlaps) {
  visit(query<Plane, Plane>("overlaps/plane_plane", ask));
  visit(query<Plane, Triangle>("overlaps/plane_triangle", ask));
  visit(query<Plane, Capsule>("overlaps/plane_capsule", ask));
  visit(query<Triangle, Triangle>("overlaps/triangle_triangle", ask));
  visit(query<Triangle, Capsule>("overlaps/triangle_capsule", ask));
  visit(query<Capsule, Capsule>("overlaps/capsule_capsule", ask));
}

template <class Visit>
void visit_hulls(const Visit& visit) {
  visit(query<Sphere, Rock>("overlaps/sphere_hull", ask_overlaps));
  visit(query<Aabb, Rock>("overlaps/aabb_hull", ask_overlaps));
  visit(query<Obb, Rock>("overlaps/obb_hull", ask_overlaps));
  visit(query<Plane, Rock>("overlaps/plane_hull", ask_overlaps));
  visit(query<Triangle, Rock>("overlaps/triangle_hull", ask_overlaps));
  visit(query<Capsule, Rock>("overlaps/capsule_hull", ask_overlaps));
  visit(query<Rock, Rock>("overlaps/hull_hull", ask_overlaps));
  visit(query<Segment, Rock>("intersects/hull", ask_intersects));
}

// Circles, rectangles, lines and triangles in 2D.
template <class Visit>
void visit_planar(const Visit& visit) {
  visit(query<Ray, Sphere, 2>("2D raycast/sphere", ask_raycast));
  visit(query<Ray, Aabb, 2>("2D raycast/aabb", ask_raycast));
  visit(query<Ray, Obb, 2>("2D raycast/obb", ask_raycast));
  visit(query<Ray, Plane, 2>("2D raycast/plane", ask_raycast));
  visit(query<Ray, Triangle, 2>("2D raycast/triangle", ask_raycast));
  visit(query<Ray, Capsule, 2>("2D raycast/capsule", ask_raycast));
  visit(query<Sphere, Sphere, 2>("2D overlaps/sphere_sphere", ask_overlaps));
  visit(query<Sphere, Aabb, 2>("2D overlaps/sphere_aabb", ask_overlaps));
  visit(query<Aabb, Aabb, 2>("2D overlaps/aabb_aabb", ask_overlaps));
  visit(query<Obb, Obb, 2>("2D overlaps/obb_obb", ask_overlaps));
  visit(query<Triangle, Triangle, 2>("2D overlaps/triangle_triangle", ask_overlaps));
  visit(query<Capsule, Capsule, 2>("2D overlaps/capsule_capsule", ask_overlaps));
  visit(query<Triangle, Point, 2>("2D contains/triangle", ask_contains));
  visit(query<Obb, Point, 2>("2D closest_point/obb", ask_closest_point));
  visit(query<Segment, Point, 2>("2D distance/segment", ask_distance));
  visit(query<Segment, Segment, 2>("2D intersects/segment", ask_intersects));
}

template <class Visit>
void visit_intersects(const Visit& visit) {
  visit(query<Segment, Sphere>("intersects/sphere", ask_intersects));
  visit(query<Segment, Aabb>("intersects/aabb", ask_intersects));
  visit(query<Segment, Obb>("intersects/obb", ask_intersects));
  visit(query<Segment, Plane>("intersects/plane", ask_intersects));
  visit(query<Segment, Triangle>("intersects/triangle", ask_intersects));
  visit(query<Segment, Capsule>("intersects/capsule", ask_intersects));
  visit(query<Segment, Segment>("intersects/segment", ask_intersects));
}

}  // namespace detent::bench
