// SPDX-License-Identifier: MIT
#include "detent/query/kernel/least_common_point.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::detail {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Place = std::array<Rational, 2>;
using Point = std::array<Rational, 3>;
using Cell = std::array<std::int64_t, 2>;

Rational side(const Place& from, const Place& to, const Place& at) {
  return (to[0] - from[0]) * (at[1] - from[1]) - (to[1] - from[1]) * (at[0] - from[0]);
}

Place place(const Cell& cell) { return {Rational(cell[0]), Rational(cell[1])}; }

/// The corners of the hull in order around it.
std::vector<Place> hull_of(std::vector<Cell> cells) {
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<Place> ring;
  for (int pass = 0; pass < 2; ++pass) {
    const auto base = ring.size();
    for (const auto& cell : cells) {
      const auto next = place(cell);
      while (ring.size() >= base + 2 && side(ring[ring.size() - 2], ring.back(), next) <= 0) {
        ring.pop_back();
      }
      ring.push_back(next);
    }
    ring.pop_back();
    std::reverse(cells.begin(), cells.end());
  }
  if (ring.empty()) ring.push_back(place(cells.front()));
  return ring;
}

/// Clips a convex ring to height(place) >= 0.
template <class Height>
std::vector<Place> clipped(const std::vector<Place>& ring, const Height& height) {
  std::vector<Place> result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto &from = ring[i], &to = ring[(i + 1) % ring.size()];
    const Rational here = height(from), there = height(to);
    if (here >= 0) result.push_back(from);
    if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
      const Rational t = here / (here - there);
      result.push_back({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
    }
  }
  return result;
}

/// The corners of the intersection of two hulls.
std::vector<Place> intersection(const std::vector<Cell>& a, const std::vector<Cell>& b) {
  auto ring = hull_of(a);
  const auto clip = [&](const auto& height) {
    for (const auto& cell : b) {
      if (height(place(cell)) < 0) return;
    }
    ring = clipped(ring, height);
  };
  for (const auto& k : b) {
    for (const auto& l : b) {
      const auto from = place(k), to = place(l);
      if (k != l) clip([&](const Place& at) { return side(from, to, at); });
      clip([&](const Place& at) {
        return Rational((to[0] - from[0]) * (to[0] - at[0]) + (to[1] - from[1]) * (to[1] - at[1]));
      });
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      clip([&](const Place& at) { return Rational(at[axis] - k[axis]); });
      clip([&](const Place& at) { return Rational(k[axis] - at[axis]); });
    }
  }
  return ring;
}

template <Number T, int N>
struct Feature {
  static constexpr int dimension = N;
  std::vector<Vec<T, N>> corners;

  [[nodiscard]] Vec<T, N> some() const { return corners.front(); }
  template <class F>
  void for_each(const F& f) const {
    for (const auto& corner : corners) f(corner);
  }
};

using Triple = std::array<std::int64_t, 3>;

