// SPDX-License-Identifier: MIT
#include <array>

#include "query/cast/shapes.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("cast: the first part of a compound that is touched is the hit", "[cast]",
                   (Space<q16_16, 3>), (Space<double, 2>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const std::array<Sphere<S, N>, 2> spheres{Sphere{at<S, N>(9), num<S>(1)},
                                            Sphere{at<S, N>(6), num<S>(1)}};
  const std::array<Aabb<S, N>, 1> boxes{Aabb{at<S, N>(5, -1, -1), at<S, N>(7, 1, 1)}};
  const Compound compound{spheres, boxes};
  const Sphere<S, N> ball{at<S, N>(0), num<S>(1)};
  const auto right = toward<S, N>(1);
  const auto hit = cast(ball, right, num<S>(9), compound);
  CHECK(hit == cast(ball, right, num<S>(9), spheres[1]));
  CHECK(detail::cast_distance(ball, right, num<S>(9), compound) == num<S>(4));
  CHECK(cast(Cast{ball, right}, compound) == hit);
  CHECK_FALSE(cast(ball, right, num<S>(3), compound));
  CHECK_FALSE(cast(ball, right, num<S>(3), Compound<Sphere<S, N>>()));
}

}  // namespace
}  // namespace detent::test
