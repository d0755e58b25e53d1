// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/capsule_hull.hpp"
#include "detent/query/overlaps/plane_hull.hpp"
#include "detent/query/overlaps/sphere_hull.hpp"
#include "oracle/hull.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  using Hull = ConvexHull<S, N>;
  examine_pair<Sphere<S, N>, Hull>(seed, count, Aim{N == 2 ? 75 : 55, 30, 70});
  examine_pair<Plane<S, N>, Hull>(seed + 1, count, Aim{70, 30, 70});
  examine_pair<Capsule<S, N>, Hull>(seed + 2, count / 2, Aim{N == 2 ? 75 : 55, 30, 70});
}

DETENT_ORACLE_TEST("hull and sphere, plane, capsule", 0x4115, pair_cases / 10, pair_cases / 10)

}  // namespace
}  // namespace detent::oracle
