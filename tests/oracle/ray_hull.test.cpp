// SPDX-License-Identifier: MIT
#include "detent/query/raycast/hull.hpp"
#include "oracle/hull.hpp"
#include "oracle/ray_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(RayExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  // A grid point on the hull's lines and planes, inside, or somewhat outside.
  const auto among = [&](const ConvexHull<S, N>& hull, int corners) {
    const auto size = hull.points.size();
    if (size == 0) return Raw<N>{};
    const auto raw_of = [&](std::size_t i) {
      Raw<N> result{};
      for (int k = 0; k < N; ++k) {
        result[static_cast<std::size_t>(k)] = hull.points[i % size][k].raw();
      }
      return result;
    };
    const auto first = random.below(size);
    auto place = raw_of(first);
    for (int c = 1; c < corners; ++c) {
      const auto next = raw_of(first + static_cast<std::size_t>(c));
      const auto part = random.between(-4, 20);
      for (std::size_t k = 0; k < draw.size; ++k) place[k] += (next[k] - place[k]) * part / 16;
    }
    return place;
  };
  const auto question = [&](Kind kind, const auto& setting, auto& artist, const auto& hull) {
    const auto& frame = setting.frame;
    if (kind == Kind::lattice || kind == Kind::degenerate) {
      // Exactly through corners, through points of edges, along edges and faces, or next to them.
      const bool is_turned = !random.one_in(4);
      const auto axis = is_turned ? frame.axes[random.below(draw.size)] : draw.unit();
      const auto direction = draw.stretched(axis, is_turned ? frame.norm : 1);
      const auto target = random.coin() ? artist.point() : among(hull, random.coin() ? 1 : 2);
      const auto steps = std::max<std::int64_t>(setting.stride * (is_turned ? 1 : frame.norm), 1);
      const auto back = steps * random.between(-1, 5);
      return std::pair{
          Ray<S, N>{draw.vec(draw.plus(target, axis, -back)),
                    random.one_in(12) ? draw.disturbed(direction) : direction, draw.reach(steps)},
          hull};
    }
    const auto target = among(hull, static_cast<int>(random.between(1, 4)));
    if (kind == Kind::extreme) {
      const auto origin = draw.extreme_point();
      const auto direction = random.coin() ? draw.any_direction() : draw.towards(origin, target);
      return std::pair{draw.ray(origin, direction, draw.scalar(draw.extreme())), hull};
    }
    const auto size = kind == Kind::tiny ? 4 : setting.size;
    auto direction = random.one_in(4) ? draw.axis_direction() : draw.any_direction();
    auto origin = draw.moved(target, direction, -random.between(-size / 4, 4 * size));
    if (random.one_in(4)) {
      origin = draw.near(target, size);
      direction = draw.towards(origin, target);
    }
    return std::pair{draw.ray(origin, direction, draw.reach(4 * size)), hull};
  };
  draw_hulls(exam, draw, count, 30, 80, question);
  exam.family("round", count / 60, 30, 80, [&] {
    const auto radius = std::max<std::int64_t>(draw.scale() / 4, 2);
    const auto center = draw.point(radius);
    const auto origin = draw.near(center, 3 * radius);
    const auto direction = draw.towards(origin, draw.near(center, N == 2 ? 2 * radius : radius));
    return std::pair{draw.ray(origin, direction, draw.scalar(draw.limit)),
                     round_hull(draw, center, radius, 12)};
  });
}

DETENT_RAY_TEST("ray against hull", 0x4116, 6'000, 6'000)

}  // namespace
}  // namespace detent::oracle
