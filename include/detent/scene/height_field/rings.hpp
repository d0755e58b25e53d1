// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "detent/scene/height_field/cells.hpp"

namespace detent::detail {

/// The cells of a height field around a point, ring by ring: first the cell nearest to it
/// horizontally, then the four sides of the square of cells around that, and so on outward.
template <Scalar S>
class FieldRings {
 public:
  constexpr FieldRings(const HeightField<S>& field, const Vec<S, 3>& point) noexcept
      : field_(field),
        columns_(field.columns - 1),
        rows_(field.rows - 1),
        column_(
            (std::min)(first_up_to(field.corner.x, field.cell, columns_, point.x), columns_ - 1)),
        row_((std::min)(first_up_to(field.corner.y, field.cell, rows_, point.z), rows_ - 1)) {}

  /// Visits the sides, rectangles of cells: calls visit(cells). If it returns Walk::stop, no farther
  /// side in that direction is visited.
  template <class Visit>
  constexpr void visit_sides(const Visit& visit) const noexcept {
    visit(FieldCells{column_, row_, 1, 1});
    std::array<bool, 4> is_open{true, true, true, true};
    for (std::uint32_t ring = 1; is_open[0] || is_open[1] || is_open[2] || is_open[3]; ++ring) {
      const auto left = column_ - (std::min)(column_, ring);
      const auto right = column_ + (std::min)(columns_ - 1 - column_, ring);
      const auto top = row_ - (std::min)(row_, ring - 1);
      const auto bottom = row_ + (std::min)(rows_ - 1 - row_, ring - 1);
      const auto side = [&](bool& open, bool exists, const FieldCells& cells) {
        open = open && exists && visit(cells) == Walk::go_on;
      };
      side(is_open[0], ring <= row_, {left, row_ - ring, right - left + 1, 1});
      side(is_open[1], ring < rows_ - row_, {left, row_ + ring, right - left + 1, 1});
      side(is_open[2], ring <= column_, {column_ - ring, top, 1, bottom - top + 1});
      side(is_open[3], ring < columns_ - column_, {column_ + ring, top, 1, bottom - top + 1});
    }
  }

  /// The square of the horizontal distance between `point` and some cells.
  [[nodiscard]] constexpr auto squared_gap(const Vec<S, 3>& point,
                                           const FieldCells& cells) const noexcept {
    const auto& corner = field_.corner;
    const auto& cell = field_.cell;
    const auto gap = [&](const S& start, std::uint32_t first, std::uint32_t count, const S& at) {
      using Way = decltype(S() - S());
      const auto before = field_border(start, cell, first) - at;
      const auto after = at - field_border(start, cell, first + count);
      return (std::max)({Way(), Way(before), Way(after)});
    };
    return square(gap(corner.x, cells.column, cells.columns, point.x)) +
           square(gap(corner.y, cells.row, cells.rows, point.z));
  }

 private:
  const HeightField<S>& field_;
  std::uint32_t columns_, rows_, column_, row_;
};

/// The heights within reach of a point, at a horizontal distance from it of the square root of
/// `squared_gap`. The distance to other heights there, rounded down, exceeds `limit`.
template <Scalar S>
struct HeightReach {
  bool is_any;
  S low, high;

  template <Number Area>
  constexpr HeightReach(const S& height, const S& limit, const Area& squared_gap) noexcept
      : is_any(true), low(lowest<S>), high(largest<S>) {
    if (limit == largest<S>) return;  // greater distances are clamped to it
    const auto beyond = limit + S::from_raw(1);
    const auto squared_rise = square(beyond) - squared_gap;
    is_any = squared_rise > 0;
    if (!is_any) return;
    const auto rise = sqrt_ceil<std::remove_cvref_t<decltype(beyond)>>(squared_rise);
    low = floor_to<S>(height - rise);
    high = ceil_to<S>(height + rise);
  }
};

}  // namespace detent::detail
