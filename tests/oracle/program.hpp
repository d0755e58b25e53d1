// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oracle/rational.hpp"

namespace detent::oracle {

inline Rational square(const Rational& x) { return x * x; }

/// A linear program: minimises a cost over all x >= 0 with the sums of x[j] * column j equal to the
/// right sides.
///
/// source: Dantzig's simplex method in two phases; Bland, New Finite Pivoting Rules (1977)
class Program {
 public:
  using Row = std::vector<Rational>;

  explicit Program(std::size_t unknowns) : unknowns_(unknowns) {}

  void add_equation(Row coefficients, const Rational& right) {
    coefficients.push_back(right);
    equations_.push_back(std::move(coefficients));
  }

  /// The least value of the sum of cost[j] x[j]; nothing if no x satisfies all equations. The cost
  /// must be bounded below.
  [[nodiscard]] std::optional<Rational> least(const Row& cost) const {
    const std::size_t rows = equations_.size(), columns = unknowns_ + rows;
    std::vector<Row> table;
    std::vector<std::size_t> basis;
    for (std::size_t i = 0; i < rows; ++i) {
      const bool flips = equations_[i].back() < 0;
      Row row(columns + 1, Rational(0));
      for (std::size_t j = 0; j < unknowns_; ++j) {
        row[j] = flips ? Rational(-equations_[i][j]) : equations_[i][j];
      }
      row[unknowns_ + i] = 1;
      row[columns] = flips ? Rational(-equations_[i].back()) : equations_[i].back();
      table.push_back(std::move(row));
      basis.push_back(unknowns_ + i);
    }
    Row artificial(columns, Rational(0));
    for (std::size_t i = 0; i < rows; ++i) artificial[unknowns_ + i] = 1;
    if (!descend(table, basis, artificial, columns).is_zero()) return std::nullopt;
    Row padded = cost;
    padded.resize(columns, Rational(0));
    // An artificial unknown that is still in the basis is 0. It leaves if it can.
    for (std::size_t i = 0; i < rows; ++i) {
      if (basis[i] < unknowns_) continue;
      for (std::size_t j = 0; j < unknowns_; ++j) {
        if (table[i][j].is_zero()) continue;
        pivot(table, basis, i, j);
        break;
      }
    }
    return descend(table, basis, padded, unknowns_);
  }

 private:
  static void pivot(std::vector<Row>& table, std::vector<std::size_t>& basis, std::size_t row,
                    std::size_t column) {
    const Rational by = table[row][column];
    for (auto& x : table[row]) {
      if (!x.is_zero()) x /= by;
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
      const Rational times = table[i][column];
      if (i == row || times.is_zero()) continue;
      for (std::size_t j = 0; j < table[i].size(); ++j) {
        if (!table[row][j].is_zero()) table[i][j] -= times * table[row][j];
      }
    }
    basis[row] = column;
  }

  /// Descends with the first `columns` columns to the least cost.
  static Rational descend(std::vector<Row>& table, std::vector<std::size_t>& basis, const Row& cost,
                          std::size_t columns) {
    while (true) {
      std::size_t enters = columns;
      for (std::size_t j = 0; j < columns && enters == columns; ++j) {
        Rational reduced = cost[j];
        for (std::size_t i = 0; i < table.size(); ++i) {
          if (!cost[basis[i]].is_zero() && !table[i][j].is_zero())
            reduced -= cost[basis[i]] * table[i][j];
        }
        if (reduced < 0) enters = j;
      }
      if (enters == columns) break;
      std::size_t leaves = table.size();
      Rational best;
      for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i][enters] <= 0) continue;
        const Rational ratio = table[i].back() / table[i][enters];
        if (leaves == table.size() || ratio < best || (ratio == best && basis[i] < basis[leaves])) {
          leaves = i;
          best = ratio;
        }
      }
      pivot(table, basis, leaves, enters);
    }
    Rational value = 0;
    for (std::size_t i = 0; i < table.size(); ++i) value += cost[basis[i]] * table[i].back();
    return value;
  }

  std::size_t unknowns_;
  std::vector<Row> equations_;
};

}  // namespace detent::oracle
