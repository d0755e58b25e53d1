// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/integer.hpp"

namespace detent::oracle {

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

}  // namespace detent::oracle
