// SPDX-License-Identifier: MIT
#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(PointExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  exam.family("random", count * 4 / 10, 0, 30, [&] {
    const auto scale = draw.scale();
    return std::pair{from_raw<Plane<S, N>>(draw.any_direction(), random.between(-scale, scale)),
                     draw.vec(draw.point(scale))};
  });
  // Through the point along an axis of the world, or off by a raw unit.
  exam.family("on an axis", count * 2 / 10, 30, 70, [&] {
    const auto point = draw.point(draw.scale());
    const auto normal = draw.axis_direction();
    return std::pair{from_raw<Plane<S, N>>(normal, draw.offset_of(normal, point) +
                                                       (random.coin() ? 0 : random.between(-1, 1))),
                     draw.vec(point)};
  });
  // Perpendicular axes of an exact frame: the plane contains the point exactly when it should.
  exam.family("exact", count * 2 / 10, 30, 70, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 4, frame.norm);
    const auto point = draw.plus(Raw<N>{}, frame.axes[1], random.between(-steps, steps));
    return std::pair{from_raw<Plane<S, N>>(draw.stretched(frame.axes[0], frame.norm),
                                           random.coin() ? 0 : random.between(-1, 1)),
                     draw.vec(point)};
  });
  exam.family("extreme", count * 2 / 10, 0, 50, [&] {
    return std::pair{
        from_raw<Plane<S, N>>(random.coin() ? draw.axis_direction() : draw.any_direction(),
                              draw.extreme()),
        draw.vec(draw.extreme_point())};
  });
}

DETENT_POINT_TEST("point and plane", 0xfccf3, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
