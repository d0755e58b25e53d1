// SPDX-License-Identifier: MIT
#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(PointExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  exam.family("random", count * 4 / 10, 0, 30, [&] {
    const auto scale = draw.scale();
    return std::pair{from_raw<Segment<S, N>>(draw.point(scale), draw.point(scale)),
                     draw.vec(draw.point(scale))};
  });
  // Integer multiples of one vector, or a raw unit off.
  exam.family("on the line", count * 3 / 10, 30, 70, [&] {
    const auto step = draw.point(random.coin() ? 3 : 15);
    const auto times = draw.steps(draw.limit / 64);
    const auto start = draw.point(draw.limit / 4);
    const auto last = random.between(0, times);
    const auto end = draw.plus(start, step, last);
    auto point = draw.plus(start, step, random.between(-last / 4 - 1, last + last / 4 + 1));
    if (random.one_in(3)) point = draw.near(point, 1);
    return std::pair{from_raw<Segment<S, N>>(start, end), draw.vec(point)};
  });
  exam.family("tiny", count / 10, 1, 90, [&] {
    return std::pair{from_raw<Segment<S, N>>(draw.point(2), draw.point(2)),
                     draw.vec(draw.point(2))};
  });
  exam.family("extreme", count * 2 / 10, 0, 50, [&] {
    return std::pair{from_raw<Segment<S, N>>(draw.extreme_point(), draw.extreme_point()),
                     draw.vec(draw.extreme_point())};
  });
}

DETENT_POINT_TEST("point and segment", 0xb3ae2, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
