// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>
#include <utility>

#include "calls.hpp"
#include "detent/query/cast.hpp"
#include "detent/query/closest_points.hpp"
#include "shapes.hpp"

// Compares closest points and casts of the C interface with C++ on the cases of `verify`. All pairs
// of kinds take minutes to compile, so ten pairs are compared in which every kind moves and is hit;
// with DETENT_TEST_EVERY_CAST, all pairs.

namespace detent::test_c {

using S = q16_16;
using c::Output;

template <int N, class A, class B>
void check_closest_points(const A& a, const B& b) {
  const auto one = in_c<N>(a), other = in_c<N>(b);
  const auto expected = closest_points(a, b);
  typename c::Types<N>::Vec point_a{}, point_b{};
  REQUIRE(Calls<N>::closest_points(&one, &other, &point_a, &point_b) == DETENT_OK);
  REQUIRE(c::Input<N>::vec(point_a) == expected.first);
  REQUIRE(c::Input<N>::vec(point_b) == expected.second);
}

template <int N, class A, class B>
void check_cast(const A& a, const B& b, const Ray<S, N>& way, Share& share) {
  const auto one = in_c<N>(a), other = in_c<N>(b);
  const auto along = Output<N>::direction(way.direction);
  const auto length = way.max_distance.raw();
  typename c::Types<N>::Hit hit{};
  if constexpr (requires { cast(a, way.direction, way.max_distance, b); }) {
    const auto expected = cast(a, way.direction, way.max_distance, b);
    REQUIRE(Calls<N>::cast(&one, &along, length, &other, &hit) ==
            c::yes_or_no(expected.has_value()));
    REQUIRE(Calls<N>::cast(&one, &along, length, &other, nullptr) ==
            c::yes_or_no(expected.has_value()));
    share.add(expected.has_value());
    if (!expected) return;
    REQUIRE(hit.distance == expected->distance.raw());
    REQUIRE(c::Input<N>::vec(hit.point) == expected->point);
    REQUIRE(c::Input<N>().direction(hit.normal) == expected->normal);
  } else {
    REQUIRE(Calls<N>::cast(&one, &along, length, &other, &hit) == DETENT_NO_QUERY);
  }
}

/// Whether a pair is compared; all of them would take minutes to compile.
constexpr bool is_compared(std::size_t i, std::size_t j) {
#ifdef DETENT_TEST_EVERY_CAST
  return i + j < 100;
#else
  constexpr std::size_t sphere = 0, aabb = 1, obb = 2, plane = 3, segment = 6;
  return i + j == 6 || (i == aabb && j == aabb) || (i == segment && j == obb) ||
         (i == sphere && j == plane);
#endif
}

/// Calls `check(a, b, way)` for pairs of random shapes.
template <int N, class Check>
void check_pairs(std::uint64_t seed, int count, const Check& check) {
  verify::Random random(seed);
  for (int i = 0; i < count; ++i) {
    CAPTURE(N, seed, i);
    Draw<N> draw{verify::ShapeScene<S, N>(random)};
    const auto two = draw.two_of_all();
    const auto way = draw.scene.aimed_ray();
    for_each_pair(two.first, two.second,
                  [&]<std::size_t I, std::size_t J>(const auto& a, const auto& b) {
                    if constexpr (is_compared(I, J)) {
                      CAPTURE(I, J);
                      check(a, b, way);
                    }
                  });
  }
}

}  // namespace detent::test_c
