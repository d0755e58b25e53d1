// SPDX-License-Identifier: MIT
#include "detent/query/raycast/aabb.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

constexpr Ray<q16_16, 3> along_x{{}, toward<q16_16, 3>(1), q16_16(100)};
constexpr Aabb<q16_16, 3> ahead{at<q16_16, 3>(4, -1, -1), at<q16_16, 3>(6, 1, 1)};

static_assert(raycast(along_x, ahead) == q16_16(4));
static_assert(raycast_hit(along_x, ahead)->point == at<q16_16, 3>(4));
static_assert(raycast_hit(along_x, ahead)->normal == toward<q16_16, 3>(-1));
static_assert(raycast_interval(along_x, ahead) == Interval<q16_16>{q16_16(4), q16_16(6)});
static_assert(!raycast(along_x, Aabb<q16_16, 3>{at<q16_16, 3>(4, 2, 2), at<q16_16, 3>(6, 3, 3)}));
static_assert(noexcept(raycast(along_x, ahead)));

TEMPLATE_TEST_CASE("ray against AABB: it hits, misses and touches as drawn", "[raycast]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto box = [](double x0, double y0, double x1, double y1) {
    return Aabb<S, N>{at<S, N>(x0, y0, -1), at<S, N>(x1, y1, 1)};
  };
  const auto interval = [](double enter, double exit) {
    return Interval<S>{num<S>(enter), num<S>(exit)};
  };
  const Ray<S, N> ray{{}, toward<S, N>(1), num<S>(100)};
  auto cut = ray;

  SECTION("hit") {
    for (int axis = 0; axis < N; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        Vec<S, N> origin = filled<S, N>(num<S>(0.5));
        origin[axis] = num<S>(10 * side);
        const auto outward =
            side > 0 ? Direction<S, N>::along(axis) : -Direction<S, N>::along(axis);
        const Aabb<S, N> cube{filled<S, N>(num<S>(-2)), filled<S, N>(num<S>(2))};
        const Ray<S, N> inward{origin, -outward, num<S>(100)};
        CHECK(distance(inward, cube) == num<S>(8));
        const auto hit = raycast_hit(inward, cube).value();
        CHECK(hit.normal == outward);
        CHECK(hit.point[axis] == num<S>(2 * side));
        CHECK(raycast_interval(inward, cube) == interval(8, 12));
        CHECK(misses(Ray<S, N>{origin, outward, num<S>(100)}, cube));
      }
    }
  }
  SECTION("miss") {
    CHECK(misses(ray, box(-6, -1, -4, 1)));
    CHECK(misses(ray, box(4, 1, 6, 2)));
    CHECK(misses(ray, box(4, -2, 6, -1)));
    CHECK(misses(Ray<S, N>{{}, toward<S, N>(1, 1), num<S>(100)}, box(4, 7, 6, 9)));
    cut.max_distance = num<S>(3.5);
    CHECK(misses(cut, box(4, -1, 6, 1)));
  }
  SECTION("touch") {
    CHECK(raycast_interval(ray, box(4, 0, 6, 1)) == interval(4, 6));
    CHECK(raycast_interval(ray, box(4, -1, 6, 0)) == interval(4, 6));
    cut.max_distance = num<S>(4);
    CHECK(raycast_interval(cut, box(4, -1, 6, 1)) == interval(4, 4));
    CHECK(raycast_hit(cut, box(4, -1, 6, 1))->normal == toward<S, N>(-1));
  }
  SECTION("touch at corners: the normal is on the lowest axis among the faces entered last") {
    const Ray<S, N> diagonal{{}, toward<S, N>(1, 1, 1), num<S>(100)};
    const Aabb<S, N> cube{filled<S, N>(num<S>(2)), filled<S, N>(num<S>(3))};
    REQUIRE(distance(diagonal, cube).has_value());
    CHECK(raycast_hit(diagonal, cube)->normal == toward<S, N>(-1));
    // Enters the same corner through y only.
    auto low = cube;
    low.min.x = num<S>(1);
    CHECK(raycast_hit(diagonal, low)->normal == toward<S, N>(0, -1));
    // Past a corner: it enters x where it leaves y.
    const Ray<S, N> falling{at<S, N>(0, 4), toward<S, N>(1, -1), num<S>(100)};
    const Aabb<S, N> corner{at<S, N>(2, 2, -1), at<S, N>(3, 3, 1)};
    REQUIRE(distance(falling, corner).has_value());
    const Aabb<S, N> tip{at<S, N>(1, 1, -1), at<S, N>(2, 2, 1)};
    REQUIRE(distance(falling, tip).has_value());
    CHECK(raycast_interval(falling, tip)->enter == raycast_interval(falling, tip)->exit);
    CHECK(raycast_hit(falling, tip)->normal == toward<S, N>(0, 1));
  }
  SECTION("inside start") {
    CHECK(raycast_interval(ray, box(-1, -1, 2, 1)) == interval(0, 2));
    CHECK(raycast_hit(ray, box(-1, -1, 2, 1))->normal == toward<S, N>(-1));
    CHECK(raycast_hit(ray, box(-1, -1, 2, 1))->point == ray.origin);
    cut.max_distance = num<S>(1);
    CHECK(raycast_interval(cut, box(-1, -1, 2, 1)) == interval(0, 1));
    cut.max_distance = num<S>(0);
    CHECK(raycast_interval(cut, box(-1, -1, 2, 1)) == interval(0, 0));
    cut.max_distance = num<S>(-1);
    CHECK(misses(cut, box(-1, -1, 2, 1)));
  }
  SECTION("start on a face, looking in, out and along") {
    CHECK(raycast_interval(ray, box(0, -1, 2, 1)) == interval(0, 2));
    CHECK(raycast_interval(ray, box(-2, -1, 0, 1)) == interval(0, 0));
    CHECK(raycast_interval(ray, box(-1, 0, 1, 1)) == interval(0, 1));
    const Ray<S, N> up{{}, toward<S, N>(0, 1), num<S>(100)};
    CHECK(raycast_hit(up, box(0, -1, 2, 1))->normal == toward<S, N>(0, -1));
  }
  SECTION("parallel to a face") {
    CHECK(distance(ray, box(4, -1, 6, 0.5)) == num<S>(4));
    CHECK(misses(ray, box(4, 0.5, 6, 1)));
    CHECK(misses(Ray<S, N>{{}, toward<S, N>(-1), num<S>(100)}, box(4, -1, 6, 1)));
  }
  SECTION("degenerate: flat, an edge, a point") {
    CHECK(raycast_interval(ray, box(4, -1, 4, 1)) == interval(4, 4));
    CHECK(raycast_hit(ray, box(4, -1, 4, 1))->normal == toward<S, N>(-1));
    CHECK(raycast_interval(ray, box(4, 0, 6, 0)) == interval(4, 6));
    CHECK(misses(ray, box(4, 0.5, 6, 0.5)));
    const Aabb<S, N> point{at<S, N>(4), at<S, N>(4)};
    CHECK(raycast_interval(ray, point) == interval(4, 4));
    CHECK(raycast_hit(ray, point)->normal == toward<S, N>(-1));
    CHECK(raycast_interval(ray, Aabb<S, N>{}) == interval(0, 0));
    CHECK(misses(ray, Aabb<S, N>{at<S, N>(4, 0.5), at<S, N>(4, 0.5)}));
  }
  SECTION("degenerate: an inverted box is empty") {
    CHECK(misses(ray, box(6, -1, 4, 1)));
    CHECK(misses(ray, box(4, 1, 6, -1)));
    CHECK(misses(ray, box(2, -1, -2, 1)));
    CHECK(misses(ray, box(-2, 1, 2, -1)));
  }
}

