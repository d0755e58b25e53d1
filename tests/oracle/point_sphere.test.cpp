// SPDX-License-Identifier: MIT
#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(PointExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  exam.family("random", count * 4 / 10, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto center = draw.point(scale);
    return std::pair{from_raw<Sphere<S, N>>(center, random.between(0, scale)),
                     draw.vec(draw.near(center, scale * 2 / 3))};
  });

  // The surface goes through the point, to the raw unit.
  exam.family("touching", count * 2 / 10, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto center = draw.point(scale), point = draw.near(center, scale);
    double square = 0;
    for (std::size_t i = 0; i < draw.size; ++i) {
      square += std::pow(static_cast<double>(point[i] - center[i]), 2);
    }
    const auto radius = std::llround(std::sqrt(square)) + random.between(-1, 1);
    return std::pair{from_raw<Sphere<S, N>>(center, radius), draw.vec(point)};
  });

  // Along an axis of an exact frame distances are integers, so halves occur exactly.
  exam.family("exact", count * 2 / 10, 20, 70, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 4, frame.norm);
    const auto center = draw.point(draw.limit / 4);
    const auto away = random.between(0, steps);
    const auto radius = random.coin() ? random.between(0, 2 * away * frame.norm)
                                      : away * frame.norm + random.between(-1, 1);
    return std::pair{from_raw<Sphere<S, N>>(center, radius),
                     draw.vec(draw.plus(center, frame.axes[0], away))};
  });

  exam.family("degenerate", count / 10, 5, 70, [&] {
    const auto center = draw.point(4);
    return std::pair{from_raw<Sphere<S, N>>(center, random.between(-1, 2)),
                     draw.vec(draw.near(center, 2))};
  });

  exam.family("extreme", count / 10, 5, 95, [&] {
    const auto radius = random.one_in(8) ? draw.extreme() : std::abs(draw.extreme());
    return std::pair{from_raw<Sphere<S, N>>(draw.extreme_point(), radius),
                     draw.vec(draw.extreme_point())};
  });
}

DETENT_POINT_TEST("point and sphere", 0xe2e0d, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
