// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine_round(std::uint64_t seed, long count) {
  CastExam<S, N> exam(seed);
  exam.template examine<Sphere<S, N>, Sphere<S, N>>(count);
  exam.template examine<Sphere<S, N>, Obb<S, N>>(count);
  exam.template examine<Sphere<S, N>, Plane<S, N>>(count);
  exam.template examine<Capsule<S, N>, Aabb<S, N>>(count);
  exam.template examine<Capsule<S, N>, Triangle<S, N>>(count);
  exam.template examine<ConvexHull<S, N>, Capsule<S, N>>(count);
  exam.finish();
}

TEST_CASE("cast of round shapes: every answer is exact", "[oracle]") {
  examine_round<q16_16, 3>(0xca57, 40);
}

TEST_CASE("cast of round shapes: many more answers are exact", "[oracle][.demand]") {
  for (const auto seed : demanded_seeds()) examine_round<q16_16, 3>(seed, 1000);
}

}  // namespace
}  // namespace detent::oracle
