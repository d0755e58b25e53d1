// SPDX-License-Identifier: MIT
#include "detent/query/intersects/aabb.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Segment<S, N>, Aabb<S, N>>(seed, count, Aim{N == 2 ? 60 : 35});
}

TEMPLATE_TEST_CASE("segment and AABB: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x5e6aab, pair_cases);
}

TEMPLATE_TEST_CASE("segment and AABB: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases);
  }
}

}  // namespace
}  // namespace detent::oracle
