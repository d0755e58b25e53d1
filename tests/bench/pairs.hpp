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
  visit(query<Sphere, Sphere>("distance/sphere_sphere", ask_pair_distance, {2055, 2032}));
  visit(query<Sphere, Aabb>("distance/sphere_aabb", ask_pair_distance, {2063, 2009}));
  visit(query<Sphere, Obb>("distance/sphere_obb", ask_pair_distance, {2040, 2040}));
  visit(query<Capsule, Triangle>("distance/capsule_triangle", ask_pair_distance, {2015, 2034}));
}
template <class Visit>
void visit_flat_distances(const Visit& visit) {
  visit(query<Aabb, Aabb>("distance/aabb_aabb", ask_pair_distance, {1977, 2032}));
  visit(query<Obb, Obb>("distance/obb_obb", ask_pair_distance, {2060, 2025}));
  visit(query<Obb, Obb, 2>("2D distance/obb_obb", ask_pair_distance, {2025, 1997}));
  visit(query<Rock, Rock>("distance/hull_hull", ask_pair_distance, {2043, 1985}));
}

template <class Visit>
void visit_round_closest_points(const Visit& visit) {
  visit(query<Sphere, Aabb>("closest_points/sphere_aabb", ask_closest_points, {2063, 2011}));
  visit(query<Sphere, Obb>("closest_points/sphere_obb", ask_closest_points, {2040, 2048}));
  visit(query<Capsule, Triangle>("closest_points/capsule_triangle", ask_closest_points,
                                 {2015, 2035}));
}
template <class Visit>
void visit_flat_closest_points(const Visit& visit) {
  visit(query<Aabb, Aabb>("closest_points/aabb_aabb", ask_closest_points, {1977, 2032}));
  visit(query<Obb, Obb>("closest_points/obb_obb", ask_closest_points, {2053, 2007}));
  visit(query<Obb, Obb, 2>("2D closest_points/obb_obb", ask_closest_points, {2025, 2003}));
}
template <class Visit>
void visit_hull_closest_points(const Visit& visit) {
  visit(query<Rock, Rock>("closest_points/hull_hull", ask_closest_points, {2043, 1991}));
}

template <class Visit>
void visit_round_contacts(const Visit& visit) {
  visit(query<Sphere, Aabb>("contact/sphere_aabb", ask_contact, {2141, 2055}));
  visit(query<Sphere, Obb>("contact/sphere_obb", ask_contact, {2075, 2045}));
  visit(query<Capsule, Triangle>("contact/capsule_triangle", ask_contact, {2061, 2078}));
}
template <class Visit>
void visit_flat_contacts(const Visit& visit) {
  visit(query<Aabb, Aabb>("contact/aabb_aabb", ask_contact, {2116, 2093}));
  visit(query<Obb, Obb>("contact/obb_obb", ask_contact, {2043, 2083}));
  visit(query<Obb, Obb, 2>("2D contact/obb_obb", ask_contact, {1998, 2081}));
}
template <class Visit>
void visit_hull_contacts(const Visit& visit) {
  visit(query<Rock, Rock>("contact/hull_hull", ask_contact, {2046, 2074}));
}

template <class Visit>
void visit_round_casts(const Visit& visit) {
  visit(query<MovingSphere, Aabb>("cast/sphere_aabb", ask_cast, {2046, 1999}));
  visit(query<MovingSphere, Obb>("cast/sphere_obb", ask_cast, {2006, 1996}));
}
template <class Visit>
void visit_capsule_casts(const Visit& visit) {
  visit(query<MovingCapsule, Triangle>("cast/capsule_triangle", ask_cast, {2028, 2002}));
}
template <class Visit>
void visit_flat_casts(const Visit& visit) {
  visit(query<MovingObb, Obb>("cast/obb_obb", ask_cast, {2044, 2082}));
  visit(query<MovingObb, Obb, 2>("2D cast/obb_obb", ask_cast, {2099, 2025}));
  visit(query<MovingRock, Rock>("cast/hull_hull", ask_cast, {2076, 2025}));
}

}  // namespace detent::bench
