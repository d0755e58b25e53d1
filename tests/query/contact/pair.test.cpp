// SPDX-License-Identifier: MIT
#include "detent/query/contact.hpp"

#include <array>

#include "detent/query/distance.hpp"
#include "detent/shape/frustum.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE(
    "contact: of equal depths, the normal with the greatest x, then y, and the positive side",
    "[contact]", DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto x = toward<S, N>(1);
  // Both directions of every axis, for a cube in itself.
  const Aabb<S, N> cube{filled<S, N>(num<S>(-1)), filled<S, N>(num<S>(1))};
  CHECK(contact(cube, cube)->normal == x);
  CHECK(contact(cube, cube)->depth == num<S>(2));
  const Sphere<S, N> ball{Vec<S, N>(), num<S>(1)};
  CHECK(contact(ball, ball)->normal == x);
  CHECK(contact(ball, ball)->depth == num<S>(2));
  CHECK(contact(cube, ball)->depth == num<S>(2));
  CHECK(contact(cube, ball)->normal == x);
  CHECK(contact(ball, cube)->normal == x);
  // Only the negative side of y is as near as the positive side of x; mirrored, x remains.
  const Sphere<S, N> inside{at<S, N>(0.5, -0.5), num<S>(0)};
  CHECK(contact(cube, inside)->normal == x);
  CHECK(contact(inside, cube)->normal == -x);
  // A flat Minkowski difference: crossing segments.
  const Segment<S, N> along_x{at<S, N>(-1), at<S, N>(1)}, along_y{at<S, N>(0, -1), at<S, N>(0, 1)};
  const auto crossing = contact(along_x, along_y);
  REQUIRE(crossing);
  CHECK(crossing->depth == (N == 2 ? num<S>(1) : S(0)));
  CHECK(crossing->normal == (N == 2 ? x : toward<S, N>(0, 0, 1)));
  // Collinear segments, and points.
  CHECK(contact(along_x, along_x)->normal == toward<S, N>(0, 1));
  CHECK(contact(along_y, along_y)->normal == x);
  const Segment<S, N> point{at<S, N>(1, 1), at<S, N>(1, 1)};
  CHECK(contact(point, point)->normal == x);
  CHECK(contact(point, point)->depth == S(0));
}

TEMPLATE_TEST_CASE("contact: a slanted face and crossing edges", "[contact]",
                   DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Triangle<S, N> slope{at<S, N>(0, 0), at<S, N>(8, 0), at<S, N>(0, 8)};
  if constexpr (N == 2) {
    // The corner (3, 3) is sqrt(2) below the slope.
    const Aabb<S, N> box{at<S, N>(3, 3), at<S, N>(9, 9)};
    const auto found = contact(slope, box);
    REQUIRE(found);
    CHECK(found->normal == toward<S, N>(1, 1));
    CHECK(found->depth >= num<S>(1.4140625));
    CHECK(found->depth <= num<S>(1.4296875));
  } else {
    // Its edge from (8, 0) to (0, 8) crosses an edge along z at x = y, 1 below it.
    const Segment<S, N> edge{at<S, N>(3, 3, -1), at<S, N>(5, 5, 1)};
    const auto found = contact(slope, edge);
    REQUIRE(found);
    CHECK(found->depth == S(0));
    const Capsule<S, N> rod{at<S, N>(4, 4, -8), at<S, N>(4, 4, 8), num<S>(1)};
    CHECK(contact(slope, rod)->normal == toward<S, N>(1, 1));
    CHECK(contact(slope, rod)->depth == num<S>(1));
  }
}

/// The point of a contact at this position, which must exist.
template <Scalar S, int N>
ContactPoint<S, N> point_at(const Contact<S, N>& contact, const Vec<S, N>& place) {
  for (std::size_t i = 0; i < contact.count; ++i) {
    if (contact.points[i].point == place) return contact.points[i];
  }
  FAIL_CHECK("no point there");
  return {};
}

TEST_CASE("contact: points of two faces are corners of both and crossings of their edges",
          "[contact]") {
  using S = q16_16;
  // The top of a, from (0, 0) to (4, 4), and the bottom of b, from (1, -2) to (9, 2).
  const Aabb<S, 3> a{at<S, 3>(0, 0, 0), at<S, 3>(4, 4, 4)};
  const Aabb<S, 3> b{at<S, 3>(1, -2, 3.5), at<S, 3>(9, 2, 8)};
  const auto found = contact(a, b);
  REQUIRE(found);
  REQUIRE(found->count == 4);
  for (const auto& point : found->points) CHECK(point.depth == num<S>(0.5));
  // Corner 2 of b is (1, 2), corner 5 of a is (4, 0); edges 4-5 of a and 0-2 of b cross.
  CHECK(point_at(*found, at<S, 3>(1, 2, 4)).feature == 0x0202ffff);
  CHECK(point_at(*found, at<S, 3>(4, 0, 4)).feature == 0xffff0505);
  CHECK(point_at(*found, at<S, 3>(1, 0, 4)).feature == 0x02000504);
  CHECK(point_at(*found, at<S, 3>(4, 2, 4)).feature == 0x03020705);
  // Swapped, the result is the same, on the surface of b.
  const auto back = contact(b, a);
  REQUIRE(back);
  CHECK(point_at(*back, at<S, 3>(1, 2, 3.5)).feature == 0xffff0202);
  CHECK(point_at(*back, at<S, 3>(1, 0, 3.5)).feature == 0x05040200);
}

