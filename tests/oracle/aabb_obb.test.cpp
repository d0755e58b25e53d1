// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/aabb_obb.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Aabb<S, N>, Obb<S, N>>(seed, count, Aim{});
}

DETENT_ORACLE_TEST("AABB and OBB", 0xaabb0bb, pair_cases / 8, pair_cases / 8)

}  // namespace
}  // namespace detent::oracle
