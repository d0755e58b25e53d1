// SPDX-License-Identifier: MIT
#include "detent/query/raycast/obb.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

constexpr Ray<q16_16, 3> along_x{{}, toward<q16_16, 3>(1), q16_16(100)};
constexpr Obb<q16_16, 3> ahead{at<q16_16, 3>(5), at<q16_16, 3>(1, 2, 3), {}};

static_assert(raycast(along_x, ahead) == q16_16(4));
static_assert(raycast_hit(along_x, ahead)->point == at<q16_16, 3>(4));
static_assert(raycast_hit(along_x, ahead)->normal == toward<q16_16, 3>(-1));
static_assert(raycast_interval(along_x, ahead) == Interval<q16_16>{q16_16(4), q16_16(6)});
static_assert(!raycast(along_x, Obb<q16_16, 3>{at<q16_16, 3>(5, 3), at<q16_16, 3>(1, 2, 3), {}}));
static_assert(noexcept(raycast(along_x, ahead)));

/// `heading(3, 4)`, exactly orthogonal.
template <Scalar S, int N>
Rotation<S, N> exact_heading() {
  const auto along = three_four_fifths<S, N>();
  const auto left = Direction<S, N>::assume_unit(make_vec<N>([&](int i) {
    using Component = direction_component<S>;
    if (i == 0) return narrow<bits_of<Component>>(-along[1]);
    return i == 1 ? along[0] : Component();
  }));
  return frame(along, left);
}

