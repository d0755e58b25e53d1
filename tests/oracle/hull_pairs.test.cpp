// SPDX-License-Identifier: MIT
#include "detent/query/intersects/hull.hpp"
#include "detent/query/overlaps/hull_hull.hpp"
#include "detent/query/overlaps/triangle_hull.hpp"
#include "oracle/hull.hpp"
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  using Hull = ConvexHull<S, N>;
  examine_pair<Hull, Hull>(
      seed, count, Aim{N == 2 ? 70 : 50, 30, 70}, [&](auto& exam, auto&, auto&) {
        exam.family("round", count / 10, 20, 80, [&] {
          const auto radius = std::max<std::int64_t>(exam.draw.scale() / 4, 2);
          const auto center = exam.draw.point(radius);
          return std::pair{
              round_hull(exam.draw, center, radius, 24),
              round_hull(exam.draw, exam.draw.near(center, radius * (N == 2 ? 9 : 7) / 4), radius,
                         24)};
        });
      });
  examine_pair<Triangle<S, N>, Hull>(seed + 1, count, Aim{N == 2 ? 55 : 10, 30, 70});
  examine_pair<Segment<S, N>, Hull>(seed + 2, count, Aim{N == 2 ? 35 : 1, N == 2 ? 30 : 15, 70});
}

DETENT_ORACLE_TEST("hull and hull, triangle, segment", 0x4111, pair_cases / 10, pair_cases / 10)

}  // namespace
}  // namespace detent::oracle
