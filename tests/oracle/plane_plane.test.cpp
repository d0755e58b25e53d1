// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/plane_plane.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(PairExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  exam.family("random", count * 2 / 10, 90, 100, [&] {
    return std::pair{from_raw<Plane<S, N>>(draw.any_direction(), draw.extreme()),
                     from_raw<Plane<S, N>>(draw.any_direction(), draw.extreme())};
  });
  exam.family("parallel", count * 4 / 10, 30, 70, [&] {
    const auto normal = random.coin() ? draw.any_direction() : draw.axis_direction();
    const auto scale = draw.scale();
    const auto offset = random.one_in(4) ? 0 : random.between(-scale, scale);
    const auto other = offset + (random.coin() ? random.between(-1, 1) : 0);
    if (random.coin()) {
      return std::pair{from_raw<Plane<S, N>>(normal, offset), from_raw<Plane<S, N>>(normal, other)};
    }
    return std::pair{from_raw<Plane<S, N>>(normal, offset), from_raw<Plane<S, N>>(-normal, -other)};
  });
  // Normals on one axis with different lengths: the same plane if the offsets differ by that ratio.
  exam.family("proportional", count * 2 / 10, 10, 90, [&] {
    const auto axis = draw.unit();
    const auto times = random.between(0, draw.limit / draw.one);
    const auto plane = [&] {
      const auto length = draw.one - random.between(0, 1);
      auto normal = axis;
      for (auto& component : normal) component *= length;
      const auto nudge = random.one_in(6) ? random.between(-1, 1) : 0;
      return from_raw<Plane<S, N>>(draw.direction(normal), times * length + nudge);
    };
    return std::pair{plane(), plane()};
  });
  exam.family("nearly parallel", count * 2 / 10, 30, 99, [&] {
    const auto normal = draw.any_direction();
    return std::pair{from_raw<Plane<S, N>>(draw.disturbed(normal), draw.extreme()),
                     from_raw<Plane<S, N>>(draw.disturbed(normal), draw.extreme())};
  });
}

DETENT_EXAMINE(PairExam)
DETENT_ORACLE_TEST("plane and plane", 0x91a91a, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
