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
  const auto question = [](const Raw<N>& start, const Raw<N>& end, const Raw<N>& point) {
    return std::pair{Segment<S, N>{D::vec(start), D::vec(end)}, D::vec(point)};
  };

  exam.family("random", count * 4 / 10, 0, 30, [&] {
    const auto scale = draw.scale();
    return question(draw.point(scale), draw.point(scale), draw.point(scale));
  });
  // Integer multiples of one vector, or a raw unit off.
  exam.family("on the line", count * 3 / 10, 30, 70, [&] {
    const auto step = draw.point(random.coin() ? 3 : 15);
    const auto times =
        std::max<std::int64_t>(1, D::limit / 64 >> random.below(static_cast<unsigned>(S::bits)));
    const auto start = draw.point(D::limit / 4);
    const auto last = random.between(0, times);
    const auto end = D::plus(start, step, last);
    auto point = D::plus(start, step, random.between(-last / 4 - 1, last + last / 4 + 1));
    if (random.one_in(3)) point = draw.near(point, 1);
    return question(start, end, point);
  });
  exam.family("tiny", count / 10, 1, 90,
              [&] { return question(draw.point(2), draw.point(2), draw.point(2)); });
  exam.family("extreme", count * 2 / 10, 0, 50, [&] {
    return question(draw.extreme_point(), draw.extreme_point(), draw.extreme_point());
  });

  exam.finish();
}

DETENT_ORACLE_TEST("point and segment", 0xb3ae2, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
