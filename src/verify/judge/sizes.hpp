// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "verify/judge/motions.hpp"

namespace detent::verify::judge {

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const CrossingCase<S, N>& c, const Answer& got) {
  std::array<std::array<Integer, N>, N> normals;
  for (std::size_t k = 0; k < N; ++k) normals[k] = oracle::widen(raw_of(c.planes[k].normal.vec()));
  const Integer whole = expansion<N>(normals);
  if (whole == 0) return compare(Answer(), got);
  Vec<S, N> expected;
  for (std::size_t i = 0; i < N; ++i) {
    auto replaced = normals;
    for (std::size_t k = 0; k < N; ++k) replaced[k][i] = oracle::raw(c.planes[k].offset);
    expected[static_cast<int>(i)] = clamped<S>(
        nearest_quotient(scaled(expansion<N>(replaced), direction_component<S>::frac), whole));
  }
  return compare(Answer(expected), got);
}

/// The smallest integer >= sqrt(square) / 2^bits.
inline Integer root_above(const Integer& square, int bits) {
  Integer root = sqrt(Integer(square >> static_cast<unsigned>(2 * bits)));
  while (scaled(root * root, 2 * bits) < square) ++root;
  return root;
}

/// The corners of a box (eight; in 2D four) relative to its center, in steps of a direction's grid.
template <Scalar S, int N>
std::vector<oracle::Vector<N>> corners_of(const Obb<S, N>& box) {
  std::vector<oracle::Vector<N>> corners;
  for (unsigned signs = 0; signs < 1u << N; ++signs) {
    oracle::Vector<N> corner{};
    for (int k = 0; k < N; ++k) {
      const Integer half = oracle::raw(box.half_extents[k]);
      for (int i = 0; i < N; ++i) {
        const Integer step = oracle::raw(box.rotation.axis(k)[i]) * half;
        corner[static_cast<std::size_t>(i)] += (signs >> k & 1u) != 0 ? step : Integer(-step);
      }
    }
    corners.push_back(corner);
  }
  return corners;
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const SizeCase<S, N>& c, const Answer& got) {
  constexpr int frac = direction_component<S>::frac;
  const bool obb_is_empty = [&] {
    for (int i = 0; i < N; ++i) {
      if (c.obb.half_extents[i] < 0) return true;
    }
    return false;
  }();
  if constexpr (Row == 0) {
    const auto a = oracle::widen(raw_of(c.triangle.a));
    const auto u = oracle::difference(oracle::widen(raw_of(c.triangle.b)), a);
    const auto v = oracle::difference(oracle::widen(raw_of(c.triangle.c)), a);
    const Integer uv = oracle::dot(u, v);
    const Integer square = oracle::dot(u, u) * oracle::dot(v, v) - uv * uv;
    return compare(clamped<Answer>(sqrt(Integer(square >> static_cast<unsigned>(2 * S::frac + 2)))),
                   got);
  } else if constexpr (Row == 1) {
    Integer size = 1;
    for (int i = 0; i < N; ++i) {
      const Integer side = oracle::raw(c.aabb.max[i]) - oracle::raw(c.aabb.min[i]);
      if (side < 0) return compare(Answer(), got);
      size *= side;
    }
    return compare(clamped<Answer>(size >> static_cast<unsigned>((N - 1) * S::frac)), got);
  } else if constexpr (Row == 2) {
    if (c.sphere.radius <= 0) return compare(Answer(), got);
    const Real radius = real(c.sphere.radius);
    const Real size = radius * radius * two_pi() / 2;
    return compare(
        clamped<Answer>(nearest((N == 2 ? size : Real(size * radius * 4 / 3)) * steps(S::frac))),
        got);
  } else if constexpr (Row == 3) {
    if (obb_is_empty) {
      return compare(Answer{make_vec<N>([](int) { return S::max(); }),
                            make_vec<N>([](int) { return S::lowest(); })},
                     got);
    }
    Answer expected;
    const Integer step = scaled(1, frac);
    for (int i = 0; i < N; ++i) {
      const auto at = static_cast<std::size_t>(i);
      Integer reach = 0;
      for (const auto& corner : corners_of(c.obb)) reach = std::max(reach, corner[at]);
      const Integer center = scaled(oracle::raw(c.obb.center[i]), frac);
      expected.min[i] = clamped<S>(oracle::floor_quotient(center - reach, step));
      expected.max[i] = clamped<S>(-oracle::floor_quotient(-(center + reach), step));
    }
    return compare(expected, got);
  } else if constexpr (Row == 4) {
    if (obb_is_empty) return compare(Answer{{}, S(-1)}, got);
    Integer farthest = 0;
    for (const auto& corner : corners_of(c.obb)) {
      farthest = std::max(farthest, oracle::dot(corner, corner));
    }
    return compare(Answer{c.obb.center, clamped<S>(root_above(farthest, frac))}, got);
  } else {
    const std::array<oracle::Vector<N>, 3> points{oracle::widen(raw_of(c.triangle.a)),
                                                  oracle::widen(raw_of(c.triangle.b)),
                                                  oracle::widen(raw_of(c.triangle.c))};
    oracle::Vector<N> center;
    for (std::size_t i = 0; i < N; ++i) {
      const auto [low, high] = std::minmax({points[0][i], points[1][i], points[2][i]});
      center[i] = oracle::nearest_even(low + high, 1);
    }
    Integer farthest = 0;
    for (const auto& point : points) {
      const auto away = oracle::difference(point, center);
      farthest = std::max(farthest, oracle::dot(away, away));
    }
    return compare(Answer{clamped<S>(center), clamped<S>(root_above(farthest, 0))}, got);
  }
}

}  // namespace detent::verify::judge
