// SPDX-License-Identifier: MIT
#include "detent/query/closest_points/plane.hpp"

#include <cmath>
#include <utility>

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

/// The filter's point of two planes.
template <class S, int N>
Decided<Vec<S, N>> point_by_filter(const Plane<S, N>& a, const Plane<S, N>& b) {
  using Point = Decided<Vec<S, N>>;
  return detail::decide_point_of_planes(
      a, b,
      [](const auto&... x) {
        return Point{{x...}, true};
      },
      [] {
        return Point{{}, false};
      });
}

/// Compares the filter with the exact point of two planes, where a coordinate is near a midpoint.
template <int N>
void compare_planes(std::uint64_t seed) {
  using S = q16_16;
  Random random(seed);
  INFO(random);
  int wrong = 0;
  HitRate sure;
  const auto raw = [&](int bits) {
    return S::from_raw(static_cast<S::raw_type>(random.wide(bits)));
  };
  for (int i = 0; i < 500; ++i) {
    const auto vec = [&] { return make_vec<N>([&](int) { return raw(24); }); };
    const auto m = normalize(vec()), n = normalize(vec());
    if (!m || !n) continue;
    const auto as_double = [](const auto& v) {
      return make_vec<N>([&](int k) { return static_cast<double>(v[k]); });
    };
    const auto u = as_double(*m), v = as_double(*n);
    const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), whole = uu * vv - uv * uv;
    const auto per_a = (u * vv - v * uv) * (65536 / whole);
    const auto per_b = (v * uu - u * uv) * (65536 / whole);
    for (int j = 0; j < 2'000; ++j) {
      const Plane<S, N> a{*m, raw(28)}, b{*n, raw(28)};
      const auto steps =
          per_a * static_cast<double>(a.offset) + per_b * static_cast<double>(b.offset);
      bool is_near = j < 20;
      for (int k = 0; k < N; ++k) {
        is_near |= std::abs(steps[k] - std::floor(steps[k]) - 0.5) * 16384 < 1;
      }
      if (!is_near) continue;
      const auto found = point_by_filter(a, b);
      sure.count(found.is_sure);
      if (!found.is_sure) continue;
      wrong += found.value == detail::exact_closest_points_of_planes(a, b).first ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  CHECK(sure.percent() >= 30);
}

/// 1 / a modulo m, or 0 if there is none.
std::int64_t inverse_modulo(std::int64_t a, std::int64_t m) {
  std::int64_t r = m, next = (a % m + m) % m, x = 0, next_x = 1;
  while (next != 0) {
    const std::int64_t quotient = r / next;
    r = std::exchange(next, r - quotient * next);
    x = std::exchange(next_x, x - quotient * next_x);
  }
  return r == 1 ? (x % m + m) % m : 0;
}

/// The same for a vertical line in 2D: y = (b.offset 2^30 - n.x a.offset) / n.y in raw numbers, where
/// the remainder is a few steps from half of n.y.
void compare_near_ties(std::uint64_t seed) {
  using S = q16_16;
  Random random(seed);
  INFO(random);
  int wrong = 0, unsure = 0, all = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto raw = [&](int bits) {
      return S::from_raw(static_cast<S::raw_type>(random.wide(bits)));
    };
    const auto n = normalize(Vec<S, 2>{raw(20), raw(20)});
    if (!n || (*n)[1].raw() < 1 << 23) continue;
    const std::int64_t x = (*n)[0].raw(), y = (*n)[1].raw();
    const std::int64_t inverse = inverse_modulo(x, y);
    const auto offset = raw(24);
    // In steps of n.y: the error is at most 64 of 2^-22.
    const std::int64_t away = random.wide(3) * ((y >> 22) + 1);
    const std::int64_t rest =
        (std::int64_t{offset.raw()} * (std::int64_t{1} << 30) - y / 2 - away) % y;
    const auto at =
        integer_cast<std::int64_t>(Int128((rest + y) % y) * Int128(inverse) % Int128(y));
    const Plane<S, 2> a{Direction<S, 2>::along(0), S::from_raw(static_cast<S::raw_type>(at))};
    const Plane<S, 2> b{*n, offset};
    if (inverse == 0) continue;
    ++all;
    const auto found = point_by_filter(a, b);
    if (!found.is_sure) {
      ++unsure;
    } else {
      wrong += found.value == detail::exact_closest_points_of_planes(a, b).first ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  CHECK(all > 1'000);
  CHECK(unsure > all / 2);
}

TEST_CASE("closest_points, plane: the filter leaves points of lines near ties to the exact one",
          "[closest_points]") {
  compare_near_ties(0x91c2);
}

TEST_CASE("closest_points, plane: the filter rounds the point of two planes like the exact point",
          "[closest_points]") {
  compare_planes<2>(0x91b2);
  compare_planes<3>(0x91b3);
}

TEST_CASE("closest_points, plane: the filter rounds the foot of a corner like the exact point",
          "[closest_points]") {
  compare<2>(0x91a2);
  compare<3>(0x91a3);
}

}  // namespace
}  // namespace detent::test
