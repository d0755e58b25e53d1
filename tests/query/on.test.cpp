// SPDX-License-Identifier: MIT
#include "detent/query/on.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("on: the tolerance includes its limit", "[on]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto is_near = [](const auto& shape, const Vec<S, N>& point, double tolerance) {
    return on(shape, point, num<S>(tolerance));
  };
  const Segment<S, N> segment{at<S, N>(1, 1), at<S, N>(9, 1)};
  const Plane<S, N> plane{toward<S, N>(0, 1), num<S>(1)};
  const Ray<S, N> ray{at<S, N>(1, 1), toward<S, N>(1), num<S>(8)};
  const Triangle<S, N> triangle{segment.start, segment.end, at<S, N>(1, -9)};
  const Sphere<S, N> sphere{at<S, N>(4, 1), num<S>(2)};
  const Aabb<S, N> aabb{at<S, N>(1, -2), at<S, N>(9, 1)};
  const Obb<S, N> obb{at<S, N>(4, 1), Vec<S, N>(), {}};

  const auto point = at<S, N>(4, 6);
  CHECK(is_near(segment, point, 5));
  CHECK(is_near(plane, point, 5));
  CHECK(is_near(ray, point, 5));
  CHECK(is_near(triangle, point, 5));
  CHECK(is_near(sphere, point, 3));
  CHECK(is_near(aabb, point, 5));
  CHECK(is_near(obb, point, 5));

  CHECK_FALSE(is_near(segment, point, 4.5));
  CHECK_FALSE(is_near(plane, point, 4.5));
  CHECK_FALSE(is_near(ray, point, 4.5));
  CHECK_FALSE(is_near(triangle, point, 4.5));
  CHECK_FALSE(is_near(sphere, point, 2.5));
  CHECK_FALSE(is_near(aabb, point, 4.5));
  CHECK_FALSE(is_near(obb, point, 4.5));
}

TEMPLATE_TEST_CASE("on: exact without a tolerance or with 0", "[on]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Segment<S, N> segment{at<S, N>(1, 1), at<S, N>(9, 1)};
  const Plane<S, N> plane{toward<S, N>(0, 1), num<S>(1)};
  const Ray<S, N> ray{at<S, N>(1, 1), toward<S, N>(1), num<S>(8)};
  const Triangle<S, N> triangle{segment.start, segment.end, at<S, N>(1, -7)};
  const auto check = [](const auto& shape) {
    const auto touching = at<S, N>(4, 1), beside = at<S, N>(4, 1.5);
    CHECK(on(shape, touching));
    CHECK(on(shape, touching, num<S>(0)));
    CHECK_FALSE(on(shape, touching, num<S>(-1)));
    CHECK_FALSE(on(shape, beside));
    CHECK_FALSE(on(shape, beside, num<S>(0)));
  };
  check(segment);
  check(plane);
  check(ray);
  check(triangle);
}

TEMPLATE_TEST_CASE("on: nothing is near an empty shape", "[on]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto origin = Vec<S, N>();
  const auto far = largest<S>;
  CHECK_FALSE(on(Sphere<S, N>{origin, num<S>(-1)}, origin, far));
  CHECK_FALSE(on(Ray<S, N>{origin, toward<S, N>(1), num<S>(-1)}, origin));
  CHECK_FALSE(on(Aabb<S, N>{at<S, N>(1), at<S, N>(0)}, origin, num<S>(100)));
  CHECK_FALSE(on(Obb<S, N>{origin, at<S, N>(0, -1), {}}, origin, num<S>(100)));
  CHECK_FALSE(on(Ray<S, N>{origin, toward<S, N>(1), num<S>(-1)}, origin, num<S>(100)));
}

}  // namespace
}  // namespace detent::test
