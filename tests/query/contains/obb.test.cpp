// SPDX-License-Identifier: MIT
#include "detent/query/contains/obb.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("contains, obb: the slabs are closed", "[contains]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Obb<S, N> box{at<S, N>(1, 2), filled<S, N>(num<S>(3)), {}};
  CHECK(contains(box, box.center));
  CHECK(contains(box, at<S, N>(4, 5)));
  CHECK(contains(box, at<S, N>(-2, 2)));
  CHECK_FALSE(contains(box, at<S, N>(4.5, 2)));
  CHECK_FALSE(contains(box, at<S, N>(1, -1.5)));
  box.half_extents.y = num<S>(0);
  CHECK(contains(box, at<S, N>(3, 2)));
  CHECK_FALSE(contains(box, at<S, N>(3, 2.5)));
  box.half_extents.y = num<S>(-1);
  CHECK_FALSE(contains(box, box.center));
}

TEMPLATE_TEST_CASE("contains, obb: rotated by 45 degrees", "[contains]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Obb<S, N> box{{}, filled<S, N>(num<S>(1)), heading<S, N>(1, 1)};
  CHECK(contains(box, at<S, N>(1.25, 0)));
  CHECK(contains(box, at<S, N>(0, -1.25)));
  CHECK_FALSE(contains(box, at<S, N>(1, 1)));
  CHECK_FALSE(contains(box, at<S, N>(1.5, 0)));
}

TEMPLATE_TEST_CASE("contains, obb: one raw unit decides, at the ends of the domain too",
                   "[contains]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK_FALSE(contains(Obb<S, N>{low, high, {}}, high));
  CHECK(contains(Obb<S, N>{{}, high, {}}, high));
  CHECK_FALSE(contains(Obb<S, N>{{}, high, {}}, low));
  CHECK_FALSE(contains(Obb<S, N>{{}, filled<S, N>(moved(S::max(), -1)), {}}, high));
}

}  // namespace
}  // namespace detent::test
