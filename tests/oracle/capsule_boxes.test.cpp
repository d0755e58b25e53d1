// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/aabb_capsule.hpp"
#include "detent/query/overlaps/obb_capsule.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Aabb<S, N>, Capsule<S, N>>(seed, count);
  examine_pair<Obb<S, N>, Capsule<S, N>>(seed, count);
}

TEMPLATE_TEST_CASE("capsules and boxes: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0xca9b0, pair_cases / 4);
}

TEMPLATE_TEST_CASE("capsules and boxes: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases / 2);
  }
}

}  // namespace
}  // namespace detent::oracle
