// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/query/cast.hpp"
#include "query/shapes_at.hpp"

namespace detent::test {

/// The distance of `cast`; checks that `cast_distance` and a `Cast` agree.
template <class A, class B, Scalar S, int N>
std::optional<S> cast_to(const A& shape, const Direction<S, N>& direction, double most,
                         const B& target) {
  const auto hit = cast(shape, direction, num<S>(most), target);
  CHECK(cast(Cast{shape, direction, num<S>(most)}, target) == hit);
  const auto distance = detail::cast_distance(shape, direction, num<S>(most), target);
  CHECK(distance.has_value() == hit.has_value());
  if (!distance || !hit) return std::nullopt;
  CHECK(*distance == hit->distance);
  CHECK(dot(direction, hit->normal) <= 0);
  return distance;
}

/// Casts `shape`, whose front is at x = -2, along the x axis at shapes in several places.
template <Scalar S, int N, class A>
void check_casts(const A& shape) {
  const auto right = toward<S, N>(1);
  visit_shapes<S, N>(4, [&](const auto& b) {
    CHECK(cast_to(shape, right, 6, b) == num<S>(5));
    CHECK(cast_to(shape, right, 5, b) == num<S>(5));
    CHECK_FALSE(cast_to(shape, right, 4.5, b));
    CHECK_FALSE(cast_to(shape, -right, 9, b));
    CHECK_FALSE(cast_to(shape, toward<S, N>(0, 1), 9, b));
    CHECK_FALSE(cast_to(shape, right, -1, b));
  });
  // Touching or overlapping at the start.
  for (const double x : {-1.0, -2.5}) {
    visit_shapes<S, N>(x, [&](const auto& b) {
      CHECK(cast_to(shape, right, 9, b) == S(0));
      const auto hit = cast(shape, -right, S(0), b);
      CHECK((hit && hit->distance == S(0) && hit->normal == right));
    });
  }
  for (const bool flipped : {false, true}) {
    const Plane<S, N> plane{flipped ? -right : right, num<S>(flipped ? -4 : 4)};
    const auto hit = cast(shape, right, num<S>(8), plane);
    REQUIRE(hit);
    CHECK(hit->distance == num<S>(6));
    CHECK(hit->normal == -right);
    CHECK(hit->point.x == num<S>(4));
    CHECK_FALSE(cast_to(shape, right, 5.5, plane));
    CHECK_FALSE(cast_to(shape, -right, 9, plane));
    CHECK_FALSE(cast_to(shape, toward<S, N>(0, 1), 9, plane));
  }
}

}  // namespace detent::test
