// SPDX-License-Identifier: MIT
#include "detent/query/distance/aabb.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("distance, aabb: to the surface, 0 inside, the greatest scalar to nothing",
                   "[distance]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Aabb<S, N> box{filled<S, N>(num<S>(-2)), filled<S, N>(num<S>(3))};
  CHECK(distance(box, at<S, N>(7, 1)) == num<S>(4));
  CHECK(distance(box, at<S, N>(6, 7)) == num<S>(5));
  CHECK(squared_distance(box, at<S, N>(6, 7)) == num<S>(25));
  CHECK(distance(box, at<S, N>(3, 1)) == num<S>(0));
  CHECK(distance(box, at<S, N>(1, 1)) == num<S>(0));
  CHECK(distance(Aabb<S, N>{box.max, box.min}, Vec<S, N>()) == largest<S>);
  CHECK(squared_distance(Aabb<S, N>{box.max, box.min}, Vec<S, N>()) >
        squared_distance(box, at<S, N>(100, 100)));
}

TEMPLATE_TEST_CASE("distance, aabb: exact squares, clamped roots", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  const auto side = high.x - low.x;
  CHECK(squared_distance(Aabb<S, N>{low, low}, high) ==
        squared_length(make_vec<N>([&](int) { return side; })));
  CHECK(distance(Aabb<S, N>{low, low}, high) == S::max());
}

}  // namespace
}  // namespace detent::test