Triple cross_product(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <Number T, int N>
Vec<T, N> corner_at(const Triple& raw, int scale) {
  return make_vec<N>([&](int i) {
    using Raw = typename T::raw_type;
    return T::assume_raw(shift_left(integer_cast<Raw>(raw[static_cast<std::size_t>(i)]), scale));
  });
}

template <class Int>
Rational rational(const Int& raw) {
  constexpr int words = std::max(words_of<Int>, 2);
  const auto wide = integer_cast<Wide<words>>(raw);
  const auto magnitude = wide.is_negative() ? -wide : wide;
  boost::multiprecision::cpp_int sum = 0;
  for (int i = words - 1; i >= 0; --i) sum = (sum << 64) + magnitude.word(i);
  return wide.is_negative() ? Rational(-sum) : Rational(sum);
}

template <class Common, int N>
Point point_of(const Common& common) {
  Point point;
  for (int i = 0; i < N; ++i) {
    point[static_cast<std::size_t>(i)] =
        rational(common.over[i].raw()) / rational(common.under.raw());
  }
  return point;
}

/// Two overlapping features, and where they overlap.
struct Case {
  std::vector<Triple> a, b;
  Triple u;  // from a point on a to the one on b
  Point least;
};

/// Corners o + i e + j f in the plane of e and f (the line of e in 2D), those of b moved by u,
/// which is perpendicular if `is_perpendicular`. Nothing if no point lies above another.
template <int N>
std::optional<Case> draw(test::Random& random, bool is_perpendicular) {
  const auto triple = [&](std::int64_t most) {
    Triple result{};
    for (std::size_t i = 0; i < N; ++i) result[i] = random.between(-most, most);
    return result;
  };
  const auto o = triple(100), e = triple(6), f = N == 2 ? Triple{} : triple(6);
  const auto n = N == 2 ? Triple{-e[1], e[0], 0} : cross_product(e, f);
  if (n == Triple{}) return std::nullopt;
  auto u = is_perpendicular ? n : triple(40);
  const auto along = u[0] * n[0] + u[1] * n[1] + u[2] * n[2];
  if (along == 0) return std::nullopt;
  const auto cells = [&] {
    std::vector<Cell> result;
    const auto width = random.between(0, 6), height = N == 2 || random.one_in(4) ? 0 : width;
    const auto center = Cell{random.between(-3, 3), N == 2 ? 0 : random.between(-3, 3)};
    for (auto count = random.between(1, 7); count > 0; --count) {
      result.push_back(
          {center[0] + random.between(-width, width), center[1] + random.between(-height, height)});
    }
    return result;
  };
  const auto a = cells(), b = cells();
  const auto ring = intersection(a, b);
  if (ring.empty()) return std::nullopt;
  Case drawn{{}, {}, u, {}};
  const auto at = [&](const auto& cell, std::size_t i) {
    return o[i] + cell[0] * e[i] + cell[1] * f[i];
  };
  for (const auto& cell : a) drawn.a.push_back({at(cell, 0), at(cell, 1), at(cell, 2)});
  for (const auto& cell : b) {
    drawn.b.push_back({at(cell, 0) + u[0], at(cell, 1) + u[1], at(cell, 2) + u[2]});
  }
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point point{at(ring[k], 0), at(ring[k], 1), at(ring[k], 2)};
    if (k == 0 || point < drawn.least) drawn.least = point;
  }
  return drawn;
}

/// Draws features with corners of `Bits` bits and compares the least common points.
template <int Bits, int Frac, int N>
void examine(std::uint64_t seed, bool is_perpendicular, int count) {
  test::Random random(seed);
  int found = 0, crossings = 0;
  while (found < count) {
    const auto drawn = draw<N>(random, is_perpendicular);
    if (!drawn) continue;
    ++found;
    using T = Fixed<Bits, Frac>;
    const int scale = static_cast<int>(random.below(Bits - 11));
    Feature<T, N> a, b;
    for (const auto& corner : drawn->a) a.corners.push_back(corner_at<T, N>(corner, scale));
    for (const auto& corner : drawn->b) b.corners.push_back(corner_at<T, N>(corner, scale));
    Point expected_on_a{}, expected_on_b{};
    const Rational unit(boost::multiprecision::cpp_int(1) << static_cast<unsigned>(scale));
    bool is_crossing = true;
    for (std::size_t i = 0; i < N; ++i) {
      expected_on_a[i] = drawn->least[i] * unit;
      expected_on_b[i] = (drawn->least[i] + drawn->u[i]) * unit;
    }
    for (const auto& corner : drawn->a)
      is_crossing &= drawn->least != Point{corner[0], corner[1], corner[2]};
    for (const auto& [x, y, z] : drawn->b) {
      is_crossing &= drawn->least != Point{x - drawn->u[0], y - drawn->u[1], z - drawn->u[2]};
    }
    crossings += is_crossing;
    const auto agrees = [&](const auto& p, const auto& q) {
      return point_of<std::decay_t<decltype(p)>, N>(p) == expected_on_a &&
             point_of<std::decay_t<decltype(q)>, N>(q) == expected_on_b;
    };
    const bool is_right =
        is_perpendicular
            ? least_common_point(a, b, agrees)
            : least_common_point(a, b, corner_at<Fixed<31, 30>, N>(drawn->u, 20), agrees);
    INFO(seed << ": case " << found << ", scale " << scale);
    CHECK(is_right);
    if (!is_right) return;
  }
  CHECK((N == 2 || crossings > count / 20));
}

TEST_CASE("least common point: features seen along their normal") {
  examine<33, 16, 3>(0x1c01, true, 400);
  examine<65, 46, 3>(0x1c02, true, 300);
  examine<17, 8, 3>(0x1c03, true, 300);
  examine<33, 16, 2>(0x1c04, true, 200);
}

TEST_CASE("least common point: features seen along a direction") {
  examine<33, 16, 3>(0x1c05, false, 400);
  examine<65, 46, 3>(0x1c06, false, 300);
  examine<33, 16, 2>(0x1c07, false, 200);
}

}  // namespace
}  // namespace detent::detail
