// SPDX-License-Identifier: MIT
#include "detent/query/raycast/sphere.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

constexpr Ray<q16_16, 3> along_x{{}, toward<q16_16, 3>(1), q16_16(100)};
constexpr Sphere<q16_16, 3> ahead{at<q16_16, 3>(10), q16_16(3)};

static_assert(raycast(along_x, ahead) == q16_16(7));
static_assert(raycast_hit(along_x, ahead)->point == at<q16_16, 3>(7));
static_assert(raycast_hit(along_x, ahead)->normal == toward<q16_16, 3>(-1));
static_assert(raycast_interval(along_x, ahead) == Interval<q16_16>{q16_16(7), q16_16(13)});
static_assert(!raycast(along_x, Sphere<q16_16, 3>{at<q16_16, 3>(10, 4), q16_16(3)}));
static_assert(noexcept(raycast(along_x, ahead)));

TEMPLATE_TEST_CASE("ray against sphere: it hits, misses and touches as drawn", "[raycast]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Ray<S, N> ray{{}, toward<S, N>(1), num<S>(100)};
  const auto sphere = [](double x, double y, double radius) {
    return Sphere<S, N>{at<S, N>(x, y), num<S>(radius)};
  };
  auto cut = ray;

  SECTION("hit") {
    CHECK(distance(ray, sphere(10, 0, 3)) == num<S>(7));
    const auto hit = raycast_hit(ray, sphere(10, 0, 3)).value();
    CHECK(hit.point == at<S, N>(7));
    CHECK(hit.normal == toward<S, N>(-1));
    CHECK(raycast_interval(ray, sphere(10, 0, 3)) == Interval<S>{num<S>(7), num<S>(13)});
    // (3, 4) is on the circle of radius 5.
    CHECK(distance(ray, sphere(10, 4, 5)) == num<S>(7));
    CHECK(raycast_interval(ray, sphere(10, 4, 5)) == Interval<S>{num<S>(7), num<S>(13)});
  }
  SECTION("miss") {
    CHECK(misses(ray, sphere(-10, 0, 3)));
    CHECK(misses(ray, sphere(10, 4, 3)));
    CHECK(misses(ray, sphere(10, -20, 3)));
    cut.max_distance = num<S>(6.5);
    CHECK(misses(cut, sphere(10, 0, 3)));
  }
  SECTION("touch") {
    CHECK(distance(ray, sphere(10, 3, 3)) == num<S>(10));
    CHECK(raycast_hit(ray, sphere(10, 3, 3))->normal == toward<S, N>(0, -1));
    CHECK(raycast_interval(ray, sphere(10, 3, 3)) == Interval<S>{num<S>(10), num<S>(10)});
    cut.max_distance = num<S>(7);
    CHECK(distance(cut, sphere(10, 0, 3)) == num<S>(7));
    CHECK(raycast_interval(cut, sphere(10, 0, 3)) == Interval<S>{num<S>(7), num<S>(7)});
  }
  SECTION("inside start") {
    CHECK(distance(ray, sphere(1, 0, 3)) == num<S>(0));
    const auto hit = raycast_hit(ray, sphere(1, 0, 3)).value();
    CHECK(hit.point == ray.origin);
    CHECK(hit.normal == toward<S, N>(-1));
    CHECK(raycast_interval(ray, sphere(1, 0, 3)) == Interval<S>{num<S>(0), num<S>(4)});
    cut.max_distance = num<S>(2);
    CHECK(raycast_interval(cut, sphere(1, 0, 3)) == Interval<S>{num<S>(0), num<S>(2)});
    cut.max_distance = num<S>(0);
    CHECK(raycast_interval(cut, sphere(1, 0, 3)) == Interval<S>{num<S>(0), num<S>(0)});
    cut.max_distance = num<S>(-1);
    CHECK(misses(cut, sphere(1, 0, 3)));
  }
  SECTION("start on the surface, looking in, out and along") {
    CHECK(raycast_interval(ray, sphere(3, 0, 3)) == Interval<S>{num<S>(0), num<S>(6)});
    CHECK(raycast_interval(ray, sphere(-3, 0, 3)) == Interval<S>{num<S>(0), num<S>(0)});
    CHECK(raycast_interval(ray, sphere(0, 3, 3)) == Interval<S>{num<S>(0), num<S>(0)});
    CHECK(raycast_hit(ray, sphere(0, 3, 3))->normal == toward<S, N>(-1));
  }
  SECTION("degenerate: a point") {
    CHECK(distance(ray, sphere(10, 0, 0)) == num<S>(10));
    CHECK(raycast_hit(ray, sphere(10, 0, 0))->normal == toward<S, N>(-1));
    CHECK(distance(ray, sphere(0, 0, 0)) == num<S>(0));
    CHECK(misses(ray, sphere(10, 1, 0)));
    CHECK(misses(ray, sphere(-10, 0, 0)));
  }
  SECTION("degenerate: an empty sphere") {
    CHECK(misses(ray, sphere(10, 0, -3)));
    CHECK(misses(ray, sphere(0, 0, -3)));
  }
}

