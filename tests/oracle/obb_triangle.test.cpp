// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/obb_triangle.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Obb<S, N>, Triangle<S, N>>(seed, count, Aim{N == 2 ? 70 : 50});
}

DETENT_ORACLE_TEST("OBB and triangle", 0x0bb321, pair_cases / 4, pair_cases / 4)

}  // namespace
}  // namespace detent::oracle
