// SPDX-License-Identifier: MIT
#include "oracle/cast_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S>
void examine_planar(std::uint64_t seed, long count) {
  CastExam<S, 2> exam(seed);
  exam.template examine<Sphere<S, 2>, Capsule<S, 2>>(count);
  exam.template examine<Capsule<S, 2>, Obb<S, 2>>(count);
  exam.template examine<Sphere<S, 2>, ConvexHull<S, 2>>(count);
  exam.template examine<Obb<S, 2>, Triangle<S, 2>>(count);
  exam.template examine<ConvexHull<S, 2>, Aabb<S, 2>>(count);
  exam.template examine<Triangle<S, 2>, Plane<S, 2>>(count);
  exam.finish();
}

TEMPLATE_TEST_CASE("cast in the plane: every answer is exact", "[oracle]", q16_16, q8_8) {
  examine_planar<TestType>(0xca57, 150);
}

TEMPLATE_TEST_CASE("cast in the plane: many more answers are exact", "[oracle][.demand]", q16_16,
                   q8_8) {
  for (const auto seed : demanded_seeds()) examine_planar<TestType>(seed, 1000);
}

}  // namespace
}  // namespace detent::oracle
