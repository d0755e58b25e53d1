// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>

#include "detent/scene/height_field/height_field.hpp"
#include "detent/scene/mesh/parts.hpp"

namespace detent {

namespace detail {

/// A rectangle of cells of a height field.
struct FieldCells {
  std::uint32_t column, row, columns, rows;

  /// One of two halves waits for each time that 2^32 columns and 2^32 rows can be halved.
  static constexpr std::size_t room = 66;

  [[nodiscard]] constexpr bool is_leaf() const noexcept { return columns == 1 && rows == 1; }
  /// The two halves across the longer side.
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

/// A box around a rectangle of cells, tight around a single one.
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

}  // namespace detail

/// The parts of a height field, halves of halves of it: see mesh/parts.hpp.
template <Scalar S>
[[nodiscard]] constexpr detail::FieldCells whole_of(const HeightField<S>& field) noexcept {
  return {0, 0, field.columns - 1, field.rows - 1};
}
template <Scalar S, class Test>
constexpr bool any_child(const HeightField<S>& field, const detail::FieldCells& cells,
                         const Test& test) noexcept {
  const auto halves = cells.halves();
  return test(halves[0], box_of(field, halves[0])) || test(halves[1], box_of(field, halves[1]));
}
template <Scalar S, class Visit>
constexpr bool at_leaf(const HeightField<S>& field, const detail::FieldCells& cell,
                       const Visit& visit) noexcept {
  const auto triangles = cell_triangles(field, cell.column, cell.row);
  return visit(std::span<const MeshTriangle<S>>(triangles));
}

}  // namespace detent
