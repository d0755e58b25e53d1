// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "detent/math/width.hpp"
#include "detent/scene/height_field/line.hpp"
#include "detent/scene/height_field/rings.hpp"
#include "detent/scene/mesh/parts.hpp"

namespace detent {

/// The parts of a height field, found by repeated halving: see mesh/parts.hpp.
template <Scalar S>
[[nodiscard]] constexpr detail::FieldCells whole_of(const HeightField<S>& field) noexcept {
  return {0, 0, field.columns - 1, field.rows - 1};
}
template <Scalar S, class Visit>
constexpr Walk visit_children(const HeightField<S>& field, const detail::FieldCells& cells,
                              const Visit& visit) noexcept {
  const auto halves = cells.halves();
  if (visit(halves[0], box_of(field, halves[0])) == Walk::stop) return Walk::stop;
  return visit(halves[1], box_of(field, halves[1]));
}
template <Scalar S, class Visit>
constexpr Walk at_leaf(const HeightField<S>& field, const detail::FieldCells& cell,
                       const Visit& visit) noexcept {
  const auto triangles = cell_triangles(field, cell.column, cell.row);
  return visit(std::span<const MeshTriangle<S>>(triangles));
}

namespace detail {

/// Visits the cells that a line may touch, in order of its strips: calls visit(triangles). `ends` is
/// as for FieldLine.
template <Scalar S, Number T, class Ends, class Visit>
constexpr Walk visit_line(const HeightField<S>& field, const Vec<S, 3>& origin,
                          const Vec<T, 3>& direction, const Ends& ends,
                          const Visit& visit) noexcept {
  return FieldLine<S, T>(field, origin, direction)
      .visit_strips(ends, [&](const FieldCells& strip, const auto& meets) {
        return visit_cells(field, strip, meets, [&](auto column, auto row) {
          return at_leaf(field, {column, row, 1, 1}, visit);
        });
      });
}

}  // namespace detail

/// The traversals of a height field step from cell to cell, without a tree, and skip cells whose
/// samples are all too high or too low, so a single tall sample does not slow them down.
/// Floating-point scalars traverse its parts instead.
template <Scalar S, class Visit>
constexpr Walk visit_along(const HeightField<S>& field, const Ray<S, 3>& ray,
                           const Visit& visit) noexcept {
  if constexpr (!is_fixed<S>) {
    return detail::visit_parts_along(field, ray, visit);
  } else {
    if (ray.max_distance < 0 || field.heights.empty()) return Walk::go_on;
    S limit = ray.max_distance;
    const auto ends = [&](const auto& ahead, const auto& size) { return ahead > limit * size; };
    return detail::visit_line(field, ray.origin, ray.direction.vec(), ends,
                              [&](auto triangles) { return visit(triangles, limit); });
  }
}
template <Scalar S, class Visit>
constexpr Walk visit_crossing(const HeightField<S>& field, const Segment<S, 3>& segment,
                              const Visit& visit) noexcept {
  if constexpr (!is_fixed<S>) {
    return detail::visit_parts_crossing(field, segment, visit);
  } else {
    if (field.heights.empty()) return Walk::go_on;
    const auto ends = [](const auto& ahead, const auto& size) { return ahead > size; };
    return by_width<30>(
        [&](const auto& along) {
          return detail::visit_line(field, segment.start, along, ends, visit);
        },
        segment.end - segment.start);
  }
}
template <Scalar S, class Visit>
constexpr Walk visit_within(const HeightField<S>& field, const Aabb<S, 3>& box,
                            const Visit& visit) noexcept {
  if (field.heights.empty() || !overlaps(field.bounds, box)) return Walk::go_on;
  const auto range = [&](const S& corner, std::uint32_t count, const S& least, const S& most) {
    const auto first = detail::first_up_to(corner, field.cell, count, least);
    const auto end = detail::first_where_not(count, [&](std::uint32_t i) {
      return detail::field_border(corner, field.cell, i) <= most;
    });
    return std::array{first, end - first};
  };
  const auto [column, columns] = range(field.corner.x, field.columns - 1, box.min.x, box.max.x);
  const auto [row, rows] = range(field.corner.y, field.rows - 1, box.min.z, box.max.z);
  const auto meets = [&](const S& low, const S& high) {
    return low <= box.max.y && high >= box.min.y;
  };
  return detail::visit_cells(field, {column, row, columns, rows}, meets, [&](auto i, auto j) {
    return at_leaf(field, {i, j, 1, 1}, visit);
  });
}
template <Scalar S, class Visit>
constexpr Walk visit_around(const HeightField<S>& field, const Vec<S, 3>& point,
                            const Visit& visit) noexcept {
  if constexpr (!is_fixed<S>) {
    return detail::visit_parts_around(field, point, visit);
  } else {
    if (field.heights.empty()) return Walk::go_on;
    S limit = largest<S>;
    Walk walk = Walk::go_on;
    const detail::FieldRings<S> rings(field, point);
    rings.visit_sides([&](const detail::FieldCells& side) {
      const auto gap = rings.squared_gap(point, side);
      detail::HeightReach<S> reach(point.y, limit, gap);
      if (!reach.is_any || walk == Walk::stop) return Walk::stop;
      const auto meets = [&](const S& low, const S& high) {
        return low <= reach.high && high >= reach.low;
      };
      detail::visit_cells(field, side, meets, [&](auto column, auto row) {
        const detail::FieldCells cell{column, row, 1, 1};
        if (distance(box_of(field, cell), point) > limit) return Walk::go_on;
        walk = at_leaf(field, cell, [&](auto triangles) { return visit(triangles, limit); });
        reach = detail::HeightReach<S>(point.y, limit, gap);
        return reach.is_any ? walk : Walk::stop;
      });
      return Walk::go_on;
    });
    return walk;
  }
}

}  // namespace detent
