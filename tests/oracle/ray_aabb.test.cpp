// SPDX-License-Identifier: MIT
#include "oracle/ray_box.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(RayExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  struct Box {
    Raw<N> min, max;
  };
  const auto question = [&](const Raw<N>& origin, const Direction<S, N>& direction, S max_distance,
                            const Box& b) {
    return std::pair{draw.ray(origin, direction, max_distance), from_raw<Aabb<S, N>>(b.min, b.max)};
  };
  const auto box = [&](std::int64_t scale) {
    const auto center = draw.point(scale);
    Box result{};
    for (std::size_t i = 0; i < draw.size; ++i) {
      const auto half = random.one_in(12) ? 0 : random.between(0, scale / 2);
      result.min[i] = center[i] - half;
      result.max[i] = center[i] + half;
    }
    return result;
  };
  // A corner with up to `loose` of its coordinates anywhere between the corners instead.
  const auto on_edge = [&](const Box& b, std::size_t loose) {
    Raw<N> result{};
    for (auto i = 0U; i < draw.size; ++i) result[i] = random.coin() ? b.min[i] : b.max[i];
    for (; loose > 0; --loose) {
      const auto i = random.below(draw.size);
      result[i] = random.between(b.min[i], b.max[i]);
    }
    return result;
  };

  draw_rays_at_boxes(exam, draw, count * 30 / 100, box, on_edge, question);

  // Aimed at an edge or a corner; rounding to the grid may make it miss by a raw unit or so.
  exam.family("grazing", count * 20 / 100, 30, 80, [&] {
    const auto scale = draw.scale();
    const auto b = box(scale);
    const auto direction = random.one_in(3) ? draw.axis_direction() : draw.any_direction();
    const auto target = draw.near(on_edge(b, random.below(draw.size)), random.coin() ? 1 : 0);
    const auto origin = draw.moved(target, direction, -random.between(-scale / 4, 2 * scale));
    return question(origin, direction, draw.reach(scale), b);
  });

  // Exactly through a point of an edge or a corner, or through that point moved by a raw unit; the
  // exact directions include the axes, so that rays run in the planes of the faces.
  exam.family("tangent", count * 20 / 100, 30, 90, [&] {
    const auto& frame = draw.frame();
    const auto scale = std::min(draw.scale(), draw.limit / 4);
    const auto steps = scale / frame.norm + 1;
    const auto b = box(scale);
    auto target = on_edge(b, random.below(draw.size));
    if (random.one_in(4)) target[random.below(draw.size)] += random.between(-1, 1);
    const auto axis = random.one_in(3) ? draw.unit() : frame.axes[0];
    const auto norm = axis == frame.axes[0] ? frame.norm : 1;
    const auto origin =
        draw.plus(target, axis, -random.between(-steps / 4, norm == 1 ? scale : steps));
    return question(origin, draw.stretched(axis, norm), draw.reach(scale), b);
  });

  exam.family("inside", count * 8 / 100, 50, 100, [&] {
    const auto scale = draw.scale();
    const auto b = box(scale);
    const auto origin =
        draw.near(on_edge(b, random.below(draw.size + 1)), random.one_in(4) ? 1 : 0);
    const auto direction = random.coin() ? draw.any_direction() : draw.axis_direction();
    return question(origin, direction, draw.reach(scale), b);
  });

  // Flat on some axes and inverted on others.
  exam.family("degenerate", count * 8 / 100, 15, 80, [&] {
    const auto& frame = draw.frame();
    const auto scale = std::min(draw.scale(), draw.limit / 4);
    auto b = box(scale);
    for (auto i = 0U; i < draw.size; ++i) {
      if (random.coin()) b.max[i] = b.min[i];
      if (random.one_in(12)) b.max[i] = b.min[i] - random.between(1, scale);
    }
    const auto target = random.one_in(4) ? draw.near(b.min, 1) : b.min;
    const auto axis = random.coin() ? draw.unit() : frame.axes[0];
    const auto norm = axis == frame.axes[0] ? frame.norm : 1;
    const auto steps = scale / frame.norm + 1;
    const auto origin =
        draw.plus(target, axis, -random.between(-steps / 4, norm == 1 ? scale : steps));
    return question(origin, draw.stretched(axis, norm), draw.reach(scale), b);
  });

  exam.family("tiny", count * 6 / 100, 5, 90, [&] {
    const auto& frame = draw.frame();
    const auto min = draw.point(4);
    Raw<N> max = min;
    for (auto& component : max) component += random.between(random.one_in(16) ? -1 : 0, 4);
    const auto origin = draw.point(4);
    const auto direction = random.one_in(3)   ? draw.stretched(frame.axes[0], frame.norm)
                           : random.one_in(3) ? draw.axis_direction()
                                              : draw.towards(origin, draw.near(min, 2));
    return question(origin, direction, draw.reach(4), Box{min, max});
  });

  exam.family("extreme", count * 10 / 100, 5, 95, [&] {
    const auto origin = draw.extreme_point();
    auto min = draw.extreme_point();
    auto max = draw.extreme_point();
    for (auto i = 0U; i < draw.size; ++i) {
      if (min[i] > max[i] && !random.one_in(16)) std::swap(min[i], max[i]);
    }
    const auto direction = random.one_in(3)   ? draw.axis_direction()
                           : random.one_in(3) ? draw.any_direction()
                                              : draw.towards(origin, random.coin() ? min : max);
    const S max_distance = random.one_in(3) ? draw.scalar(draw.extreme()) : S::max();
    return question(origin, direction, max_distance, Box{min, max});
  });
}

DETENT_RAY_TEST("ray against AABB", 0xaabb, cases<TestType>, 1'000'000)

}  // namespace
}  // namespace detent::oracle
