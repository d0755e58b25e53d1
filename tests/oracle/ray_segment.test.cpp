// SPDX-License-Identifier: MIT
#include "detent/query/raycast/segment.hpp"

#include "oracle/exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  Exam<S, N> exam(seed);
  auto& draw = exam.draw;
  auto& random = draw.random;
  using D = Draw<S, N>;
  const auto question = [](const Raw<N>& origin, const Direction<S, N>& direction, S max_distance,
                           const Raw<N>& start, const Raw<N>& end) {
    return std::pair{Ray<S, N>{D::vec(origin), direction, max_distance},
                     Segment<S, N>{D::vec(start), D::vec(end)}};
  };
  const auto steps_of = [&](const Frame<N>& frame, std::int64_t reach) {
    return std::max<std::int64_t>(
        1, reach / frame.norm >> random.below(static_cast<unsigned>(S::bits)));
  };

  // In 3D a random ray hits a random segment only if both are coplanar.
  exam.family("random", count * 2 / 10, N == 2 ? 30 : 0, 70, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale), start = draw.point(scale), end = draw.point(scale);
    auto target = start;
    const auto along = random.between(-128, 384);
    for (std::size_t i = 0; i < D::size; ++i) target[i] += (end[i] - start[i]) / 256 * along;
    return question(origin, draw.towards(origin, target), draw.reach(scale), start, end);
  });
  // A point of an exact ray is inside the segment, at its end, or next to it.
  exam.family("across", count * 5 / 10, 30, 90, [&] {
    const auto& frame = draw.frame();
    const auto steps = steps_of(frame, D::limit / 8);
    const auto origin = draw.point(D::limit / 4);
    auto crossing = D::plus(origin, frame.axes[0], random.between(-steps / 8, steps));
    if (random.one_in(6)) crossing = draw.near(crossing, 1);
    const auto way = draw.point(std::min<std::int64_t>(steps, D::limit / 64));
    const auto before = random.between(-2, 6), after = random.between(-2, 6);
    return question(origin, D::stretched(frame.axes[0], frame.norm), draw.reach(steps),
                    D::plus(crossing, way, -before), D::plus(crossing, way, after));
  });
  // On the ray's line, or parallel to it, or a single point.
  exam.family("along", count * 2 / 10, 20, 90, [&] {
    const auto& frame = draw.frame();
    const auto steps = steps_of(frame, D::limit / 4);
    const auto origin = draw.point(D::limit / 4);
    auto start = D::plus(origin, frame.axes[0], random.between(-steps, steps));
    if (random.one_in(6)) start = draw.near(start, 1);
    const auto length = random.one_in(3) ? 0 : random.between(-steps, steps);
    return question(origin, D::stretched(frame.axes[0], frame.norm), draw.reach(steps), start,
                    D::plus(start, frame.axes[0], length));
  });
  exam.family("tiny", count / 20, 1, 90, [&] {
    const auto origin = draw.point(3);
    const auto start = draw.point(3), end = draw.point(3);
    return question(origin, draw.axis_direction(), draw.reach(3), start, end);
  });
  exam.family("extreme", count / 20, 0, 70, [&] {
    const auto direction = random.coin() ? draw.axis_direction() : draw.any_direction();
    return question(draw.extreme_point(), direction, S::max(), draw.extreme_point(),
                    draw.extreme_point());
  });

  exam.finish(count);
}

DETENT_ORACLE_TEST("ray against segment", 0x5e61e, 40'000, 80'000)

}  // namespace
}  // namespace detent::oracle
