// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/aabb_plane.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Aabb<S, N>, Plane<S, N>>(seed, count, Aim{});
}

TEMPLATE_TEST_CASE("AABB and plane: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0xaabb91a, pair_cases);
}

TEMPLATE_TEST_CASE("AABB and plane: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases);
  }
}

}  // namespace
}  // namespace detent::oracle
