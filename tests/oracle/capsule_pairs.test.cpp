// SPDX-License-Identifier: MIT
#include "detent/query/intersects/capsule.hpp"
#include "detent/query/overlaps/capsule_capsule.hpp"
#include "detent/query/overlaps/plane_capsule.hpp"
#include "detent/query/overlaps/triangle_capsule.hpp"
#include "oracle/near_segment.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <class Shape, Scalar S, int N>
bool meet(const Shape& shape, const Capsule<S, N>& capsule) {
  return capsule.radius >= 0 &&
         near_segment(shape, Segment{capsule.a, capsule.b}, raw(capsule.radius));
}
template <Scalar S, int N>
bool meet(const Capsule<S, N>& a, const Capsule<S, N>& b) {
  return a.radius >= 0 && b.radius >= 0 &&
         near_segment(Segment{a.a, a.b}, Segment{b.a, b.b}, raw(a.radius) + raw(b.radius));
}

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  const auto truth = [](const auto& a, const auto& b) { return meet(a, b); };
  examine_pair<Plane<S, N>, Capsule<S, N>>(seed, count, truth);
  examine_pair<Triangle<S, N>, Capsule<S, N>>(seed, count, truth, Aim{40});
  examine_pair<Capsule<S, N>, Capsule<S, N>>(seed, count, truth);
  examine_pair<Segment<S, N>, Capsule<S, N>>(seed, count, truth, Aim{10});
}

TEMPLATE_TEST_CASE("capsules and edges: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0xca950, pair_cases / 2);
}

TEMPLATE_TEST_CASE("capsules and edges: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases);
  }
}

}  // namespace
}  // namespace detent::oracle
