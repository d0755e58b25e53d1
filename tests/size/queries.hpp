// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "bench/queries.hpp"

namespace detent::size {

using bench::query;

/// The number of inputs per query on a microcontroller: as many as its flash holds.
inline constexpr int question_count = 64;

inline constexpr auto ask_raycast = [](const auto& ray, const auto& shape) {
  return raycast(ray, shape);
};
inline constexpr auto ask_overlaps = [](const auto& a, const auto& b) { return overlaps(a, b); };
inline constexpr auto ask_distance = [](const auto& a, const auto& b) { return distance(a, b); };
inline constexpr auto ask_closest_points = [](const auto& a, const auto& b) {
  return closest_points(a, b);
};
inline constexpr auto ask_contact = [](const auto& a, const auto& b) { return contact(a, b); };
inline constexpr auto ask_cast = [](const auto& moving, const auto& target) {
  return cast(moving.shape, moving.direction, moving.max_distance, target);
};

// The measured queries, in groups small enough for one program each.

template <class Visit>
void visit_raycasts(const Visit& visit) {
  bench::visit_solid_raycasts(visit, ask_raycast);
}
template <class Visit>
void visit_spheres(const Visit& visit) {
  bench::visit_sphere_overlaps(visit, ask_overlaps);
}
template <class Visit>
void visit_boxes(const Visit& visit) {
  bench::visit_box_overlaps(visit, ask_overlaps);
}
template <class Visit>
void visit_others(const Visit& visit) {
  bench::visit_other_overlaps(visit, ask_overlaps);
}

// Queries of two shapes.

template <class Visit>
void visit_distances(const Visit& visit) {
  visit(query<Sphere, Obb>("distance/sphere_obb", ask_distance));
  visit(query<Obb, Obb>("distance/obb_obb", ask_distance));
}

template <class Visit>
void visit_closest_points(const Visit& visit) {
  visit(query<Sphere, Obb>("closest_points/sphere_obb", ask_closest_points));
  visit(query<Obb, Obb>("closest_points/obb_obb", ask_closest_points));
}

template <class Visit>
void visit_contacts(const Visit& visit) {
  visit(query<Sphere, Aabb>("contact/sphere_aabb", ask_contact));
  visit(query<Obb, Obb>("contact/obb_obb", ask_contact));
}

template <Scalar S, int N>
using MovingSphere = bench::Moving<S, N, Sphere>;
template <Scalar S, int N>
using MovingCapsule = bench::Moving<S, N, Capsule>;

template <class Visit>
void visit_casts(const Visit& visit) {
  visit(query<MovingSphere, Aabb>("cast/sphere_aabb", ask_cast));
  visit(query<MovingCapsule, Triangle>("cast/capsule_triangle", ask_cast));
}

/// Storage for `count` inputs, padded to whole words.
template <class Question>
inline constexpr std::size_t size_of_questions = (sizeof(Question) * question_count + 3) / 4 * 4;

/// A number or bool as 32 bits.
template <class T>
constexpr std::uint32_t pattern_of(const T& x) {
  if constexpr (is_fixed<T>) {
    return static_cast<std::uint32_t>(x.raw());
  } else if constexpr (std::is_same_v<T, float>) {
    return std::bit_cast<std::uint32_t>(x);
  } else {
    return static_cast<std::uint32_t>(x);
  }
}

/// The results of some queries, for comparing machines.
struct Tally {
  std::uint32_t hits = 0;
  std::uint32_t digest = 2166136261;

  constexpr void operator()(bool answer) {
    hits += answer ? 1 : 0;
    add(answer);
  }
  template <Scalar S>
  constexpr void operator()(const S& distance) {
    (*this)(distance > 0);
    add(distance);
  }
  template <Scalar S>
  constexpr void operator()(const std::pair<Vec<S, 3>, Vec<S, 3>>& points) {
    (*this)(points.first != points.second);
    add(points.first);
    add(points.second);
  }
  template <class T>
  constexpr void operator()(const std::optional<T>& answer) {
    (*this)(answer.has_value());
    if (answer) add(*answer);
  }

 private:
  template <class T>
  constexpr void add(const T& x) {
    digest = (digest ^ pattern_of(x)) * 16777619;
  }
  template <Number T>
  constexpr void add(const Vec<T, 3>& v) {
    for (int i = 0; i < 3; ++i) add(v[i]);
  }
  template <Scalar S>
  constexpr void add(const Contact<S, 3>& contact) {
    add(contact.normal.vec());
    add(contact.depth);
    add(static_cast<std::uint32_t>(contact.count));
    for (std::size_t i = 0; i < contact.count; ++i) add(contact.points[i].point);
  }
  template <Scalar S>
  constexpr void add(const CastHit<S, 3>& hit) {
    add(hit.distance);
    add(hit.point);
    add(hit.normal.vec());
  }
};

}  // namespace detent::size
