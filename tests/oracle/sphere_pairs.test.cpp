// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/sphere_aabb.hpp"
#include "detent/query/overlaps/sphere_obb.hpp"
#include "detent/query/overlaps/sphere_plane.hpp"
#include "detent/query/overlaps/sphere_sphere.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  using Round = Sphere<S, N>;
  examine_pair<Round, Sphere<S, N>>(seed, count);
  examine_pair<Round, Aabb<S, N>>(seed, count);
  examine_pair<Round, Obb<S, N>>(seed, count);
  examine_pair<Round, Plane<S, N>>(seed, count);
}

DETENT_ORACLE_TEST("spheres and boxes", 0x59e8e, pair_cases, 2 * pair_cases)

}  // namespace
}  // namespace detent::oracle
