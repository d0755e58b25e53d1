// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/plane_triangle.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Plane<S, N>, Triangle<S, N>>(seed, count, Aim{});
}

TEMPLATE_TEST_CASE("plane and triangle: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x91a321, pair_cases);
}

TEMPLATE_TEST_CASE("plane and triangle: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases);
  }
}

}  // namespace
}  // namespace detent::oracle
