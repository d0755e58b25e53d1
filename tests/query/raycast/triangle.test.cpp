// SPDX-License-Identifier: MIT
#include "detent/query/raycast/triangle.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

constexpr Ray<q16_16, 3> upward{{}, toward<q16_16, 3>(0, 0, 1), q16_16(100)};
constexpr Triangle<q16_16, 3> above{at<q16_16, 3>(-1, -1, 5), at<q16_16, 3>(1, -1, 5),
                                    at<q16_16, 3>(0, 1, 5)};

static_assert(raycast(upward, above) == q16_16(5));
static_assert(raycast_hit(upward, above)->point == at<q16_16, 3>(0, 0, 5));
static_assert(raycast_hit(upward, above)->normal == toward<q16_16, 3>(0, 0, -1));
static_assert(raycast_interval(upward, above) == Interval<q16_16>{q16_16(5), q16_16(5)});
static_assert(!raycast(upward, above, Facing::front));
static_assert(noexcept(raycast(upward, above)));

constexpr Ray<q16_16, 2> along_x{{}, toward<q16_16, 2>(1), q16_16(100)};
constexpr Triangle<q16_16, 2> arrow{at<q16_16, 2>(4), at<q16_16, 2>(6, -1), at<q16_16, 2>(6, 1)};

static_assert(raycast(along_x, arrow) == q16_16(4));
static_assert(raycast_interval(along_x, arrow) == Interval<q16_16>{q16_16(4), q16_16(6)});
static_assert(noexcept(raycast(along_x, arrow)));

/// The triangle starting at each corner, in both windings.
template <Scalar S, int N>
std::array<Triangle<S, N>, 6> orders(const Triangle<S, N>& t) {
  return {{{t.a, t.b, t.c},
           {t.b, t.c, t.a},
           {t.c, t.a, t.b},
           {t.a, t.c, t.b},
           {t.c, t.b, t.a},
           {t.b, t.a, t.c}}};
}

