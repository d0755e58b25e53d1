// SPDX-License-Identifier: MIT
#include "oracle/crossing_round.hpp"
#include "oracle/ray_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(RayExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  exam.family("random", count * 25 / 100, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale);
    const auto center = draw.point(scale);
    const auto radius = random.between(0, scale / 2);
    const auto spread = N == 2 ? 2 * radius : radius + radius / 4;
    const auto direction = draw.towards(origin, draw.near(center, spread));
    return std::pair{draw.ray(origin, direction, draw.reach(scale)),
                     from_raw<Sphere<S, N>>(center, radius)};
  });

  // The radius is the distance between center and line, to the raw unit.
  exam.family("grazing", count * 20 / 100, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale);
    const auto center = draw.point(scale);
    const auto direction =
        draw.towards(origin, draw.near(center, random.one_in(8) ? 4 : random.between(0, scale)));
    double square = 0;
    double along = 0;
    for (std::size_t i = 0; i < draw.size; ++i) {
      const auto apart = static_cast<double>(center[i] - origin[i]);
      const auto d =
          static_cast<double>(direction[static_cast<int>(i)].raw()) / static_cast<double>(draw.one);
      square += apart * apart;
      along += apart * d;
    }
    const double distance = std::sqrt(std::max(0.0, square - along * along));
    const auto radius = std::llround(distance) + random.between(-1, 1);
    return std::pair{draw.ray(origin, direction, draw.reach(scale)),
                     from_raw<Sphere<S, N>>(center, radius)};
  });

  // An integer tangent: origin, direction and the radius to the contact point are along the axes of
  // an exact frame. Then a unit more or less.
  exam.family("tangent", count * 15 / 100, 30, 90, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 4, frame.norm);
    const auto origin = draw.point(draw.limit / 4);
    const auto along = random.between(-steps / 8, steps);
    const auto aside = random.between(0, steps);
    const auto center = draw.plus(draw.plus(origin, frame.axes[0], along), frame.axes[1], aside);
    const auto radius = aside * frame.norm + (random.coin() ? 0 : random.between(-1, 1));
    return std::pair{draw.ray(origin, draw.stretched(frame.axes[0], frame.norm), draw.reach(steps)),
                     from_raw<Sphere<S, N>>(center, radius)};
  });

  // Exactly on the surface (or one unit off), or inside, in any direction.
  exam.family("inside", count * 12 / 100, 50, 100, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 4, frame.norm);
    const auto center = draw.point(draw.limit / 4);
    const auto aside = random.between(0, steps);
    const auto origin = draw.plus(center, frame.axes[0], aside);
    const auto radius = aside * frame.norm + random.between(-1, random.coin() ? 1 : steps);
    const auto direction = random.coin()
                               ? draw.any_direction()
                               : draw.stretched(frame.axes[random.below(draw.size)], frame.norm);
    return std::pair{draw.ray(origin, direction, draw.reach(steps)),
                     from_raw<Sphere<S, N>>(center, radius)};
  });

  // Roots that are integers or barely not: with radius n + 1 and the center's distance from an
  // axis-parallel ray being the root of 2 n - delta, the squared half chord is n^2 + 1 + delta. Or
  // origin + direction is a point of the surface.
  exam.family("roots", count * 5 / 100, 35, 100, [&] {
    const auto sign = random.coin() ? 1 : -1;
    if (random.coin()) {
      const auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(draw.limit)));
      const auto axis = random.below(draw.size);
      Raw<N> aside{};
      std::int64_t square = 0;
      for (std::size_t i = 0; i < draw.size; ++i) {
        if (i == axis) continue;
        aside[i] = random.between(root / 4, root);
        square += aside[i] * aside[i];
      }
      const auto n = (square + random.between(-2, 2)) / 2;
      Raw<N> ahead{};
      ahead[axis] = sign * random.between(n / 2, draw.limit);
      const auto origin = draw.point(draw.limit / 4);
      Raw<N> forward{};
      forward[axis] = sign;
      return std::pair{draw.ray(origin, draw.stretched(forward, 1), draw.reach(n)),
                       from_raw<Sphere<S, N>>(draw.plus(draw.plus(origin, aside), ahead), n + 1)};
    }
    const auto& frame = draw.frame();
    const auto direction = draw.stretched(frame.axes[0], frame.norm);
    const auto origin = draw.point(draw.limit / 4);
    const auto steps = random.between(1, std::max<std::int64_t>(1, draw.limit / 8 / frame.norm));
    const auto surface = draw.plus(origin, raw(direction));
    return std::pair{draw.ray(origin, direction, draw.reach(draw.limit)),
                     from_raw<Sphere<S, N>>(draw.plus(surface, frame.axes[0], sign * steps),
                                            steps * frame.norm)};
  });

  // Points, and empty spheres.
  exam.family("degenerate", count * 6 / 100, 20, 80, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 2, frame.norm);
    const auto origin = draw.point(draw.limit / 2);
    auto center = draw.plus(origin, frame.axes[0], random.between(-steps / 8, steps));
    if (random.one_in(4)) center = draw.near(center, 1);
    const auto radius = random.one_in(4) ? -random.between(0, steps) : 0;
    return std::pair{draw.ray(origin, draw.stretched(frame.axes[0], frame.norm), draw.reach(steps)),
                     from_raw<Sphere<S, N>>(center, radius)};
  });

  // Everything a few raw units large, so that coincidences are common.
  exam.family("tiny", count * 6 / 100, 10, 90, [&] {
    const auto& frame = draw.frame();
    const auto origin = draw.point(4);
    const auto center = draw.point(4);
    const auto direction = random.one_in(3) ? draw.stretched(frame.axes[0], frame.norm)
                                            : draw.towards(origin, draw.near(center, 3));
    return std::pair{draw.ray(origin, direction, draw.reach(4)),
                     from_raw<Sphere<S, N>>(center, random.between(-1, 4))};
  });

  exam.family("extreme", count * 8 / 100, 5, 95, [&] {
    const auto origin = draw.extreme_point();
    const auto center = draw.extreme_point();
    const auto radius = random.one_in(8) ? draw.extreme() : std::abs(draw.extreme());
    const auto direction = random.one_in(3)   ? draw.axis_direction()
                           : random.one_in(3) ? draw.any_direction()
                                              : draw.towards(origin, center);
    return std::pair{
        draw.ray(origin, direction, random.one_in(3) ? draw.scalar(draw.extreme()) : S::max()),
        from_raw<Sphere<S, N>>(center, radius)};
  });
}