TEMPLATE_TEST_CASE("ray against OBB: it hits, misses and touches as drawn", "[raycast]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto interval = [](double enter, double exit) {
    return Interval<S>{num<S>(enter), num<S>(exit)};
  };
  const auto box = [](double x, double y, double half_x, double half_y,
                      const Rotation<S, N>& rotation = {}) {
    return Obb<S, N>{at<S, N>(x, y), at<S, N>(half_x, half_y, 1), rotation};
  };
  const auto quarter = heading<S, N>(0, 1);
  const auto eighth = heading<S, N>(1, 1);
  const Ray<S, N> ray{{}, toward<S, N>(1), num<S>(100)};
  auto cut = ray;

  SECTION("hit") {
    CHECK(raycast_interval(ray, box(10, 0, 3, 1)) == interval(7, 13));
    CHECK(raycast_interval(ray, box(10, 0, 3, 1, quarter)) == interval(9, 11));
    CHECK(raycast_hit(ray, box(10, 0, 3, 1, quarter))->point == at<S, N>(9));
    // From the left, the ray hits the rotated box on its local +y face.
    CHECK(raycast_hit(ray, box(10, 0, 3, 1, quarter))->normal == toward<S, N>(-1));
    CHECK(raycast_hit(ray, box(10, 0, 3, 1, quarter))->normal == quarter.axis(1));
    const Ray<S, N> back{at<S, N>(20), toward<S, N>(-1), num<S>(100)};
    CHECK(raycast_interval(back, box(10, 0, 3, 1, quarter)) == interval(9, 11));
    CHECK(raycast_hit(back, box(10, 0, 3, 1, quarter))->normal == -quarter.axis(1));
    // Off its diagonal, the ray hits one of the two faces.
    CHECK(raycast_hit(ray, box(10, 1, 4, 4, eighth))->normal == -eighth.axis(0));
    CHECK(raycast_hit(ray, box(10, -1, 4, 4, eighth))->normal == eighth.axis(1));
  }
  SECTION("miss") {
    CHECK(misses(ray, box(-10, 0, 3, 1)));
    CHECK(misses(ray, box(10, 2, 3, 1)));
    CHECK(distance(ray, box(10, 2, 3, 1, quarter)) == num<S>(9));
    CHECK(misses(ray, box(10, 4, 3, 1, quarter)));
    CHECK(misses(ray, box(10, 6, 4, 4, eighth)));
    cut.max_distance = num<S>(8.5);
    CHECK(misses(cut, box(10, 0, 3, 1, quarter)));
  }
  SECTION("touch") {
    CHECK(raycast_interval(ray, box(10, 1, 3, 1)) == interval(7, 13));
    CHECK(raycast_interval(ray, box(10, 3, 3, 1, quarter)) == interval(9, 11));
    cut.max_distance = num<S>(9);
    CHECK(raycast_interval(cut, box(10, 0, 3, 1, quarter)) == interval(9, 9));
    // Enters both faces at a corner at once.
    CHECK(raycast_hit(ray, box(10, 0, 4, 4, eighth))->normal == -eighth.axis(0));
  }
  SECTION("inside start") {
    CHECK(raycast_interval(ray, box(1, 0, 3, 1)) == interval(0, 4));
    CHECK(raycast_interval(ray, box(1, 0, 1, 3, quarter)) == interval(0, 4));
    CHECK(raycast_hit(ray, box(1, 0, 1, 3, quarter))->normal == toward<S, N>(-1));
    CHECK(raycast_hit(ray, box(1, 0, 1, 3, quarter))->point == ray.origin);
    cut.max_distance = num<S>(2);
    CHECK(raycast_interval(cut, box(1, 0, 3, 1)) == interval(0, 2));
    cut.max_distance = num<S>(-1);
    CHECK(misses(cut, box(1, 0, 3, 1)));
  }
  SECTION("start on a face, looking in, out and along") {
    CHECK(raycast_interval(ray, box(3, 0, 1, 3, quarter)) == interval(0, 6));
    CHECK(raycast_interval(ray, box(-3, 0, 1, 3, quarter)) == interval(0, 0));
    CHECK(raycast_interval(ray, box(0, 1, 1, 3, quarter)) == interval(0, 3));
  }
  SECTION("parallel to a face") {
    CHECK(misses(ray, box(10, 1.5, 3, 1)));
    CHECK(misses(ray, box(10, -1.5, 1, 1, quarter)));
    CHECK(distance(ray, box(10, 0.5, 3, 1)) == num<S>(7));
  }
  SECTION("degenerate: flat, an edge, a point") {
    CHECK(raycast_interval(ray, box(10, 0, 3, 0)) == interval(7, 13));
    CHECK(raycast_interval(ray, box(10, 0, 3, 0, quarter)) == interval(10, 10));
    CHECK(raycast_hit(ray, box(10, 0, 3, 0, quarter))->normal == quarter.axis(1));
    const Obb<S, N> point{at<S, N>(10), {}, eighth};
    CHECK(raycast_interval(ray, point) == interval(10, 10));
    CHECK(raycast_hit(ray, point)->normal == -eighth.axis(0));
    CHECK(misses(ray, Obb<S, N>{at<S, N>(10, 0.5), {}, eighth}));
    CHECK(raycast_interval(ray, Obb<S, N>{{}, {}, eighth}) == interval(0, 0));
  }
  SECTION("degenerate: a negative extent makes the box empty") {
    CHECK(misses(ray, box(10, 0, -3, 1)));
    CHECK(misses(ray, box(10, 0, 3, -1)));
    CHECK(misses(ray, box(0, 0, 3, -1)));
    CHECK(misses(ray, box(0, 0, -3, -1, quarter)));
  }
  SECTION("degenerate: coincident axes leave one slab") {
    std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
    axes.fill(toward<S, N>(1));
    const Obb<S, N> slab{at<S, N>(10, 50), filled<S, N>(num<S>(1)),
                         Rotation<S, N>::from_axes(axes)};
    CHECK(raycast_interval(ray, slab) == interval(9, 11));
    CHECK(raycast_hit(ray, slab)->normal == toward<S, N>(-1));
  }
}

