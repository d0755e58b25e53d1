// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/obb_hull.hpp"
#include "oracle/hull.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  using Hull = ConvexHull<S, N>;
  examine_pair<Obb<S, N>, Hull>(seed, count, Aim{N == 2 ? 85 : 60, 30, 70});
}

DETENT_ORACLE_TEST("OBB and hull", 0x4113, pair_cases / 10, pair_cases / 10)

}  // namespace
}  // namespace detent::oracle
