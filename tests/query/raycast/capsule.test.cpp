// SPDX-License-Identifier: MIT
#include "detent/query/raycast/capsule.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

constexpr Ray<q16_16, 3> along_x{{}, toward<q16_16, 3>(1), q16_16(100)};
constexpr Capsule<q16_16, 3> across{at<q16_16, 3>(10, -9), at<q16_16, 3>(10, 9), q16_16(3)};

static_assert(raycast(along_x, across) == q16_16(7));
static_assert(raycast_hit(along_x, across)->normal == toward<q16_16, 3>(-1));
static_assert(raycast_interval(along_x, across) == Interval<q16_16>{q16_16(7), q16_16(13)});
static_assert(noexcept(raycast(along_x, across)));

// The exit is beyond every representable distance, and must not step past the last number.
constexpr auto greatest = q16_16::max();
constexpr Ray<q16_16, 3> across_the_world{at<q16_16, 3>(-32768), toward<q16_16, 3>(1), greatest};
constexpr Capsule<q16_16, 3> as_long{at<q16_16, 3>(-32758), {greatest, {}, {}}, q16_16(3)};
static_assert(raycast_interval(across_the_world, as_long) == Interval<q16_16>{q16_16(7), greatest});

TEMPLATE_TEST_CASE("ray against capsule: it hits, misses and touches as drawn", "[raycast]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Ray<S, N> ray{{}, toward<S, N>(1), num<S>(100)};
  // Vertical at x, from y - 4 to y + 4.
  const auto standing = [](double x, double y, double radius) {
    return Capsule<S, N>{at<S, N>(x, y - 4), at<S, N>(x, y + 4), num<S>(radius)};
  };
  // Horizontal at y, from x to x + 10.
  const auto lying = [](double x, double y, double radius) {
    return Capsule<S, N>{at<S, N>(x, y), at<S, N>(x + 10, y), num<S>(radius)};
  };
  auto cut = ray;

  SECTION("hit on the side") {
    CHECK(distance(ray, standing(10, 0, 3)) == num<S>(7));
    const auto hit = raycast_hit(ray, standing(10, 0, 3)).value();
    CHECK(hit.point == at<S, N>(7));
    CHECK(hit.normal == toward<S, N>(-1));
    CHECK(raycast_interval(ray, standing(10, 0, 3)) == Interval<S>{num<S>(7), num<S>(13)});
    // Off the ray's plane by (3, 4) / 5 of the radius.
    const Capsule<S, N> aside{at<S, N>(10, -20, 4), at<S, N>(10, 20, 4), num<S>(5)};
    CHECK(distance(ray, aside) == num<S>(N == 2 ? 5 : 7));
  }
  SECTION("hit at an end") {
    CHECK(distance(ray, standing(10, 8, 5)) == num<S>(7));
    CHECK(distance(ray, standing(10, -8, 5)) == num<S>(7));
    CHECK(raycast_interval(ray, standing(10, 8, 5)) == Interval<S>{num<S>(7), num<S>(13)});
    CHECK(distance(ray, lying(10, 0, 3)) == num<S>(7));
    CHECK(raycast_hit(ray, lying(10, 0, 3))->normal == toward<S, N>(-1));
    CHECK(raycast_interval(ray, lying(10, 0, 3)) == Interval<S>{num<S>(7), num<S>(23)});
  }
  SECTION("miss") {
    CHECK(misses(ray, standing(-10, 0, 3)));
    CHECK(misses(ray, standing(10, 8, 3)));
    CHECK(misses(ray, lying(10, 4, 3)));
    CHECK(misses(ray, lying(-20, 0, 3)));
    cut.max_distance = num<S>(6.5);
    CHECK(misses(cut, standing(10, 0, 3)));
  }
  SECTION("touch") {
    CHECK(distance(ray, standing(10, 7, 3)) == num<S>(10));
    CHECK(raycast_interval(ray, standing(10, 7, 3)) == Interval<S>{num<S>(10), num<S>(10)});
    CHECK(raycast_hit(ray, standing(10, 7, 3))->normal == toward<S, N>(0, -1));
    cut.max_distance = num<S>(7);
    CHECK(raycast_interval(cut, standing(10, 0, 3)) == Interval<S>{num<S>(7), num<S>(7)});
  }
  SECTION("inside start") {
    CHECK(raycast_interval(ray, standing(1, 0, 3)) == Interval<S>{num<S>(0), num<S>(4)});
    CHECK(raycast_hit(ray, standing(1, 0, 3))->normal == toward<S, N>(-1));
    CHECK(raycast_interval(ray, lying(-2, 1, 3))->enter == num<S>(0));
    // It ends before it reaches the sphere through which it would leave.
    cut.max_distance = num<S>(2);
    CHECK(raycast_interval(cut, lying(-2, 0, 3)) == Interval<S>{num<S>(0), num<S>(2)});
    cut.max_distance = num<S>(-1);
    CHECK(misses(cut, standing(1, 0, 3)));
  }
  SECTION("parallel to the axis") {
    CHECK(raycast_interval(ray, lying(10, 3, 5)) == Interval<S>{num<S>(6), num<S>(24)});
    // Along its surface: from where it touches the sphere at one end to the other.
    CHECK(raycast_interval(ray, lying(10, 3, 3)) == Interval<S>{num<S>(10), num<S>(20)});
    CHECK(raycast_hit(ray, lying(10, 3, 3))->normal == toward<S, N>(0, -1));
    CHECK(raycast_interval(ray, lying(-5, 3, 3)) == Interval<S>{num<S>(0), num<S>(5)});
  }
  SECTION("degenerate: a sphere, a segment, a point") {
    const auto center = at<S, N>(10, 4);
    const Capsule<S, N> sphere{center, center, num<S>(5)};
    CHECK(raycast_interval(ray, sphere) == Interval<S>{num<S>(7), num<S>(13)});
    CHECK(raycast_hit(ray, sphere) == raycast_hit(ray, Sphere<S, N>{center, num<S>(5)}));
    CHECK(distance(ray, standing(10, 0, 0)) == num<S>(10));
    CHECK(raycast_hit(ray, standing(10, 0, 0))->normal == toward<S, N>(-1));
    CHECK(misses(ray, standing(10, 5, 0)));
    CHECK(raycast_interval(ray, lying(10, 0, 0)) == Interval<S>{num<S>(10), num<S>(20)});
    CHECK(distance(ray, Capsule<S, N>{at<S, N>(5), at<S, N>(5), num<S>(0)}) == num<S>(5));
  }
  SECTION("empty") {
    CHECK(misses(ray, standing(10, 0, -3)));
    CHECK(misses(ray, standing(0, 0, -3)));
  }
}

