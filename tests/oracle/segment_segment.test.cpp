// SPDX-License-Identifier: MIT
#include "detent/query/intersects/segment.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  const auto more = [count](auto& exam, auto& draw, auto&) {
    exam.family("crossing", count * 3 / 10, 30, 90, [&] {
      const Pencil lines(draw);
      const auto u = lines.way(), v = lines.way();
      return std::pair{Segment<S, N>{lines.point(u, 0, 3), lines.point(u, -3, 0)},
                       Segment<S, N>{lines.point(v, 0, 3), lines.point(v, -3, 0)}};
    });
  };
  examine_pair<Segment<S, N>, Segment<S, N>>(seed, count, Aim{30, 0, 70}, more);
}

DETENT_ORACLE_TEST("segment and segment", 0x5e65e6, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
