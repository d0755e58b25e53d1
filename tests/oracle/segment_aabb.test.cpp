// SPDX-License-Identifier: MIT
#include "detent/query/intersects/aabb.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Segment<S, N>, Aabb<S, N>>(seed, count, Aim{N == 2 ? 60 : 35});
}

DETENT_ORACLE_TEST("segment and AABB", 0x5e6aab, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