TEMPLATE_TEST_CASE("ray against capsule: one raw unit decides, at the ends of the domain too",
                   "[raycast]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = S::lowest(), high = S::max();
  const Ray<S, N> ray{{}, toward<S, N>(1), num<S>(100)};
  const auto radius = num<S>(3), less = moved(radius, -1);
  CHECK(misses(ray, Capsule<S, N>{at<S, N>(10, 3), at<S, N>(20, 3), less}));
  CHECK(misses(ray, Capsule<S, N>{at<S, N>(10, 3), at<S, N>(10, 9), less}));
  CHECK(distance(ray, Capsule<S, N>{at<S, N>(10, -9), at<S, N>(10, 9), less}) ==
        moved(num<S>(7), 1));

  // From 0 by 2 (3, 4) to the side, whose axis is perpendicular; the direction is 2^-30 too long.
  const Ray<S, N> slanted{{}, three_four_fifths<S, N>(), num<S>(100)};
  const Capsule<S, N> wall{at<S, N>(9 - 8, 12 + 6), at<S, N>(9 + 8, 12 - 6), num<S>(5)};
  CHECK(distance(slanted, wall) == moved(num<S>(10), -1));

  // The diagonal of the world, and a ray from one corner of its lowest side to the next.
  auto corner = filled<S, N>(low);
  corner.x = high;
  const Capsule<S, N> diagonal{filled<S, N>(low), filled<S, N>(high), S(0)};
  const Ray<S, N> edge{corner, Direction<S, N>::along(1)};
  CHECK_FALSE(raycast(edge, diagonal).has_value());
  const Capsule<S, N> beam{diagonal.a, diagonal.b, high};
  CHECK(raycast(edge, beam).has_value() == (N == 2));  // in 3D they are 0.7 sides apart
  CHECK(raycast(Ray<S, N>{diagonal.a, Direction<S, N>::along(0)}, beam) == S(0));
  const Capsule<S, N> far_side{filled<S, N>(high), filled<S, N>(high), S(0)};
  auto start = filled<S, N>(high);
  start.x = S(0);
  CHECK(raycast(Ray<S, N>{start, Direction<S, N>::along(0)}, far_side) == high);
}

