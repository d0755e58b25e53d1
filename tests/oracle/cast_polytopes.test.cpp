// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"
#include "query/cast/shapes.hpp"

namespace detent::oracle {
namespace {

TEST_CASE("cast of other polytopes: every answer is exact", "[oracle]") {
  examine_casts<q16_16, 3, CastFamily::polytopes>(0xca59, 12);
}

TEST_CASE("cast of other polytopes: many more answers are exact", "[oracle][.demand]") {
  for (const auto seed : demanded_seeds())
    examine_casts<q16_16, 3, CastFamily::polytopes>(seed, 100);
}

#if DETENT_TEST_ALL
// Examples of the same pairs, which share their instantiations.
TEST_CASE("cast: a segment, triangle or hull against every kind of shape", "[cast]") {
  test::visit_hulls<q16_16, 3>(-3, [](const auto& shape) { test::check_casts<q16_16, 3>(shape); });
}
#endif

}  // namespace
}  // namespace detent::oracle
