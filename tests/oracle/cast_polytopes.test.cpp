// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"
#include "query/cast/shapes.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine_polytopes(std::uint64_t seed, long count) {
  CastExam<S, N> exam(seed);
  CastShapes<S, N>::for_each([&]<class A>(const A&) {
    if constexpr (!is_round<A> && !is_box<A>) exam.template examine_all<A>(count);
  });
  exam.finish();
}

TEST_CASE("cast of other polytopes: every answer is exact", "[oracle]") {
  examine_polytopes<q16_16, 3>(0xca59, 12);
}

TEST_CASE("cast of other polytopes: many more answers are exact", "[oracle][.demand]") {
  for (const auto seed : demanded_seeds()) examine_polytopes<q16_16, 3>(seed, 100);
}

#if DETENT_TEST_ALL
// Examples of the same pairs, which share their instantiations.
TEST_CASE("cast: a segment, triangle or hull against every kind of shape", "[cast]") {
  test::visit_hulls<q16_16, 3>(-3, [](const auto& shape) { test::check_casts<q16_16, 3>(shape); });
}
#endif

}  // namespace
}  // namespace detent::oracle
