// SPDX-License-Identifier: MIT
#include "detent/query/intersects/plane.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Segment<S, N>, Plane<S, N>>(seed, count, Aim{50});
}

TEMPLATE_TEST_CASE("segment and plane: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x5e6b1a, pair_cases);
}

TEMPLATE_TEST_CASE("segment and plane: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases);
  }
}

}  // namespace
}  // namespace detent::oracle
