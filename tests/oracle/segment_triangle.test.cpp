// SPDX-License-Identifier: MIT
#include "detent/query/intersects/triangle.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  const auto more = [count](auto& exam, auto& draw, auto& random) {
    exam.family("crossing", count * 3 / 10, 30, 90, [&] {
      const Pencil lines(draw);
      const auto u = lines.way(), v = lines.way(), w = lines.way();
      const auto opposite = draw.plus(draw.plus(Raw<N>{}, u, -1), v, random.between(-2, 0));
      return std::pair{
          Segment<S, N>{lines.point(w, 0, 3), lines.point(w, -3, 2)},
          Triangle<S, N>{lines.point(u, 0, 3), lines.point(v, 0, 3), lines.point(opposite, 0, 1)}};
    });
  };
  examine_pair<Segment<S, N>, Triangle<S, N>>(seed, count, Aim{30, 0, 70}, more);
}

DETENT_ORACLE_TEST("segment and triangle", 0x5e6721, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
