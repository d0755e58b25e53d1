// SPDX-License-Identifier: MIT
#include "oracle/ray_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(RayExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  exam.family("random", count * 30 / 100, 30, 70, [&] {
    const auto scale = draw.scale();
    return std::pair{draw.ray(draw.point(scale), draw.any_direction(), draw.reach(scale)),
                     from_raw<Plane<S, N>>(draw.any_direction(), random.between(-scale, scale))};
  });

  // Starts on the plane, or as close to it as the grid allows.
  exam.family("touching", count * 15 / 100, 30, 80, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale);
    const auto normal = random.one_in(3) ? draw.axis_direction() : draw.any_direction();
    const auto direction = random.one_in(8) ? draw.axis_direction() : draw.any_direction();
    return std::pair{
        draw.ray(origin, direction, draw.reach(scale)),
        from_raw<Plane<S, N>>(normal, draw.offset_of(normal, origin) + random.between(-1, 1))};
  });

  // The angle between ray and plane is a few units in the last place, so the hit is far away.
  exam.family("grazing", count * 15 / 100, 20, 80, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.near(draw.point(scale), 4);
    const auto rotation = draw.rotation();
    const auto direction = draw.disturbed(rotation.axis(0));
    const auto normal = draw.disturbed(rotation.axis(1));
    const auto reach = draw.shrunk(scale);
    return std::pair{
        draw.ray(origin, direction, draw.reach(scale)),
        from_raw<Plane<S, N>>(normal, draw.offset_of(normal, origin) +
                                          (random.coin() ? 0 : random.between(-reach, reach)))};
  });

  // Exactly parallel; exactly in the plane, or a raw unit off.
  exam.family("parallel", count * 20 / 100, 20, 80, [&] {
    const auto& frame = draw.frame();
    if (random.coin()) {
      const auto normal = draw.unit();
      auto along = draw.unit();
      while (std::abs(along[0]) == std::abs(normal[0]) &&
             std::abs(along[1]) == std::abs(normal[1])) {
        along = draw.unit();
      }
      const auto origin = draw.point(draw.scale());
      const auto offset = draw.offset_of(draw.stretched(normal, 1), origin) +
                          (random.coin() ? 0 : random.between(-1, 1));
      return std::pair{draw.ray(origin, draw.stretched(along, 1), draw.reach(64)),
                       from_raw<Plane<S, N>>(draw.stretched(normal, 1), offset)};
    }
    const auto steps = draw.shrunk(draw.limit / 4 / frame.norm);
    Raw<N> origin{};
    for (auto i = 1U; i < draw.size; ++i) {
      origin = draw.plus(origin, frame.axes[i], random.between(-steps, steps));
    }
    if (random.one_in(4)) origin = draw.near(origin, 1);
    const auto offset = random.one_in(4) ? random.between(-1, 1) : 0;
    const auto direction = draw.stretched(frame.axes[1], frame.norm);
    return std::pair{
        draw.ray(origin, random.one_in(3) ? draw.disturbed(direction) : direction, draw.reach(64)),
        from_raw<Plane<S, N>>(draw.stretched(frame.axes[0], frame.norm), offset)};
  });

  exam.family("tiny", count * 10 / 100, 20, 80, [&] {
    const auto& frame = draw.frame();
    const auto normal = random.one_in(3)   ? draw.axis_direction()
                        : random.one_in(3) ? draw.any_direction()
                                           : draw.stretched(frame.axes[0], frame.norm);
    const auto direction = random.one_in(3)   ? draw.axis_direction()
                           : random.one_in(3) ? draw.any_direction()
                                              : draw.stretched(frame.axes[1], frame.norm);
    return std::pair{draw.ray(draw.point(4), direction, draw.reach(4)),
                     from_raw<Plane<S, N>>(normal, random.between(-4, 4))};
  });

  exam.family("extreme", count * 10 / 100, 5, 95, [&] {
    const auto direction = random.one_in(3) ? draw.axis_direction() : draw.any_direction();
    const auto normal = random.one_in(3) ? draw.axis_direction() : draw.any_direction();
    return std::pair{draw.ray(draw.extreme_point(), direction,
                              random.one_in(3) ? draw.scalar(draw.extreme()) : S::max()),
                     from_raw<Plane<S, N>>(normal, draw.extreme())};
  });
}

DETENT_RAY_TEST("ray against plane", 0x91a7e, cases<TestType>, 1'000'000)

}  // namespace
}  // namespace detent::oracle
