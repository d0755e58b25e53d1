// SPDX-License-Identifier: MIT
#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(PointExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  const auto extents = [&](std::int64_t reach) {
    Raw<N> half{};
    for (auto& component : half) component = random.one_in(50) ? -1 : random.between(0, reach);
    return half;
  };

  exam.family("random", count * 4 / 10, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto center = draw.point(scale);
    const auto rotation = random.one_in(4) ? draw.skewed() : draw.rotation();
    return std::pair{from_raw<Obb<S, N>>(center, extents(scale), rotation),
                     draw.vec(draw.near(center, N == 2 ? scale / 2 : scale * 2 / 5))};
  });
  // A corner of an exact frame, to the raw unit.
  exam.family("touching", count * 3 / 10, 10, 90, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 8, frame.norm);
    const auto center = draw.point(draw.limit / 4);
    auto point = center;
    Raw<N> half{};
    for (std::size_t i = 0; i < draw.size; ++i) {
      const auto along = random.between(0, steps);
      point = draw.plus(point, frame.axes[i], random.coin() ? along : -along);
      half[i] = along * frame.norm + (random.coin() ? random.between(-1, 1) : 1);
    }
    return std::pair{from_raw<Obb<S, N>>(center, half, draw.rotation(frame)), draw.vec(point)};
  });
  exam.family("tiny", count / 10, 10, 90, [&] {
    const auto center = draw.point(4);
    return std::pair{from_raw<Obb<S, N>>(center, extents(4), draw.rotation()),
                     draw.vec(draw.near(center, 3))};
  });
  exam.family("extreme", count * 2 / 10, 1, 70, [&] {
    auto half = draw.extreme_point();
    for (auto& component : half) {
      if (!random.one_in(20)) component = std::abs(component);
    }
    return std::pair{from_raw<Obb<S, N>>(draw.extreme_point(), half,
                                         random.coin() ? draw.skewed() : draw.rotation()),
                     draw.vec(draw.extreme_point())};
  });
}

DETENT_POINT_TEST("point and OBB", 0x5189f, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
