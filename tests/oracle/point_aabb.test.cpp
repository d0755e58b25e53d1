// SPDX-License-Identifier: MIT
#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(PointExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  // A box around `center` with sides up to twice `reach`, which may be flat or, rarely, inverted.
  const auto around = [&](const Raw<N>& center, std::int64_t reach, const Raw<N>& point) {
    auto min = center, max = center;
    for (std::size_t i = 0; i < draw.size; ++i) {
      const auto half = random.one_in(50) ? -1 : random.between(0, reach);
      min[i] -= half;
      max[i] += half;
    }
    return std::pair{from_raw<Aabb<S, N>>(min, max), draw.vec(point)};
  };

  exam.family("random", count * 5 / 10, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto center = draw.point(scale);
    return around(center, scale, draw.near(center, N == 2 ? scale / 2 : scale * 2 / 5));
  });
  exam.family("tiny", count * 3 / 10, 20, 80, [&] {
    const auto center = draw.point(4);
    return around(center, 3, draw.near(center, 2));
  });
  exam.family("extreme", count * 2 / 10, 1, 70, [&] {
    auto min = draw.extreme_point(), max = draw.extreme_point();
    for (std::size_t i = 0; i < draw.size; ++i) {
      if (max[i] < min[i] && !random.one_in(20)) std::swap(min[i], max[i]);
    }
    return std::pair{from_raw<Aabb<S, N>>(min, max), draw.vec(draw.extreme_point())};
  });
}

DETENT_POINT_TEST("point and AABB", 0xf201c, point_cases, 2 * point_cases)

}  // namespace
}  // namespace detent::oracle
