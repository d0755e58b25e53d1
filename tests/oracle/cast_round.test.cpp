// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"
#include "query/cast/shapes.hpp"

namespace detent::oracle {
namespace {

TEST_CASE("cast of round shapes: every answer is exact", "[oracle]") {
  examine_casts<q16_16, 3, CastFamily::round>(0xca57, 12);
}

TEST_CASE("cast of round shapes: many more answers are exact", "[oracle][.demand]") {
  for (const auto seed : demanded_seeds()) examine_casts<q16_16, 3, CastFamily::round>(seed, 100);
}

#if DETENT_TEST_ALL
// Examples of the same pairs, which share their instantiations.
TEST_CASE("cast: a sphere or capsule against every kind of shape", "[cast]") {
  test::visit_round<q16_16, 3>(-3, [](const auto& shape) { test::check_casts<q16_16, 3>(shape); });
}

TEST_CASE("cast: a sphere touches the face, edge or corner of a box", "[cast]") {
  using S = q16_16;
  const Aabb<S, 3> box{test::at<S, 3>(5, -1, -1), test::at<S, 3>(7, 1, 1)};
  const auto right = test::toward<S, 3>(1);
  const auto at_height = [&](double y, double z) {
    return cast(Sphere<S, 3>{test::at<S, 3>(0, y, z), test::num<S>(5)}, right, test::num<S>(9),
                box);
  };
  const auto face = at_height(1, -1);
  REQUIRE(face);
  CHECK(face->distance == S(0));  // touches at the start
  const auto near_face = cast(Sphere<S, 3>{test::at<S, 3>(-3, 0.5, -0.5), test::num<S>(5)}, right,
                              test::num<S>(9), box);
  REQUIRE(near_face);
  CHECK(*near_face == CastHit<S, 3>{test::num<S>(3), test::at<S, 3>(5, 0.5, -0.5), -right});
  // 3, 4, 5 from the edge at y = 1.
  const auto edge = at_height(4 + 1, 0);
  REQUIRE(edge);
  CHECK(edge->distance == test::num<S>(2));
  CHECK(edge->point.y == test::num<S>(1));
  CHECK(edge->normal == test::toward<S, 3>(-3, 4));
  // At a distance of exactly 5 it touches the box; a step farther away it misses.
  const auto graze = at_height(6, 0);
  REQUIRE(graze);
  CHECK(graze->distance == test::num<S>(5));
  CHECK(graze->normal == test::toward<S, 3>(0, 1));
  const auto pass = Sphere<S, 3>{{S(0), test::moved(test::num<S>(6), 1), S(0)}, test::num<S>(5)};
  CHECK_FALSE(cast(pass, right, test::num<S>(9), box));
}
#endif

}  // namespace
}  // namespace detent::oracle