TEMPLATE_TEST_CASE("ray against AABB: one raw unit decides", "[raycast]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Ray<S, N> ray{{}, toward<S, N>(1), num<S>(100)};
  const Aabb<S, N> box{at<S, N>(4, -1, -1), at<S, N>(6, 1, 1)};

  SECTION("touch") {
    auto above = box;
    above.min.y = moved(S(0), 1);
    CHECK(misses(ray, above));
    auto cut = ray;
    cut.max_distance = moved(num<S>(4), -1);
    CHECK(misses(cut, box));
  }
  SECTION("touch at a corner") {
    // From 0 along (3, 4) through the corner (6, 8) of a box to the right of the ray.
    const Ray<S, N> slanted{{}, three_four_fifths<S, N>(), num<S>(100)};
    const Aabb<S, N> right{at<S, N>(6, 2, -1), at<S, N>(9, 8, 1)};
    CHECK(distance(slanted, right) == moved(num<S>(10), -1));
    CHECK(raycast_hit(slanted, right)->normal == toward<S, N>(-1));
    auto lower = right;
    lower.max.y = moved(lower.max.y, -1);
    CHECK(misses(slanted, lower));
    auto farther = right;
    farther.min.x = moved(farther.min.x, 1);
    CHECK(misses(slanted, farther));
  }
  SECTION("inside start") {
    auto behind = box;
    behind.min.x = num<S>(-1);
    behind.max.x = S(0);
    CHECK(distance(ray, behind) == S(0));
    behind.max.x = moved(S(0), -1);
    CHECK(misses(ray, behind));
  }
}

TEMPLATE_TEST_CASE("ray against AABB: correct at the ends of the domain", "[raycast]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = S::lowest();
  const auto high = S::max();
  const Aabb<S, N> world{filled<S, N>(low), filled<S, N>(high)};
  const Aabb<S, N> corner{filled<S, N>(high), filled<S, N>(high)};
  Vec<S, N> left;
  left.x = low;
  const Ray<S, N> right{left, toward<S, N>(1)};

  CHECK(raycast_interval(right, world) == Interval<S>{S(0), high});
  CHECK(raycast_interval(Ray<S, N>{{}, toward<S, N>(1)}, world) == Interval<S>{S(0), high});
  CHECK(raycast_interval(Ray<S, N>{{}, toward<S, N>(-1)}, world) == Interval<S>{S(0), high});
  CHECK(misses(right, corner));
  CHECK(raycast_interval(Ray<S, N>{filled<S, N>(high), toward<S, N>(1)}, corner) ==
        Interval<S>{S(0), S(0)});
  CHECK(misses(right, Aabb<S, N>{filled<S, N>(high), filled<S, N>(low)}));
  CHECK(misses(Ray<S, N>{left, right.direction, low}, world));

  // The wall at x = -1 raw unit is exactly as far from the end of the world as a ray can reach.
  Aabb<S, N> wall{filled<S, N>(low), filled<S, N>(high)};
  wall.min.x = moved(S(0), -1);
  CHECK(raycast_interval(right, wall) == Interval<S>{high, high});
  CHECK(raycast_hit(right, wall)->point.x == wall.min.x);
  wall.min.x = S(0);
  CHECK(misses(right, wall));
}

TEMPLATE_TEST_CASE("ray against AABB: results do not depend on the frame", "[raycast]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto box_of = [](Random&, const Vec<S, N>& center, const Vec<S, N>& half) {
    return Aabb<S, N>{nearest_to<S>(center - half), nearest_to<S>(center + half)};
  };
  // If two faces are entered at once, the lower axis does depend on the frame.
  check_symmetry_of_boxes<S, N>(0xaabb, S::bits - 2, N == 2 ? 3 : 1.5, false, box_of);
}

}  // namespace
}  // namespace detent::test
