// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy/ladder.hpp"

namespace detent::accuracy {

/// The numbers of a test case, and the numbers for which its result is checked.
///
/// `own`: drawn on the scalar's own grid and checked for exactly those numbers, so every error
/// comes from the computation. `asked`: drawn on the grid of q16_16 (beyond its range, of q24_8),
/// rounded to the scalar's nearest numbers, and checked for the numbers before rounding, so that
/// unrepresentable inputs count as well.
enum class Inputs { own, asked };

/// The results of a scalar at one rung. Errors are in units of 2^-16, over the test cases where
/// both the exact and the given result are hits.
struct Cell {
  std::string scalar;
  Inputs inputs = Inputs::own;
  long questions = 0;
  long hits = 0;   // by the exact results
  long wrong = 0;  // hit for miss, miss for hit, or NaN or infinity
  long off = 0;    // for a `Fixed`: lengths and points other than the exact ones, rounded
  double median = 0;
  double largest = 0;
};

/// A query of the library, as run by the ladder.
struct Query {
  std::string kind;  // "raycast", "overlaps", "cast", ...
  std::string name;  // "raycast/sphere", "overlaps/sphere_aabb", "raycast/sphere_2d"
  int cost;          // divides the number of test cases
  std::function<bool(const Rung&)> applies;
  std::function<std::vector<Cell>(const Rung&, long count, std::uint64_t seed)> ask;
};

/// Every query of the ladder: 3D before 2D, and raycasts first within each.
[[nodiscard]] const std::vector<Query>& queries();

/// The results of a query at one rung.
struct Result {
  const Query* query;
  const Rung* rung;
  std::vector<Cell> cells;
};

/// Runs one query at one rung.
///
/// Test cases are random: half of them are drawn until they are hits, half until they are misses.
/// Throws std::runtime_error if the share of hits is still outside 30 to 70 %.
[[nodiscard]] Result survey(const Query& query, const Rung& rung, long count, std::uint64_t seed);

}  // namespace detent::accuracy
