// SPDX-License-Identifier: MIT
#include "detent/math/vec.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

static_assert(distance(at<q16_16, 3>(1, 2, 3), at<q16_16, 3>(3, 5, 9)) == q16_16(7));
static_assert(squared_distance(at<q16_16, 2>(1, 2), at<q16_16, 2>(3, 5)) == 13);

TEMPLATE_TEST_CASE("distance of two points: exact squares, roots rounded down", "[distance]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  CHECK(distance(at<S, N>(1, 2), at<S, N>(4, 6)) == num<S>(5));
  CHECK(distance(at<S, N>(4, 6), at<S, N>(1, 2)) == num<S>(5));
  CHECK(squared_distance(at<S, N>(1, 2), at<S, N>(4, 6)) == num<S>(25));
  CHECK(distance(at<S, N>(1, 2), at<S, N>(1, 2)) == num<S>(0));
}

TEMPLATE_TEST_CASE("distance of two points: over the whole domain, and at random", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  CHECK(distance(filled<S, N>(S::lowest()), filled<S, N>(S::max())) == S::max());
  auto far = Vec<S, N>();
  far.x = S::lowest();
  CHECK(distance(Vec<S, N>(), far) == S::max());

  Random random(0xd157);
  INFO(random);
  for (int i = 0; i < 20'000; ++i) {
    const auto a = random_point<S, N>(random), b = random_point<S, N>(random);
    const auto squared = squared_distance(a, b);
    const S root = distance(a, b);
    const auto after = root + S::from_raw(1);
    REQUIRE(root * root <= squared);
    REQUIRE((root == S::max() || after * after > squared));
    REQUIRE(distance(b, a) == root);
  }
}

}  // namespace
}  // namespace detent::test
