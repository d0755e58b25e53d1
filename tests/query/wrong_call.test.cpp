// SPDX-License-Identifier: MIT
#include "detent/query/wrong_call.hpp"

#include <array>

#include "detent/query/query.hpp"
#include "query/shapes_at.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace detent;

namespace {

template <class A, class B>
concept Overlapping = requires(const A& a, const B& b) {
  { overlaps(a, b) } -> std::same_as<bool>;
};
template <class A, class B>
concept Asked = requires(const A& a, const B& b) {
  overlaps(a, b);
};
template <class A, class B>
concept Containing = requires(const A& a, const B& b) {
  contains(a, b);
};
template <class A, class B>
concept Intersecting = requires(const A& a, const B& b) {
  intersects(a, b);
};
template <class A, class B>
concept Casting = requires(const A& a, const B& b) {
  raycast(a, b);
};
template <class A, class B>
concept Distant = requires(const A& a, const B& b) {
  distance(a, b);
};

template <template <Scalar, int> class Shape, Scalar S, int N>
constexpr bool takes_right_calls_only(const Shape<S, N>&) {
  using Ball = Sphere<S, N>;
  using Bar = Segment<S, N>;
  using Line = Ray<S, N>;
  using Point = Vec<S, N>;
  using Body = Shape<S, N>;
  using Other = Shape<std::conditional_t<std::same_as<S, q8_8>, q16_16, q8_8>, N>;
  using Flat = Shape<S, 5 - N>;
  return Overlapping<Body, Ball> && Overlapping<Ball, Body> && !Asked<Body, Line> &&
         !Asked<Point, Body> && !Asked<Body, Bar> && !Asked<Body, Other> && !Asked<Flat, Body> &&
         Containing<Body, Point> && !Containing<Point, Body> && !Containing<Other, Point> &&
         Intersecting<Bar, Body> && Intersecting<Body, Bar> && !Intersecting<Body, Ball> &&
         !Intersecting<Line, Body> && !Intersecting<Bar, Other> && Casting<Line, Body> &&
         !Casting<Body, Line> && !Casting<Line, Other> && !Casting<Line, Point> &&
         Distant<Body, Point> && Distant<Point, Point> && !Distant<Point, Body> &&
         !Distant<Other, Point> && Distant<Body, Ball> && Distant<Bar, Body> &&
         !Distant<Body, Line> && !Distant<Other, Body>;
}

template <Scalar S, int N>
constexpr bool all_take_right_calls_only() {
  bool are_right = takes_right_calls_only(ConvexHull<S, N>());
  support::SceneShapes<S, N>::for_each(
      [&](const auto& shape) { are_right = are_right && takes_right_calls_only(shape); });
  return are_right;
}

TEMPLATE_TEST_CASE("wrong calls: they do not compile, and all correct calls do", "[query]", q8_8,
                   q16_16, float) {
  STATIC_REQUIRE(all_take_right_calls_only<TestType, 2>());
  STATIC_REQUIRE(all_take_right_calls_only<TestType, 3>());
}

template <Scalar S>
constexpr bool frusta_take_right_calls_only() {
  using Body = Frustum<S>;
  using Other = Frustum<std::conditional_t<std::same_as<S, q8_8>, q16_16, q8_8>>;
  using Ball = Sphere<S, 3>;
  using Disc = Sphere<S, 2>;
  using Bar = Segment<S, 3>;
  using Line = Ray<S, 3>;
  using Point = Vec<S, 3>;
  return Overlapping<Body, Ball> && Overlapping<Ball, Body> && Overlapping<Body, Body> &&
         !Asked<Body, Line> && !Asked<Point, Body> && !Asked<Body, Bar> && !Asked<Body, Other> &&
         !Asked<Disc, Body> && Containing<Body, Point> && !Containing<Point, Body> &&
         !Containing<Other, Point> && Intersecting<Bar, Body> && Intersecting<Body, Bar> &&
         !Intersecting<Body, Ball> && !Intersecting<Bar, Other> && Casting<Line, Body> &&
         !Casting<Body, Line> && !Casting<Line, Other> && Distant<Body, Point> &&
         !Distant<Point, Body>;
}

TEMPLATE_TEST_CASE("wrong calls: with a frustum as well", "[query]", q8_8, q16_16, float) {
  STATIC_REQUIRE(frusta_take_right_calls_only<TestType>());
}

TEMPLATE_TEST_CASE("intersects: takes a segment and a shape in either order", "[query]", q16_16,
                   float) {
  using S = TestType;
  using Point = Vec<S, 3>;
  const auto at = [](int x, int y, int z) { return Point{S(x), S(y), S(z)}; };
  const std::array balls{Sphere{at(0, 0, 0), S(1)}};
  const Segment through{at(0, 0, -5), at(0, 0, 5)}, beyond{at(0, 0, 5), at(4, 4, 6)};
  const auto check = [&](const auto& shape) {
    CHECK(intersects(shape, through));
    CHECK(intersects(through, shape));
    CHECK_FALSE(intersects(shape, beyond));
    CHECK_FALSE(intersects(beyond, shape));
  };
  test::visit_shapes<S, 3>(0, check);
  check(Plane{Direction<S, 3>::along(2), S(0)});
  check(Compound(balls));
}

}  // namespace
