// SPDX-License-Identifier: MIT
#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  PointExam<S, N> exam(seed);
  auto& draw = exam.draw;
  auto& random = draw.random;
  using D = Draw<S, N>;
  const auto question = [](const Raw<N>& a, const Raw<N>& b, const Raw<N>& c, const Raw<N>& point) {
    return std::pair{Triangle<S, N>{D::vec(a), D::vec(b), D::vec(c)}, D::vec(point)};
  };

  exam.family("random", count * 3 / 10, 0, 70, [&] {
    const auto scale = draw.scale();
    return question(draw.point(scale), draw.point(scale), draw.point(scale), draw.point(scale));
  });
  // Integer combinations of two vectors: in the triangle's plane, often on edges and corners.
  exam.family("in the plane", count * 3 / 10, 30, 70, [&] {
    const auto times =
        std::max<std::int64_t>(1, D::limit / 128 >> random.below(static_cast<unsigned>(S::bits)));
    const auto u = draw.point(7), v = draw.point(7), origin = draw.point(D::limit / 4);
    const auto grid = [&](std::int64_t i, std::int64_t j) {
      return D::plus(D::plus(origin, u, i), v, j);
    };
    const auto any = [&] {
      return grid(random.between(-times, times), random.between(-times, times));
    };
    const auto i = random.between(0, times), j = random.between(0, times - i);
    auto point =
        random.one_in(4) ? any() : grid(random.one_in(4) ? 0 : i, random.one_in(4) ? 0 : j);
    if (random.one_in(6)) point = draw.near(point, 1);
    if (random.one_in(6)) return question(any(), any(), any(), any());
    return question(origin, grid(times, 0), grid(0, times), point);
  });
  // Collinear corners, and equal ones.
  exam.family("collapsed", count * 2 / 10, 10, 80, [&] {
    const auto times =
        std::max<std::int64_t>(1, D::limit / 64 >> random.below(static_cast<unsigned>(S::bits)));
    const auto step = draw.point(7), origin = draw.point(D::limit / 4);
    const auto any = [&] { return D::plus(origin, step, random.between(-times, times)); };
    const auto a = any(), b = random.one_in(6) ? a : any(), c = random.one_in(6) ? b : any();
    return question(a, b, c, random.one_in(3) ? draw.near(any(), times) : any());
  });
  exam.family("tiny", count / 10, 2, 90,
              [&] { return question(draw.point(2), draw.point(2), draw.point(2), draw.point(2)); });
  exam.family("extreme", count / 10, 0, 50, [&] {
    return question(draw.extreme_point(), draw.extreme_point(), draw.extreme_point(),
                    draw.extreme_point());
  });

  exam.finish();
}

DETENT_ORACLE_TEST("point and triangle", 0x73150, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
