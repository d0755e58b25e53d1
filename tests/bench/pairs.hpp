// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "bench/queries.hpp"

namespace detent::bench {

// The measured queries of two solid shapes, in their own sources and in four scalars: each takes
// the compiler two seconds.

template <Scalar S, int N>
using MovingSphere = Moving<S, N, Sphere>;
template <Scalar S, int N>
using MovingObb = Moving<S, N, Obb>;
template <Scalar S, int N>
using MovingCapsule = Moving<S, N, Capsule>;
template <Scalar S, int N>
using MovingRock = Moving<S, N, Rock>;

// Separate functions, compiled once for all loops; compared with such queries a call costs nothing.

inline constexpr auto ask_pair_distance =
    [](const auto& a, const auto& b) __attribute__((noinline)) {
  return distance(as_shape(a), as_shape(b));
};
inline constexpr auto ask_closest_points =
    [](const auto& a, const auto& b) __attribute__((noinline)) {
  return closest_points(as_shape(a), as_shape(b));
};
inline constexpr auto ask_contact = [](const auto& a, const auto& b) __attribute__((noinline)) {
  return contact(as_shape(a), as_shape(b));
};
inline constexpr auto ask_cast =
    [](const auto& moving, const auto& target) __attribute__((noinline)) {
  return cast(as_shape(moving.shape), moving.direction, moving.max_distance, as_shape(target));
};

template <class Visit>
void visit_round_distances(const Visit& visit) {
  visit(query<Sphere, Sphere>("distance/sphere_sphere", ask_pair_distance));
  visit(query<Sphere, Aabb>("distance/sphere_aabb", ask_pair_distance));
  visit(query<Sphere, Obb>("distance/sphere_obb", ask_pair_distance));
  visit(query<Capsule, Triangle>("distance/capsule_triangle", ask_pair_distance));
}
template <class Visit>
void visit_flat_distances(const Visit& visit) {
  visit(query<Aabb, Aabb>("distance/aabb_aabb", ask_pair_distance));
  visit(query<Obb, Obb>("distance/obb_obb", ask_pair_distance));
  visit(query<Obb, Obb, 2>("2D distance/obb_obb", ask_pair_distance));
  visit(query<Rock, Rock>("distance/hull_hull", ask_pair_distance));
}

template <class Visit>
void visit_round_closest_points(const Visit& visit) {
  visit(query<Sphere, Aabb>("closest_points/sphere_aabb", ask_closest_points));
  visit(query<Sphere, Obb>("closest_points/sphere_obb", ask_closest_points));
  visit(query<Capsule, Triangle>("closest_points/capsule_triangle", ask_closest_points));
}
template <class Visit>
void visit_flat_closest_points(const Visit& visit) {
  visit(query<Aabb, Aabb>("closest_points/aabb_aabb", ask_closest_points));
  visit(query<Obb, Obb>("closest_points/obb_obb", ask_closest_points));
  visit(query<Obb, Obb, 2>("2D closest_points/obb_obb", ask_closest_points));
}
template <class Visit>
void visit_hull_closest_points(const Visit& visit) {
  visit(query<Rock, Rock>("closest_points/hull_hull", ask_closest_points));
}

template <class Visit>
void visit_round_contacts(const Visit& visit) {
  visit(query<Sphere, Aabb>("contact/sphere_aabb", ask_contact));
  visit(query<Sphere, Obb>("contact/sphere_obb", ask_contact));
  visit(query<Capsule, Triangle>("contact/capsule_triangle", ask_contact));
}
template <class Visit>
void visit_flat_contacts(const Visit& visit) {
  visit(query<Aabb, Aabb>("contact/aabb_aabb", ask_contact));
  visit(query<Obb, Obb>("contact/obb_obb", ask_contact));
  visit(query<Obb, Obb, 2>("2D contact/obb_obb", ask_contact));
}
template <class Visit>
void visit_hull_contacts(const Visit& visit) {
  visit(query<Rock, Rock>("contact/hull_hull", ask_contact));
}

template <class Visit>
void visit_round_casts(const Visit& visit) {
  visit(query<MovingSphere, Aabb>("cast/sphere_aabb", ask_cast));
  visit(query<MovingSphere, Obb>("cast/sphere_obb", ask_cast));
}
template <class Visit>
void visit_capsule_casts(const Visit& visit) {
  visit(query<MovingCapsule, Triangle>("cast/capsule_triangle", ask_cast));
}
template <class Visit>
void visit_flat_casts(const Visit& visit) {
  visit(query<MovingObb, Obb>("cast/obb_obb", ask_cast));
  visit(query<MovingObb, Obb, 2>("2D cast/obb_obb", ask_cast));
  visit(query<MovingRock, Rock>("cast/hull_hull", ask_cast));
}

}  // namespace detent::bench
