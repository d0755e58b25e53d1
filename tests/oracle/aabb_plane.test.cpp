// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/aabb_plane.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Aabb<S, N>, Plane<S, N>>(seed, count, Aim{});
}

DETENT_ORACLE_TEST("AABB and plane", 0xaabb91a, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
