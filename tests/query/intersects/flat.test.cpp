// SPDX-License-Identifier: MIT
#include "query/overlaps/helpers.hpp"

namespace detent::test {
namespace {

static_assert(intersects(Segment<q16_16, 3>{}, Segment<q16_16, 3>{}));
static_assert(intersects(Segment<q16_16, 2>{}, Triangle<q16_16, 2>{}));

TEMPLATE_TEST_CASE("intersects, segments: crossing, ends, collinear, parallel, points",
                   "[intersects]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Line = Segment<S, N>;
  const Line line{at<S, N>(0, 0), at<S, N>(8, 4)};
  CHECK(meet(line, Line{at<S, N>(4, 0), at<S, N>(4, 9)}));
  CHECK(meet(line, Line{at<S, N>(4, 2), at<S, N>(4, 9)}));
  CHECK_FALSE(meet(line, Line{at<S, N>(4, 2.5), at<S, N>(4, 9)}));
  CHECK(meet(line, Line{at<S, N>(8, 4), at<S, N>(9, 0)}));
  CHECK_FALSE(meet(line, Line{at<S, N>(8.5, 0), at<S, N>(8.5, 9)}));
  CHECK(meet(line, Line{at<S, N>(4, 0, -1), at<S, N>(4, 4, 1)}));
  CHECK(meet(line, Line{at<S, N>(4, 0, 1), at<S, N>(4, 4, 1)}) == (N == 2));
  CHECK(meet(line, Line{at<S, N>(6, 3), at<S, N>(10, 5)}));
  CHECK(meet(line, Line{at<S, N>(8, 4), at<S, N>(10, 5)}));
  CHECK_FALSE(meet(line, Line{at<S, N>(10, 5), at<S, N>(12, 6)}));
  CHECK_FALSE(meet(line, Line{at<S, N>(0, 1), at<S, N>(8, 5)}));
  const Line point{at<S, N>(2, 1), at<S, N>(2, 1)}, other{at<S, N>(2, 2), at<S, N>(2, 2)};
  CHECK(meet(line, point));
  CHECK_FALSE(meet(line, other));
  CHECK(meet(point, point));
  CHECK_FALSE(meet(point, other));
}

TEMPLATE_TEST_CASE("intersects, segment and triangle: through, edge, corner, within, collapsed",
                   "[intersects]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Line = Segment<S, N>;
  const auto triangle = right_triangle<S, N>();
  for (const auto& t : {triangle, Triangle<S, N>{triangle.a, triangle.c, triangle.b}}) {
    CHECK(meet(Line{at<S, N>(2, 2, -1), at<S, N>(2, 2, 1)}, t));
    CHECK(meet(Line{at<S, N>(4, 4, -1), at<S, N>(4, 4, 1)}, t));
    CHECK_FALSE(meet(Line{at<S, N>(4, 4.5, -1), at<S, N>(4, 4.5, 1)}, t));
    CHECK(meet(Line{at<S, N>(8, 0), at<S, N>(9, 0, 5)}, t));
    CHECK(meet(Line{at<S, N>(1, 1), at<S, N>(2, 3)}, t));
    CHECK(meet(Line{at<S, N>(-9, 4), at<S, N>(9, 4)}, t));
    CHECK(meet(Line{at<S, N>(-1, 9), at<S, N>(9, -1)}, t));
    CHECK_FALSE(meet(Line{at<S, N>(-1, 9.5), at<S, N>(9.5, -1)}, t));
    CHECK(meet(Line{at<S, N>(2, 2, 1), at<S, N>(3, 2, 5)}, t) == (N == 2));
    CHECK_FALSE(meet(Line{at<S, N>(9, 0), at<S, N>(12, 0)}, t));
    CHECK(meet(Line{at<S, N>(2, 2), at<S, N>(2, 2)}, t));
    CHECK_FALSE(meet(Line{at<S, N>(5, 4), at<S, N>(5, 4)}, t));
  }
  const Triangle<S, N> line{at<S, N>(0, 0), at<S, N>(8, 4), at<S, N>(4, 2)};
  CHECK(meet(Line{at<S, N>(6, 0), at<S, N>(6, 9)}, line));
  CHECK_FALSE(meet(Line{at<S, N>(6, 3.5), at<S, N>(6, 9)}, line));
  CHECK(meet(Line{at<S, N>(8, 4), at<S, N>(10, 5)}, line));
  CHECK(meet(Line{line.a, line.b}, Triangle<S, N>{line.c, line.c, line.c}));
}

TEMPLATE_TEST_CASE("intersects, segment and boxes: inside, through, face, corner, empty",
                   "[intersects]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Line = Segment<S, N>;
  const auto check = [](const auto& box) {
    CHECK(meet(Line{at<S, N>(-1, 0), at<S, N>(1, 0)}, box));
    CHECK(meet(Line{at<S, N>(1, 1, 1), at<S, N>(1, 1, 1)}, box));
    CHECK(meet(Line{at<S, N>(-9, 0), at<S, N>(9, 1)}, box));
    CHECK(meet(Line{at<S, N>(2, 0), at<S, N>(9, 0)}, box));
    CHECK_FALSE(meet(Line{at<S, N>(2.5, 0), at<S, N>(9, 0)}, box));
    CHECK(meet(Line{at<S, N>(-9, 2), at<S, N>(9, 2)}, box));
    CHECK_FALSE(meet(Line{at<S, N>(-9, 2.5), at<S, N>(9, 2.5)}, box));
    CHECK(meet(Line{at<S, N>(1, 3), at<S, N>(3, 1)}, box));
    CHECK_FALSE(meet(Line{at<S, N>(1, 3.5), at<S, N>(3.5, 1)}, box));
    CHECK(meet(Line{at<S, N>(0, 0, 1), at<S, N>(0, 0, 9)}, box));
    CHECK_FALSE(meet(Line{at<S, N>(2.5, 2), at<S, N>(2.5, 2)}, box));
  };
  const auto two = filled<S, N>(num<S>(2));
  check(Aabb<S, N>{filled<S, N>(num<S>(-2)), two});
  check(Obb<S, N>{{}, two, {}});
  const Line line{at<S, N>(-9, 0), at<S, N>(9, 0)};
  CHECK(meet(line, Aabb<S, N>{{}, {}}));
  CHECK(meet(line, Obb<S, N>{}));
  CHECK_FALSE(intersects(line, Aabb<S, N>{at<S, N>(1), at<S, N>(-1)}));
  CHECK_FALSE(meet(line, Obb<S, N>{{}, at<S, N>(-1, 9, 9), {}}));
}

TEMPLATE_TEST_CASE("intersects, segment and plane: through, end, within, parallel", "[intersects]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Line = Segment<S, N>;
  const Plane<S, N> plane{Direction<S, N>::along(0), num<S>(3)};
  CHECK(meet(Line{at<S, N>(0, 0), at<S, N>(9, 9)}, plane));
  CHECK(meet(Line{at<S, N>(3, 0), at<S, N>(9, 9)}, plane));
  CHECK(meet(Line{at<S, N>(3, 0), at<S, N>(3, 9)}, plane));
  CHECK(meet(Line{at<S, N>(3, 5), at<S, N>(3, 5)}, plane));
  CHECK_FALSE(meet(Line{at<S, N>(3.5, 0), at<S, N>(9, 9)}, plane));
  CHECK_FALSE(meet(Line{at<S, N>(0, 0), at<S, N>(2.5, 9)}, plane));
}

TEMPLATE_TEST_CASE("intersects, flat: one raw unit decides, at the ends of the domain too",
                   "[intersects]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  const Segment<S, N> diagonal{low, high};
  auto side = low, beside = Vec<S, N>();
  side.x = S::max();
  beside.x = moved(S(0), 1);
  for (const auto& p : {Vec<S, N>(), beside}) {
    const bool inside = p == Vec<S, N>();
    CHECK(meet(diagonal, Segment<S, N>{p, side}) == inside);
    CHECK(meet(diagonal, Triangle<S, N>{p, p, side}) == inside);
    CHECK(meet(diagonal, Aabb<S, N>{p, p}) == inside);
    CHECK(meet(diagonal, Obb<S, N>{p, {}, {}}) == inside);
  }
  CHECK(meet(diagonal, Triangle<S, N>{low, side, high}));
  CHECK(meet(diagonal, Aabb<S, N>{low, high}));
  CHECK(meet(diagonal, Obb<S, N>{high, high, {}}));
  CHECK(meet(diagonal, Plane<S, N>{Direction<S, N>::along(0), S::max()}));
  CHECK_FALSE(meet(Segment<S, N>{low, {}}, Plane<S, N>{Direction<S, N>::along(0), beside.x}));
}

}  // namespace
}  // namespace detent::test
