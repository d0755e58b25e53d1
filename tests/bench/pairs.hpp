// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>

#include "bench/queries.hpp"

namespace detent::bench {

class Suite;

// The measured queries of two solid shapes, in their own sources and in four scalars: each takes
// the compiler several seconds, casts half a minute.

template <Scalar S, int N>
using MovingSphere = Moving<S, N, Sphere>;
template <Scalar S, int N>
using MovingObb = Moving<S, N, Obb>;
template <Scalar S, int N>
using MovingCapsule = Moving<S, N, Capsule>;
template <Scalar S, int N>
using MovingRock = Moving<S, N, Rock>;
template <Scalar S, int N>
using MovingAabb = Moving<S, N, Aabb>;
template <Scalar S, int N>
using MovingTriangle = Moving<S, N, Triangle>;
template <Scalar S, int N>
using MovingSegment = Moving<S, N, Segment>;

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

/// The name of a row, and its golden counts.
struct PairRow {
  std::string_view name;
  Golden golden;
};

/// Calls `visit` with every column.
template <class Visit>
void for_each_column(const Visit& visit) {
  for_each_index<column_count>(visit);
}

/// Visits the query of a shape and that of a column.
template <template <class, int> class Shape, int N, int Column, class Visit, class Ask>
void visit_column(const Visit& visit, const Ask& ask, const PairRow& row) {
  with_shape<Column>([&]<template <class, int> class Other>() {
    visit(query<Shape, Other, N>(row.name, ask, row.golden));
  });
}

// Every pair of `cast`: a table for each moving shape and dimension.

/// The casts of a moving shape: at a sphere, AABB, OBB, capsule, triangle, hull, segment and plane.
template <template <class, int> class Shape, int N>
inline constexpr std::array<PairRow, column_count> cast_rows{};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingSphere, 3>{{
    {"cast/sphere_sphere", {2028, 1976}},
    {"cast/sphere_aabb", {2046, 1999}},
    {"cast/sphere_obb", {2006, 1996}},
    {"cast/sphere_capsule", {2011, 2009}},
    {"cast/sphere_triangle", {2071, 2062}},
    {"cast/sphere_hull", {2077, 2033}},
    {"cast/sphere_segment", {2069, 2039}},
    {"cast/sphere_plane", {2055, 2014}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingSphere, 2>{{
    {"2D cast/sphere_sphere", {2049, 2051}},
    {"2D cast/sphere_aabb", {2027, 2113}},
    {"2D cast/sphere_obb", {1996, 2020}},
    {"2D cast/sphere_capsule", {2026, 2037}},
    {"2D cast/sphere_triangle", {2040, 2022}},
    {"2D cast/sphere_hull", {2059, 2020}},
    {"2D cast/sphere_segment", {2003, 2045}},
    {"2D cast/sphere_plane", {1984, 2029}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingAabb, 3>{{
    {"cast/aabb_sphere", {2019, 2093}},
    {"cast/aabb_aabb", {1985, 2053}},
    {"cast/aabb_obb", {2097, 2005}},
    {"cast/aabb_capsule", {2066, 2047}},
    {"cast/aabb_triangle", {2057, 2042}},
    {"cast/aabb_hull", {2099, 2049}},
    {"cast/aabb_segment", {2069, 2073}},
    {"cast/aabb_plane", {2013, 2052}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingAabb, 2>{{
    {"2D cast/aabb_sphere", {2017, 2014}},
    {"2D cast/aabb_aabb", {1995, 2033}},
    {"2D cast/aabb_obb", {2015, 2026}},
    {"2D cast/aabb_capsule", {2039, 1991}},
    {"2D cast/aabb_triangle", {2072, 2041}},
    {"2D cast/aabb_hull", {2073, 2072}},
    {"2D cast/aabb_segment", {2008, 2161}},
    {"2D cast/aabb_plane", {2013, 1993}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingObb, 3>{{
    {"cast/obb_sphere", {2035, 2029}},
    {"cast/obb_aabb", {2062, 2060}},
    {"cast/obb_obb", {2044, 2082}},
    {"cast/obb_capsule", {2050, 2049}},
    {"cast/obb_triangle", {2083, 2065}},
    {"cast/obb_hull", {2001, 2037}},
    {"cast/obb_segment", {2123, 2070}},
    {"cast/obb_plane", {2070, 2069}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingObb, 2>{{
    {"2D cast/obb_sphere", {2031, 2084}},
    {"2D cast/obb_aabb", {2077, 2047}},
    {"2D cast/obb_obb", {2099, 2025}},
    {"2D cast/obb_capsule", {2097, 2057}},
    {"2D cast/obb_triangle", {2075, 2013}},
    {"2D cast/obb_hull", {2075, 2043}},
    {"2D cast/obb_segment", {2026, 2042}},
    {"2D cast/obb_plane", {2056, 2072}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingTriangle, 3>{{
    {"cast/triangle_sphere", {2050, 2089}},
    {"cast/triangle_aabb", {2090, 2023}},
    {"cast/triangle_obb", {1999, 2029}},
    {"cast/triangle_capsule", {2053, 2054}},
    {"cast/triangle_triangle", {2048, 2094}},
    {"cast/triangle_hull", {2078, 2014}},
    {"cast/triangle_segment", {2120, 2057}},
    {"cast/triangle_plane", {2061, 2072}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingTriangle, 2>{{
    {"2D cast/triangle_sphere", {2000, 2041}},
    {"2D cast/triangle_aabb", {1995, 2084}},
    {"2D cast/triangle_obb", {2031, 2104}},
    {"2D cast/triangle_capsule", {2036, 2002}},
    {"2D cast/triangle_triangle", {1979, 2007}},
    {"2D cast/triangle_hull", {2098, 2047}},
    {"2D cast/triangle_segment", {2045, 2024}},
    {"2D cast/triangle_plane", {2064, 2025}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingCapsule, 3>{{
    {"cast/capsule_sphere", {2067, 2019}},
    {"cast/capsule_aabb", {2110, 2052}},
    {"cast/capsule_obb", {2084, 2052}},
    {"cast/capsule_capsule", {2056, 2013}},
    {"cast/capsule_triangle", {2028, 2002}},
    {"cast/capsule_hull", {2047, 2041}},
    {"cast/capsule_segment", {2037, 2034}},
    {"cast/capsule_plane", {2057, 2065}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingCapsule, 2>{{
    {"2D cast/capsule_sphere", {2099, 2023}},
    {"2D cast/capsule_aabb", {2063, 2024}},
    {"2D cast/capsule_obb", {2061, 2051}},
    {"2D cast/capsule_capsule", {2005, 2039}},
    {"2D cast/capsule_triangle", {2061, 2029}},
    {"2D cast/capsule_hull", {2076, 2044}},
    {"2D cast/capsule_segment", {2060, 2089}},
    {"2D cast/capsule_plane", {2064, 2108}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingRock, 3>{{
    {"cast/hull_sphere", {2064, 2079}},
    {"cast/hull_aabb", {2055, 2020}},
    {"cast/hull_obb", {2018, 2075}},
    {"cast/hull_capsule", {2048, 2064}},
    {"cast/hull_triangle", {2051, 2046}},
    {"cast/hull_hull", {2076, 2025}},
    {"cast/hull_segment", {2087, 2057}},
    {"cast/hull_plane", {2067, 2044}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingRock, 2>{{
    {"2D cast/hull_sphere", {2063, 2062}},
    {"2D cast/hull_aabb", {2044, 2116}},
    {"2D cast/hull_obb", {2019, 2117}},
    {"2D cast/hull_capsule", {2023, 2028}},
    {"2D cast/hull_triangle", {2078, 2091}},
    {"2D cast/hull_hull", {2026, 2073}},
    {"2D cast/hull_segment", {2050, 2030}},
    {"2D cast/hull_plane", {2078, 2031}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingSegment, 3>{{
    {"cast/segment_sphere", {2042, 2103}},
    {"cast/segment_aabb", {2022, 2029}},
    {"cast/segment_obb", {2006, 2038}},
    {"cast/segment_capsule", {2033, 2087}},
    {"cast/segment_triangle", {2114, 2081}},
    {"cast/segment_hull", {2105, 2051}},
    {"cast/segment_segment", {2027, 2070}},
    {"cast/segment_plane", {2054, 2044}},
}};
template <>
inline constexpr std::array<PairRow, column_count> cast_rows<MovingSegment, 2>{{
    {"2D cast/segment_sphere", {2050, 2036}},
    {"2D cast/segment_aabb", {2060, 2056}},
    {"2D cast/segment_obb", {2044, 2066}},
    {"2D cast/segment_capsule", {2046, 2002}},
    {"2D cast/segment_triangle", {2027, 2033}},
    {"2D cast/segment_hull", {2078, 2071}},
    {"2D cast/segment_segment", {2034, 1982}},
    {"2D cast/segment_plane", {2109, 2097}},
}};

/// Visits the cast of a shape at that of a column.
template <template <class, int> class Shape, int N, int Column, class Visit>
void visit_cast(const Visit& visit) {
  visit_column<Shape, N, Column>(visit, ask_cast, cast_rows<Shape, N>[Column]);
}
/// Visits all casts of a shape.
template <template <class, int> class Shape, class Visit>
void visit_casts(const Visit& visit) {
  for_each_column([&]<int Column>() {
    visit_cast<Shape, 3, Column>(visit);
    visit_cast<Shape, 2, Column>(visit);
  });
}

/// Adds one to a suite: casts.cpp, in an object of its own.
template <template <class, int> class Shape, int N, int Column>
void add_cast(Suite& suite);
template <template <class, int> class Shape, int N>
void add_casts(Suite& suite) {
  for_each_column([&]<int Column>() { add_cast<Shape, N, Column>(suite); });
}

}  // namespace detent::bench
