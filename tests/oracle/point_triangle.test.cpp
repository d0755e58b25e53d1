// SPDX-License-Identifier: MIT
#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(PointExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  exam.family("random", count * 3 / 10, 0, 70, [&] {
    const auto scale = draw.scale();
    return std::pair{
        from_raw<Triangle<S, N>>(draw.point(scale), draw.point(scale), draw.point(scale)),
        draw.vec(draw.point(scale))};
  });
  // Integer combinations of two vectors: in the triangle's plane, often on edges and corners.
  exam.family("in the plane", count * 3 / 10, 30, 70, [&] {
    const auto times = draw.steps(draw.limit / 128);
    const auto u = draw.point(7), v = draw.point(7), origin = draw.point(draw.limit / 4);
    const auto grid = [&](std::int64_t i, std::int64_t j) {
      return draw.plus(draw.plus(origin, u, i), v, j);
    };
    const auto any = [&] {
      return grid(random.between(-times, times), random.between(-times, times));
    };
    const auto i = random.between(0, times), j = random.between(0, times - i);
    auto point =
        random.one_in(4) ? any() : grid(random.one_in(4) ? 0 : i, random.one_in(4) ? 0 : j);
    if (random.one_in(6)) point = draw.near(point, 1);
    if (random.one_in(6))
      return std::pair{from_raw<Triangle<S, N>>(any(), any(), any()), draw.vec(any())};
    return std::pair{from_raw<Triangle<S, N>>(origin, grid(times, 0), grid(0, times)),
                     draw.vec(point)};
  });
  // Collinear corners, and equal ones.
  exam.family("collapsed", count * 2 / 10, 10, 80, [&] {
    const auto times = draw.steps(draw.limit / 64);
    const auto step = draw.point(7), origin = draw.point(draw.limit / 4);
    const auto any = [&] { return draw.plus(origin, step, random.between(-times, times)); };
    const auto a = any(), b = random.one_in(6) ? a : any(), c = random.one_in(6) ? b : any();
    return std::pair{from_raw<Triangle<S, N>>(a, b, c),
                     draw.vec(random.one_in(3) ? draw.near(any(), times) : any())};
  });
  exam.family("tiny", count / 10, 2, 90, [&] {
    return std::pair{from_raw<Triangle<S, N>>(draw.point(2), draw.point(2), draw.point(2)),
                     draw.vec(draw.point(2))};
  });
  exam.family("extreme", count / 10, 0, 50, [&] {
    return std::pair{
        from_raw<Triangle<S, N>>(draw.extreme_point(), draw.extreme_point(), draw.extreme_point()),
        draw.vec(draw.extreme_point())};
  });
}

DETENT_POINT_TEST("point and triangle", 0x73150, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
