// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy/ladder.hpp"

namespace detent::cli::accuracy {

/// Whose numbers a question consists of, and what its answer is judged by.
///
/// `own`: drawn on the scalar's own grid and judged for exactly those numbers, so all that is wrong
/// is the computation. `asked`: drawn on the grid of q16_16 (beyond its world of q24_8), rounded to
/// the nearest numbers of the scalar, and judged for the numbers before that: so what the scalar
/// cannot represent counts too.
enum class Inputs { own, asked };

/// How a scalar did at one rung. Errors are in units of 2^-16, of questions whose right answer and
/// whose given one are hits.
struct Cell {
  std::string scalar;
  Inputs inputs = Inputs::own;
  long questions = 0;
  long hits = 0;   // by the exact answers
  long wrong = 0;  // hit for miss, miss for hit, or no number
  long off = 0;    // of a `Fixed`: distances that are not the exact one rounded down
  double median = 0;
  double largest = 0;
};

/// A query of the library as the ladder sees it.
struct Query {
  std::string kind;  // "raycast", "overlaps" or "intersects"
  std::string name;  // "raycast/sphere", "overlaps/sphere_aabb", "raycast/sphere_2d"
  int cost;          // how many times fewer questions than others it is asked
  std::function<bool(const Rung&)> applies;
  std::function<std::vector<Cell>(const Rung&, long count, std::uint64_t seed)> ask;
};

/// Every query of the ladder, those of 3D first, and of each dimension raycasts first.
[[nodiscard]] const std::vector<Query>& queries();

/// What a rung gave for a query.
struct Result {
  const Query* query;
  const Rung* rung;
  std::vector<Cell> cells;
};

/// Asks one query at one rung.
///
/// Questions are random; half of them are drawn until they are hits, half until they are misses.
/// Throws std::runtime_error when the share of hits is outside 30 to 70 % nevertheless.
[[nodiscard]] Result survey(const Query& query, const Rung& rung, long count, std::uint64_t seed);

}  // namespace detent::cli::accuracy
