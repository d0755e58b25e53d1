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

TEMPLATE_TEST_CASE("spheres and edges: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x5ed9e, pair_cases);
}

TEMPLATE_TEST_CASE("spheres and edges: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, 2 * pair_cases);
  }
}

}  // namespace
}  // namespace detent::oracle
