// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/triangle_triangle.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Triangle<S, N>, Triangle<S, N>>(seed, count, Aim{N == 2 ? 60 : 20, N == 2 ? 30 : 5});
}

DETENT_ORACLE_TEST("triangle and triangle", 0x321321, pair_cases / 2, pair_cases / 2)

}  // namespace
}  // namespace detent::oracle