TEMPLATE_TEST_CASE("ray against triangle: a surface is hit, missed and touched as drawn",
                   "[raycast]", q16_16, q14_16, q24_8, q8_8, float, double) {
  using S = TestType;
  const auto interval = [](double enter, double exit) {
    return Interval<S>{num<S>(enter), num<S>(exit)};
  };
  const auto point = [](double x, double y, double z) { return at<S, 3>(x, y, z); };
  const auto up = toward<S, 3>(0, 0, 1);
  const auto down = toward<S, 3>(0, 0, -1);
  const auto ray = [](double x, double y, double z, double dx, double dy, double dz) {
    return Ray<S, 3>{at<S, 3>(x, y, z), toward<S, 3>(dx, dy, dz), num<S>(100)};
  };
  // Counter-clockwise seen from above: the front is the upper side.
  const Triangle<S, 3> level{point(0, 0, 5), point(4, 0, 5), point(0, 4, 5)};

  SECTION("hit, from both sides and in any order of corners") {
    for (const auto& triangle : orders(level)) {
      CHECK(raycast_interval(ray(1, 1, 0, 0, 0, 1), triangle) == interval(5, 5));
      CHECK(raycast_hit(ray(1, 1, 0, 0, 0, 1), triangle)->point == point(1, 1, 5));
      CHECK(raycast_hit(ray(1, 1, 0, 0, 0, 1), triangle)->normal == down);
      CHECK(distance(ray(1, 1, 9, 0, 0, -1), triangle) == num<S>(4));
      CHECK(raycast_hit(ray(1, 1, 9, 0, 0, -1), triangle)->normal == up);
    }
    const Triangle<S, 3> slanted{point(0, 0, 6), point(3, 0, 0), point(0, 3, 0)};
    CHECK(distance(ray(1, 1, 0, 0, 0, 1), slanted) == num<S>(2));
    if constexpr (is_fixed<S>) {
      CHECK(raycast_hit(ray(1, 1, 0, 0, 0, 1), slanted)->normal == toward<S, 3>(-2, -2, -1));
    }
  }
  SECTION("miss") {
    CHECK(misses(ray(-1, 1, 0, 0, 0, 1), level));
    CHECK(misses(ray(1, -1, 0, 0, 0, 1), level));
    CHECK(misses(ray(3, 2, 0, 0, 0, 1), level));
    CHECK(misses(ray(1, 1, 0, 0, 0, -1), level));
    CHECK(misses(ray(1, 1, 6, 0, 0, 1), level));
    auto cut = ray(1, 1, 0, 0, 0, 1);
    cut.max_distance = num<S>(4.5);
    CHECK(misses(cut, level));
    cut.max_distance = num<S>(-1);
    CHECK(misses(cut, level));
  }
  SECTION("touch: corners and edges belong to the triangle") {
    for (const auto& triangle : orders(level)) {
      CHECK(distance(ray(0, 0, 0, 0, 0, 1), triangle) == num<S>(5));
      CHECK(distance(ray(4, 0, 0, 0, 0, 1), triangle) == num<S>(5));
      CHECK(distance(ray(0, 4, 0, 0, 0, 1), triangle) == num<S>(5));
      CHECK(distance(ray(0, 3, 0, 0, 0, 1), triangle) == num<S>(5));
      CHECK(distance(ray(1, 0, 0, 0, 0, 1), triangle) == num<S>(5));
      CHECK(distance(ray(1, 3, 0, 0, 0, 1), triangle) == num<S>(5));
    }
    auto cut = ray(1, 1, 0, 0, 0, 1);
    cut.max_distance = num<S>(5);
    CHECK(distance(cut, level) == num<S>(5));
  }
  SECTION("inside start: on the surface, for any direction") {
    CHECK(raycast_interval(ray(1, 1, 5, 0, 0, 1), level) == interval(0, 0));
    CHECK(raycast_hit(ray(1, 1, 5, 0, 0, 1), level)->normal == down);
    CHECK(raycast_interval(ray(1, 1, 5, 0, 0, -1), level) == interval(0, 0));
    CHECK(raycast_hit(ray(1, 1, 5, 0, 0, -1), level)->normal == up);
    CHECK(distance(ray(0, 0, 5, 1, 1, 1), level) == num<S>(0));
    auto cut = ray(1, 1, 5, 0, 0, 1);
    cut.max_distance = num<S>(0);
    CHECK(raycast_interval(cut, level) == interval(0, 0));
  }
  SECTION("parallel: outside the plane") {
    CHECK(misses(ray(-1, 1, 4, 1, 0, 0), level));
    CHECK(misses(ray(1, 1, 6, 1, 0, 0), level));
  }
  SECTION("parallel: in the plane, up to the triangle's nearest point") {
    for (const auto& triangle : orders(level)) {
      CHECK(raycast_interval(ray(-2, 1, 5, 1, 0, 0), triangle) == interval(2, 5));
      CHECK(raycast_interval(ray(1, 1, 5, 1, 0, 0), triangle) == interval(0, 2));
      CHECK(raycast_interval(ray(-2, 0, 5, 1, 0, 0), triangle) == interval(2, 6));
      CHECK(raycast_interval(ray(-2, 4, 5, 1, 0, 0), triangle) == interval(2, 2));
      CHECK(misses(ray(-2, 5, 5, 1, 0, 0), triangle));
      CHECK(misses(ray(5, 1, 5, 1, 0, 0), triangle));
      auto cut = ray(-2, 1, 5, 1, 0, 0);
      cut.max_distance = num<S>(3);
      CHECK(raycast_interval(cut, triangle) == interval(2, 3));
      cut.max_distance = num<S>(1.5);
      CHECK(misses(cut, triangle));
    }
    const Triangle<S, 3> flipped{level.a, level.c, level.b};
    CHECK(raycast_hit(ray(-2, 1, 5, 1, 0, 0), level)->normal == up);
    CHECK(raycast_hit(ray(-2, 1, 5, 1, 0, 0), flipped)->normal == down);
    CHECK(raycast_hit(ray(1, 1, 5, 1, 0, 0), level)->normal == up);
  }
  SECTION("degenerate: a segment is crossed, followed and missed") {
    const Triangle<S, 3> segment{point(2, 0, 5), point(-2, 0, 5), point(1, 0, 5)};
    for (const auto& triangle : orders(segment)) {
      CHECK(raycast_interval(ray(-2, 0, 0, 0, 0, 1), triangle) == interval(5, 5));
      CHECK(raycast_hit(ray(-2, 0, 0, 0, 0, 1), triangle)->normal == down);
      CHECK(misses(ray(-3, 0, 0, 0, 0, 1), triangle));
      CHECK(misses(ray(0, 1, 0, 0, 0, 1), triangle));
      CHECK(raycast_interval(ray(-5, 0, 5, 1, 0, 0), triangle) == interval(3, 7));
      CHECK(raycast_interval(ray(0, 0, 5, 1, 0, 0), triangle) == interval(0, 2));
      CHECK(raycast_hit(ray(-5, 0, 5, 1, 0, 0), triangle)->normal == toward<S, 3>(-1));
      CHECK(misses(ray(5, 0, 5, 1, 0, 0), triangle));
      CHECK(misses(ray(-5, 1, 5, 1, 0, 0), triangle));
    }
  }
  SECTION("degenerate: a point") {
    const Triangle<S, 3> dot{point(1, 2, 5), point(1, 2, 5), point(1, 2, 5)};
    CHECK(raycast_interval(ray(1, 2, 0, 0, 0, 1), dot) == interval(5, 5));
    CHECK(raycast_hit(ray(1, 2, 0, 0, 0, 1), dot)->normal == down);
    CHECK(raycast_interval(ray(1, 2, 5, 0, 1, 1), dot) == interval(0, 0));
    CHECK(misses(ray(1, 1, 0, 0, 0, 1), dot));
    CHECK(misses(ray(1, 2, 6, 0, 0, 1), dot));
  }
  SECTION("only the front, on request") {
    CHECK(raycast(ray(1, 1, 9, 0, 0, -1), level, Facing::front) == num<S>(4));
    CHECK_FALSE(raycast(ray(1, 1, 0, 0, 0, 1), level, Facing::front).has_value());
    CHECK_FALSE(raycast_hit(ray(1, 1, 0, 0, 0, 1), level, Facing::front).has_value());
    CHECK_FALSE(raycast_interval(ray(1, 1, 0, 0, 0, 1), level, Facing::front).has_value());
    CHECK_FALSE(raycast(ray(-2, 1, 5, 1, 0, 0), level, Facing::front).has_value());
    CHECK_FALSE(raycast_interval(ray(-2, 1, 5, 1, 0, 0), level, Facing::front).has_value());
  }
}

