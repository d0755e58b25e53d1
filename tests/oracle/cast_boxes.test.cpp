// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"
#include "query/cast/shapes.hpp"

namespace detent::oracle {
namespace {

TEST_CASE("cast of boxes: every answer is exact", "[oracle]") {
  examine_casts<q16_16, 3, CastFamily::boxes>(0xca58, 12);
}

TEST_CASE("cast of boxes: many more answers are exact", "[oracle][.demand]") {
  for (const auto seed : demanded_seeds()) examine_casts<q16_16, 3, CastFamily::boxes>(seed, 100);
}

// Examples of the same pairs, which share their instantiations.
TEST_CASE("cast: a box against every kind of shape", "[cast]") {
  test::visit_boxes<q16_16, 3>(-3, [](const auto& shape) { test::check_casts<q16_16, 3>(shape); });
}

}  // namespace
}  // namespace detent::oracle
