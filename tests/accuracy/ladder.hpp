// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace detent::accuracy {

/// The quantity that grows from rung to rung.
enum class Ladder { size, distance, place, angle };

inline constexpr Ladder ladders[] = {Ladder::size, Ladder::distance, Ladder::place, Ladder::angle};

[[nodiscard]] std::string_view name_of(Ladder ladder);
[[nodiscard]] std::string_view description_of(Ladder ladder);

/// The scale of a set of test cases; lengths in world units.
struct Rung {
  Ladder ladder;
  double value;      // of the growing quantity
  std::string name;  // the value in words
  double size;       // of the shapes
  double length;     // distance from the ray origins to the shapes
  double place;      // coordinate of the shapes on every axis
  double angle;      // between the axes of shapes and rays, in radians; negative for any
  int frac;          // the grid: 2^-frac

  /// All numbers of the test cases are below this, except for some that are drawn again.
  [[nodiscard]] double reach() const;
};

/// The rungs in ascending order. The distance ladder applies to rays and casts only.
[[nodiscard]] const std::vector<Rung>& rungs();

}  // namespace detent::accuracy
