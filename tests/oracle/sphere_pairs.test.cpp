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

TEMPLATE_TEST_CASE("spheres and boxes: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x59e8e, pair_cases);
}

TEMPLATE_TEST_CASE("spheres and boxes: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, 2 * pair_cases);
  }
}

}  // namespace
}  // namespace detent::oracle
