// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/obb_obb.hpp"

#include "oracle/linear.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  const auto truth = [](const auto& a, const auto& b) { return meet(hull_of(a), hull_of(b)); };
  examine_pair<Obb<S, N>, Obb<S, N>>(seed, count, truth, Aim{});
}

TEMPLATE_TEST_CASE("OBB and OBB: every answer is the exact one", "[oracle]", DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x0bb0bb, pair_cases / 8);
}

TEMPLATE_TEST_CASE("OBB and OBB: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases / 8);
  }
}

}  // namespace
}  // namespace detent::oracle