TEST_CASE("contact: features persist while the same corners meet", "[contact]") {
  using S = q16_16;
  const Aabb<S, 3> ground{at<S, 3>(-9, -9, -1), at<S, 3>(9, 9, 0)};
  std::array<std::uint32_t, 4> features{};
  for (int step = 0; step < 40; ++step) {
    const auto x = S::from_double(0.03125 * step);
    const Aabb<S, 3> box{{x, S(0), num<S>(-0.0625)},
                         {x + 1 > S(9) ? S(9) : nearest_to<S>(x + 1), S(1), S(1)}};
    const auto found = contact(ground, box);
    REQUIRE(found);
    REQUIRE(found->count == 4);
    for (std::size_t i = 0; i < 4; ++i) {
      if (step > 0) CHECK(found->points[i].feature == features[i]);
      features[i] = found->points[i].feature;
    }
  }
}

TEMPLATE_TEST_CASE(
    "contact: a capsule lying on a face has two points, and a tilted one has two depths",
    "[contact]", DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto check = [&](const auto& ground) {
    const Capsule<S, N> level{at<S, N>(2.5, 0), at<S, N>(2.5, 3), num<S>(2)};
    const auto found = contact(ground, level);
    REQUIRE(found);
    CHECK(found->depth == num<S>(0.5));
    REQUIRE(found->count == 2);
    CHECK(point_at(*found, at<S, N>(1, 0)).depth == num<S>(0.5));
    CHECK(point_at(*found, at<S, N>(1, 3)).depth == num<S>(0.5));
    const Capsule<S, N> tilted{at<S, N>(2.5, 0), at<S, N>(2.75, 3), num<S>(2)};
    const auto lifted = contact(ground, tilted);
    REQUIRE(lifted);
    REQUIRE(lifted->count == 2);
    CHECK(point_at(*lifted, at<S, N>(1, 0)).depth == num<S>(0.5));
    CHECK(point_at(*lifted, at<S, N>(1, 3)).depth == num<S>(0.25));
    // Swapped, the points are on the capsule.
    const auto back = contact(tilted, ground);
    REQUIRE(back);
    CHECK(point_at(*back, at<S, N>(0.5, 0)).depth == num<S>(0.5));
    CHECK(point_at(*back, at<S, N>(0.75, 3)).depth == num<S>(0.25));
  };
  check(Plane<S, N>{toward<S, N>(1), num<S>(1)});
  check(Aabb<S, N>{at<S, N>(-1, -9, -9), at<S, N>(1, 9, 9)});
  check(Obb<S, N>{at<S, N>(0), at<S, N>(1, 9, 9), {}});
}

TEMPLATE_TEST_CASE("contact: an upright flat shape touches with the edge that rises least",
                   "[contact]", q16_16, q8_8, float) {
  using S = TestType;
  const auto check = [&](const auto& ground, const auto& shape, std::size_t low, double depth,
                         std::size_t end, const auto& place) {
    const auto found = contact(ground, shape), back = contact(shape, ground);
    REQUIRE(found);
    REQUIRE(back);
    CHECK(found->depth == num<S>(0.5));
    REQUIRE(found->count == 2);
    REQUIRE(back->count == 2);
    CHECK(point_at(*found, at<S, 3>(0, 1)).depth == num<S>(0.5));
    CHECK(point_at(*found, at<S, 3>(0, 1)).feature == (low << 24 | low << 16 | 0xffff));
    CHECK(point_at(*found, at<S, 3>(place, 1)).depth == num<S>(depth));
    CHECK(point_at(*found, at<S, 3>(place, 1)).feature == (end << 24 | end << 16 | 0xffff));
    CHECK(point_at(*back, at<S, 3>(0, 0.5)).depth == num<S>(0.5));
    CHECK(point_at(*back, at<S, 3>(place, 1 - depth)).depth == num<S>(depth));
  };
  const auto low = at<S, 3>(0, 0.5);
  const auto check_high = [&](const auto& ground) {
    // Both lowest corners, at an end of the shape and between its ends.
    for (const int side : {-1, 1}) {
      const auto other = at<S, 3>(2 * side, 0.5);
      check(ground, Triangle<S, 3>{other, low, at<S, 3>(0, 4)}, 1, 0.5, 0, 2 * side);
      check(ground, Triangle<S, 3>{other, low, at<S, 3>(2 * side, 4)}, 1, 0.5, 0, 2 * side);
      const std::array wide{at<S, 3>(-3, 2), other, low, at<S, 3>(3, 3)};
      check(ground, ConvexHull<S, 3>{wide}, 2, 0.5, 1, 2 * side);
    }
  };
  const auto check_sunk = [&](const auto& ground) {
    for (const int side : {-1, 1}) {
      // One lowest corner between two others: the edge that rises least; of equal ones, the longer, or
      // the first.
      const auto near = at<S, 3>(side, 0.75);
      check(ground, Triangle<S, 3>{near, at<S, 3>(-2 * side, 1.25), low}, 2, 0.25, 0, side);
      check(ground, Triangle<S, 3>{near, at<S, 3>(-2 * side, 0.875), low}, 2, 0.125, 1, -2 * side);
      check(ground, Triangle<S, 3>{near, at<S, 3>(-2 * side, 1), low}, 2, 0, 1, -2 * side);
      check(ground, Triangle<S, 3>{near, low, at<S, 3>(-side, 0.75)}, 1, 0.25, 0, side);
      // Across the x axis the first corner in lexicographic order is the lowest, between the others.
      const Triangle<S, 3> across{at<S, 3>(0, 0.5625, side), at<S, 3>(0, 0.875, -2 * side), low};
      const auto found = contact(ground, across);
      REQUIRE(found);
      REQUIRE(found->count == 2);
      CHECK(point_at(*found, at<S, 3>(0, 1)).depth == num<S>(0.5));
      CHECK(point_at(*found, at<S, 3>(0, 1, side)).depth == num<S>(0.4375));
      // An upright edge does not count.
      check(ground, Triangle<S, 3>{at<S, 3>(0, 0.625), near, low}, 2, 0.25, 1, side);
    }
  };
  const Aabb<S, 3> box{at<S, 3>(-9, -9, -9), at<S, 3>(9, 1, 9)};
  const Obb<S, 3> turned{at<S, 3>(0), at<S, 3>(9, 1, 9), {}};
  check_high(Plane<S, 3>{toward<S, 3>(0, 1), num<S>(1)});
  check_high(box);
  check_high(turned);
  check_sunk(box);
  check_sunk(turned);
}

