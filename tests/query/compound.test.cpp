// SPDX-License-Identifier: MIT
#include "detent/shape/compound.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "detent/number/digest.hpp"
#include "detent/query/query.hpp"
#include "oracle/draw.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("compound: without parts it is empty", "[compound]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Compound<Sphere<S, N>, Aabb<S, N>> nothing;
  const Vec<S, N> origin;
  CHECK_FALSE(contains(nothing, origin));
  CHECK_FALSE(on(nothing, origin, largest<S>));
  CHECK_FALSE(overlaps(nothing, Sphere{origin, num<S>(9)}));
  CHECK_FALSE(overlaps(Sphere{origin, num<S>(9)}, nothing));
  CHECK_FALSE(overlaps(nothing, nothing));
  CHECK_FALSE(intersects(Segment{origin, at<S, N>(1)}, nothing));
  CHECK_FALSE(raycast(Ray{origin, toward<S, N>(1)}, nothing));
  CHECK_FALSE(raycast_hit(Ray{origin, toward<S, N>(1)}, nothing));
  CHECK_FALSE(raycast_interval(Ray{origin, toward<S, N>(1)}, nothing));
  CHECK(distance(nothing, origin) == largest<S>);
  CHECK(distance(nothing, nothing) == largest<S>);
  CHECK(distance(Sphere{origin, num<S>(9)}, nothing) == largest<S>);
  CHECK(closest_point(nothing, at<S, N>(1, 2)) == at<S, N>(1, 2));
}

TEMPLATE_TEST_CASE("compound: among equally near parts, the first in the list is returned",
                   "[compound]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const std::array<Sphere<S, N>, 2> spheres{Sphere{at<S, N>(-3), num<S>(1)},
                                            Sphere{at<S, N>(3), num<S>(1)}};
  const std::array<Aabb<S, N>, 1> boxes{Aabb{at<S, N>(-2, 2), at<S, N>(2, 3)}};
  const Compound compound{spheres, boxes};
  CHECK(closest_point(compound, Vec<S, N>()) == at<S, N>(-2));
  CHECK(distance(compound, Vec<S, N>()) == num<S>(2));
  CHECK(closest_point(compound, at<S, N>(0, 1)) == at<S, N>(0, 2));
  CHECK(contains(compound, at<S, N>(3.5)));
  CHECK(on(compound, Vec<S, N>(), num<S>(2)));

  const auto hit = raycast_hit(Ray{at<S, N>(-6), toward<S, N>(1)}, compound);
  REQUIRE(hit);
  CHECK(hit->distance == num<S>(2));
  const auto interval = raycast_interval(Ray{at<S, N>(-6), toward<S, N>(1)}, compound);
  REQUIRE(interval);
  CHECK((interval->enter == num<S>(2) && interval->exit == num<S>(10)));

  // A list may contain compounds.
  const std::array inner{compound};
  CHECK(contains(Compound{inner}, at<S, N>(3.5)));
  CHECK(overlaps(compound, Compound{inner}));
  CHECK(distance(compound, Compound{inner}) == S(0));
  CHECK(distance(Compound{inner}, Aabb{at<S, N>(6), at<S, N>(7)}) == num<S>(2));
  CHECK(digest(compound) != digest(Compound{boxes, spheres}));
}

/// Compares the results of `compound` with those of a loop over all its shapes.
TEMPLATE_TEST_CASE("compound: results equal those of its parts", "[compound]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  oracle::Draw<S, N> draw(0xc0b0);
  INFO(draw.random);
  HitRate rate;
  for (int i = 0; i < 3'000; ++i) {
    const auto scale = draw.scale();
    const auto point = [&] { return draw.vec(draw.point(scale)); };
    const auto size = [&] { return draw.scalar(draw.random.between(-scale / 8, scale / 2)); };
    std::vector<Sphere<S, N>> spheres(draw.random.below(3));
    for (auto& sphere : spheres) sphere = {point(), size()};
    std::vector<Triangle<S, N>> triangles(draw.random.below(3));
    for (auto& triangle : triangles) triangle = {point(), point(), point()};
    const Compound compound{spheres, triangles};
    const auto query = point();
    // Most rays are aimed at one of the shapes.
    const auto origin = draw.point(scale);
    auto target = draw.point(scale);
    if (draw.random.one_in(3)) {
      // at nothing
    } else if (!spheres.empty() && draw.random.coin()) {
      for (int j = 0; j < N; ++j) {
        target[static_cast<std::size_t>(j)] = spheres[0].center[j].raw();
      }
    } else if (!triangles.empty()) {
      const auto& [a, b, c] = triangles[0];
      for (int j = 0; j < N; ++j) {
        target[static_cast<std::size_t>(j)] =
            (std::int64_t{a[j].raw()} + b[j].raw() + c[j].raw()) / 3;
      }
    }
    const Ray<S, N> ray{draw.vec(origin), draw.towards(origin, target)};
    const Segment<S, N> segment{point(), point()};
    const Sphere<S, N> ball{point(), size()};

    bool contained = false, touched = false, crossed = false;
    S least = largest<S>, from_ball = largest<S>;
    std::optional<S> first;
    std::optional<Interval<S>> whole;
    const auto visit = [&](const auto& part) {
      contained = contained || contains(part, query);
      touched = touched || overlaps(ball, part);
      crossed = crossed || intersects(segment, part);
      least = std::min(least, distance(part, query));
      from_ball = std::min(from_ball, distance(part, ball));
      if (const auto interval = raycast_interval(ray, part)) {
        first = first ? std::min(*first, interval->enter) : interval->enter;
        whole = {*first, whole ? std::max(whole->exit, interval->exit) : interval->exit};
      }
    };
    for (const auto& sphere : spheres) visit(sphere);
    for (const auto& triangle : triangles) visit(triangle);
    rate.count(first.has_value());

    const auto hit = raycast_hit(ray, compound);
    const bool right =
        contains(compound, query) == contained && overlaps(compound, ball) == touched &&
        overlaps(ball, compound) == touched && intersects(segment, compound) == crossed &&
        distance(compound, query) == least && distance(compound, ball) == from_ball &&
        distance(ball, compound) == from_ball && raycast(ray, compound) == first &&
        raycast_interval(ray, compound) == whole && hit.has_value() == first.has_value() &&
        (!hit || hit->distance == *first);
    if (!right) FAIL("case " << i);
  }
  INFO(rate);
  CHECK(rate.is_balanced());
}

}  // namespace
}  // namespace detent::test
