// SPDX-License-Identifier: MIT
#include "detent/query/contains/aabb.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

static_assert(contains(Aabb<q16_16, 3>{{}, at<q16_16, 3>(1, 1, 1)}, at<q16_16, 3>(1, 0.5)));

TEMPLATE_TEST_CASE("contains, aabb: the box is closed", "[contains]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Aabb<S, N> box{filled<S, N>(num<S>(-2)), filled<S, N>(num<S>(3))};
  CHECK(contains(box, Vec<S, N>()));
  CHECK(contains(box, box.min));
  CHECK(contains(box, box.max));
  CHECK(contains(box, at<S, N>(3, 1)));
  CHECK_FALSE(contains(box, at<S, N>(3.5, 1)));
  CHECK_FALSE(contains(box, at<S, N>(0, -2.5)));
  CHECK(contains(Aabb<S, N>{box.min, box.min}, box.min));
  CHECK_FALSE(contains(Aabb<S, N>{box.min, box.min}, box.max));
  auto inverted = box;
  inverted.min.y = num<S>(4);
  CHECK_FALSE(contains(inverted, at<S, N>(0, 3.5)));
}

TEMPLATE_TEST_CASE("contains, aabb: one raw unit decides, at the ends of the domain too",
                   "[contains]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(contains(Aabb<S, N>{low, high}, low));
  CHECK(contains(Aabb<S, N>{low, high}, high));
  CHECK_FALSE(contains(Aabb<S, N>{low, filled<S, N>(moved(S::max(), -1))}, high));
  CHECK_FALSE(contains(Aabb<S, N>{filled<S, N>(moved(S::lowest(), 1)), high}, low));
}

}  // namespace
}  // namespace detent::test
