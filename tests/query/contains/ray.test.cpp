// SPDX-License-Identifier: MIT
#include "detent/query/contains/ray.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

// A float library with a tolerance on the cosine reported this point as on the ray.
constexpr Ray<q16_16, 3> along_z{{}, toward<q16_16, 3>(0, 0, 1)};
static_assert(!contains(along_z, at<q16_16, 3>(4, 0, 10000)));
static_assert(contains(along_z, at<q16_16, 3>(0, 0, 10000)));

TEMPLATE_TEST_CASE("contains, ray: its points, up to its length", "[contains]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Ray<S, N> ray{at<S, N>(1, 1), toward<S, N>(0, -1), num<S>(5)};
  CHECK(contains(ray, ray.origin));
  CHECK(contains(ray, at<S, N>(1, -2)));
  CHECK(contains(ray, at<S, N>(1, -4)));
  CHECK_FALSE(contains(ray, at<S, N>(1, -4.5)));
  CHECK_FALSE(contains(ray, at<S, N>(1, 2)));
  CHECK_FALSE(contains(ray, at<S, N>(1.5, -2)));
  auto cut = ray;
  cut.max_distance = num<S>(0);
  CHECK(contains(cut, ray.origin));
  CHECK_FALSE(contains(cut, at<S, N>(1, 0.5)));
  cut.max_distance = num<S>(-1);
  CHECK_FALSE(contains(cut, ray.origin));
}

TEMPLATE_TEST_CASE("contains, ray: uses the direction exactly as stored", "[contains]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  // The direction is 2^-30 (2^-14) too long, so the ray reaches the point just before 50.
  Ray<S, N> ray{Vec<S, N>(), three_four_fifths<S, N>(), S(50)};
  CHECK(contains(ray, at<S, N>(30, 40)));
  CHECK_FALSE(contains(ray, at<S, N>(33, 44)));
  CHECK_FALSE(contains(ray, at<S, N>(30, 40 + 1.0 / (1 << S::frac))));
  ray.max_distance = moved(ray.max_distance, -1);
  CHECK_FALSE(contains(ray, at<S, N>(30, 40)));
  const auto low = filled<S, N>(S::lowest());
  auto far = low;
  far.x = S::max();
  CHECK_FALSE(contains(Ray<S, N>{low, toward<S, N>(1)}, far));
  far.x = moved(S::lowest(), S::max().raw());
  CHECK(contains(Ray<S, N>{low, toward<S, N>(1)}, far));
}

}  // namespace
}  // namespace detent::test
