// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine_round(std::uint64_t seed, long count) {
  CastExam<S, N> exam(seed);
  CastShapes<S, N>::for_each([&]<class A>(const A&) {
    if constexpr (is_round<A>) exam.template examine_all<A>(count);
  });
  exam.finish();
}

TEST_CASE("cast of round shapes: every answer is exact", "[oracle]") {
  examine_round<q16_16, 3>(0xca57, 12);
}

TEST_CASE("cast of round shapes: many more answers are exact", "[oracle][.demand]") {
  for (const auto seed : demanded_seeds()) examine_round<q16_16, 3>(seed, 100);
}

}  // namespace
}  // namespace detent::oracle
