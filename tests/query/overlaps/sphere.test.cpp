// SPDX-License-Identifier: MIT
#include "query/overlaps/helpers.hpp"

namespace detent::test {
namespace {

static_assert(overlaps(Sphere<q16_16, 2>{{}, q16_16(1)}, Sphere<q16_16, 2>{{}, q16_16(0)}));
static_assert(!overlaps(Sphere<q16_16, 3>{{}, q16_16(-1)}, Sphere<q16_16, 3>{{}, q16_16(2)}));

/// Its surface contains (4, 5), (6, 1) and (1, 6).
template <Scalar S, int N>
const Sphere<S, N> ball{at<S, N>(1, 1), num<S>(5)};

TEMPLATE_TEST_CASE("overlaps, spheres: the distance is at most the sum of the radii", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Other = Sphere<S, N>;
  const auto& sphere = ball<S, N>;
  CHECK(meet(sphere, Other{at<S, N>(3, 1), num<S>(1)}));
  CHECK_FALSE(meet(sphere, Other{at<S, N>(7.5, 9), num<S>(5)}));
  CHECK(meet(sphere, Other{at<S, N>(7, 9), num<S>(5)}));
  CHECK(meet(sphere, Other{at<S, N>(1, 1), num<S>(0.5)}));
  CHECK(meet(sphere, Other{at<S, N>(4, 5), num<S>(0)}));
  CHECK_FALSE(meet(sphere, Other{at<S, N>(4.5, 5), num<S>(0)}));
  CHECK(meet(Other{at<S, N>(1, 1), num<S>(0)}, Other{at<S, N>(1, 1), num<S>(0)}));
  CHECK_FALSE(meet(sphere, Other{sphere.center, num<S>(-1)}));
  CHECK_FALSE(meet(Other{sphere.center, num<S>(-1)}, Other{sphere.center, num<S>(-1)}));
}

TEMPLATE_TEST_CASE("overlaps, sphere and aabb: the nearest point of the box is within the radius",
                   "[overlaps]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Box = Aabb<S, N>;
  const auto& sphere = ball<S, N>;
  CHECK(meet(sphere, Box{at<S, N>(3, 4), at<S, N>(9, 9)}));
  CHECK_FALSE(meet(sphere, Box{at<S, N>(4.5, 5), at<S, N>(9, 9)}));
  CHECK(meet(sphere, Box{at<S, N>(4, 5), at<S, N>(9, 9)}));
  CHECK(meet(sphere, Box{at<S, N>(6, -9), at<S, N>(9, 9)}));
  CHECK(meet(sphere, Box{at<S, N>(-20, -20, -20), at<S, N>(20, 20, 20)}));
  CHECK(meet(sphere, Box{at<S, N>(2, 2), at<S, N>(2, 2)}));
  CHECK(meet(Sphere<S, N>{at<S, N>(4, 5), num<S>(0)}, Box{at<S, N>(4, 5), at<S, N>(9, 9)}));
  CHECK_FALSE(overlaps(sphere, Box{at<S, N>(2, 1), at<S, N>(1, 1)}));
  CHECK_FALSE(meet(Sphere<S, N>{sphere.center, num<S>(-1)}, Box{{}, at<S, N>(9, 9)}));
}

TEMPLATE_TEST_CASE("overlaps, sphere and obb: the slabs within the radius, in their frame",
                   "[overlaps]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto& sphere = ball<S, N>;
  Obb<S, N> box{at<S, N>(7, 7), at<S, N>(3, 2), {}};
  CHECK(meet(sphere, box));
  box.half_extents = at<S, N>(2.5, 2);
  CHECK_FALSE(meet(sphere, box));
  box.half_extents = filled<S, N>(num<S>(20));
  CHECK(meet(sphere, box));
  box.half_extents.x = num<S>(-1);
  CHECK_FALSE(meet(sphere, box));
  CHECK_FALSE(meet(Sphere<S, N>{{}, num<S>(-1)}, Obb<S, N>{{}, at<S, N>(9, 9, 9), {}}));
  CHECK(meet(sphere, Obb<S, N>{at<S, N>(4, 5), {}, {}}));
}

TEMPLATE_TEST_CASE("overlaps, sphere and plane: the center is within the radius", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto& sphere = ball<S, N>;
  const auto x = Direction<S, N>::along(0);
  CHECK(meet(sphere, Plane<S, N>{x, num<S>(3)}));
  CHECK(meet(sphere, Plane<S, N>{x, num<S>(6)}));
  CHECK_FALSE(meet(sphere, Plane<S, N>{x, num<S>(6.5)}));
  CHECK(meet(sphere, Plane<S, N>{x, num<S>(-4)}));
  CHECK_FALSE(meet(sphere, Plane<S, N>{-x, num<S>(4.5)}));
  CHECK(meet(Sphere<S, N>{sphere.center, num<S>(0)}, Plane<S, N>{x, num<S>(1)}));
  CHECK_FALSE(meet(Sphere<S, N>{sphere.center, num<S>(-1)}, Plane<S, N>{x, num<S>(1)}));
}

TEMPLATE_TEST_CASE("overlaps, sphere and triangle: corner, edge, face, collapsed", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Corners = Triangle<S, N>;
  const auto& sphere = ball<S, N>;
  CHECK(meet(sphere, Corners{at<S, N>(4, 5), at<S, N>(20, 5), at<S, N>(20, 20)}));
  CHECK_FALSE(meet(sphere, Corners{at<S, N>(4.5, 5), at<S, N>(20, 5), at<S, N>(20, 20)}));
  CHECK(meet(sphere, Corners{at<S, N>(6, -20), at<S, N>(6, 20), at<S, N>(20, 0)}));
  CHECK_FALSE(meet(sphere, Corners{at<S, N>(6.5, -20), at<S, N>(6.5, 20), at<S, N>(20, 0)}));
  const Corners above{at<S, N>(-40, -40, 5), at<S, N>(40, -40, 5), at<S, N>(0, 60, 5)};
  CHECK(meet(sphere, above));
  CHECK(meet(Sphere<S, N>{sphere.center, num<S>(4.5)}, above) == (N == 2));
  CHECK(meet(Sphere<S, N>{at<S, N>(1, 1, 5), num<S>(0)}, above));
  CHECK_FALSE(meet(Sphere<S, N>{at<S, N>(1, 1, 5), num<S>(-1)}, above));
  // Collinear corners, and one point three times.
  const Corners line{at<S, N>(-1), at<S, N>(0), at<S, N>(1)};
  CHECK(meet(Sphere<S, N>{at<S, N>(0, 0.5), num<S>(1)}, line));
  CHECK(meet(Sphere<S, N>{at<S, N>(0, 0.5), num<S>(0.5)}, line));
  CHECK_FALSE(meet(Sphere<S, N>{at<S, N>(0, 0.5), num<S>(0.25)}, line));
  CHECK(meet(sphere, Corners{at<S, N>(4, 5), at<S, N>(4, 5), at<S, N>(4, 5)}));
  CHECK_FALSE(meet(sphere, Corners{at<S, N>(4, 5.5), at<S, N>(4, 5.5), at<S, N>(4, 5.5)}));
}

TEMPLATE_TEST_CASE("overlaps, sphere and capsule: the distance is at most the sum of the radii",
                   "[overlaps]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Pill = Capsule<S, N>;
  const auto& sphere = ball<S, N>;
  CHECK(meet(sphere, Pill{at<S, N>(7, 9), at<S, N>(20, 9), num<S>(5)}));
  CHECK_FALSE(meet(sphere, Pill{at<S, N>(7.5, 9), at<S, N>(20, 9), num<S>(5)}));
  CHECK(meet(sphere, Pill{at<S, N>(-20, 11), at<S, N>(20, 11), num<S>(5)}));
  CHECK_FALSE(meet(sphere, Pill{at<S, N>(-20, 11.5), at<S, N>(20, 11.5), num<S>(5)}));
  CHECK(meet(sphere, Pill{at<S, N>(0, 1), at<S, N>(2, 1), num<S>(1)}));
  CHECK(meet(sphere, Pill{at<S, N>(4, 5), at<S, N>(4, 5), num<S>(0)}));
  CHECK_FALSE(meet(sphere, Pill{sphere.center, sphere.center, num<S>(-1)}));
  CHECK_FALSE(meet(Sphere<S, N>{{}, num<S>(-1)}, Pill{at<S, N>(-1), at<S, N>(1), num<S>(5)}));
}

TEMPLATE_TEST_CASE("intersects, segment and sphere: through, tangent, inside, no length",
                   "[intersects]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Line = Segment<S, N>;
  const auto& sphere = ball<S, N>;
  CHECK(meet(Line{at<S, N>(-20, 3), at<S, N>(20, 3)}, sphere));
  CHECK(meet(Line{at<S, N>(-20, 6), at<S, N>(20, 6)}, sphere));
  CHECK_FALSE(meet(Line{at<S, N>(-20, 6.5), at<S, N>(20, 6.5)}, sphere));
  CHECK(meet(Line{at<S, N>(4, 5), at<S, N>(20, 5)}, sphere));
  CHECK_FALSE(meet(Line{at<S, N>(4.5, 5), at<S, N>(20, 5)}, sphere));
  CHECK(meet(Line{at<S, N>(0, 1), at<S, N>(2, 1)}, sphere));
  CHECK(meet(Line{at<S, N>(4, 5), at<S, N>(4, 5)}, sphere));
  CHECK_FALSE(meet(Line{at<S, N>(4, 5.5), at<S, N>(4, 5.5)}, sphere));
  CHECK_FALSE(meet(Line{at<S, N>(0, 1), at<S, N>(2, 1)}, Sphere<S, N>{{}, num<S>(-1)}));
}

TEMPLATE_TEST_CASE("overlaps, sphere: one raw unit decides, at the ends of the domain too",
                   "[overlaps]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = S::lowest(), high = S::max();
  auto left = Vec<S, N>(), right = Vec<S, N>();
  left.x = low;
  right.x = high;
  CHECK_FALSE(meet(Sphere<S, N>{left, high}, Sphere<S, N>{right, high}));
  right.x = moved(high, -1);
  CHECK(meet(Sphere<S, N>{left, high}, Sphere<S, N>{right, high}));
  const Sphere<S, N> world{{}, high};
  CHECK(meet(world, Aabb<S, N>{{}, filled<S, N>(high)}));
  CHECK_FALSE(meet(world, Aabb<S, N>{filled<S, N>(low), left}));
  CHECK_FALSE(meet(world, Capsule<S, N>{left, left, S(0)}));
  CHECK(meet(world, Capsule<S, N>{left, left, moved(S(0), 1)}));
  CHECK_FALSE(meet(Segment<S, N>{left, left}, world));
  left.x = moved(low, 1);
  CHECK(meet(Segment<S, N>{left, left}, world));
  CHECK(meet(world, Triangle<S, N>{left, left, filled<S, N>(low)}));
  CHECK(meet(world, Plane<S, N>{Direction<S, N>::along(0), high}));
  CHECK_FALSE(meet(world, Plane<S, N>{Direction<S, N>::along(0), low}));

  // As stored: the directions are too long, which moves surfaces by less than a raw unit.
  const Sphere<S, N> sphere{at<S, N>(3, 4), num<S>(5)};
  const auto normal = three_four_fifths<S, N>();
  CHECK(meet(sphere, Plane<S, N>{normal, S(0)}));
  CHECK_FALSE(meet(sphere, Plane<S, N>{normal, moved(S(0), -1)}));
  CHECK_FALSE(meet(sphere, Plane<S, N>{normal, moved(S(10), 1)}));
  Obb<S, N> box{at<S, N>(9, 12), filled<S, N>(num<S>(50)), three_four_fifths_frame<S, N>()};
  box.half_extents.x = num<S>(5);
  CHECK_FALSE(overlaps(sphere, box));
  box.half_extents.x = moved(num<S>(5), 1);
  CHECK(overlaps(sphere, box));
}

}  // namespace
}  // namespace detent::test
