// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/aabb_aabb.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Aabb<S, N>, Aabb<S, N>>(seed, count, Aim{N == 2 ? 70 : 55});
}

DETENT_ORACLE_TEST("AABB and AABB", 0xaabbaabb, pair_cases / 4, pair_cases / 4)

}  // namespace
}  // namespace detent::oracle