TEMPLATE_TEST_CASE("ray against triangle: solid in 2D", "[raycast]", q16_16, q14_16, q24_8, q8_8,
                   float, double) {
  using S = TestType;
  const auto interval = [](double enter, double exit) {
    return Interval<S>{num<S>(enter), num<S>(exit)};
  };
  const auto point = [](double x, double y) { return at<S, 2>(x, y); };
  const auto ray = [](double x, double y, double dx, double dy) {
    return Ray<S, 2>{at<S, 2>(x, y), toward<S, 2>(dx, dy), num<S>(100)};
  };
  const Triangle<S, 2> right_angle{point(2, 0), point(6, 0), point(2, 4)};

  SECTION("hit, in any order of corners") {
    for (const auto& triangle : orders(right_angle)) {
      CHECK(raycast_interval(ray(0, 1, 1, 0), triangle) == interval(2, 5));
      CHECK(raycast_hit(ray(0, 1, 1, 0), triangle)->normal == toward<S, 2>(-1));
      CHECK(raycast_hit(ray(0, 1, 1, 0), triangle)->point == point(2, 1));
      CHECK(raycast_interval(ray(9, 1, -1, 0), triangle) == interval(4, 7));
      CHECK(raycast_interval(ray(3, -2, 0, 1), triangle) == interval(2, 5));
      CHECK(raycast_hit(ray(3, -2, 0, 1), triangle)->normal == toward<S, 2>(0, -1));
      if constexpr (is_fixed<S>) {
        CHECK(raycast_hit(ray(9, 1, -1, 0), triangle)->normal == toward<S, 2>(1, 1));
      }
    }
  }
  SECTION("miss") {
    CHECK(misses(ray(0, -1, 1, 0), right_angle));
    CHECK(misses(ray(0, 5, 1, 0), right_angle));
    CHECK(misses(ray(0, 1, -1, 0), right_angle));
    CHECK(misses(ray(6, 1, 1, 0), right_angle));
    auto cut = ray(0, 1, 1, 0);
    cut.max_distance = num<S>(1.5);
    CHECK(misses(cut, right_angle));
    cut.max_distance = num<S>(-1);
    CHECK(misses(cut, right_angle));
  }
  SECTION("touch: a corner, an edge, the end of the ray") {
    for (const auto& triangle : orders(right_angle)) {
      CHECK(raycast_interval(ray(0, 4, 1, 0), triangle) == interval(2, 2));
      CHECK(raycast_interval(ray(0, 0, 1, 0), triangle) == interval(2, 6));
      CHECK(raycast_interval(ray(6, -2, 0, 1), triangle) == interval(2, 2));
      CHECK(raycast_hit(ray(0, 0, 1, 0), triangle)->normal == toward<S, 2>(-1));
      auto cut = ray(0, 1, 1, 0);
      cut.max_distance = num<S>(2);
      CHECK(raycast_interval(cut, triangle) == interval(2, 2));
    }
  }
  SECTION("touch: an entered corner has the normal of the first of its edges") {
    const Triangle<S, 2> tip{point(4, 0), point(6, -1), point(6, 1)};
    CHECK(distance(ray(0, 0, 1, 0), tip) == num<S>(4));
    const auto lower = raycast_hit(ray(0, 0, 1, 0), tip)->normal;
    CHECK(lower[0] < 0);
    CHECK(lower[1] < 0);
    const Triangle<S, 2> other{tip.a, tip.c, tip.b};
    CHECK(raycast_hit(ray(0, 0, 1, 0), other)->normal[1] > 0);
    const Triangle<S, 2> from_b{tip.c, tip.a, tip.b};
    CHECK(raycast_hit(ray(0, 0, 1, 0), from_b)->normal[1] > 0);
  }
  SECTION("inside start") {
    CHECK(raycast_interval(ray(3, 1, 1, 0), right_angle) == interval(0, 2));
    CHECK(raycast_hit(ray(3, 1, 1, 0), right_angle)->normal == toward<S, 2>(-1));
    CHECK(raycast_interval(ray(2, 1, 1, 0), right_angle) == interval(0, 3));
    CHECK(raycast_interval(ray(2, 1, -1, 0), right_angle) == interval(0, 0));
    CHECK(raycast_hit(ray(2, 1, -1, 0), right_angle)->normal == toward<S, 2>(1));
    CHECK(raycast_interval(ray(6, 0, 1, 0), right_angle) == interval(0, 0));
    auto cut = ray(3, 1, 1, 0);
    cut.max_distance = num<S>(1);
    CHECK(raycast_interval(cut, right_angle) == interval(0, 1));
  }
  SECTION("degenerate: a segment and a point") {
    const Triangle<S, 2> segment{point(4, 1), point(4, -2), point(4, 0)};
    for (const auto& triangle : orders(segment)) {
      CHECK(raycast_interval(ray(0, 1, 1, 0), triangle) == interval(4, 4));
      CHECK(raycast_hit(ray(0, 1, 1, 0), triangle)->normal == toward<S, 2>(-1));
      CHECK(raycast_interval(ray(4, 5, 0, -1), triangle) == interval(4, 7));
      CHECK(raycast_interval(ray(4, 0, 0, -1), triangle) == interval(0, 2));
      CHECK(misses(ray(0, 2, 1, 0), triangle));
      CHECK(misses(ray(5, 5, 0, -1), triangle));
    }
    const Triangle<S, 2> dot{point(4, 1), point(4, 1), point(4, 1)};
    CHECK(raycast_interval(ray(0, 1, 1, 0), dot) == interval(4, 4));
    CHECK(raycast_interval(ray(4, 1, 1, 0), dot) == interval(0, 0));
    CHECK(misses(ray(0, 0, 1, 0), dot));
  }
}

