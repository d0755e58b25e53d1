// SPDX-License-Identifier: MIT
#include "detent/query/raycast/plane.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

constexpr Ray<q16_16, 3> along_x{{}, toward<q16_16, 3>(1), q16_16(100)};
constexpr Plane<q16_16, 3> wall{toward<q16_16, 3>(1), q16_16(5)};

static_assert(raycast(along_x, wall) == q16_16(5));
static_assert(raycast_hit(along_x, wall)->point == at<q16_16, 3>(5));
static_assert(raycast_hit(along_x, wall)->normal == toward<q16_16, 3>(-1));
static_assert(raycast_interval(along_x, wall) == Interval<q16_16>{q16_16(5), q16_16(5)});
static_assert(!raycast(along_x, Plane<q16_16, 3>{toward<q16_16, 3>(1), q16_16(-5)}));
static_assert(!raycast(along_x, wall, Facing::front));
static_assert(noexcept(raycast(along_x, wall)));

TEMPLATE_TEST_CASE("ray against plane: it hits, misses and touches as drawn", "[raycast]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto interval = [](double enter, double exit) {
    return Interval<S>{num<S>(enter), num<S>(exit)};
  };
  const auto plane = [](double x, double y, double offset) {
    return Plane<S, N>{toward<S, N>(x, y), num<S>(offset)};
  };
  const Ray<S, N> ray{at<S, N>(1), toward<S, N>(1), num<S>(100)};
  auto cut = ray;

  SECTION("hit, from both sides") {
    CHECK(raycast_interval(ray, plane(1, 0, 5)) == interval(4, 4));
    CHECK(distance(ray, plane(-1, 0, -5)) == num<S>(4));
    CHECK(raycast_hit(ray, plane(1, 0, 5))->point == at<S, N>(5));
    CHECK(raycast_hit(ray, plane(1, 0, 5))->normal == toward<S, N>(-1));
    CHECK(raycast_hit(ray, plane(-1, 0, -5))->normal == toward<S, N>(-1));
    const Ray<S, N> back{at<S, N>(9), toward<S, N>(-1), num<S>(100)};
    CHECK(distance(back, plane(1, 0, 5)) == num<S>(4));
    CHECK(raycast_hit(back, plane(1, 0, 5))->normal == toward<S, N>(1));
  }
  SECTION("miss") {
    CHECK(misses(ray, plane(1, 0, -5)));
    CHECK(misses(ray, plane(1, 0, 0)));
    cut.max_distance = num<S>(3.5);
    CHECK(misses(cut, plane(1, 0, 5)));
    cut.max_distance = num<S>(-1);
    CHECK(misses(cut, plane(1, 0, 1)));
  }
  SECTION("touch") {
    cut.max_distance = num<S>(4);
    CHECK(raycast_interval(cut, plane(1, 0, 5)) == interval(4, 4));
  }
  SECTION("inside start: in the plane, for any direction") {
    CHECK(raycast_interval(ray, plane(1, 0, 1)) == interval(0, 0));
    CHECK(raycast_hit(ray, plane(1, 0, 1))->normal == toward<S, N>(-1));
    CHECK(raycast_hit(ray, plane(-1, 0, -1))->normal == toward<S, N>(-1));
    CHECK(raycast_hit(ray, plane(1, 0, 1))->point == ray.origin);
    cut.max_distance = num<S>(0);
    CHECK(raycast_interval(cut, plane(1, 0, 1)) == interval(0, 0));
  }
  SECTION("parallel") {
    CHECK(misses(ray, plane(0, 1, 1)));
    CHECK(misses(ray, plane(0, 1, -1)));
    CHECK(raycast_interval(ray, plane(0, 1, 0)) == interval(0, 100));
    CHECK(raycast_hit(ray, plane(0, 1, 0))->normal == toward<S, N>(0, 1));
    CHECK(raycast_hit(ray, plane(0, -1, 0))->normal == toward<S, N>(0, -1));
  }
  SECTION("only the front, on request") {
    CHECK(raycast(ray, plane(-1, 0, -5), Facing::front) == num<S>(4));
    CHECK(raycast(ray, plane(-1, 0, -1), Facing::front) == num<S>(0));
    CHECK_FALSE(raycast(ray, plane(1, 0, 5), Facing::front).has_value());
    CHECK_FALSE(raycast_hit(ray, plane(1, 0, 5), Facing::front).has_value());
    CHECK_FALSE(raycast_interval(ray, plane(1, 0, 5), Facing::front).has_value());
    CHECK_FALSE(raycast(ray, plane(0, 1, 0), Facing::front).has_value());
  }
}

