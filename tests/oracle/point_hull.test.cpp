// SPDX-License-Identifier: MIT
#include "oracle/hull.hpp"
#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(PointExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  const auto question = [&](Kind kind, const auto& setting, auto& artist, const auto& hull) {
    const auto reach = kind == Kind::general ? setting.size / (N == 2 ? 2 : 10) : 0;
    auto point = Draw<S, N>::vec(draw.near(artist.point(), reach));
    // On the hull, or on the line or in the plane of some of its points, to the raw unit.
    if (kind != Kind::general && hull.points.size() > 1 && random.one_in(3)) {
      const auto a = raw(hull.points[0]), b = raw(hull.points[1]), c = raw(hull.points.back());
      const auto s = random.between(-1, 5), t = random.coin() ? 0 : random.between(-1, 5);
      for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) {
        const Integer place = a[i] + (b[i] - a[i]) * s / 4 + (c[i] - a[i]) * t / 4;
        if (place * place > raw(S::max()) * raw(S::max())) continue;
        point[static_cast<int>(i)] = Draw<S, N>::scalar(static_cast<std::int64_t>(place));
      }
    }
    return std::pair{hull, point};
  };
  draw_hulls(exam, draw, count, N == 2 ? 25 : 15, 75, question);
}

DETENT_POINT_TEST("point and hull", 0x4114, point_cases / 10, point_cases / 10)

}  // namespace
}  // namespace detent::oracle
