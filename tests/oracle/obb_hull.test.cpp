// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/obb_hull.hpp"
// The hull helpers come before the exam, which looks them up.
#include "oracle/hull.hpp"
//
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  using Hull = ConvexHull<S, N>;
  examine_pair<Obb<S, N>, Hull>(seed, count, Aim{N == 2 ? 85 : 60, 30, 70});
}

TEMPLATE_TEST_CASE("OBB and hull: overlapping is decided exactly", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x4113, pair_cases / 10);
}

TEMPLATE_TEST_CASE("OBB and hull: many more decisions are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases / 10);
  }
}

}  // namespace
}  // namespace detent::oracle
