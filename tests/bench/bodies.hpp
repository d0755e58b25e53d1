// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "bench/question.hpp"

namespace detent::bench {

class Suite;

// Two moving bodies, and shapes at a mesh. CMakeLists.txt compiles each row in an object of its own:
// they take the compiler as long as those of pairs.hpp.

template <Scalar S, int N>
using SweptSphere = Swept<S, N, Sphere>;
template <Scalar S, int N>
using SweptObb = Swept<S, N, Obb>;
template <Scalar S, int N>
using SweptCapsule = Swept<S, N, Capsule>;
template <Scalar S, int N>
using SweptRock = Swept<S, N, Rock>;

inline constexpr auto ask_impact = [](const auto& a, const auto& b) __attribute__((noinline)) {
  if constexpr (requires { b.sweep; }) {
    return time_of_impact(as_shape(a.shape), a.sweep, as_shape(b.shape), b.sweep);
  } else {
    return time_of_impact(as_shape(a.shape), a.sweep, b);
  }
};
/// Whether there are any.
inline constexpr auto ask_mesh_contacts =
    []<Scalar S, int N>(const Terrain<S, N>& terrain, const auto& shape) __attribute__((noinline)) {
  std::array<MeshContact<S>, 16> found;
  return contacts(terrain.mesh, shape, found) > 0;
};
inline constexpr auto ask_mesh_distance =
    [](const auto& terrain, const auto& shape) __attribute__((noinline)) {
  return distance(terrain.mesh, shape);
};

/// Visits the query of a row.
template <int Row, class Visit>
void visit_body(const Visit& visit) {
  if constexpr (Row == 0) {
    visit(
        query<SweptSphere, SweptSphere>("time_of_impact/sphere_sphere", ask_impact, {2069, 2041}));
  } else if constexpr (Row == 1) {
    visit(query<SweptObb, SweptObb>("time_of_impact/obb_obb", ask_impact, {1966, 2011}));
  } else if constexpr (Row == 2) {
    visit(query<SweptObb, SweptCapsule>("time_of_impact/obb_capsule", ask_impact, {2078, 2058}));
  } else if constexpr (Row == 3) {
    visit(query<SweptRock, SweptRock>("time_of_impact/hull_hull", ask_impact, {2016, 2027}));
  } else if constexpr (Row == 4) {
    visit(query<SweptObb, Plane>("time_of_impact/obb_plane", ask_impact, {2065, 2043}));
  } else if constexpr (Row == 5) {
    visit(query<SweptObb, SweptObb, 2>("2D time_of_impact/obb_obb", ask_impact, {2074, 2062}));
  } else if constexpr (Row == 6) {
    visit(query<Terrain, Sphere>("contacts/mesh_sphere", ask_mesh_contacts, {2092, 2061}));
  } else if constexpr (Row == 7) {
    visit(query<Terrain, Capsule>("contacts/mesh_capsule", ask_mesh_contacts, {2032, 2071}));
  } else if constexpr (Row == 8) {
    visit(query<Terrain, Obb>("contacts/mesh_obb", ask_mesh_contacts, {2043, 2055}));
  } else if constexpr (Row == 9) {
    visit(query<Terrain, Sphere>("distance/mesh_sphere", ask_mesh_distance, {2015, 2060}));
  } else if constexpr (Row == 10) {
    visit(query<Terrain, Capsule>("distance/mesh_capsule", ask_mesh_distance, {2045, 2051}));
  } else if constexpr (Row == 11) {
    visit(query<Terrain, Obb>("distance/mesh_obb", ask_mesh_distance, {2111, 2050}));
  }
}
inline constexpr int body_row_count = 12;

/// Visits all rows.
template <class Visit>
void visit_bodies(const Visit& visit) {
  for_each_index<body_row_count>([&]<int Row>() { visit_body<Row>(visit); });
}

/// Adds a row to a suite: bodies.cpp, in an object of its own.
template <int Row>
void add_body(Suite& suite);
inline void add_bodies(Suite& suite) {
  for_each_index<body_row_count>([&]<int Row>() { add_body<Row>(suite); });
}

}  // namespace detent::bench
