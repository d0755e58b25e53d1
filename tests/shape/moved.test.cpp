// SPDX-License-Identifier: MIT
#include "detent/shape/moved.hpp"

#include "detent/shape/segment.hpp"
#include "support/catch.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;

namespace {

constexpr Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }
const auto quarter = Rotation<S, 3>::from_euler({}, {}, Angle<S>::turn(1, 4));
const Transform<S, 3> motion{at(10, 0, 0), quarter, S(-2)};

}  // namespace

TEST_CASE("translated: every shape moves by the vector and clamps at the end of the world") {
  const auto by = at(1, 2, 3);
  CHECK(translated(Sphere{at(0, 0, 0), S(1)}, by) == Sphere{by, S(1)});
  CHECK(translated(Aabb{at(0, 0, 0), at(1, 1, 1)}, by) == Aabb{by, at(2, 3, 4)});
  CHECK(translated(Obb{at(0, 0, 0), at(1, 1, 1), quarter}, by) == Obb{by, at(1, 1, 1), quarter});
  CHECK(translated(Triangle{at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)}, by) ==
        Triangle{by, at(2, 2, 3), at(1, 3, 3)});
  CHECK(translated(Capsule{at(0, 0, 0), at(1, 0, 0), S(1)}, by) == Capsule{by, at(2, 2, 3), S(1)});
  CHECK(translated(Segment{at(0, 0, 0), at(1, 0, 0)}, by) == Segment{by, at(2, 2, 3)});
  CHECK(translated(Plane{Direction<S, 3>::along(1), S(5)}, by) ==
        Plane{Direction<S, 3>::along(1), S(7)});
  CHECK(translated(Sphere{at(32767, 0, 0), S(1)}, at(9, 0, 0)).center.x == S::max());
}

TEST_CASE("placed: rotated, mirrored, scaled and moved") {
  CHECK(placed(motion, Sphere{at(1, 0, 0), S(1)}) == Sphere{at(10, -2, 0), S(2)});
  CHECK(placed(motion, Aabb{at(0, 0, 0), at(1, 2, 3)}) == Aabb{at(10, -2, -6), at(14, 0, 0)});
  CHECK(placed(motion, Obb{at(1, 0, 0), at(1, 2, 3), {}}) ==
        Obb{at(10, -2, 0), at(2, 4, 6), quarter});
  CHECK(placed(motion, Triangle{at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)}) ==
        Triangle{at(10, 0, 0), at(10, -2, 0), at(12, 0, 0)});
  CHECK(placed(motion, Capsule{at(0, 0, 0), at(1, 0, 0), S(1)}) ==
        Capsule{at(10, 0, 0), at(10, -2, 0), S(2)});
  CHECK(placed(motion, Segment{at(0, 0, 0), at(1, 0, 0)}) == Segment{at(10, 0, 0), at(10, -2, 0)});
  // x = 3 goes to y = -6, and its normal to -y.
  CHECK(placed(motion, Plane{Direction<S, 3>::along(0), S(3)}) ==
        Plane{-Direction<S, 3>::along(1), S(6)});
}

TEST_CASE("placed: an empty shape stays empty, and a scale of 0 leaves a point") {
  CHECK(placed(motion, Sphere{at(0, 0, 0), S(-1)}).radius == S(-1));
  CHECK(is_empty(placed(motion, Aabb{at(1, 0, 0), at(0, 0, 0)})));
  CHECK(is_empty(placed(motion, Obb{at(0, 0, 0), at(1, -1, 1), {}})));
  const Transform<S, 3> nowhere{at(1, 2, 3), quarter, S(0)};
  CHECK(placed(nowhere, Sphere{at(7, 7, 7), S(3)}) == Sphere{at(1, 2, 3), S(0)});
  CHECK(placed(nowhere, Aabb{at(0, 0, 0), at(1, 2, 3)}) == Aabb{at(1, 2, 3), at(1, 2, 3)});
}

TEST_CASE("placed: a rotated AABB contains its corners") {
  const auto turn = Rotation<S, 3>::from_euler(Angle<S>::turn(1, 7), Angle<S>::turn(1, 5), {});
  const Transform<S, 3> skew{at(1, 1, 1), turn, S(3)};
  const auto around = placed(skew, Aabb{at(-1, -2, -3), at(4, 5, 6)});
  for (int i = 0; i < 8; ++i) {
    const auto corner = transform_point(skew, at(i & 1 ? 4 : -1, i & 2 ? 5 : -2, i & 4 ? 6 : -3));
    for (int j = 0; j < 3; ++j) {
      CHECK(around.min[j] <= corner[j]);
      CHECK(corner[j] <= around.max[j]);
    }
  }
}