TEMPLATE_TEST_CASE("ray against triangle: one raw unit decides", "[raycast]", q16_16, q14_16, q24_8,
                   q8_8) {
  using S = TestType;
  const auto step = moved(S(0), 1);
  const Triangle<S, 3> level{at<S, 3>(0, 0, 5), at<S, 3>(4, 0, 5), at<S, 3>(0, 4, 5)};
  const auto up = toward<S, 3>(0, 0, 1);
  const auto from = [](S x, S y, S z) { return Vec<S, 3>{x, y, z}; };
  const auto under = [&](S x, S y) { return Ray<S, 3>{from(x, y, S(0)), up}; };

  SECTION("touch") {
    CHECK(misses(under(num<S>(1), moved(S(0), -1)), level));
    CHECK(misses(under(moved(S(0), -1), num<S>(1)), level));
    CHECK(misses(under(moved(num<S>(1), 1), num<S>(3)), level));
    CHECK(distance(under(moved(num<S>(1), -1), num<S>(3)), level) == num<S>(5));
    auto cut = under(num<S>(1), num<S>(1));
    cut.max_distance = moved(num<S>(5), -1);
    CHECK(misses(cut, level));
  }
  SECTION("parallel: a raw unit out of the plane") {
    Ray<S, 3> ray{at<S, 3>(-1, 1, 5), toward<S, 3>(1)};
    CHECK(distance(ray, level) == num<S>(1));
    ray.origin.z = moved(ray.origin.z, 1);
    CHECK(misses(ray, level));
    // A corner is a raw unit higher: the ray hits the tilted plane at its own height.
    auto tilted = level;
    tilted.c.z = moved(tilted.c.z, 1);
    CHECK(misses(ray, tilted));
    ray.origin.y = num<S>(4);
    CHECK(raycast_interval(ray, tilted) == Interval<S>{num<S>(1), num<S>(1)});
  }
  SECTION("the smallest triangle") {
    const Triangle<S, 3> small{from(S(0), S(0), num<S>(5)), from(step, S(0), num<S>(5)),
                               from(S(0), step, num<S>(5))};
    CHECK(distance(under(step, S(0)), small) == num<S>(5));
    CHECK(misses(under(step, step), small));
    CHECK(raycast_hit(under(S(0), S(0)), small)->normal == -up);
  }
  SECTION("a slanted ray through a corner, and one that passes it") {
    const auto slanted = three_four_fifths<S, 3>();
    const Triangle<S, 3> triangle{at<S, 3>(6, 8), at<S, 3>(6, 9, 1), at<S, 3>(6, 9, -1)};
    CHECK(distance(Ray<S, 3>{{}, slanted}, triangle) == moved(num<S>(10), -1));
    CHECK(misses(Ray<S, 3>{from(step, S(0), S(0)), slanted}, triangle));
    CHECK(distance(Ray<S, 3>{from(S(0), step, S(0)), slanted}, triangle).has_value());
  }
}

