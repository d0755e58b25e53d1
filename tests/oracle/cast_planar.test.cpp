// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"

namespace detent::oracle {
namespace {

TEST_CASE("cast of round shapes and boxes in the plane: every answer is exact", "[oracle]") {
  examine_casts<q16_16, 2, CastFamily::round, CastFamily::boxes>(0xca5a, 12);
}

TEST_CASE("cast of round shapes and boxes in the plane: many more answers are exact",
          "[oracle][.demand]") {
  for (const auto seed : demanded_seeds())
    examine_casts<q16_16, 2, CastFamily::round, CastFamily::boxes>(seed, 100);
}

}  // namespace
}  // namespace detent::oracle
