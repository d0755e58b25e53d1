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
  const auto question = [](const Direction<S, N>& normal, std::int64_t offset,
                           const Raw<N>& point) {
    return std::pair{Plane<S, N>{normal, D::scalar(offset)}, D::vec(point)};
  };
  const auto height = [](const Direction<S, N>& normal, const Raw<N>& point) {
    double sum = 0;
    for (std::size_t i = 0; i < D::size; ++i) {
      sum += static_cast<double>(normal[static_cast<int>(i)].raw()) *
             static_cast<double>(point[i]) / static_cast<double>(D::one);
    }
    return std::llround(sum);
  };

  exam.family("random", count * 4 / 10, 0, 30, [&] {
    const auto scale = draw.scale();
    return question(draw.any_direction(), random.between(-scale, scale), draw.point(scale));
  });
  // Through the point along an axis of the world, or off by a raw unit.
  exam.family("on an axis", count * 2 / 10, 30, 70, [&] {
    const auto point = draw.point(draw.scale());
    const auto normal = draw.axis_direction();
    return question(normal, height(normal, point) + (random.coin() ? 0 : random.between(-1, 1)),
                    point);
  });
  // Perpendicular axes of an exact frame: the plane contains the point exactly when it should.
  exam.family("exact", count * 2 / 10, 30, 70, [&] {
    const auto& frame = draw.frame();
    const auto steps = std::max<std::int64_t>(
        1, (D::limit / 4) / frame.norm >> random.below(static_cast<unsigned>(S::bits)));
    const auto point = D::plus(Raw<N>{}, frame.axes[1], random.between(-steps, steps));
    return question(D::stretched(frame.axes[0], frame.norm),
                    random.coin() ? 0 : random.between(-1, 1), point);
  });
  exam.family("extreme", count * 2 / 10, 0, 50, [&] {
    return question(random.coin() ? draw.axis_direction() : draw.any_direction(), draw.extreme(),
                    draw.extreme_point());
  });

  exam.finish();
}

DETENT_ORACLE_TEST("point and plane", 0xfccf3, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
