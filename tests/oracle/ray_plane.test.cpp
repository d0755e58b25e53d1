// SPDX-License-Identifier: MIT
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
                           const Direction<S, N>& normal, std::int64_t offset) {
    return std::pair{Ray<S, N>{D::vec(origin), direction, max_distance},
                     Plane<S, N>{normal, D::scalar(offset)}};
  };
  // The offset, to the raw unit, of the plane through a point.
  const auto offset_of = [](const Direction<S, N>& normal, const Raw<N>& point) {
    double sum = 0;
    for (std::size_t i = 0; i < D::size; ++i) {
      sum += static_cast<double>(normal[static_cast<int>(i)].raw()) / static_cast<double>(D::one) *
             static_cast<double>(point[i]);
    }
    return std::llround(sum);
  };

  exam.family("random", count * 30 / 100, 30, 70, [&] {
    const auto scale = draw.scale();
    return question(draw.point(scale), draw.any_direction(), draw.reach(scale),
                    draw.any_direction(), random.between(-scale, scale));
  });

  // Starts on the plane, or as close to it as the grid allows.
  exam.family("touching", count * 15 / 100, 30, 80, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale);
    const auto normal = random.one_in(3) ? draw.axis_direction() : draw.any_direction();
    const auto direction = random.one_in(8) ? draw.axis_direction() : draw.any_direction();
    return question(origin, direction, draw.reach(scale), normal,
                    offset_of(normal, origin) + random.between(-1, 1));
  });

  // The angle between ray and plane is a few units in the last place, so the hit is far away.
  exam.family("grazing", count * 15 / 100, 20, 80, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.near(draw.point(scale), 4);
    const auto rotation = draw.rotation();
    const auto direction = draw.disturbed(rotation.axis(0));
    const auto normal = draw.disturbed(rotation.axis(1));
    const auto reach = scale >> random.below(static_cast<unsigned>(S::bits));
    return question(
        origin, direction, draw.reach(scale), normal,
        offset_of(normal, origin) + (random.coin() ? 0 : random.between(-reach, reach)));
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
      const auto offset =
          offset_of(D::stretched(normal, 1), origin) + (random.coin() ? 0 : random.between(-1, 1));
      return question(origin, D::stretched(along, 1), draw.reach(64), D::stretched(normal, 1),
                      offset);
    }
    const auto steps = D::limit / 4 / frame.norm >> random.below(static_cast<unsigned>(S::bits));
    Raw<N> origin{};
    for (auto i = 1U; i < D::size; ++i) {
      origin = D::plus(origin, frame.axes[i], random.between(-steps, steps));
    }
    if (random.one_in(4)) origin = draw.near(origin, 1);
    const auto offset = random.one_in(4) ? random.between(-1, 1) : 0;
    const auto direction = D::stretched(frame.axes[1], frame.norm);
    return question(origin, random.one_in(3) ? draw.disturbed(direction) : direction,
                    draw.reach(64), D::stretched(frame.axes[0], frame.norm), offset);
  });

  exam.family("tiny", count * 10 / 100, 20, 80, [&] {
    const auto& frame = draw.frame();
    const auto normal = random.one_in(3)   ? draw.axis_direction()
                        : random.one_in(3) ? draw.any_direction()
                                           : D::stretched(frame.axes[0], frame.norm);
    const auto direction = random.one_in(3)   ? draw.axis_direction()
                           : random.one_in(3) ? draw.any_direction()
                                              : D::stretched(frame.axes[1], frame.norm);
    return question(draw.point(4), direction, draw.reach(4), normal, random.between(-4, 4));
  });

  exam.family("extreme", count * 10 / 100, 5, 95, [&] {
    const auto direction = random.one_in(3) ? draw.axis_direction() : draw.any_direction();
    const auto normal = random.one_in(3) ? draw.axis_direction() : draw.any_direction();
    return question(draw.extreme_point(), direction,
                    random.one_in(3) ? D::scalar(draw.extreme()) : S::max(), normal,
                    draw.extreme());
  });

  exam.finish(count);
}

DETENT_ORACLE_TEST("ray against plane", 0x91a7e, cases<TestType>, 1'000'000)

}  // namespace
}  // namespace detent::oracle
