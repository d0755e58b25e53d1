// SPDX-License-Identifier: MIT
#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(PointExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  exam.family("random", count * 4 / 10, 0, 30, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale), point = draw.point(scale);
    const auto direction = random.coin() ? draw.any_direction()
                                         : draw.towards(origin, draw.near(point, scale / 8 + 1));
    return std::pair{draw.ray(origin, direction, draw.reach(scale)), draw.vec(point)};
  });
  // Directions exactly parallel to integer vectors, and points exactly on them.
  exam.family("on the line", count * 3 / 10, 30, 80, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 4, frame.norm);
    const auto origin = draw.point(draw.limit / 4);
    const auto along = random.between(-steps / 4, steps);
    auto point = draw.plus(origin, frame.axes[0], along);
    if (random.one_in(8)) point = draw.near(point, 1);
    const auto reach =
        random.coin() ? S::max() : draw.scalar(along * frame.norm + random.between(-1, 1));
    return std::pair{draw.ray(origin, draw.stretched(frame.axes[0], frame.norm), reach),
                     draw.vec(point)};
  });
  exam.family("tiny", count / 10, 0, 90, [&] {
    const auto direction = random.coin() ? draw.axis_direction() : draw.any_direction();
    return std::pair{draw.ray(draw.point(2), direction, draw.scalar(random.between(-1, 3))),
                     draw.vec(draw.point(2))};
  });
  exam.family("extreme", count * 2 / 10, 0, 50, [&] {
    return std::pair{
        draw.ray(draw.extreme_point(), random.coin() ? draw.axis_direction() : draw.any_direction(),
                 random.coin() ? S::max() : draw.scalar(draw.extreme())),
        draw.vec(draw.extreme_point())};
  });
}

DETENT_POINT_TEST("point and ray", 0x81df6, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
