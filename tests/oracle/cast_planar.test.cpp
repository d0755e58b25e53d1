// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"

namespace detent::oracle {
namespace {

void examine_planar(std::uint64_t seed, long count) {
  CastExam<q16_16, 2> exam(seed);
  CastShapes<q16_16, 2>::for_each([&]<class A>(const A&) {
    if constexpr (is_round<A> || is_box<A>) exam.template examine_all<A>(count);
  });
  exam.finish();
}

TEST_CASE("cast of round shapes and boxes in the plane: every answer is exact", "[oracle]") {
  examine_planar(0xca5a, 12);
}

TEST_CASE("cast of round shapes and boxes in the plane: many more answers are exact",
          "[oracle][.demand]") {
  for (const auto seed : demanded_seeds()) examine_planar(seed, 100);
}

}  // namespace
}  // namespace detent::oracle