TEMPLATE_TEST_CASE("ray against triangle: correct at the ends of the domain", "[raycast]", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  const auto low = S::lowest();
  const auto high = S::max();
  const Triangle<S, 3> half{{low, low, S(0)}, {high, low, S(0)}, {low, high, S(0)}};
  const auto up = toward<S, 3>(0, 0, 1);

  CHECK(distance(Ray<S, 3>{{low, low, moved(low, 1)}, up}, half) == high);
  CHECK(misses(Ray<S, 3>{{low, low, low}, up}, half));
  CHECK(distance(Ray<S, 3>{{high, low, S(0)}, up}, half) == S(0));
  CHECK(distance(Ray<S, 3>{{S(0), moved(S(0), -1), num<S>(-1)}, up}, half) == num<S>(1));
  CHECK(misses(Ray<S, 3>{{S(0), S(0), num<S>(-1)}, up}, half));
  CHECK(raycast_interval(Ray<S, 3>{{low, low, S(0)}, toward<S, 3>(1)}, half) ==
        Interval<S>{S(0), high});
  CHECK(misses(Ray<S, 3>{{high, high, S(0)}, toward<S, 3>(1)}, half));
  CHECK(misses(Ray<S, 3>{{low, low, S(0)}, up, low}, half));

  // The diagonal of the world, as a triangle without area.
  const Triangle<S, 3> diagonal{{low, low, low}, {high, high, high}, {S(0), S(0), S(0)}};
  CHECK(distance(Ray<S, 3>{{S(0), S(0), num<S>(-1)}, up}, diagonal) == num<S>(1));
  CHECK(misses(Ray<S, 3>{{S(0), moved(S(0), 1), num<S>(-1)}, up}, diagonal));
  CHECK(distance(Ray<S, 3>{{low, low, low}, toward<S, 3>(-1, -1, -1)}, diagonal) == S(0));

  const Triangle<S, 2> flat{{low, low}, {high, low}, {low, high}};
  CHECK(raycast_interval(Ray<S, 2>{{low, low}, toward<S, 2>(1)}, flat) == Interval<S>{S(0), high});
  CHECK(raycast_interval(Ray<S, 2>{{high, high}, toward<S, 2>(-1)}, flat) == std::nullopt);
  CHECK(distance(Ray<S, 2>{{high, moved(S(0), -1)}, toward<S, 2>(-1)}, flat) == high);
  CHECK(misses(Ray<S, 2>{{high, S(0)}, toward<S, 2>(-1)}, flat));
}

