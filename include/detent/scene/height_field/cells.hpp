// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>

#include "detent/scene/height_field/view.hpp"

namespace detent::detail {

/// A rectangle of cells of a height field.
struct FieldCells {
  std::uint32_t column, row, columns, rows;

  static constexpr std::size_t most_children = 2;
  /// The most rectangles pending in a traversal: one of two halves for each time that 2^32 columns
  /// and 2^32 rows can be halved.
  static constexpr std::size_t room = 66;

  [[nodiscard]] constexpr bool is_leaf() const noexcept { return columns == 1 && rows == 1; }
  /// The two halves of the longer side.
  [[nodiscard]] constexpr std::array<FieldCells, 2> halves() const noexcept {
    const auto left = columns / 2, upper = rows / 2;
    if (columns >= rows) {
      return {FieldCells{column, row, left, rows},
              FieldCells{column + left, row, columns - left, rows}};
    }
    return {FieldCells{column, row, columns, upper},
            FieldCells{column, row + upper, columns, rows - upper}};
  }
};

/// A box around a rectangle of cells; tight for a single cell.
template <Scalar S>
[[nodiscard]] constexpr Aabb<S, 3> box_of(const HeightField<S>& field,
                                          const FieldCells& cells) noexcept {
  const auto first = field_point(field, cells.column, cells.row);
  const auto last = field_point(field, cells.column + cells.columns, cells.row + cells.rows);
  Aabb<S, 3> box{first, last};
  if (cells.is_leaf()) {
    const auto across = field_point(field, cells.column + 1, cells.row);
    const auto down = field_point(field, cells.column, cells.row + 1);
    std::tie(box.min.y, box.max.y) = std::minmax({first.y, last.y, across.y, down.y});
  } else {
    box.min.y = field.bounds.min.y;
    box.max.y = field.bounds.max.y;
  }
  return box;
}

/// Visits each of `cells` whose lowest and highest sample satisfy meets(low, high): calls
/// visit(column, row).
template <Scalar S, class Meets, class Visit>
constexpr Walk visit_cells(const HeightField<S>& field, const FieldCells& cells, const Meets& meets,
                           const Visit& visit) noexcept {
  for (auto row = cells.row; row < cells.row + cells.rows; ++row) {
    const auto upper = field.heights.subspan(std::size_t{row} * field.columns);
    const auto lower = upper.subspan(field.columns);
    auto left = std::minmax({upper[cells.column], lower[cells.column]});
    for (auto column = cells.column; column < cells.column + cells.columns; ++column) {
      const auto right = std::minmax({upper[column + 1], lower[column + 1]});
      const bool is_met =
          meets((std::min)(left.first, right.first), (std::max)(left.second, right.second));
      if (is_met && visit(column, row) == Walk::stop) return Walk::stop;
      left = right;
    }
  }
  return Walk::go_on;
}

/// The first number in [0, count) for which `test` fails, or `count`. A binary search: once `test`
/// fails, it must fail for all greater numbers.
template <class Test>
[[nodiscard]] constexpr std::uint32_t first_where_not(std::uint32_t count,
                                                      const Test& test) noexcept {
  std::uint32_t first = 0;
  while (count > 0) {
    const auto half = count / 2;
    if (test(first + half)) {
      first += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  return first;
}

/// The index of the first of `count` intervals from `corner` on, each `cell` long, that does not
/// end before `x`; `count` if all do.
template <Scalar S>
[[nodiscard]] constexpr std::uint32_t first_up_to(const S& corner, const S& cell,
                                                  std::uint32_t count, const S& x) noexcept {
  return first_where_not(count,
                         [&](std::uint32_t i) { return field_border(corner, cell, i + 1) < x; });
}

}  // namespace detent::detail
