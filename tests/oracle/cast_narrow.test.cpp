// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"

namespace detent::oracle {
namespace {

TEST_CASE("cast in the plane, q8_8: every answer is exact", "[oracle]") {
  examine_casts<q8_8, 2, CastFamily::round, CastFamily::boxes, CastFamily::polytopes>(0xca5c, 12);
}

TEST_CASE("cast in the plane, q8_8: many more answers are exact", "[oracle][.demand]") {
  for (const auto seed : demanded_seeds())
    examine_casts<q8_8, 2, CastFamily::round, CastFamily::boxes, CastFamily::polytopes>(seed, 100);
}

}  // namespace
}  // namespace detent::oracle