TEMPLATE_TEST_CASE("ray against triangle: results do not depend on frame and order of corners",
                   "[raycast]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(0x7419);
  INFO(random);
  HitRate rate;
  for (int i = 0; i < 2000; ++i) {
    const auto a = random_point<S, N>(random);
    const auto reach = std::int64_t{1} << random.between(4, S::bits - 2);
    const Triangle<S, N> triangle{a, random_near(random, a, reach), random_near(random, a, reach)};
    const auto origin = random_point<S, N>(random);
    // u and v extend beyond the triangle, farther in 2D, where the ray may still cross it.
    const int slack = N == 2 ? 150 : 10;
    const auto u = random.between(-slack, 90 + slack);
    const auto v = random.between(-slack, 90 + slack);
    const auto target = make_vec<N>([&](int k) {
      const std::int64_t from = triangle.a[k].raw();
      const auto raw =
          from + (u * (triangle.b[k].raw() - from) + v * (triangle.c[k].raw() - from)) / 100;
      const auto limit = std::int64_t{S::max().raw()};
      return S::from_raw(static_cast<typename S::raw_type>(std::clamp(raw, -limit, limit)));
    });
    const Ray<S, N> ray{origin, aimed(origin, target)};
    rate.count(raycast(ray, triangle).has_value());
    check_symmetry(ray, triangle, true);
    for (const auto& other : orders(triangle)) {
      CHECK(raycast_interval(ray, other) == raycast_interval(ray, triangle));
      if (N == 3) CHECK(raycast_hit(ray, other) == raycast_hit(ray, triangle));
    }
  }
  INFO(rate);
  CHECK(rate.is_balanced());
}

}  // namespace
}  // namespace detent::test
