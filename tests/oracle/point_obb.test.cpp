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
  const auto question = [](const Raw<N>& center, const Raw<N>& half_extents,
                           const Rotation<S, N>& rotation, const Raw<N>& point) {
    return std::pair{Obb<S, N>{D::vec(center), D::vec(half_extents), rotation}, D::vec(point)};
  };
  const auto extents = [&](std::int64_t reach) {
    Raw<N> half{};
    for (auto& component : half) component = random.one_in(50) ? -1 : random.between(0, reach);
    return half;
  };

  exam.family("random", count * 4 / 10, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto center = draw.point(scale);
    const auto rotation = random.one_in(4) ? draw.skewed() : draw.rotation();
    return question(center, extents(scale), rotation,
                    draw.near(center, N == 2 ? scale / 2 : scale * 2 / 5));
  });
  // A corner of an exact frame, to the raw unit.
  exam.family("touching", count * 3 / 10, 10, 90, [&] {
    const auto& frame = draw.frame();
    const auto steps = std::max<std::int64_t>(
        1, (D::limit / 8) / frame.norm >> random.below(static_cast<unsigned>(S::bits)));
    const auto center = draw.point(D::limit / 4);
    auto point = center;
    Raw<N> half{};
    for (std::size_t i = 0; i < D::size; ++i) {
      const auto along = random.between(0, steps);
      point = D::plus(point, frame.axes[i], random.coin() ? along : -along);
      half[i] = along * frame.norm + (random.coin() ? random.between(-1, 1) : 1);
    }
    return question(center, half, draw.rotation(frame), point);
  });
  exam.family("tiny", count / 10, 10, 90, [&] {
    const auto center = draw.point(4);
    return question(center, extents(4), draw.rotation(), draw.near(center, 3));
  });
  exam.family("extreme", count * 2 / 10, 1, 70, [&] {
    auto half = draw.extreme_point();
    for (auto& component : half) {
      if (!random.one_in(20)) component = std::abs(component);
    }
    return question(draw.extreme_point(), half, random.coin() ? draw.skewed() : draw.rotation(),
                    draw.extreme_point());
  });

  exam.finish();
}

DETENT_ORACLE_TEST("point and OBB", 0x5189f, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
