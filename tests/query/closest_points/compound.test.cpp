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

TEMPLATE_TEST_CASE(
    "closest points: of a compound are those of its part, in either order, at ties too",
    "[closest_points]", DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto box = [](int least, int greatest) {
    return Aabb<S, N>{at<S, N>(least, least, least), at<S, N>(greatest, greatest, greatest)};
  };
  const Segment<S, N> edge{at<S, N>(0, 9), at<S, N>(4, 9)};
  const auto check = [](const auto& a, const auto& b) {
    const std::array as{a};
    const std::array bs{b};
    const auto expected = closest_points(a, b);
    CHECK(closest_points(Compound{as}, b) == expected);
    CHECK(closest_points(a, Compound{bs}) == expected);
    CHECK(closest_points(Compound{as}, Compound{bs}) == expected);
  };
  check(box(0, 4), box(2, 6));
  check(box(2, 6), box(0, 4));
  check(edge, box(0, 4));
  check(box(0, 4), edge);
}

TEMPLATE_TEST_CASE("closest points: an empty part of a compound changes nothing",
                   "[closest_points]", DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  if (!is_fixed<S>) return;  // only fixed-point distances are clamped
  auto low = at<S, N>(0), high = at<S, N>(0);
  for (int i = 0; i < N; ++i) {
    low[i] = lowest<S>;
    high[i] = largest<S>;
  }
  const Sphere<S, N> empty{{}, num<S>(-1)}, far{low, num<S>(0)}, ball{high, num<S>(1)};
  const std::array parts{empty, far};
  const std::array empties{empty}, fars{far};
  const std::array nested{Compound{empties}, Compound{fars}};
  CHECK(closest_points(Compound{parts}, ball) == closest_points(far, ball));
  CHECK(closest_points(Compound{nested}, ball) == closest_points(far, ball));
  CHECK(closest_points(ball, Compound{parts}) == closest_points(ball, far));
}

}  // namespace
}  // namespace detent::test