TEMPLATE_TEST_CASE(
    "ray against capsule: results do not depend on the frame or the order of the ends", "[raycast]",
    DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(0xca95);
  INFO(random);
  for (int i = 0; i < 100; ++i) {
    const auto a = random_point<S, N>(random), b = random_point<S, N>(random);
    const auto origin = random_point<S, N>(random);
    const auto radius = S::from_raw(static_cast<typename S::raw_type>(
        random.below(std::uint64_t{1} << random.between(0, S::bits - 2))));
    const Ray<S, N> ray{origin, aimed(origin, random.coin() ? a : b)};
    const Capsule<S, N> capsule{a, b, radius}, reversed{b, a, radius};
    check_symmetry(ray, capsule, true);
    CHECK(raycast_hit(ray, reversed) == raycast_hit(ray, capsule));
    CHECK(raycast_interval(ray, reversed) == raycast_interval(ray, capsule));
  }
}

TEST_CASE("ray against capsule: narrow and wide integers give the same result", "[raycast]") {
  using S = q16_16;
  using Narrow = Fixed<29, 16>;
  using Wide = Fixed<32, 16>;
  Random random(0xca96);
  INFO(random);
  int sides = 0, wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto bits = random.between(4, 28);
    const auto vec = [&] {
      return make_vec<3>([&](int) {
        return Narrow::from_raw(static_cast<std::int32_t>(
            random.between(-(std::int64_t{1} << bits), std::int64_t{1} << bits)));
      });
    };
    const auto e = vec();
    const auto aim = vec();
    const Vec ahead{Narrow::from_raw(1), Narrow(0), Narrow(0)};
    auto d = *direction_of<S>(random.coin() ? vec() + ahead : aim + ahead);
    if (dot(e, d) < 0) d = -d;
    auto m = aim;
    for (int k = 0; k < 3; ++k) m[k] = Narrow::from_raw(-aim[k].raw());
    const auto radius =
        Narrow::from_raw(static_cast<std::int32_t>(random.below(std::uint64_t{1} << bits)));
    const auto wide = [](const auto& v) { return make_vec<3>([&](int k) { return Wide(v[k]); }); };
    const detail::RayCylinder<S, 3, Narrow, Narrow> small(d, m, e, radius);
    const detail::RayCylinder<S, 3, Wide, S> large(d, wide(m), wide(e), S(radius));
    const auto limit = S::from_raw(static_cast<std::int32_t>(random.below(std::uint64_t{1} << 31)));
    const auto a = detail::capsule_entry(small, limit), b = detail::capsule_entry(large, limit);
    if (a.part != b.part || a.distance != b.distance) ++wrong;
    if (a.part != detail::CapsulePart::side || radius == 0) continue;
    ++sides;
    if (detail::side_normal(small) != detail::side_normal(large)) ++wrong;
    if (a.distance && detail::left_part(small) != detail::left_part(large)) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(sides > 100);
}

}  // namespace
}  // namespace detent::test
