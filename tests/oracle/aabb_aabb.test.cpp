// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/aabb_aabb.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Aabb<S, N>, Aabb<S, N>>(seed, count, Aim{N == 2 ? 70 : 55});
}

TEMPLATE_TEST_CASE("AABB and AABB: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0xaabbaabb, pair_cases / 4);
}

TEMPLATE_TEST_CASE("AABB and AABB: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases / 4);
  }
}

}  // namespace
}  // namespace detent::oracle
