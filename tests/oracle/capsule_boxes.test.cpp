// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/aabb_capsule.hpp"
#include "detent/query/overlaps/obb_capsule.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Aabb<S, N>, Capsule<S, N>>(seed, count);
  examine_pair<Obb<S, N>, Capsule<S, N>>(seed, count);
}

DETENT_ORACLE_TEST("capsules and boxes", 0xca9b0, pair_cases / 4, pair_cases / 2)

}  // namespace
}  // namespace detent::oracle