TEMPLATE_TEST_CASE("ray against OBB: one raw unit decides", "[raycast]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto turned_box = exact_heading<S, N>();
  const Obb<S, N> box{at<S, N>(6, 8), at<S, N>(2, 0, 1), turned_box};

  SECTION("a ray in the plane of a flat box hits it or passes next to it") {
    const Ray<S, N> ray{{}, turned_box.axis(0), num<S>(100)};
    // Axis and ray are both 2^-30 too long, so the ends come slightly earlier.
    CHECK(raycast_interval(ray, box) == Interval<S>{moved(num<S>(8), -1), moved(num<S>(12), -1)});
    CHECK(raycast_hit(ray, box)->normal == -turned_box.axis(0));
    auto beside = ray;
    beside.origin.x = moved(beside.origin.x, 1);
    CHECK(misses(beside, box));
    beside.origin.x = moved(beside.origin.x, -2);
    CHECK(misses(beside, box));
  }
  SECTION("a flat box is crossed in its plane") {
    const Ray<S, N> ray{at<S, N>(6 + 4, 8 - 3), turned_box.axis(1), num<S>(100)};
    CHECK(raycast_interval(ray, box) == Interval<S>{moved(num<S>(5), -1), moved(num<S>(5), -1)});
    CHECK(raycast_hit(ray, box)->normal == -turned_box.axis(1));
  }
  SECTION("length of the ray") {
    Ray<S, N> ray{{}, toward<S, N>(1), num<S>(9)};
    const Obb<S, N> ahead_of_it{at<S, N>(10), at<S, N>(1, 3, 1), heading<S, N>(-1, 0)};
    CHECK(distance(ray, ahead_of_it) == num<S>(9));
    ray.max_distance = moved(num<S>(9), -1);
    CHECK(misses(ray, ahead_of_it));
  }
}

TEMPLATE_TEST_CASE("ray against OBB: correct at the ends of the domain", "[raycast]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = S::lowest();
  const auto high = S::max();
  const auto eighth = heading<S, N>(1, 1);
  Vec<S, N> left;
  left.x = low;
  const Ray<S, N> right{left, toward<S, N>(1)};

  CHECK(raycast_interval(right, Obb<S, N>{{}, filled<S, N>(high), {}}) ==
        Interval<S>{moved(S(0), 1), high});
  // From 0 to lowest() is one raw unit more than the extent.
  CHECK(misses(right, Obb<S, N>{filled<S, N>(low), filled<S, N>(high), {}}));
  CHECK(misses(right, Obb<S, N>{filled<S, N>(high), filled<S, N>(high), {}}));
  CHECK(distance(right, Obb<S, N>{{}, filled<S, N>(high), eighth}) == S(0));
  CHECK(misses(right, Obb<S, N>{left, filled<S, N>(low), eighth}));
  CHECK(misses(Ray<S, N>{left, right.direction, low}, Obb<S, N>{left, filled<S, N>(high), {}}));
  CHECK(distance(Ray<S, N>{filled<S, N>(low), toward<S, N>(1, 1, 1)},
                 Obb<S, N>{filled<S, N>(low), {}, eighth}) == S(0));
  CHECK(misses(Ray<S, N>{filled<S, N>(low), toward<S, N>(1, 1, 1)},
               Obb<S, N>{filled<S, N>(high), {}, eighth}));
}

TEMPLATE_TEST_CASE("ray against OBB: without a rotation it is an AABB", "[raycast]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(0x0bb);
  INFO(random);
  HitRate rate;
  for (int i = 0; i < 2000; ++i) {
    const auto center = random_point<S, N>(random);
    const auto reach = std::int64_t{1} << random.between(2, S::bits - 2);
    const auto half = make_vec<N>([&](int) { return random.number<S>(-reach / 64, reach); });
    const auto origin = random_point<S, N>(random);
    const Ray<S, N> ray{origin, aimed(origin, random_near(random, center, reach))};
    const Aabb<S, N> same{nearest_to<S>(center - half), nearest_to<S>(center + half)};
    const Obb<S, N> box{center, half, {}};
    rate.count(raycast(ray, box).has_value());
    CHECK(raycast_hit(ray, box) == raycast_hit(ray, same));
    CHECK(raycast_interval(ray, box) == raycast_interval(ray, same));
  }
  INFO(rate);
  CHECK(rate.is_balanced());
}

TEMPLATE_TEST_CASE("ray against OBB: results do not depend on the frame", "[raycast]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto box_of = [](Random& random, const Vec<S, N>& center, const Vec<S, N>& half) {
    return Obb<S, N>{center, half,
                     heading<S, N>(static_cast<double>(random.between(-99, 99)),
                                   static_cast<double>(random.between(1, 99)))};
  };
  check_symmetry_of_boxes<S, N>(0x0bb2, S::bits - 1, 2, true, box_of);
}

}  // namespace
}  // namespace detent::test
