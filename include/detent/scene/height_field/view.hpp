// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "detent/cull/bins.hpp"
#include "detent/scene/mesh/surface.hpp"

namespace detent {

/// Terrain: a view of heights on a grid of squares. The caller owns the heights. `height_field`
/// makes one.
///
/// Sample (column, row) is at x = corner.x + column * cell, z = corner.y + row * cell and its y is
/// heights[row * columns + column]. Four samples make a cell, which is two triangles: (0, 0),
/// (0, 1), (1, 0) with index 2 k and (1, 0), (0, 1), (1, 1) with index 2 k + 1, where k counts the
/// cells row by row. Seen from above (+y), their corners are counter-clockwise.
template <Scalar S>
struct HeightField {
  Vec<S, 2> corner;
  S cell{};
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::span<const S> heights;
  /// The smallest box around all samples.
  Aabb<S, 3> bounds = detail::no_box<Aabb<S, 3>>;
};

template <>
inline constexpr bool is_surface<HeightField> = true;

/// The smallest box around the field.
template <Scalar S>
[[nodiscard]] constexpr Aabb<S, 3> bounding_box(const HeightField<S>& field) noexcept {
  return field.bounds;
}

/// The height field of these samples. Returns nothing for fewer than two columns or rows, a cell
/// that is not positive, a number of heights other than columns * rows, 2^31 cells or more, or a
/// far corner beyond the range of the scalar.
template <Scalar S>
[[nodiscard]] constexpr std::optional<HeightField<S>> height_field(
    const Vec<S, 2>& corner, const S& cell, std::uint32_t columns, std::uint32_t rows,
    std::span<const S> heights) noexcept {
  if (columns < 2 || rows < 2 || !(cell > 0)) return std::nullopt;
  if (heights.size() != std::uint64_t{columns} * rows) return std::nullopt;
  if (std::uint64_t{columns - 1} * (rows - 1) >= std::uint64_t{1} << 31) return std::nullopt;
  if (corner.x + times(cell, columns - 1) > largest<S>) return std::nullopt;
  if (corner.y + times(cell, rows - 1) > largest<S>) return std::nullopt;
  HeightField<S> field{corner, cell, columns, rows, heights};
  const auto [least, greatest] = std::minmax_element(heights.begin(), heights.end());
  field.bounds = {field_point(field, 0, 0), field_point(field, columns - 1, rows - 1)};
  field.bounds.min.y = *least;
  field.bounds.max.y = *greatest;
  return field;
}

namespace detail {

/// The coordinate `count` cells from a corner of a field: in range, because the far corner is.
template <Scalar S>
[[nodiscard]] constexpr S field_border(const S& corner, const S& cell,
                                       std::uint32_t count) noexcept {
  return S(narrow<bits_of<S>>(corner + times(cell, count)));
}

}  // namespace detail

/// The position of a sample.
template <Scalar S>
[[nodiscard]] constexpr Vec<S, 3> field_point(const HeightField<S>& field, std::uint32_t column,
                                              std::uint32_t row) noexcept {
  return {detail::field_border(field.corner.x, field.cell, column),
          field.heights[std::size_t{row} * field.columns + column],
          detail::field_border(field.corner.y, field.cell, row)};
}

/// The two triangles of a cell.
template <Scalar S>
[[nodiscard]] constexpr std::array<MeshTriangle<S>, 2> cell_triangles(const HeightField<S>& field,
                                                                      std::uint32_t column,
                                                                      std::uint32_t row) noexcept {
  const auto across = field_point(field, column + 1, row),
             down = field_point(field, column, row + 1);
  const std::uint32_t index = 2 * (row * (field.columns - 1) + column);
  return {MeshTriangle<S>{{field_point(field, column, row), down, across}, index},
          MeshTriangle<S>{{across, down, field_point(field, column + 1, row + 1)}, index + 1}};
}

}  // namespace detent
