// SPDX-License-Identifier: MIT
#include "detent/query/closest_points/plane.hpp"

#include "detent/math/direction.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using Place = Fixed<63, 46>;  // a corner of an oriented box

/// Compares the filter with the exact foot, for corners whose coordinates are near midpoints.
template <int N>
void compare(std::uint64_t seed) {
  using S = q16_16;
  Random random(seed);
  INFO(random);
  int wrong = 0;
  HitRate sure;
  for (int i = 0; i < 20'000; ++i) {
    const int bits = static_cast<int>(random.below(31));
    const auto raw = [&] { return S::from_raw(static_cast<S::raw_type>(random.wide(30))); };
    auto direction = normalize(make_vec<N>([&](int) { return raw(); }));
    if (i % 4 == 0 || !direction) {
      Vec<S, N> axis{};
      axis[i / 4 % N] = S(random.coin() ? 1 : -1);
      direction = normalize(axis);
    }
    const Plane<S, N> plane{*direction, raw()};
    const auto corner = make_vec<N>([&](int) {
      const std::int64_t half = (2 * random.wide(32) + 1) << 29;
      return Place::from_raw(half + (random.coin() ? 0 : random.wide(bits)));
    });
    const auto& n = plane.normal.vec();
    const auto above = detail::height_above(plane, corner);
    const auto whole = squared_length(plane.normal);
    const auto found = detail::decide_foot<S>(n, corner, above, whole);
    sure.count(found.is_sure);
    if (!found.is_sure) continue;
    const auto exact = detail::RationalPoint{corner * whole - n * above, whole};
    wrong += found.value == detail::rounded<S>(exact) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(sure.percent() >= 30);
}

TEST_CASE("closest_points, plane: the filter rounds the foot of a corner like the exact point",
          "[closest_points]") {
  compare<2>(0x91a2);
  compare<3>(0x91a3);
}

}  // namespace
}  // namespace detent::test
