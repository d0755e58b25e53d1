// SPDX-License-Identifier: MIT
#include "detent/query/closest_points/compound.hpp"

#include <array>
#include <utility>

#include "detent/query/closest_points.hpp"
#include "detent/query/distance.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("closest points: of a compound, those of its nearest part, the first of several",
                   "[closest_points]", DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Points = std::pair<Vec<S, N>, Vec<S, N>>;
  const std::array balls{Sphere<S, N>{at<S, N>(-7), num<S>(1)},
                         Sphere<S, N>{at<S, N>(5), num<S>(2)},
                         Sphere<S, N>{at<S, N>(-5), num<S>(2)}};
  const std::array boxes{Aabb<S, N>{at<S, N>(4, 9, 9), at<S, N>(9, 10, 10)}};
  const Compound compound{balls, boxes};
  const Sphere<S, N> ball{{}, num<S>(1)};
  CHECK(closest_points(compound, ball) == Points{at<S, N>(3), at<S, N>(1)});
  CHECK(closest_points(ball, compound) == Points{at<S, N>(1), at<S, N>(3)});
  const std::array others{ball};
  CHECK(closest_points(compound, Compound{others}) == Points{at<S, N>(3), at<S, N>(1)});
  CHECK(closest_points(ball, Compound<Sphere<S, N>>{}) == Points());
}

}  // namespace
}  // namespace detent::test
