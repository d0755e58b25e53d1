// SPDX-License-Identifier: MIT
#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(PointExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  exam.family("random", count * 4 / 10, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto a = draw.point(scale), b = draw.point(scale);
    auto middle = a;
    for (std::size_t i = 0; i < draw.size; ++i) middle[i] = (a[i] + b[i]) / 2;
    return std::pair{from_raw<Capsule<S, N>>(a, b, random.between(0, scale)),
                     draw.vec(draw.near(middle, scale * 3 / 4))};
  });
  // The radius is the distance from the point to the axis, along an exact frame.
  exam.family("touching", count * 3 / 10, 20, 80, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 8, frame.norm);
    const auto a = draw.point(draw.limit / 4);
    const auto last = random.between(0, steps);
    const auto b = draw.plus(a, frame.axes[0], last);
    const auto aside = random.between(0, steps);
    const auto along = random.between(-last / 8, last + last / 8);
    const auto point = draw.plus(draw.plus(a, frame.axes[0], along), frame.axes[1], aside);
    const auto radius = random.one_in(4) ? random.between(0, aside * frame.norm)
                                         : aside * frame.norm + random.between(-1, 1);
    return std::pair{from_raw<Capsule<S, N>>(a, b, radius), draw.vec(point)};
  });
  exam.family("tiny", count / 10, 10, 90, [&] {
    return std::pair{from_raw<Capsule<S, N>>(draw.point(3), draw.point(3), random.between(-1, 3)),
                     draw.vec(draw.point(3))};
  });
  exam.family("extreme", count * 2 / 10, 1, 90, [&] {
    const auto radius = random.one_in(8) ? draw.extreme() : std::abs(draw.extreme());
    return std::pair{from_raw<Capsule<S, N>>(draw.extreme_point(), draw.extreme_point(), radius),
                     draw.vec(draw.extreme_point())};
  });
}

DETENT_POINT_TEST("point and capsule", 0xa8148, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
