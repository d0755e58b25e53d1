// SPDX-License-Identifier: MIT
#include "detent/query/kernel/pivot.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using Weight = Fixed<62, 0>;
template <int N>
using Integers = std::array<std::int64_t, static_cast<std::size_t>(N)>;

/// Columns are points, or directions where the index is `no_point`.
template <int N>
struct Basis {
  std::array<Integers<N>, static_cast<std::size_t>(N)> columns;
  std::array<detail::PointIndex, static_cast<std::size_t>(N)> indices;

  [[nodiscard]] Integers<N> weights(const Integers<N>& d) const {
    if constexpr (N == 2) {
      const auto cross = [](const auto& u, const auto& v) { return u[0] * v[1] - u[1] * v[0]; };
      return {cross(columns[1], d), cross(d, columns[0])};
    } else {
      const auto volume = [&](const auto& u, const auto& v) {
        return d[0] * (u[1] * v[2] - u[2] * v[1]) + d[1] * (u[2] * v[0] - u[0] * v[2]) +
               d[2] * (u[0] * v[1] - u[1] * v[0]);
      };
      return {volume(columns[1], columns[2]), volume(columns[2], columns[0]),
              volume(columns[0], columns[1])};
    }
  }

  /// Whether the line along d stabs the basis: no weight is negative, and those of points have a
  /// positive sum.
  [[nodiscard]] bool is_stabbed(const Integers<N>& d) const {
    const auto weight = weights(d);
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
      if (weight[i] < 0) return false;
      if (indices[i] != detail::no_point) sum += weight[i];
    }
    return sum > 0;
  }
};

/// The volumes d . (w x c_i), for columns c_i.
template <int N>
Integers<N> sides(const Integers<N>& d, const Integers<N>& w, const Basis<N>& basis) {
  Integers<N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    auto pair = basis;
    if constexpr (N == 2) {
      pair.columns[1 - i] = w;
      result[i] = pair.weights(d)[i];
    } else {
      pair.columns[(i + 1) % 3] = w;
      pair.columns[(i + 2) % 3] = basis.columns[i];
      result[i] = pair.weights(d)[i];
    }
  }
  return result;
}

template <int N>
std::array<Weight, static_cast<std::size_t>(N)> numbers(const Integers<N>& integers) {
  std::array<Weight, static_cast<std::size_t>(N)> result{};
  for (std::size_t i = 0; i < N; ++i) result[i] = Weight::from_raw(integers[i]);
  return result;
}

TEMPLATE_TEST_CASE_SIG(
    "pivot: the leaving column has the least index among those that keep the basis stabbed", "",
    ((int N), N), 2, 3) {
  Random random(0x9170);
  const auto draw = [&] {
    Integers<N> result{};
    for (auto& x : result) x = random.between(-3, 3);
    return result;
  };
  int checked = 0, ties = 0, directions = 0;
  for (int step = 0; step < 40'000; ++step) {
    const auto d = draw();
    Basis<N> basis{};
    detail::PointIndex next = 5;
    for (std::size_t i = 0; i < N; ++i) {
      basis.columns[i] = draw();
      basis.indices[i] = random.one_in(4) ? detail::no_point : next--;
    }
    if (random.coin()) std::swap(basis.indices[0], basis.indices[N - 1]);
    if (!basis.is_stabbed(d)) continue;
    const auto entering = draw();
    int expected = N, able = 0;
    for (int i = 0; i < N; ++i) {
      auto replaced = basis;
      const auto column = static_cast<std::size_t>(i);
      replaced.columns[column] = entering;
      replaced.indices[column] = 9;
      if (!replaced.is_stabbed(d)) continue;
      ++able;
      if (expected == N ||
          basis.indices[column] < basis.indices[static_cast<std::size_t>(expected)]) {
        expected = i;
      }
    }
    INFO("step " << step);
    const detail::Pivot<Weight, N> pivot{numbers<N>(basis.weights(d)),
                                         numbers<N>(sides(d, entering, basis)), basis.indices};
    REQUIRE(pivot.leaving() == expected);
    REQUIRE(expected < N);
    ++checked;
    ties += able > 1 ? 1 : 0;
    directions += basis.indices[static_cast<std::size_t>(expected)] == detail::no_point ? 1 : 0;
  }
  CHECK(checked > 1'000);
  CHECK(ties > checked / 20);
  CHECK(directions > checked / 20);
}

TEST_CASE("pivot: the farthest point enters, or the first in front of the plane") {
  using S = q16_16;
  const auto at = [](int x, int y) { return Vec<S, 2>{S(x), S(y)}; };
  const std::array points{at(2, 0), at(0, 1), at(-1, 0), at(-3, 5)};
  const std::span<const Vec<S, 2>> all(points);
  const auto right = at(1, 0);
  CHECK(detail::entering_point(all, right, points[0], false) == 3);
  CHECK(detail::entering_point(all, right, points[0], true) == 1);
  CHECK(detail::entering_point(all, right, points[2], true) == 3);
  CHECK(detail::entering_point(all, right, points[3], false) == detail::no_point);
}

}  // namespace
}  // namespace detent::test
