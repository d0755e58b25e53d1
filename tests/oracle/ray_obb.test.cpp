// SPDX-License-Identifier: MIT
#include "oracle/ray_box.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(RayExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  struct Box {
    Raw<N> center, half;
    Rotation<S, N> rotation;
  };
  const auto question = [&](const Raw<N>& origin, const Direction<S, N>& direction, S max_distance,
                            const Box& box) {
    return std::pair{draw.ray(origin, direction, max_distance),
                     Obb<S, N>{draw.vec(box.center), draw.vec(box.half), box.rotation}};
  };
  const auto box = [&](std::int64_t scale) {
    Box result{draw.point(scale), {}, draw.rotation()};
    for (auto& half : result.half) half = random.one_in(12) ? 0 : random.between(0, scale / 2);
    return result;
  };
  // A corner with up to `loose` of its local coordinates anywhere between the faces instead, in
  // world coordinates and on the grid.
  const auto on_edge = [&](const Box& b, std::size_t loose) {
    Raw<N> local{};
    for (auto i = 0U; i < draw.size; ++i) local[i] = random.coin() ? b.half[i] : -b.half[i];
    for (; loose > 0; --loose) {
      const auto i = random.below(draw.size);
      local[i] = random.between(-std::abs(b.half[i]), std::abs(b.half[i]));
    }
    Raw<N> result = b.center;
    for (int i = 0; i < N; ++i) {
      result = draw.moved(result, b.rotation.axis(i), local[static_cast<std::size_t>(i)]);
    }
    return result;
  };

  draw_rays_at_boxes(exam, draw, count * 30 / 100, box, on_edge, question);

  exam.family("grazing", count * 20 / 100, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto b = box(scale);
    const auto along = b.rotation.axis(static_cast<int>(random.below(draw.size)));
    const auto direction = random.one_in(3) ? along : draw.any_direction();
    const auto target = draw.near(on_edge(b, random.below(draw.size)), random.coin() ? 1 : 0);
    const auto origin = draw.moved(target, direction, -random.between(-scale / 4, 2 * scale));
    return question(origin, direction, draw.reach(scale), b);
  });

  // An exactly orthogonal box and a ray along one of its axes, at or next to a face.
  exam.family("parallel", count * 12 / 100, 20, 80, [&] {
    const auto& frame = draw.frame();
    const auto scale = std::min(draw.scale(), draw.limit / 4);
    auto b = box(scale);
    b.rotation = draw.rotation(frame);
    const auto target = draw.near(on_edge(b, 1), random.coin() ? 1 : 0);
    const auto i = random.below(draw.size);
    const auto origin =
        draw.plus(target, frame.axes[i], random.between(-scale, scale / 4) / frame.norm);
    return question(origin, draw.stretched(frame.axes[i], frame.norm), draw.reach(scale), b);
  });

  exam.family("inside", count * 8 / 100, 30, 100, [&] {
    const auto scale = draw.scale();
    const auto b = box(scale);
    const auto origin =
        draw.near(on_edge(b, random.below(draw.size + 1)), random.one_in(4) ? 1 : 0);
    const auto along = b.rotation.axis(static_cast<int>(random.below(draw.size)));
    return question(origin, random.coin() ? draw.any_direction() : along, draw.reach(scale), b);
  });

  // A box that is flat along some of its exact axes, hit exactly in its plane, line or point; some
  // have a negative extent.
  exam.family("degenerate", count * 10 / 100, 15, 85, [&] {
    const auto& frame = draw.frame();
    const auto scale = std::min(draw.scale(), draw.limit / 4);
    auto b = box(scale);
    b.rotation = draw.rotation(frame);
    const auto steps = scale / frame.norm / 2 + 1;
    Raw<N> target = b.center;
    for (auto i = 0U; i < draw.size; ++i) {
      if (random.coin()) {
        b.half[i] = 0;
      } else {
        target = draw.plus(target, frame.axes[i], random.between(-steps, steps));
      }
      if (random.one_in(20)) b.half[i] = -random.between(1, scale);
    }
    if (random.one_in(8)) target = draw.near(target, 1);
    const auto& axis = frame.axes[random.below(draw.size)];
    const auto origin = draw.plus(target, axis, -random.between(-steps / 4, steps));
    return question(origin, draw.stretched(axis, frame.norm), draw.reach(scale), b);
  });

  // Slabs that are not perpendicular, or the same slab twice.
  exam.family("skewed", count * 6 / 100, 15, 95, [&] {
    const auto scale = draw.scale();
    auto b = box(scale);
    b.rotation = draw.skewed();
    const auto origin = draw.point(scale);
    return question(origin, draw.towards(origin, draw.near(b.center, scale / 4)), draw.reach(scale),
                    b);
  });

  exam.family("tiny", count * 6 / 100, 10, 90, [&] {
    auto b = box(16);
    b.center = draw.point(4);
    for (auto& half : b.half) half = random.between(random.one_in(8) ? -1 : 0, 4);
    if (random.coin()) b.rotation = draw.rotation(draw.frame());
    const auto origin = draw.point(6);
    const auto along = b.rotation.axis(static_cast<int>(random.below(draw.size)));
    const auto direction = random.one_in(3) ? along : draw.towards(origin, draw.near(b.center, 4));
    return question(origin, direction, draw.reach(4), b);
  });

  exam.family("extreme", count * 8 / 100, 5, 95, [&] {
    const auto origin = draw.extreme_point();
    Box b{draw.extreme_point(), draw.extreme_point(), draw.rotation()};
    for (auto& half : b.half) {
      if (!random.one_in(16)) half = std::abs(half);
    }
    if (random.one_in(4)) b.rotation = random.coin() ? draw.skewed() : Rotation<S, N>();
    const auto along = b.rotation.axis(static_cast<int>(random.below(draw.size)));
    const auto direction = random.one_in(3)   ? along
                           : random.one_in(3) ? draw.any_direction()
                                              : draw.towards(origin, b.center);
    return question(origin, direction, random.one_in(3) ? draw.scalar(draw.extreme()) : S::max(),
                    b);
  });
}

DETENT_EXAMINE(RayExam)

TEMPLATE_TEST_CASE("ray against OBB: every answer is the exact one", "[oracle]", (Space<q16_16, 3>),
                   (Space<q16_16, 2>), (Space<q14_16, 3>), (Space<q14_16, 2>), (Space<q24_8, 3>),
                   (Space<q24_8, 2>), (Space<q8_8, 3>), (Space<q8_8, 2>)) {
  examine<typename TestType::scalar, TestType::dimension>(0x0bb, cases<TestType>);
}

TEMPLATE_TEST_CASE("ray against OBB: many more answers are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, 1'000'000);
  }
}

}  // namespace
}  // namespace detent::oracle