TEMPLATE_TEST_CASE("contact: a frustum is the hull of its corners", "[contact]", q16_16, q8_8,
                   float) {
  using S = TestType;
  const Frustum<S> frustum(frustum_corners<S>());
  const Sphere<S, 3> ball{at<S, 3>(0, 0, 2.5), num<S>(1)};
  REQUIRE(contact(frustum, ball));
  CHECK(contact(frustum, ball) == contact(frustum.hull(), ball));
  CHECK(contact(frustum, ball)->depth == num<S>(0.5));
  CHECK(contact(frustum, ball)->normal == toward<S, 3>(0, 0, 1));
}

TEMPLATE_TEST_CASE("contact: clamped at the ends of the domain", "[contact]",
                   DETENT_EVERYDAY_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> all{Vec<S, N>(), S::max()};
  CHECK(contact(all, all)->depth == S::max());
  const Aabb<S, N> world{filled<S, N>(S::lowest()), filled<S, N>(S::max())};
  CHECK(contact(world, world)->depth == S::max());
  CHECK(contact(world, world)->normal == (toward<S, N>(1)));
}

TEMPLATE_TEST_CASE("contact: a short shape in the line or plane of a long one touches it there",
                   "[contact]", DETENT_EVERYDAY_FIXED_SPACES) {
  // The normal is rounded, so that the ends of the long one may seem to be on one side of it, and the
  // middle on the other.
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Raw = typename S::raw_type;
  Random random(31);
  const auto most = static_cast<int>(static_cast<std::int64_t>(S::max().raw()) / 40);
  const auto step = [&] { return static_cast<int>(random.below(std::uint64_t(2 * most))) - most; };
  const auto nearest = moved(S(0), 4 + (40 * most) / (1 << (bits_of<direction_component<S>> - 4)));
  long found = 0;
  for (int i = 0; i < 1000; ++i) {
    std::array<std::array<int, 3>, 2> axes{};
    for (auto& axis : axes) {
      for (auto& component : axis) component = step();
    }
    const auto place = [&](int along, int across) {
      return make_vec<N>([&](int k) {
        const auto c = static_cast<std::size_t>(k);
        return S::from_raw(static_cast<Raw>(along * axes[0][c] + across * axes[1][c]));
      });
    };
    const auto check = [&](const auto& small, const auto& large) {
      const auto ahead = contact(small, large), back = contact(large, small);
      REQUIRE(ahead);
      REQUIRE(back);
      INFO(random << ", pair " << i);
      for (std::size_t k = 0; k < ahead->count; ++k) {
        CHECK(distance(small, ahead->points[k].point) <= nearest);
      }
      for (std::size_t k = 0; k < back->count; ++k) {
        CHECK(distance(small, back->points[k].point) <= nearest);
      }
      found += ahead->count > 1 && back->count > 1;
    };
    const int at = static_cast<int>(random.below(7)) - 3;
    check(Segment<S, N>{place(at, 0), place(at + 1, 0)},
          Segment<S, N>{place(-16, 0), place(14, 0)});
    if constexpr (N == 3) {
      check(Triangle<S, 3>{place(at, 0), place(at + 1, 0), place(at, 1)},
            Triangle<S, 3>{place(-16, -10), place(16, -12), place(1, 16)});
    }
  }
  CHECK(found > 900);
}

}  // namespace
}  // namespace detent::test
