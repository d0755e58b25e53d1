// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace detent::cli::accuracy {

/// What grows from rung to rung.
enum class Ladder { size, distance, place, angle };

inline constexpr Ladder ladders[] = {Ladder::size, Ladder::distance, Ladder::place, Ladder::angle};

[[nodiscard]] std::string_view name_of(Ladder ladder);
[[nodiscard]] std::string_view description_of(Ladder ladder);

/// A scale at which questions are asked; lengths in world units.
struct Rung {
  Ladder ladder;
  double value;      // of what grows
  std::string name;  // the value in words
  double size;       // of the shapes
  double length;     // how far the rays are from them
  double place;      // where the shapes are on every axis, away from the world's origin
  double angle;      // between the axes of shapes and rays, in radians; negative for any
  int frac;          // the grid: 2^-frac

  /// All numbers of the questions are below this, but for some that are drawn again.
  [[nodiscard]] double reach() const;
};

/// The rungs from the least to the greatest. Those of the distance are for rays alone.
[[nodiscard]] const std::vector<Rung>& rungs();

}  // namespace detent::cli::accuracy
