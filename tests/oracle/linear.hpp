// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "detent/shape/shape.hpp"
#include "oracle/exact.hpp"

namespace detent::oracle {

/// The convex hull of the points over[k] / under, in raw units; empty without points.
template <int N>
struct Hull {
  std::vector<Vector<N>> over;
  Integer under = 1;
};

/// Whether the equations sum of x[j] * column j = right[i] have a solution with all x >= 0.
///
/// The simplex method, phase one: minimizes the sum of the equations' residuals by Bland's rule,
/// which terminates. Row i of the tableau gives a basic variable, and the last row the residual.
/// All numbers have the last pivot as denominator, so they stay integers: minors of the matrix.
///
/// source: Bland, New Finite Pivoting Rules for the Simplex Method (1977); Edmonds, Systems of
///         Distinct Representatives and Linear Algebra (1967)
class Simplex {
 public:
  Simplex(std::size_t equations, std::size_t unknowns)
      : rows_(equations), columns_(unknowns), table_(equations + 1), basis_(equations) {
    for (auto& row : table_) row.assign(unknowns + 1, Integer(0));
  }

  Integer& at(std::size_t row, std::size_t column) { return table_[row][column]; }
  Integer& right(std::size_t row) { return table_[row][columns_]; }

  bool is_feasible() {
    auto& lack = table_[rows_];
    for (std::size_t i = 0; i < rows_; ++i) {
      basis_[i] = columns_ + i;  // artificial: no column, since it never re-enters
      for (std::size_t j = 0; j <= columns_; ++j) {
        if (right(i) < 0 && j < columns_) table_[i][j] = -table_[i][j];
      }
      if (right(i) < 0) right(i) = -right(i);
      for (std::size_t j = 0; j <= columns_; ++j) lack[j] += table_[i][j];
    }
    while (!lack[columns_].is_zero()) {
      std::size_t enters = 0;
      while (enters < columns_ && lack[enters].sign() <= 0) ++enters;
      if (enters == columns_) return false;
      pivot(leaving(enters), enters);
    }
    return true;
  }

 private:
  /// The row with the smallest ratio for `column`; of equal ones, that of the first variable. There
  /// is one, otherwise the residual would fall without bound.
  std::size_t leaving(std::size_t column) const {
    std::size_t best = rows_;
    for (std::size_t i = 0; i < rows_; ++i) {
      if (table_[i][column].sign() <= 0) continue;
      if (best == rows_) {
        best = i;
        continue;
      }
      const Integer here = table_[i][columns_] * table_[best][column];
      const Integer there = table_[best][columns_] * table_[i][column];
      if (here < there || (here == there && basis_[i] < basis_[best])) best = i;
    }
    return best;
  }

  void pivot(std::size_t row, std::size_t column) {
    const Integer by = table_[row][column];
    for (std::size_t i = 0; i <= rows_; ++i) {
      if (i == row) continue;
      const Integer times = table_[i][column];
      for (std::size_t j = 0; j <= columns_; ++j) {
        table_[i][j] = (table_[i][j] * by - times * table_[row][j]) / last_pivot_;
      }
    }
    last_pivot_ = by;
    basis_[row] = column;
  }

  std::size_t rows_, columns_;
  std::vector<std::vector<Integer>> table_;
  std::vector<std::size_t> basis_;
  Integer last_pivot_ = 1;
};

/// Whether two hulls share a point: a convex combination of each that gives the same point.
template <int N>
bool meet(const Hull<N>& a, const Hull<N>& b) {
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
template <Scalar S, int N>
bool meet(const Plane<S, N>& plane, const Hull<N>& hull) {
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  const auto normal = widen(raw(plane.normal));
  bool is_above = false, is_below = false;
  for (const auto& point : hull.over) {
    const Integer height = dot(normal, point) - raw(plane.offset) * one * hull.under;
    is_above = is_above || height >= 0;
    is_below = is_below || height <= 0;
  }
  return is_above && is_below;
}

/// Whether two planes meet: two equations for a point, with each coordinate a difference of two
/// non-negative variables.
template <Scalar S, int N>
bool meet(const Plane<S, N>& a, const Plane<S, N>& b) {
  Simplex simplex(2, 2 * static_cast<std::size_t>(N));
  std::size_t row = 0;
  for (const auto& plane : {a, b}) {
    const auto normal = widen(raw(plane.normal));
    const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
    for (std::size_t i = 0; i < normal.size(); ++i) {
      simplex.at(row, 2 * i) = normal[i];
      simplex.at(row, 2 * i + 1) = -normal[i];
    }
    simplex.right(row++) = raw(plane.offset) * one;
  }
  return simplex.is_feasible();
}

template <Scalar S, int N>
Hull<N> hull_of(const Segment<S, N>& segment) {
  return {{raw(segment.start), raw(segment.end)}};
}
template <Scalar S, int N>
Hull<N> hull_of(const Triangle<S, N>& triangle) {
  return {{raw(triangle.a), raw(triangle.b), raw(triangle.c)}};
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

template <Scalar S, int N>
Hull<N> hull_of(const Aabb<S, N>& box) {
  const auto low = raw(box.min), high = raw(box.max);
  Vector<N> center;
  std::array<Vector<N>, N> edges;
  for (std::size_t i = 0; i < center.size(); ++i) {
    if (high[i] < low[i]) return {};
    center[i] = low[i] + high[i];
    edges[i][i] = high[i] - low[i];
  }
  return corners<N>(center, edges, 2);
}

/// The box as spanned by its edges.
template <Scalar S, int N>
Hull<N> hull_of(const Obb<S, N>& box) {
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  const auto half = raw(box.half_extents);
  auto center = raw(box.center);
  std::array<Vector<N>, N> edges;
  for (std::size_t j = 0; j < center.size(); ++j) {
    if (half[j] < 0) return {};
    center[j] *= one;
    edges[j] = widen(raw(box.rotation.axis(static_cast<int>(j))));
    for (auto& component : edges[j]) component *= half[j];
  }
  return corners<N>(center, edges, one);
}

}  // namespace detent::oracle
