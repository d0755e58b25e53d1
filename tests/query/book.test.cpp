// SPDX-License-Identifier: MIT
//
// Point, pair and segment queries that textbook float code gets wrong, though float represents
// every input. The ray queries are in raycast/book.test.cpp.

#include <array>
#include <cmath>

#include "detent/query/intersection.hpp"
#include "detent/query/query.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

template <class S>
constexpr auto v(double x, double y = 0, double z = 0) {
  return at<S, 3>(x, y, z);
}

TEMPLATE_TEST_CASE("book: a point next to a ray, far from its origin, is not on it", "[book]",
                   q16_16, q24_8, double) {
  using S = TestType;
  const Ray<S, 3> ray{Vec<S, 3>(), Direction<S, 3>::along(2)};
  CHECK_FALSE(on(ray, v<S>(4, 0, 10000)));
  CHECK(on(ray, v<S>(0, 0, 10000)));
}

TEMPLATE_TEST_CASE("book: a segment inside a box intersects it", "[book]", q16_16, q14_16, q24_8,
                   q8_8, float, double) {
  using S = TestType;
  const Aabb<S, 3> box{v<S>(-2, -2, -2), v<S>(2, 2, 2)};
  const Obb<S, 3> same{Vec<S, 3>(), v<S>(2, 2, 2), {}};
  for (const auto& segment : {Segment{v<S>(-1), v<S>(1)}, Segment{v<S>(1, 1, 1), v<S>(1, 1, 1)}}) {
    CHECK(intersects(segment, box));
    CHECK(intersects(segment, same));
  }
}

TEMPLATE_TEST_CASE("book: a collapsed triangle touches what its segment touches", "[book]", q16_16,
                   q14_16, q24_8, q8_8, float, double) {
  using S = TestType;
  const Triangle<S, 3> collapsed{v<S>(-1), v<S>(0), v<S>(1)};
  CHECK(overlaps(collapsed, Sphere{v<S>(0, 0.5), num<S>(1)}));
  CHECK(overlaps(collapsed, Sphere{v<S>(0, 1), num<S>(1)}));
  CHECK_FALSE(overlaps(collapsed, Sphere{v<S>(0, 1.5), num<S>(1)}));
}

TEMPLATE_TEST_CASE("book: closest points are on the shape, and an inside point is its own",
                   "[book]", q16_16, q14_16, q24_8, q8_8, float, double) {
  using S = TestType;
  CHECK(closest_point(Triangle{v<S>(0, 1), v<S>(0), v<S>(1)}, v<S>(5)) == v<S>(1));
  CHECK(closest_point(Aabb{v<S>(-1, -5, -1), v<S>(1, 5, 1)}, v<S>(0, 3)) == v<S>(0, 3));
}

TEMPLATE_TEST_CASE("book: small triangles five units apart do not overlap", "[book]", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  const auto at_height = [](double z) {
    return Triangle{v<S>(0, 0, z), v<S>(1.0 / 256, 0, z), v<S>(0, 1.0 / 256, z)};
  };
  CHECK_FALSE(overlaps(at_height(0), at_height(5)));
  CHECK(overlaps(at_height(0), at_height(0)));
}

TEMPLATE_TEST_CASE("book: two boxes a thousand units apart do not overlap", "[book]", q16_16,
                   q14_16, q24_8, float, double) {
  using S = TestType;
  const auto box_at = [](double x) { return Obb<S, 3>{v<S>(x), v<S>(1, 1, 1), {}}; };
  CHECK_FALSE(overlaps(box_at(0), box_at(1000)));
  CHECK(overlaps(box_at(0), box_at(2)));
}

TEMPLATE_TEST_CASE("book: the nearer of two triangles is hit, in either order", "[book]", q16_16,
                   q14_16, q24_8, q8_8, float, double) {
  using S = TestType;
  const auto at_height = [](double z) {
    return Triangle{v<S>(-1, -1, z), v<S>(1, -1, z), v<S>(0, 2, z)};
  };
  const std::array far_first{at_height(10), at_height(5)};
  const Ray<S, 3> ray{Vec<S, 3>(), Direction<S, 3>::along(2)};
  CHECK(raycast(ray, Compound{far_first}) == num<S>(5));
}

TEMPLATE_TEST_CASE("book: three planes intersect in their common point", "[book]", q16_16, q14_16,
                   q24_8, q8_8, float, double) {
  using S = TestType;
  const auto plane = [](int axis, double offset) {
    return Plane{Direction<S, 3>::along(axis), num<S>(offset)};
  };
  CHECK(intersection(plane(0, 1), plane(1, 2), plane(2, 3)) == v<S>(1, 2, 3));
}

// A fixed half unit would be wrong.
TEMPLATE_TEST_CASE("book: two unit spheres overlap by two minus the distance", "[book]", q16_16,
                   q14_16, float, double) {
  using S = TestType;
  const Sphere<S, 3> unit{Vec<S, 3>(), num<S>(1)};
  const auto depth = [&](double apart) {
    const Sphere<S, 3> other{v<S>(0, apart), num<S>(1)};
    CHECK(overlaps(unit, other));
    const auto lacking = unit.radius + other.radius - distance(unit.center, other.center);
    return static_cast<double>(lacking);
  };
  const auto is_near = [](double x, double y) { return std::abs(x - y) < 1.0 / 65536; };
  CHECK(is_near(depth(1.999), 0.001));
  CHECK(depth(1.5) == 0.5);
  CHECK(is_near(depth(0.1), 1.9));
}

}  // namespace
}  // namespace detent::test
