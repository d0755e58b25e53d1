// SPDX-License-Identifier: MIT
#include "detent/query/distance/obb.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("distance, obb: to the surface, 0 inside, the greatest scalar to nothing",
                   "[distance]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Obb<S, N> box{at<S, N>(1, 2), filled<S, N>(num<S>(3)), {}};
  CHECK(distance(box, at<S, N>(9, 3)) == num<S>(5));
  CHECK(distance(box, at<S, N>(7, 9)) == num<S>(5));
  CHECK(squared_distance(box, at<S, N>(7, 9)) == num<S>(25));
  CHECK(distance(box, at<S, N>(4, 3)) == num<S>(0));
  box.half_extents.x = num<S>(-1);
  CHECK(distance(box, box.center) == largest<S>);
}

TEMPLATE_TEST_CASE("distance, obb: coincident axes count one excess three times", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  auto axes = std::array<Direction<S, N>, static_cast<std::size_t>(N)>{};
  axes.fill(Direction<S, N>::along(0));
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  const Obb<S, N> point{low, {}, Rotation<S, N>::from_axes(axes)};
  const auto side = high.x - low.x;
  CHECK(squared_distance(point, high) == squared_length(make_vec<N>([&](int) { return side; })));
  CHECK(distance(point, high) == S::max());
}

}  // namespace
}  // namespace detent::test