TEMPLATE_TEST_CASE("ray against sphere: one raw unit decides", "[raycast]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Ray<S, N> ray{{}, toward<S, N>(1), num<S>(100)};

  SECTION("touch") {
    CHECK(misses(ray, Sphere<S, N>{at<S, N>(10, 3), moved(num<S>(3), -1)}));
    auto cut = ray;
    cut.max_distance = moved(num<S>(7), -1);
    CHECK(misses(cut, Sphere<S, N>{at<S, N>(10), num<S>(3)}));
  }
  SECTION("touch at an angle") {
    // From 0 by 2 (3, 4) to the contact point, then by (-4, 3) to the center.
    const Ray<S, N> slanted{{}, three_four_fifths<S, N>(), num<S>(100)};
    const Sphere<S, N> sphere{at<S, N>(2, 11), num<S>(5)};
    // The direction is 2^-30 too long, so the contact is reached just before 10.
    CHECK(distance(slanted, sphere) == moved(num<S>(10), -1));
    CHECK(misses(slanted, Sphere<S, N>{sphere.center, moved(sphere.radius, -1)}));
    auto cut = slanted;
    cut.max_distance = num<S>(10);
    CHECK(distance(cut, sphere) == moved(num<S>(10), -1));
    cut.max_distance = moved(num<S>(10), -1);
    CHECK(misses(cut, sphere));
  }
  SECTION("inside start") {
    const Sphere<S, N> sphere{at<S, N>(-3), num<S>(3)};
    CHECK(distance(ray, sphere) == num<S>(0));
    CHECK(misses(ray, Sphere<S, N>{at<S, N>(-3), moved(num<S>(3), -1)}));
    CHECK(distance(ray, Sphere<S, N>{at<S, N>(4), moved(num<S>(4), -1)}) == moved(S(0), 1));
  }
  SECTION("degenerate") {
    auto center = at<S, N>(10);
    center.y = moved(center.y, 1);
    CHECK(misses(ray, Sphere<S, N>{center, num<S>(0)}));
    CHECK(distance(ray, Sphere<S, N>{center, moved(S(0), 1)}) == num<S>(10));
  }
}

TEMPLATE_TEST_CASE("ray against sphere: correct at the ends of the domain", "[raycast]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = S::lowest();
  const auto high = S::max();
  const auto on_x = [](S x) {
    Vec<S, N> result;
    result.x = x;
    return result;
  };
  const Ray<S, N> right{on_x(low), toward<S, N>(1), high};
  const Ray<S, N> left{on_x(high), toward<S, N>(-1), high};

  CHECK(raycast_interval(right, Sphere<S, N>{{}, high}) == Interval<S>{moved(S(0), 1), high});
  CHECK(raycast_interval(left, Sphere<S, N>{{}, high}) == Interval<S>{S(0), high});
  CHECK(misses(right, Sphere<S, N>{on_x(high), S(0)}));
  CHECK(misses(left, Sphere<S, N>{on_x(low), high}));
  CHECK(distance(Ray<S, N>{on_x(moved(high, -1)), left.direction, high},
                 Sphere<S, N>{on_x(low), high}) == high);
  CHECK(misses(right, Sphere<S, N>{on_x(low), low}));
  CHECK(distance(right, Sphere<S, N>{on_x(low), S(0)}) == S(0));
  CHECK(misses(Ray<S, N>{on_x(low), right.direction, low}, Sphere<S, N>{on_x(low), high}));
  CHECK(misses(Ray<S, N>{filled<S, N>(low), right.direction, high},
               Sphere<S, N>{filled<S, N>(high), high}));

  // Down past the right end of the world to a sphere that extends beyond it: the point is clamped.
  Vec<S, N> top;
  top.x = top.y = high;
  const Sphere<S, N> bulging{on_x(high),
                             S::from_raw(static_cast<typename S::raw_type>(high.raw() / 10 * 7))};
  const auto hit = raycast_hit(Ray<S, N>{top, toward<S, N>(3, -4)}, bulging);
  REQUIRE(hit.has_value());
  CHECK(hit->point.x == high);
  CHECK(hit->point.y < high);
  CHECK(hit->normal[0] > 0);
}

TEST_CASE("ray against sphere: float places the ball of the README behind its center",
          "[raycast]") {
  const auto distance_to_ball = []<Scalar S>(S zero, S one, S side, S forward, S radius) {
    const Sphere ball{Vec<S, 3>{side, zero, forward}, radius};
    return raycast(Ray{Vec<S, 3>{}, *normalize(Vec<S, 3>{zero, zero, one})}, ball);
  };
  CHECK(distance_to_ball(q16_16(0), q16_16(1), q16_16(6), q16_16(30000), *q16_16::parse("7.5")) ==
        q16_16::parse("29995.5"));
  CHECK(distance_to_ball(0.0F, 1.0F, 6.0F, 30000.0F, 7.5F) == 30000.0F);
}

TEMPLATE_TEST_CASE("ray against sphere: results do not depend on the frame", "[raycast]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(0x5f3e);
  INFO(random);
  HitRate rate;
  for (int i = 0; i < 2000; ++i) {
    const auto center = random_point<S, N>(random);
    const auto radius = random.between(0, std::int64_t{1} << random.between(2, S::bits - 1));
    const Sphere<S, N> sphere{center, S::from_raw(static_cast<typename S::raw_type>(radius))};
    const auto origin = random_point<S, N>(random);
    const Ray<S, N> ray{origin, aimed(origin, random_near(random, center, 2 * radius))};
    rate.count(raycast(ray, sphere).has_value());
    check_symmetry(ray, sphere, false);
  }
  INFO(rate);
  CHECK(rate.is_balanced());
}

}  // namespace
}  // namespace detent::test
