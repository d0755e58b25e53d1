// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/scene/height_field/cells.hpp"

// The cells of a height field along a line {origin + t * direction : t >= 0}, strip by strip. A
// strip is one row or one column of cells, across the axis on which the line moves most, so the
// line crosses at most three of its cells.
//
// Let `ahead` be the distance on that axis from the origin to a border of strips, and `size` the
// absolute component of the direction. The line reaches the border at t = ahead / size, where it
// has moved by ahead * d / size on an axis with component d. Multiplied by `size`, all comparisons
// are exact and need no division.

namespace detent::detail {

/// One horizontal axis of a height field. Its cells, and the borders between them, are counted in
/// the direction in which the line moves.
template <Scalar S>
struct FieldAxis {
  S corner, cell, origin;
  std::uint32_t count;
  bool is_backward;

  /// The distance on this axis from the line's origin to a border.
  [[nodiscard]] constexpr auto ahead(std::uint32_t border) const noexcept {
    return is_backward ? origin - field_border(corner, cell, count - border)
                       : field_border(corner, cell, border) - origin;
  }
  /// The lowest column or row of the field among `width` cells from `first` on.
  [[nodiscard]] constexpr std::uint32_t place(std::uint32_t first,
                                              std::uint32_t width) const noexcept {
    return is_backward ? count - first - width : first;
  }
};

/// A line over a height field. `T` is the exact type of its direction's components, none of which
/// is the lowest `T`.
template <Scalar S, Number T>
class FieldLine {
 public:
  constexpr FieldLine(const HeightField<S>& field, const Vec<S, 3>& origin,
                      const Vec<T, 3>& direction) noexcept
      : is_along_rows_(abs(direction.x) >= abs(direction.z)),
        main_(axis(field, origin, direction, is_along_rows_)),
        side_(axis(field, origin, direction, !is_along_rows_)),
        height_(origin.y),
        is_falling_(direction.y < 0),
        size_(narrow_abs(is_along_rows_ ? direction.x : direction.z)),
        side_speed_(narrow_abs(is_along_rows_ ? direction.z : direction.x)),
        rise_speed_(narrow_abs(direction.y)),
        is_vertical_(size_ == 0),
        bounds_(rises(field.bounds.min.y, field.bounds.max.y)) {
    if (is_vertical_) size_ = T::from_raw(1);  // the line stays in its strip, at any height
  }

  /// Visits the strips that the line crosses, in order: calls visit(cells, meets). `cells` are the
  /// cells of the strip that it crosses; meets(low, high) returns whether it may touch samples
  /// between these heights there. ends(ahead, size) returns whether the line ends before a strip
  /// that begins there.
  template <class Ends, class Visit>
  constexpr Walk visit_strips(const Ends& ends, const Visit& visit) const noexcept {
    const auto far_side = side_.ahead(side_.count) * size_;
    const auto far_rise = bounds_.most * size_;
    std::uint32_t first = 0;
    bool is_first = true;
    for (auto i = first_strip(); i < main_.count; ++i) {
      const auto start = main_.ahead(i), end = main_.ahead(i + 1);
      const auto from = start * side_speed_, to = end * side_speed_;
      const auto rise_from = start * rise_speed_, rise_to = end * rise_speed_;
      if (ends(start, size_) || from > far_side) return Walk::go_on;
      if (!is_vertical_ && rise_from > far_rise) return Walk::go_on;
      const auto is_before = [&](std::uint32_t cell) {
        return side_.ahead(cell + 1) * size_ < from;
      };
      if (is_first) first = first_where_not(side_.count - 1, is_before);
      is_first = false;
      while (first + 1 < side_.count && is_before(first)) ++first;
      auto last = first;
      while (last + 1 < side_.count && side_.ahead(last + 1) * size_ <= to) ++last;
      const auto meets = [&](const S& low, const S& high) {
        if (is_vertical_) return true;
        const auto [least, most] = rises(low, high);
        return least * size_ <= rise_to && most * size_ >= rise_from;
      };
      if (visit(strip(i, first, last - first + 1), meets) == Walk::stop) return Walk::stop;
    }
    return Walk::go_on;
  }

 private:
  using Way = decltype(S() - S());
  struct Rises {
    Way least, most;
  };

  [[nodiscard]] static constexpr FieldAxis<S> axis(const HeightField<S>& field,
                                                   const Vec<S, 3>& origin,
                                                   const Vec<T, 3>& direction, bool is_x) noexcept {
    if (is_x) return {field.corner.x, field.cell, origin.x, field.columns - 1, direction.x < 0};
    return {field.corner.y, field.cell, origin.z, field.rows - 1, direction.z < 0};
  }

  /// The vertical distance from the line's origin to each of these heights.
  [[nodiscard]] constexpr Rises rises(const S& low, const S& high) const noexcept {
    return is_falling_ ? Rises{height_ - high, height_ - low}
                       : Rises{low - height_, high - height_};
  }

  /// The first strip that is neither behind the line's origin nor before the point where the line
  /// reaches the field.
  [[nodiscard]] constexpr std::uint32_t first_strip() const noexcept {
    const auto near_side = side_.ahead(0) * size_;
    const auto near_rise = bounds_.least * size_;
    return first_where_not(main_.count, [&](std::uint32_t i) {
      const auto end = main_.ahead(i + 1);
      return end < 0 || end * side_speed_ < near_side ||
             (!is_vertical_ && end * rise_speed_ < near_rise);
    });
  }

  [[nodiscard]] constexpr FieldCells strip(std::uint32_t i, std::uint32_t first,
                                           std::uint32_t width) const noexcept {
    const auto at = main_.place(i, 1), begin = side_.place(first, width);
    return is_along_rows_ ? FieldCells{at, begin, 1, width} : FieldCells{begin, at, width, 1};
  }

  bool is_along_rows_;
  FieldAxis<S> main_, side_;
  S height_;
  bool is_falling_;
  T size_, side_speed_, rise_speed_;
  bool is_vertical_;
  Rises bounds_;
};

}  // namespace detent::detail
