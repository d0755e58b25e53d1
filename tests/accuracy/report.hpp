// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "accuracy/survey.hpp"

namespace detent::accuracy {

struct Report {
  std::vector<Result> results;  // ordered by query, then by rung
  long count = 0;
  std::uint64_t seed = 0;
};

/// The cell of a scalar, or nothing if the rung does not apply to it.
[[nodiscard]] const Cell* find(const Result& result, std::string_view scalar, Inputs inputs);

/// The results of one query on one ladder.
[[nodiscard]] std::vector<const Result*> column(const Report& report, const Query& query,
                                                Ladder ladder);

/// "2026-11-21, g++ 12.2.0, seed 1, 2000 questions"
[[nodiscard]] std::string circumstances(const Report& report);

/// The two tables of docs/accuracy.md, in Markdown.
[[nodiscard]] std::string summary(const Report& report);
/// Every rung: docs/data/accuracy.csv.
[[nodiscard]] std::string csv(const Report& report);
[[nodiscard]] std::string plot(const Report& report);

}  // namespace detent::accuracy
