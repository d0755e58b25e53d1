// SPDX-License-Identifier: MIT
#include "detent/query/raycast/segment.hpp"

#include "oracle/ray_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(RayExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  // In 3D a random ray hits a random segment only if both are coplanar.
  exam.family("random", count * 2 / 10, N == 2 ? 30 : 0, 70, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale), start = draw.point(scale), end = draw.point(scale);
    auto target = start;
    const auto along = random.between(-128, 384);
    for (std::size_t i = 0; i < draw.size; ++i) target[i] += (end[i] - start[i]) / 256 * along;
    return std::pair{draw.ray(origin, draw.towards(origin, target), draw.reach(scale)),
                     from_raw<Segment<S, N>>(start, end)};
  });
  // A point of an exact ray is inside the segment, at its end, or next to it.
  exam.family("across", count * 5 / 10, 30, 90, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 8, frame.norm);
    const auto origin = draw.point(draw.limit / 4);
    auto crossing = draw.plus(origin, frame.axes[0], random.between(-steps / 8, steps));
    if (random.one_in(6)) crossing = draw.near(crossing, 1);
    const auto way = draw.point(std::min<std::int64_t>(steps, draw.limit / 64));
    const auto before = random.between(-2, 6), after = random.between(-2, 6);
    return std::pair{draw.ray(origin, draw.stretched(frame.axes[0], frame.norm), draw.reach(steps)),
                     from_raw<Segment<S, N>>(draw.plus(crossing, way, -before),
                                             draw.plus(crossing, way, after))};
  });
  // On the ray's line, or parallel to it, or a single point.
  exam.family("along", count * 2 / 10, 20, 90, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 4, frame.norm);
    const auto origin = draw.point(draw.limit / 4);
    auto start = draw.plus(origin, frame.axes[0], random.between(-steps, steps));
    if (random.one_in(6)) start = draw.near(start, 1);
    const auto length = random.one_in(3) ? 0 : random.between(-steps, steps);
    return std::pair{draw.ray(origin, draw.stretched(frame.axes[0], frame.norm), draw.reach(steps)),
                     from_raw<Segment<S, N>>(start, draw.plus(start, frame.axes[0], length))};
  });
  exam.family("tiny", count / 20, 1, 90, [&] {
    const auto origin = draw.point(3);
    const auto start = draw.point(3), end = draw.point(3);
    return std::pair{draw.ray(origin, draw.axis_direction(), draw.reach(3)),
                     from_raw<Segment<S, N>>(start, end)};
  });
  exam.family("extreme", count / 20, 0, 70, [&] {
    const auto direction = random.coin() ? draw.axis_direction() : draw.any_direction();
    return std::pair{draw.ray(draw.extreme_point(), direction, S::max()),
                     from_raw<Segment<S, N>>(draw.extreme_point(), draw.extreme_point())};
  });
}

DETENT_RAY_TEST("ray against segment", 0x5e61e, 40'000, 80'000)

}  // namespace
}  // namespace detent::oracle
