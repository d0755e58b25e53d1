// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/plane_triangle.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Plane<S, N>, Triangle<S, N>>(seed, count, Aim{});
}

DETENT_ORACLE_TEST("plane and triangle", 0x91a321, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
