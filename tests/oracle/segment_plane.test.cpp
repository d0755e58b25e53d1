// SPDX-License-Identifier: MIT
#include "detent/query/intersects/plane.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  const auto truth = [](const auto& segment, const auto& plane) {
    const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
    const auto normal = widen(raw(plane.normal));
    const Integer place = one * raw(plane.offset);
    const Integer start = dot(normal, raw(segment.start)) - place;
    const Integer end = dot(normal, raw(segment.end)) - place;
    return start.sign() * end.sign() <= 0;
  };
  examine_pair<Segment<S, N>, Plane<S, N>>(seed, count, truth, Aim{50});
}

TEMPLATE_TEST_CASE("segment and plane: every answer is the exact one", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x5e6b1a, pair_cases);
}

TEMPLATE_TEST_CASE("segment and plane: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases);
  }
}

}  // namespace
}  // namespace detent::oracle
