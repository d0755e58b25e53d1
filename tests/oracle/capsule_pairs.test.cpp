// SPDX-License-Identifier: MIT
#include "detent/query/intersects/capsule.hpp"
#include "detent/query/overlaps/capsule_capsule.hpp"
#include "detent/query/overlaps/plane_capsule.hpp"
#include "detent/query/overlaps/triangle_capsule.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Plane<S, N>, Capsule<S, N>>(seed, count);
  examine_pair<Triangle<S, N>, Capsule<S, N>>(seed, count, Aim{40});
  examine_pair<Capsule<S, N>, Capsule<S, N>>(seed, count);
  examine_pair<Segment<S, N>, Capsule<S, N>>(seed, count, Aim{10});
}

DETENT_ORACLE_TEST("capsules and edges", 0xca950, pair_cases / 2, pair_cases)

}  // namespace
}  // namespace detent::oracle
