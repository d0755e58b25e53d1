// SPDX-License-Identifier: MIT
#include "detent/query/distance/ray.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("distance, ray: to the line, the origin or the end", "[distance]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Ray<S, N> ray{at<S, N>(1, 1), toward<S, N>(1), num<S>(8)};
  CHECK(distance(ray, at<S, N>(3, 5)) == num<S>(4));
  CHECK(distance(ray, at<S, N>(-2, 5)) == num<S>(5));
  CHECK(distance(ray, at<S, N>(12, -3)) == num<S>(5));
  CHECK(distance(ray, at<S, N>(4, 1)) == num<S>(0));
  ray.max_distance = num<S>(-1);
  CHECK(distance(ray, ray.origin) == largest<S>);
}

TEMPLATE_TEST_CASE("distance, ray: exact for the stored direction, and clamped", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Ray<S, N> ray{Vec<S, N>(), three_four_fifths<S, N>(), S::max()};
  CHECK(distance(ray, at<S, N>(30 - 8, 40 + 6)) == S(10));
  CHECK(distance(ray, at<S, N>(30, 40)) == S(0));
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(distance(Ray<S, N>{low, toward<S, N>(-1)}, high) == S::max());
  CHECK(distance(Ray<S, N>{low, toward<S, N>(1)}, high) == S::max());
}

TEMPLATE_TEST_CASE("distance, ray: near an end, whatever the direction's length", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(0x4e7d);
  INFO(random);
  const auto any = [&] {
    return S::from_raw(
        static_cast<typename S::raw_type>(random.between(-S::max().raw(), S::max().raw())));
  };
  int beyond = 0, count = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto direction = normalize(make_vec<N>([&](int) { return any(); }));
    if (!direction) continue;
    const auto reach =
        S::from_raw(static_cast<typename S::raw_type>(S::max().raw() / 2 - any().raw() / 4));
    const Ray<S, N> ray{Vec<S, N>(), *direction, reach};
    const auto end = nearest_to<S>(*direction * reach);
    const auto point = make_vec<N>([&](int j) {
      const auto step = static_cast<typename S::raw_type>(random.between(-70, 70));
      return S::from_raw(static_cast<typename S::raw_type>(end[j].raw() + step));
    });
    const auto squared = squared_distance(ray, point);
    CHECK(distance(ray, point) == sqrt_floor<S>(squared));
    ++count;
    beyond += squared.denominator == 1 ? 1 : 0;
  }
  CHECK(count > 15'000);
  CHECK(beyond > count / 4);
  CHECK(beyond < count * 3 / 4);
}

}  // namespace
}  // namespace detent::test
