// SPDX-License-Identifier: MIT

#include "detent/query/raycast/capsule.hpp"
#include "oracle/crossing_round.hpp"
#include "oracle/ray_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(RayExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  exam.family("random", count * 40 / 100, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale);
    const auto a = draw.point(scale), b = draw.point(scale);
    const auto radius = random.between(0, random.coin() ? scale / 4 : scale / 64);
    auto target = a;
    const auto along = random.between(0, 256);
    for (std::size_t i = 0; i < draw.size; ++i) target[i] += (b[i] - a[i]) / 256 * along;
    const auto spread = N == 2 ? 6 * radius + 1 : radius + radius / 2 + 1;
    return std::pair{
        draw.ray(origin, draw.towards(origin, draw.near(target, spread)), draw.reach(scale)),
        from_raw<Capsule<S, N>>(a, b, radius)};
  });

  // Everything along the axes of an exact frame: parallel to the axis at the radius from it, or
  // across it, touching the side, the ends, or where they join; then a unit more or less.
  exam.family("frame", count * 25 / 100, 20, 90, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 16, frame.norm);
    const auto any = [&] { return random.one_in(3) ? 0 : random.between(-3, 3) * steps; };
    const auto place = [&](Raw<N> point) {
      for (const auto& axis : frame.axes) point = draw.plus(point, axis, any());
      return point;
    };
    const auto a = draw.point(draw.limit / 4);
    const auto b = random.coin() ? draw.plus(a, frame.axes[0], any()) : place(a);
    auto origin = place(a);
    if (random.one_in(6)) origin = draw.near(origin, 1);
    const auto radius =
        random.between(0, 3) * steps * frame.norm + (random.one_in(3) ? random.between(-1, 1) : 0);
    auto direction = draw.stretched(frame.axes[random.below(draw.size)], frame.norm);
    if (random.coin()) direction = -direction;
    if (random.one_in(8)) direction = draw.disturbed(direction);
    return std::pair{draw.ray(origin, direction, draw.reach(4 * steps)),
                     from_raw<Capsule<S, N>>(a, b, radius)};
  });

  // Nearly along the axis, so that the leading term of the cylinder's quadratic almost vanishes.
  exam.family("along", count * 10 / 100, 20, 90, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale);
    const auto direction = draw.any_direction();
    const auto first = draw.moved(origin, direction, random.between(-scale, 4 * scale));
    const auto a = draw.near(first, 3);
    const auto b = draw.near(draw.moved(first, direction, random.between(-scale, scale)), 3);
    return std::pair{draw.ray(origin, direction, draw.reach(scale)),
                     from_raw<Capsule<S, N>>(a, b, random.between(0, 6))};
  });

  // The ends are one point, the radius is 0, or the capsule is empty.
  exam.family("degenerate", count * 8 / 100, 10, 80, [&] {
    const auto& frame = draw.frame();
    const auto steps = draw.steps(draw.limit / 4, frame.norm);
    const auto origin = draw.point(draw.limit / 4);
    const auto a = draw.plus(origin, frame.axes[0], random.between(-steps / 4, steps));
    auto b = a;
    if (random.coin()) b = draw.plus(a, frame.axes[random.below(draw.size)], random.between(-3, 3));
    const auto radius = random.one_in(6) ? -random.between(1, steps)
                        : random.coin()  ? 0
                                         : random.between(0, 3);
    return std::pair{draw.ray(origin, draw.stretched(frame.axes[0], frame.norm), draw.reach(steps)),
                     from_raw<Capsule<S, N>>(a, b, radius)};
  });

  exam.family("tiny", count * 9 / 100, 10, 90, [&] {
    const auto origin = draw.point(6);
    const auto a = draw.point(4), b = draw.point(4);
    const auto& frame = draw.frame();
    const auto direction = random.one_in(3) ? draw.stretched(frame.axes[0], frame.norm)
                                            : draw.towards(origin, draw.near(a, 3));
    return std::pair{draw.ray(origin, direction, draw.reach(6)),
                     from_raw<Capsule<S, N>>(a, b, random.between(-1, 4))};
  });

  exam.family("extreme", count * 8 / 100, 5, 95, [&] {
    const auto origin = draw.extreme_point();
    const auto a = draw.extreme_point(), b = draw.extreme_point();
    const auto radius = random.one_in(8) ? draw.extreme() : std::abs(draw.extreme());
    const auto direction = random.one_in(3)   ? draw.axis_direction()
                           : random.one_in(3) ? draw.any_direction()
                                              : draw.towards(origin, a);
    return std::pair{
        draw.ray(origin, direction, random.one_in(3) ? draw.scalar(draw.extreme()) : S::max()),
        from_raw<Capsule<S, N>>(a, b, radius)};
  });
}

DETENT_RAY_TEST("ray against capsule", 0xca94e, 10'000, 20'000)

// The bound on normals, 0.501 units, is tight: some are off by more than 0.499.
TEMPLATE_TEST_CASE("ray against capsule: a normal may be off by nearly half a unit", "[oracle]",
                   (test::Space<q16_16, 3>), (test::Space<q8_8, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using D = Draw<S, N>;
  D draw(0x4a1f);
  INFO(draw.random);
  long sides = 0, nearly_half = 0;
  for (long i = 0; i < 4'000; ++i) {
    const auto origin = draw.point(D::limit / 2), middle = draw.point(D::limit / 2);
    const auto a = draw.near(middle, D::limit / 4), b = D::plus(D::plus(middle, middle), a, -1);
    const Ray<S, N> ray{D::vec(origin), draw.towards(origin, middle)};
    const Capsule<S, N> capsule{D::vec(a), D::vec(b), D::scalar(draw.random.between(1, 4096))};
    const auto found = detent::raycast_hit(ray, capsule);
    if (!found || found->distance == 0) continue;
    const auto expected = expected_raycast(ray, capsule);
    const auto& normal = dynamic_cast<const CapsuleNormal<N>&>(*expected.hit->normal);
    if (normal.under == 1) continue;
    ++sides;
    REQUIRE(normal.within(raw(found->normal), 501, 1000));
    nearly_half += normal.within(raw(found->normal), 499, 1000) ? 0 : 1;
  }
  CHECK(sides > 1'000);
  CHECK(nearly_half > 0);
}

}  // namespace
}  // namespace detent::oracle