TEMPLATE_TEST_CASE("ray against plane: one raw unit decides", "[raycast]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Ray<S, N> ray{at<S, N>(1), toward<S, N>(1), num<S>(100)};

  SECTION("touch") {
    auto cut = ray;
    cut.max_distance = moved(num<S>(4), -1);
    CHECK(misses(cut, Plane<S, N>{toward<S, N>(1), num<S>(5)}));
    CHECK(misses(ray, Plane<S, N>{toward<S, N>(1), moved(num<S>(1), -1)}));
    CHECK(distance(ray, Plane<S, N>{toward<S, N>(1), moved(num<S>(1), 1)}) == moved(S(0), 1));
  }
  SECTION("parallel") {
    const Plane<S, N> floor{toward<S, N>(0, 1), S(0)};
    auto beside = ray;
    beside.origin.y = moved(S(0), 1);
    CHECK(misses(beside, floor));
    beside.origin.y = moved(S(0), -1);
    CHECK(misses(beside, floor));
  }
  SECTION("parallel at an angle: 4 x - 3 y = 0") {
    const auto along = three_four_fifths<S, N>();
    Vec<direction_component<S>, N> across;
    across.x = along[1];
    across.y = narrow<bits_of<direction_component<S>>>(-along[0]);
    const Plane<S, N> plane{Direction<S, N>::assume_unit(across), S(0)};
    CHECK(raycast_interval(Ray<S, N>{at<S, N>(3, 4), along, num<S>(50)}, plane) ==
          Interval<S>{S(0), num<S>(50)});
    auto beside = at<S, N>(3, 4);
    beside.x = moved(beside.x, 1);
    CHECK(misses(Ray<S, N>{beside, along, num<S>(50)}, plane));
    CHECK(misses(Ray<S, N>{{}, along, num<S>(50)}, Plane<S, N>{plane.normal, moved(S(0), 1)}));
  }
}

TEMPLATE_TEST_CASE("ray against plane: correct at the ends of the domain", "[raycast]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = S::lowest();
  const auto high = S::max();
  Vec<S, N> left;
  left.x = low;
  const Ray<S, N> right{left, toward<S, N>(1)};

  CHECK(misses(right, Plane<S, N>{toward<S, N>(1), S(0)}));
  CHECK(distance(right, Plane<S, N>{toward<S, N>(1), moved(S(0), -1)}) == high);
  CHECK(misses(right, Plane<S, N>{toward<S, N>(1), high}));
  CHECK(distance(right, Plane<S, N>{toward<S, N>(1), low}) == S(0));
  CHECK(misses(right, Plane<S, N>{toward<S, N>(-1), low}));
  CHECK(misses(Ray<S, N>{left, right.direction, low}, Plane<S, N>{toward<S, N>(1), low}));
  CHECK(raycast_interval(Ray<S, N>{filled<S, N>(low), right.direction},
                         Plane<S, N>{toward<S, N>(0, 1), low}) == Interval<S>{S(0), high});

  // Half the world down along (3, -4) / 5 is 3/8 of it to the right, and outside: the point is
  // clamped.
  const Ray<S, N> leaving{filled<S, N>(high), toward<S, N>(3, -4)};
  const auto half = S::from_raw(static_cast<typename S::raw_type>(high.raw() / 2));
  const auto hit = raycast_hit(leaving, Plane<S, N>{toward<S, N>(0, 1), half});
  REQUIRE(hit.has_value());
  CHECK(hit->point.x == high);
  CHECK(hit->point.y - half >= S(0));
  CHECK(misses(leaving, Plane<S, N>{toward<S, N>(0, 1), S(0)}));  // 5/4 of the longest distance
}

TEMPLATE_TEST_CASE("ray against plane: results do not depend on the frame", "[raycast]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(0x91a7e);
  INFO(random);
  HitRate rate;
  for (int i = 0; i < 2000; ++i) {
    const auto reach = std::int64_t{1} << random.between(4, S::bits - 1);
    const Plane<S, N> plane{aimed(Vec<S, N>(), random_point<S, N>(random)),
                            random.number<S>(-reach, reach)};
    const auto origin = random_near(random, Vec<S, N>(), reach);
    const Ray<S, N> ray{origin, aimed(origin, random_near(random, Vec<S, N>(), reach))};
    rate.count(raycast(ray, plane).has_value());
    check_symmetry(ray, plane, true);
    const Plane<S, N> other_side{-plane.normal, narrow<S::bits>(-plane.offset)};
    CHECK(raycast(ray, other_side) == raycast(ray, plane));
  }
  INFO(rate);
  CHECK(rate.is_balanced());
}

}  // namespace
}  // namespace detent::test
