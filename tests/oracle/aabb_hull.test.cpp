// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/aabb_hull.hpp"
#include "oracle/hull.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  using Hull = ConvexHull<S, N>;
  examine_pair<Aabb<S, N>, Hull>(seed, count, Aim{N == 2 ? 90 : 70, 30, 70});
}

DETENT_ORACLE_TEST("AABB and hull", 0x4112, pair_cases / 10, pair_cases / 10)

}  // namespace
}  // namespace detent::oracle
