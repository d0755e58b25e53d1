// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>

#include "detent/query/distance/aabb.hpp"
#include "detent/query/overlaps/aabb_aabb.hpp"
#include "detent/scene/height_field/height_field.hpp"
#include "detent/scene/static_tree/along.hpp"

namespace detent {

namespace detail {

/// A rectangle of cells of a height field.
struct FieldCells {
  std::uint32_t column, row, columns, rows;

  [[nodiscard]] constexpr bool is_single() const noexcept { return columns == 1 && rows == 1; }
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
  if (cells.is_single()) {
    const auto across = field_point(field, cells.column + 1, cells.row);
    const auto down = field_point(field, cells.column, cells.row + 1);
    std::tie(box.min.y, box.max.y) = std::minmax({first.y, last.y, across.y, down.y});
  } else {
    box.min.y = field.bounds.min.y;
    box.max.y = field.bounds.max.y;
  }
  return box;
}

/// Visits cells of a field by halving it, the nearest first: near(box) says how near a box is, as a
/// Key, or nothing where it does not matter; matters(key) whether it still does when its turn
/// comes; visit(triangles) whether to go on.
template <class Key, Scalar S, class Near, class Matters, class Visit>
constexpr void visit_cells(const HeightField<S>& field, const Near& near, const Matters& matters,
                           const Visit& visit) noexcept {
  if (field.heights.empty()) return;
  struct Entry {
    Key key;
    FieldCells cells;
  };
  // One of two halves stays for each time that 2^32 columns and 2^32 rows can be halved.
  std::array<Entry, 66> stack;
  std::size_t used = 0;
  const FieldCells all{0, 0, field.columns - 1, field.rows - 1};
  if (const auto key = near(box_of(field, all))) stack[used++] = {*key, all};
  while (used != 0) {
    const auto [key, cells] = stack[--used];
    if (!matters(key)) continue;
    if (cells.is_single()) {
      const auto triangles = cell_triangles(field, cells.column, cells.row);
      if (!visit(std::span<const MeshTriangle<S>>(triangles))) return;
      continue;
    }
    const auto halves = cells.halves();
    const auto first = near(box_of(field, halves[0])), second = near(box_of(field, halves[1]));
    const bool swap = first && second && *second < *first;
    if (swap && first) stack[used++] = {*first, halves[0]};
    if (second) stack[used++] = {*second, halves[1]};
    if (!swap && first) stack[used++] = {*first, halves[0]};
  }
}

}  // namespace detail

/// The walks of a `HeightField`, as those of a static tree: see static_tree/.
template <Scalar S, class Visit>
constexpr void visit_along(const HeightField<S>& field, const Ray<S, 3>& ray,
                           const Visit& visit) noexcept {
  if (ray.max_distance < 0 || field.heights.empty()) return;
  using Time = typename SlabTimes<S>::Time;
  const detail::StaticRay<S, 3> prepared(ray, field.bounds);
  auto limit = SlabTimes<S>::time(ray.max_distance);
  detail::visit_cells<Time>(
      field, [&](const Aabb<S, 3>& box) { return prepared.meets(box, limit); },
      [&](const Time& enter) { return enter <= limit; },
      [&](std::span<const MeshTriangle<S>> cell) {
        const S left = visit(cell);
        limit = SlabTimes<S>::time(left);
        return left >= 0;
      });
}

template <Scalar S, class Visit>
constexpr bool visit_within(const HeightField<S>& field, const Aabb<S, 3>& box,
                            const Visit& visit) noexcept {
  bool found = false;
  detail::visit_cells<bool>(
      field,
      [&](const Aabb<S, 3>& part) {
        return overlaps(part, box) ? std::optional(false) : std::nullopt;
      },
      [](bool) { return true; },
      [&](std::span<const MeshTriangle<S>> cell) {
        found = visit(cell);
        return !found;
      });
  return found;
}

template <Scalar S, class Visit>
constexpr void visit_around(const HeightField<S>& field, const Vec<S, 3>& point,
                            const Visit& visit) noexcept {
  S limit = largest<S>;
  detail::visit_cells<S>(
      field,
      [&](const Aabb<S, 3>& part) {
        const S to_part = distance(part, point);
        return to_part <= limit ? std::optional(to_part) : std::nullopt;
      },
      [&](const S& to_part) { return to_part <= limit; },
      [&](std::span<const MeshTriangle<S>> cell) {
        limit = visit(cell);
        return true;
      });
}

}  // namespace detent
