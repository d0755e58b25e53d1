// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine_polytopes(std::uint64_t seed, long count) {
  CastExam<S, N> exam(seed);
  exam.template examine<Aabb<S, N>, Aabb<S, N>>(count);
  exam.template examine<Aabb<S, N>, Triangle<S, N>>(count);
  exam.template examine<Obb<S, N>, Obb<S, N>>(count);
  exam.template examine<Obb<S, N>, Segment<S, N>>(count);
  exam.template examine<Triangle<S, N>, ConvexHull<S, N>>(count);
  exam.template examine<Obb<S, N>, ConvexHull<S, N>>(count);
  exam.template examine<ConvexHull<S, N>, ConvexHull<S, N>>(count);
  exam.template examine<Segment<S, N>, Segment<S, N>>(count);
  exam.template examine<ConvexHull<S, N>, Plane<S, N>>(count);
  exam.finish();
}

TEST_CASE("cast of polytopes: every answer is exact", "[oracle]") {
  examine_polytopes<q16_16, 3>(0xca57, 100);
}

TEST_CASE("cast of polytopes: many more answers are exact", "[oracle][.demand]") {
  for (const auto seed : demanded_seeds()) examine_polytopes<q16_16, 3>(seed, 1000);
}

}  // namespace
}  // namespace detent::oracle