DETENT_RAY_TEST("ray against sphere", 0x5be7e, cases<TestType>, 1'000'000)

// The bound on normals, one unit, could not be half a unit: some are off by more than half, unlike
// correctly rounded ones. With 16-bit scalars a few in a hundred thousand; with 32-bit ones, whose
// root is 2^16 times as fine, none that a test could find.
TEMPLATE_TEST_CASE("ray against sphere: a normal may be off by more than half a unit", "[oracle]",
                   (test::Space<q8_8, 3>), (test::Space<q8_8, 2>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using D = Draw<S, N>;
  D draw(0x4a1f);
  INFO(draw.random);
  long beyond_half = 0;
  for (long i = 0; i < 60'000; ++i) {
    const auto origin = draw.point(D::limit / 2);
    const auto center = draw.point(D::limit / 2);
    const Ray<S, N> ray{D::vec(origin), draw.towards(origin, center)};
    const Sphere<S, N> sphere{D::vec(center), D::scalar(draw.random.between(1, 4096))};
    const auto hit = detent::raycast_hit(ray, sphere);
    if (!hit || hit->distance == 0) continue;
    const auto expected = expected_raycast(ray, sphere);
    const auto& normal = dynamic_cast<const SphereNormal<N>&>(*expected.hit->normal);
    REQUIRE(normal.allows(raw(hit->normal)));
    beyond_half += normal.within(raw(hit->normal), 1, 2) ? 0 : 1;
  }
  CHECK(beyond_half > 0);
}

}  // namespace
}  // namespace detent::oracle
