// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/obb_plane.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Obb<S, N>, Plane<S, N>>(seed, count, Aim{});
}

DETENT_ORACLE_TEST("OBB and plane", 0x0bb91a, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
