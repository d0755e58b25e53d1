// SPDX-License-Identifier: MIT
#include "detent/query/intersection.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

static_assert(!intersection(Plane<q16_16, 2>{}, Plane<q16_16, 2>{}));

TEMPLATE_TEST_CASE("intersection: the point of three planes", "[intersection]", q16_16, q14_16,
                   q24_8, q8_8, float, double) {
  using S = TestType;
  const auto plane = [](const Direction<S, 3>& normal, double offset) {
    return Plane<S, 3>{normal, num<S>(offset)};
  };
  const auto x = Direction<S, 3>::along(0), y = Direction<S, 3>::along(1);
  const auto z = Direction<S, 3>::along(2);
  CHECK(intersection(plane(x, 1), plane(y, 2), plane(z, 3)) == at<S, 3>(1, 2, 3));
  CHECK(intersection(plane(z, 3), plane(-x, 1), plane(-y, -2)) == at<S, 3>(-1, 2, 3));
  CHECK(intersection(plane(x, 0), plane(y, 0), plane(toward<S, 3>(1, 2, 3), 0)) == at<S, 3>(0, 0));
  CHECK_FALSE(intersection(plane(x, 1), plane(y, 2), plane(-x, -1)).has_value());
  CHECK_FALSE(intersection(plane(x, 1), plane(x, 1), plane(x, 1)).has_value());
  CHECK_FALSE(intersection(plane(x, 1), plane(y, 2), plane(toward<S, 3>(3, 4), 5)).has_value());
}

TEMPLATE_TEST_CASE("intersection: the point of two lines", "[intersection]", q16_16, q14_16, q24_8,
                   q8_8, float, double) {
  using S = TestType;
  const auto x = Direction<S, 2>::along(0), y = Direction<S, 2>::along(1);
  const Plane<S, 2> one{x, num<S>(1)}, two{y, num<S>(2)};
  CHECK(intersection(one, two) == at<S, 2>(1, 2));
  CHECK(intersection(two, one) == at<S, 2>(1, 2));
  CHECK(intersection(one, Plane<S, 2>{-y, num<S>(2)}) == at<S, 2>(1, -2));
  CHECK_FALSE(intersection(one, Plane<S, 2>{-x, num<S>(1)}).has_value());
}

TEMPLATE_TEST_CASE("intersection: a distant point is clamped to the domain", "[intersection]",
                   q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  using D = Direction<S, 2>;
  auto tilted = D::along(0).vec();
  tilted.y = moved(tilted.y, 1);
  const Plane<S, 2> line{D::along(0), S(0)};
  const Plane<S, 2> other{D::assume_unit(tilted), moved(S(0), 2)};
  CHECK(intersection(line, other) == Vec<S, 2>{S(0), S::max()});
  CHECK(intersection(line, Plane<S, 2>{other.normal, moved(S(0), -2)}) ==
        Vec<S, 2>{S(0), S::lowest()});
}

}  // namespace
}  // namespace detent::test
