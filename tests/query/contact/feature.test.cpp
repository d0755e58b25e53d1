// SPDX-License-Identifier: MIT
#include "detent/query/contact/feature.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "detent/query/kernel/support.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Point = Vec<S, 3>;
using Offset = std::array<BigInteger, 3>;

Offset offset(const Point& p, const Point& from) {
  const auto component = [&](int i) {
    return BigInteger(std::int64_t{p[i].raw()} - std::int64_t{from[i].raw()});
  };
  return {component(0), component(1), component(2)};
}
Offset cross_of(const Offset& a, const Offset& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
BigInteger dot_of(const Offset& a, const Offset& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The corners in the plane that holds `corner`, has all others on one side, and is most opposed to
/// d, by trying every plane through two other corners; all corners if there is no such plane.
std::vector<Point> opposed_corners(const std::vector<Point>& points, const Point& corner,
                                   const Direction<S, 3>& d) {
  const Offset along{BigInteger(d[0].raw()), BigInteger(d[1].raw()), BigInteger(d[2].raw())};
  Offset best{};
  BigInteger best_along, best_squared;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Offset n = cross_of(offset(points[i], corner), offset(points[j], corner));
      BigInteger low = 0, high = 0;
      for (const auto& point : points) {
        const BigInteger height = dot_of(n, offset(point, corner));
        low = std::min(low, height);
        high = std::max(high, height);
      }
      if (dot_of(n, n) == 0 || (low < 0 && high > 0)) continue;
      BigInteger here = dot_of(n, along);
      if (high > 0 || (low == 0 && here > 0)) {
        for (auto& component : n) component = -component;
        here = -here;
      }
      // here / |n| < best_along / |best|
      const BigInteger squared = dot_of(n, n);
      const auto signed_square = [](const BigInteger& x) {
        return x < 0 ? BigInteger(-(x * x)) : BigInteger(x * x);
      };
      if (best_squared != 0 &&
          signed_square(here) * best_squared >= signed_square(best_along) * squared) {
        continue;
      }
      best = n;
      best_along = here;
      best_squared = squared;
    }
  }
  std::vector<Point> found;
  for (const auto& point : points) {
    const bool is_known = std::find(found.begin(), found.end(), point) != found.end();
    if (!is_known && dot_of(best, offset(point, corner)) == 0) found.push_back(point);
  }
  return found;
}

TEST_CASE("opposed face: the same as by trying every plane", "[query]") {
  Random random(0xfaced);
  int faces = 0, flats = 0, wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    // Lattices have coplanar and repeated corners; the last is too long for short numbers.
    const std::int64_t reach = std::array{2, 5, 1 << 20, 0x7fffffff}[random.below(4)];
    const bool is_flat = random.one_in(6);
    std::vector<Point> points(1 + random.below(12));
    for (auto& point : points) {
      point = make_vec<3>([&](int axis) {
        const auto raw = is_flat && axis == 1 ? 1 : random.between(-reach, reach);
        return S::from_raw(static_cast<std::int32_t>(raw));
      });
    }
    const auto d = direction_of<S>(make_vec<3>(
        [&](int) { return S::from_raw(static_cast<std::int32_t>(random.between(-3, 3))); }));
    if (!d) continue;
    const ConvexHull<S, 3> hull{std::span<const Point>(points)};
    const detail::HullBody body(hull);
    const Point corner = body.extreme<33>(d->vec(), points.front(), false);
    const detail::OpposedFace<std::remove_cvref_t<decltype(body)>, S, 3, 32> found(
        body, make_vec<3>([&](int axis) { return detail::Length<S>(corner[axis]); }), *d);
    const auto expected = opposed_corners(points, corner, *d);
    const auto& feature = found.feature();
    wrong += feature.count == expected.size() ? 0 : 1;
    for (std::size_t k = 0; k < std::min(feature.count, expected.size()); ++k) {
      wrong += nearest_to<S>(feature.corners[k].x) == expected[k].x &&
                       nearest_to<S>(feature.corners[k].y) == expected[k].y &&
                       nearest_to<S>(feature.corners[k].z) == expected[k].z
                   ? 0
                   : 1;
    }
    faces += expected.size() < points.size() ? 1 : 0;
    flats += is_flat ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(faces > 1500);
  CHECK(flats > 400);
}

}  // namespace
}  // namespace detent::test
