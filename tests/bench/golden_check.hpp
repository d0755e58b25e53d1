// SPDX-License-Identifier: MIT
#pragma once

#include "bench/question.hpp"
#include "support/catch.hpp"

namespace detent::bench {

/// Checks the hit count that the benchmark of a query compares with, without the benchmark.
inline constexpr auto check_golden = [](const auto& query) {
  INFO(query.name);
  REQUIRE(query.golden);
  const auto drawn = draw_questions(query, default_seed, ordinary);
  CHECK(count_hits<q16_16>(query, as_questions<q16_16>(query, drawn)) == query.golden->ordinary);
};

}  // namespace detent::bench
