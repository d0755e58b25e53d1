// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "oracle/simplex.hpp"
#include "oracle/solid.hpp"

// Shapes with corners as the hulls of these.
namespace detent::oracle {

/// The convex hull of the points over[k] / under, in raw units; empty without points.
template <int N>
struct Hull {
  std::vector<Vector<N>> over;
  Integer under = 1;
};

template <int N>
Hull<N> hull_of(const Edge<N>& edge) {
  return {{edge.start, edge.end}};
}
template <int N>
Hull<N> hull_of(const Face<N>& face) {
  return {{face.corners.begin(), face.corners.end()}};
}
template <int N>
Hull<N> hull_of(const Cloud<N>& cloud) {
  return {cloud.points};
}

/// The corners center +- edge[0] +- edge[1] ... over `under`.
template <int N>
Hull<N> corners(const Vector<N>& center, const std::array<Vector<N>, N>& edges,
                const Integer& under) {
  Hull<N> hull{{}, under};
  for (unsigned signs = 0; signs < 1u << N; ++signs) {
    auto corner = center;
    for (unsigned j = 0; j < unsigned{N}; ++j) {
      for (std::size_t i = 0; i < corner.size(); ++i) {
        if ((signs >> j & 1) != 0) {
          corner[i] += edges[j][i];
        } else {
          corner[i] -= edges[j][i];
        }
      }
    }
    hull.over.push_back(corner);
  }
  return hull;
}

template <int N>
Hull<N> hull_of(const Box<N>& box) {
  Vector<N> center;
  std::array<Vector<N>, N> edges;
  for (std::size_t i = 0; i < center.size(); ++i) {
    if (box.high[i] < box.low[i]) return {};
    center[i] = box.low[i] + box.high[i];
    edges[i][i] = box.high[i] - box.low[i];
  }
  return corners<N>(center, edges, 2);
}

/// The box as spanned by its edges.
template <int N>
Hull<N> hull_of(const TurnedBox<N>& box) {
  auto center = box.center;
  auto edges = box.axes;
  for (std::size_t j = 0; j < center.size(); ++j) {
    if (box.half[j] < 0) return {};
    center[j] *= box.one;
    for (auto& component : edges[j]) component *= box.half[j];
  }
  return corners<N>(center, edges, box.one);
}

/// Whether two hulls share a point: a convex combination of each that gives the same point.
template <int N>
bool hulls_meet(const Hull<N>& a, const Hull<N>& b) {
  if (a.over.empty() || b.over.empty()) return false;
  constexpr auto size = static_cast<std::size_t>(N);
  const Integer under = lcm(a.under, b.under);
  const Integer scale_a = under / a.under, scale_b = under / b.under;
  Simplex simplex(size + 2, a.over.size() + b.over.size());
  std::size_t column = 0;
  for (const auto& point : a.over) {
    for (std::size_t i = 0; i < size; ++i) simplex.at(i, column) = point[i] * scale_a;
    simplex.at(size, column++) = 1;
  }
  for (const auto& point : b.over) {
    for (std::size_t i = 0; i < size; ++i) simplex.at(i, column) = -point[i] * scale_b;
    simplex.at(size + 1, column++) = 1;
  }
  simplex.right(size) = simplex.right(size + 1) = 1;
  return simplex.is_feasible();
}

/// Whether a plane meets a hull: not all points are strictly on one side.
template <int N>
bool wall_meets(const Wall<N>& wall, const Hull<N>& hull) {
  bool is_above = false, is_below = false;
  for (const auto& point : hull.over) {
    const Integer height = dot(wall.normal, point) - wall.offset * wall.one * hull.under;
    is_above = is_above || height >= 0;
    is_below = is_below || height <= 0;
  }
  return is_above && is_below;
}

}  // namespace detent::oracle
