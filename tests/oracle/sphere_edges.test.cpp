// SPDX-License-Identifier: MIT
#include "detent/query/intersects/sphere.hpp"
#include "detent/query/overlaps/sphere_capsule.hpp"
#include "detent/query/overlaps/sphere_triangle.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  examine_pair<Sphere<S, N>, Triangle<S, N>>(seed, count, Aim{40});
  examine_pair<Sphere<S, N>, Capsule<S, N>>(seed, count);
  examine_pair<Segment<S, N>, Sphere<S, N>>(seed, count, Aim{15});
}

DETENT_ORACLE_TEST("spheres and edges", 0x5ed9e, pair_cases, 2 * pair_cases)

}  // namespace
}  // namespace detent::oracle
