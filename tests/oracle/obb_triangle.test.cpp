// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/obb_triangle.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Obb<S, N>, Triangle<S, N>>(seed, count, Aim{N == 2 ? 70 : 50});
}

TEMPLATE_TEST_CASE("OBB and triangle: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x0bb321, pair_cases / 4);
}

TEMPLATE_TEST_CASE("OBB and triangle: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases / 4);
  }
}

}  // namespace
}  // namespace detent::oracle
