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
  const auto question = [](const Raw<N>& a, const Raw<N>& b, std::int64_t radius,
                           const Raw<N>& point) {
    return std::pair{Capsule<S, N>{D::vec(a), D::vec(b), D::scalar(radius)}, D::vec(point)};
  };

  exam.family("random", count * 4 / 10, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto a = draw.point(scale), b = draw.point(scale);
    auto middle = a;
    for (std::size_t i = 0; i < D::size; ++i) middle[i] = (a[i] + b[i]) / 2;
    return question(a, b, random.between(0, scale), draw.near(middle, scale * 3 / 4));
  });
  // The radius is the distance from the point to the axis, along an exact frame.
  exam.family("touching", count * 3 / 10, 20, 80, [&] {
    const auto& frame = draw.frame();
    const auto steps = std::max<std::int64_t>(
        1, (D::limit / 8) / frame.norm >> random.below(static_cast<unsigned>(S::bits)));
    const auto a = draw.point(D::limit / 4);
    const auto last = random.between(0, steps);
    const auto b = D::plus(a, frame.axes[0], last);
    const auto aside = random.between(0, steps);
    const auto along = random.between(-last / 8, last + last / 8);
    const auto point = D::plus(D::plus(a, frame.axes[0], along), frame.axes[1], aside);
    const auto radius = random.one_in(4) ? random.between(0, aside * frame.norm)
                                         : aside * frame.norm + random.between(-1, 1);
    return question(a, b, radius, point);
  });
  exam.family("tiny", count / 10, 10, 90, [&] {
    return question(draw.point(3), draw.point(3), random.between(-1, 3), draw.point(3));
  });
  exam.family("extreme", count * 2 / 10, 1, 90, [&] {
    const auto radius = random.one_in(8) ? draw.extreme() : std::abs(draw.extreme());
    return question(draw.extreme_point(), draw.extreme_point(), radius, draw.extreme_point());
  });

  exam.finish();
}

DETENT_ORACLE_TEST("point and capsule", 0xa8148, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
