// SPDX-License-Identifier: MIT
#include "detent/query/intersects/triangle.hpp"

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
      const auto u = draw.point(reach), v = draw.point(reach), w = draw.point(reach);
      const auto corner = [&](const Raw<N>& way, std::int64_t from, std::int64_t to) {
        const auto exact = D::plus(point, way, random.between(from, to));
        return D::vec(random.one_in(8) ? draw.near(exact, 1) : exact);
      };
      const auto opposite = D::plus(D::plus(Raw<N>{}, u, -1), v, random.between(-2, 0));
      return std::pair{Segment<S, N>{corner(w, 0, 3), corner(w, -3, 2)},
                       Triangle<S, N>{corner(u, 0, 3), corner(v, 0, 3), corner(opposite, 0, 1)}};
    });
  };
  examine_pair<Segment<S, N>, Triangle<S, N>>(seed, count, Aim{30, 0, 70}, more);
}

DETENT_ORACLE_TEST("segment and triangle", 0x5e6721, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
