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
  const auto question = [](const Raw<N>& origin, const Direction<S, N>& direction, S max_distance,
                           const Raw<N>& point) {
    return std::pair{Ray<S, N>{D::vec(origin), direction, max_distance}, D::vec(point)};
  };

  exam.family("random", count * 4 / 10, 0, 30, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale), point = draw.point(scale);
    const auto direction = random.coin() ? draw.any_direction()
                                         : draw.towards(origin, draw.near(point, scale / 8 + 1));
    return question(origin, direction, draw.reach(scale), point);
  });
  // Directions exactly parallel to integer vectors, and points exactly on them.
  exam.family("on the line", count * 3 / 10, 30, 80, [&] {
    const auto& frame = draw.frame();
    const auto steps = std::max<std::int64_t>(
        1, (D::limit / 4) / frame.norm >> random.below(static_cast<unsigned>(S::bits)));
    const auto origin = draw.point(D::limit / 4);
    const auto along = random.between(-steps / 4, steps);
    auto point = D::plus(origin, frame.axes[0], along);
    if (random.one_in(8)) point = draw.near(point, 1);
    const auto reach =
        random.coin() ? S::max() : D::scalar(along * frame.norm + random.between(-1, 1));
    return question(origin, D::stretched(frame.axes[0], frame.norm), reach, point);
  });
  exam.family("tiny", count / 10, 0, 90, [&] {
    const auto direction = random.coin() ? draw.axis_direction() : draw.any_direction();
    return question(draw.point(2), direction, D::scalar(random.between(-1, 3)), draw.point(2));
  });
  exam.family("extreme", count * 2 / 10, 0, 50, [&] {
    return question(draw.extreme_point(),
                    random.coin() ? draw.axis_direction() : draw.any_direction(),
                    random.coin() ? S::max() : D::scalar(draw.extreme()), draw.extreme_point());
  });

  exam.finish();
}

DETENT_ORACLE_TEST("point and ray", 0x81df6, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
