// SPDX-License-Identifier: MIT
#include "detent/query/intersects/obb.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Segment<S, N>, Obb<S, N>>(seed, count, Aim{N == 2 ? 60 : 35});
}

TEMPLATE_TEST_CASE("segment and OBB: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x5e60bb, pair_cases);
}

TEMPLATE_TEST_CASE("segment and OBB: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases);
  }
}

}  // namespace
}  // namespace detent::oracle
