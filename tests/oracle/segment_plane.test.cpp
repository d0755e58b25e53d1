// SPDX-License-Identifier: MIT
#include "detent/query/intersects/plane.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Segment<S, N>, Plane<S, N>>(seed, count, Aim{50});
}

DETENT_ORACLE_TEST("segment and plane", 0x5e6b1a, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
