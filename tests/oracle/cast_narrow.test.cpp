// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"

namespace detent::oracle {
namespace {

void examine_narrow(std::uint64_t seed, long count) {
  CastExam<q8_8, 2> exam(seed);
  CastShapes<q8_8, 2>::for_each([&]<class A>(const A&) { exam.template examine_all<A>(count); });
  exam.finish();
}

TEST_CASE("cast in the plane, q8_8: every answer is exact", "[oracle]") {
  examine_narrow(0xca5c, 12);
}

TEST_CASE("cast in the plane, q8_8: many more answers are exact", "[oracle][.demand]") {
  for (const auto seed : demanded_seeds()) examine_narrow(seed, 100);
}

}  // namespace
}  // namespace detent::oracle
