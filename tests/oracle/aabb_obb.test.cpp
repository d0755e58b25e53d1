// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/aabb_obb.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Aabb<S, N>, Obb<S, N>>(seed, count, Aim{});
}

TEMPLATE_TEST_CASE("AABB and OBB: every answer is the exact one", "[oracle]", DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0xaabb0bb, pair_cases / 8);
}

TEMPLATE_TEST_CASE("AABB and OBB: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases / 8);
  }
}

}  // namespace
}  // namespace detent::oracle
