// SPDX-License-Identifier: MIT
#include "detent/query/intersects/segment.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  // Through a common point, or missing it by one raw unit.
  const auto more = [count](auto& exam) {
    auto& draw = exam.draw;
    auto& random = draw.random;
    using D = Draw<S, N>;
    exam.family("crossing", count * 3 / 10, 30, 90, [&] {
      const auto reach = std::min(draw.scale(), D::limit / 16);
      const auto point = draw.point(D::limit / 4);
      const auto u = draw.point(reach), v = draw.point(reach);
      const auto corner = [&](const Raw<N>& way, std::int64_t from, std::int64_t to) {
        const auto exact = D::plus(point, way, random.between(from, to));
        return D::vec(random.one_in(8) ? draw.near(exact, 1) : exact);
      };
      return std::pair{Segment<S, N>{corner(u, 0, 3), corner(u, -3, 0)},
                       Segment<S, N>{corner(v, 0, 3), corner(v, -3, 0)}};
    });
  };
  examine_pair<Segment<S, N>, Segment<S, N>>(seed, count, Aim{30, 0, 70}, more);
}

DETENT_ORACLE_TEST("segment and segment", 0x5e65e6, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
