// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/plane_plane.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  PairExam<S, N> exam(seed);
  auto& draw = exam.draw;
  auto& random = draw.random;
  using D = Draw<S, N>;
  exam.family("random", count * 2 / 10, 90, 100, [&] {
    return std::pair{Plane<S, N>{draw.any_direction(), D::scalar(draw.extreme())},
                     Plane<S, N>{draw.any_direction(), D::scalar(draw.extreme())}};
  });
  exam.family("parallel", count * 4 / 10, 30, 70, [&] {
    const auto normal = random.coin() ? draw.any_direction() : draw.axis_direction();
    const auto scale = draw.scale();
    const auto offset = random.one_in(4) ? 0 : random.between(-scale, scale);
    const auto other = offset + (random.coin() ? random.between(-1, 1) : 0);
    if (random.coin()) {
      return std::pair{Plane<S, N>{normal, D::scalar(offset)},
                       Plane<S, N>{normal, D::scalar(other)}};
    }
    return std::pair{Plane<S, N>{normal, D::scalar(offset)},
                     Plane<S, N>{-normal, D::scalar(-other)}};
  });
  // Normals on one axis with different lengths: the same plane if the offsets differ by that ratio.
  exam.family("proportional", count * 2 / 10, 10, 90, [&] {
    const auto axis = draw.unit();
    const auto times = random.between(0, D::limit / D::one);
    const auto plane = [&] {
      const auto length = D::one - random.between(0, 1);
      auto normal = axis;
      for (auto& component : normal) component *= length;
      const auto nudge = random.one_in(6) ? random.between(-1, 1) : 0;
      return Plane<S, N>{D::direction(normal), D::scalar(times * length + nudge)};
    };
    return std::pair{plane(), plane()};
  });
  exam.family("nearly parallel", count * 2 / 10, 30, 99, [&] {
    const auto normal = draw.any_direction();
    return std::pair{Plane<S, N>{draw.disturbed(normal), D::scalar(draw.extreme())},
                     Plane<S, N>{draw.disturbed(normal), D::scalar(draw.extreme())}};
  });
  exam.finish();
}

DETENT_ORACLE_TEST("plane and plane", 0x91a91a, pair_cases, pair_cases)

}  // namespace
}  // namespace detent::oracle
