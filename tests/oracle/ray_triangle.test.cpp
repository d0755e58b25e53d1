// SPDX-License-Identifier: MIT
#include "oracle/ray_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void draw_cases(RayExam<S, N>& exam, Draw<S, N>& draw, test::Random& random, long count) {
  using Corners = std::array<Raw<N>, 3>;
  const auto question = [&](const Raw<N>& origin, const Direction<S, N>& direction, S max_distance,
                            const Corners& corners) {
    const auto first = random.below(3);
    const bool other_way = random.coin();
    const auto corner = [&](std::size_t i) {
      return draw.vec(corners[(first + (other_way ? 3 - i : i)) % 3]);
    };
    return std::pair{draw.ray(origin, direction, max_distance),
                     Triangle<S, N>{corner(0), corner(1), corner(2)}};
  };
  // a + u (b - a) + v (c - a) on the grid, u and v in 1/1024.
  const auto at = [&](const Corners& t, std::int64_t u, std::int64_t v) {
    Raw<N> result = t[0];
    for (std::size_t i = 0; i < draw.size; ++i) {
      result[i] += (u * (t[1][i] - t[0][i]) + v * (t[2][i] - t[0][i])) / 1024;
    }
    return result;
  };

  exam.family("random", count * 30 / 100, 30, 70, [&] {
    const auto scale = draw.scale();
    const Corners t{draw.point(scale), draw.point(scale), draw.point(scale)};
    const auto origin = draw.point(scale);
    constexpr int low = N == 2 ? -1536 : -128;
    constexpr int high = N == 2 ? 1536 : 896;
    const auto target = at(t, random.between(low, high), random.between(low, high));
    return question(origin, draw.towards(origin, target), draw.reach(scale), t);
  });

  // At a corner or a point of an edge; rounding to the grid may make it miss by a raw unit or so.
  exam.family("grazing", count * 20 / 100, 25, 80, [&] {
    const auto scale = draw.scale();
    const Corners t{draw.point(scale), draw.point(scale), draw.point(scale)};
    const auto direction = random.one_in(3) ? draw.axis_direction() : draw.any_direction();
    const auto target =
        draw.near(at(t, random.coin() ? random.between(0, 1024) : 0, 0), random.coin() ? 1 : 0);
    const auto origin = draw.moved(target, direction, -random.between(-scale / 4, 2 * scale));
    return question(origin, direction, draw.reach(scale), t);
  });

  // Exactly through a corner, or through a point that divides an edge into integer parts.
  exam.family("tangent", count * 15 / 100, 30, 95, [&] {
    const auto& frame = draw.frame();
    const auto scale = std::min(draw.scale(), draw.limit / 4);
    const auto steps = scale / frame.norm + 1;
    const auto target = draw.point(scale);
    const auto edge = draw.point(std::max<std::int64_t>(1, scale / 64));
    const Corners t{draw.plus(target, edge, random.between(0, 32)),
                    draw.plus(target, edge, -random.between(0, 32)), draw.point(scale)};
    const auto axis = random.one_in(3) ? draw.unit() : frame.axes[0];
    const auto norm = axis == frame.axes[0] ? frame.norm : 1;
    auto origin = draw.plus(target, axis, -random.between(-steps / 4, norm == 1 ? scale : steps));
    if (random.one_in(4)) origin[random.below(draw.size)] += random.between(-1, 1);
    return question(origin, draw.stretched(axis, norm), draw.reach(scale), t);
  });

  // Ray and triangle exactly coplanar, or a corner or the ray's start a raw unit off. In 2D that is
  // another way to draw rays along edges.
  exam.family("coplanar", count * 12 / 100, 15, 90, [&] {
    const auto& frame = draw.frame();
    const auto steps = std::max<std::int64_t>(2, draw.steps(draw.limit / 8, frame.norm));
    const auto base = draw.point(draw.limit / 4);
    const auto in_plane = [&](std::int64_t reach) {
      return draw.plus(draw.plus(base, frame.axes[0], random.between(-reach, reach)), frame.axes[1],
                       random.between(-reach, reach));
    };
    Corners t{in_plane(steps), in_plane(steps), in_plane(steps)};
    auto origin = random.coin() ? in_plane(steps)
                                : draw.plus(t[0], frame.axes[0], random.between(-steps, steps));
    if (random.one_in(4)) t[1] = draw.plus(t[0], frame.axes[0], random.between(-steps, steps));
    if (random.one_in(8)) origin = draw.near(origin, 1);
    if (random.one_in(8)) t[2] = draw.near(t[2], 1);
    const auto direction = draw.stretched(frame.axes[0], frame.norm);
    return question(origin, random.one_in(8) ? draw.disturbed(direction) : direction,
                    draw.reach(steps), t);
  });

  // A segment or a point that is hit exactly, crossed, followed, or missed by a raw unit.
  exam.family("collapsed", count * 12 / 100, 15, 90, [&] {
    const auto& frame = draw.frame();
    const auto steps = std::max<std::int64_t>(2, draw.steps(draw.limit / 8, frame.norm));
    const auto target = draw.point(draw.limit / 4);
    Raw<N> edge = frame.axes[random.below(draw.size)];
    if (random.coin()) edge = draw.point(frame.norm);
    if (random.one_in(8)) edge = Raw<N>{};
    Corners t{target, target, target};
    for (auto& corner : t) corner = draw.plus(corner, edge, random.between(-steps, steps));
    if (random.one_in(8)) t[2] = draw.near(t[2], 1);
    auto origin = draw.plus(target, frame.axes[0], -random.between(-steps / 4, steps));
    if (random.one_in(8)) origin = draw.near(origin, 1);
    return question(origin, draw.stretched(frame.axes[0], frame.norm), draw.reach(steps), t);
  });

  // Nearly along an edge, at angles to it and to the triangle's plane down to the last bit.
  exam.family("shallow", count * 6 / 100, 10, 90, [&] {
    const auto scale = draw.scale();
    const Corners t{draw.point(scale), draw.point(scale), draw.point(scale)};
    const auto angle = draw.shrunk(scale);
    const auto direction = draw.disturbed(draw.towards(t[0], draw.near(t[1], angle)));
    const auto v = random.coin() ? 0 : random.between(0, 64);
    const auto target = draw.near(at(t, random.between(0, 1024 - v), v), random.coin() ? 1 : 0);
    const auto origin = draw.moved(target, direction, -random.between(-scale / 4, 2 * scale));
    return question(origin, direction, draw.reach(scale), t);
  });

  exam.family("inside", count * 6 / 100, 20, 100, [&] {
    const auto scale = draw.scale();
    const Corners t{draw.point(scale), draw.point(scale), draw.point(scale)};
    const auto u = random.one_in(3) ? 0 : random.between(0, 1024);
    const auto origin = draw.near(at(t, u, random.one_in(3) ? 0 : random.between(0, 1024 - u)),
                                  random.one_in(4) ? 1 : 0);
    const auto direction = random.coin() ? draw.any_direction() : draw.towards(origin, t[0]);
    return question(origin, direction, draw.reach(scale), t);
  });

  exam.family("tiny", count * 8 / 100, 10, 90, [&] {
    const auto& frame = draw.frame();
    const Corners t{draw.point(4), draw.point(4), draw.point(4)};
    const auto origin = draw.point(6);
    const auto direction = random.one_in(3)   ? draw.stretched(frame.axes[0], frame.norm)
                           : random.one_in(3) ? draw.axis_direction()
                                              : draw.towards(origin, t[random.below(3)]);
    return question(origin, direction, draw.reach(4), t);
  });

  exam.family("extreme", count * 8 / 100, 5, 95, [&] {
    const auto origin = draw.extreme_point();
    const Corners t{draw.extreme_point(), draw.extreme_point(), draw.extreme_point()};
    const auto direction = random.one_in(3) ? draw.axis_direction()
                           : random.one_in(3)
                               ? draw.any_direction()
                               : draw.towards(origin, at(t, random.between(0, 1024), 0));
    return question(origin, direction, random.one_in(3) ? draw.scalar(draw.extreme()) : S::max(),
                    t);
  });
}

/// An integer vector with a component that, once normalised, is almost halfway between two grid
/// points: its slope is a convergent of the continued fraction of the exact slope.
Raw<2> near_tie(test::Random& random, int frac, std::int64_t limit) {
  // cosine = c / 2^(frac + 1) for an odd c, slope = sqrt(4^(frac + 1) - c^2) / c.
  const Integer c = 2 * random.between(1, (std::int64_t{1} << frac) - 1) + 1;
  const Integer squared = (Integer(1) << static_cast<unsigned>(2 * frac + 2)) - c * c;
  constexpr unsigned digits = 150;
  Integer over = sqrt(Integer(squared << (2 * digits)));
  Integer under = c << digits;
  Raw<2> last{1, 0};
  Raw<2> next{0, 1};
  while (under != 0) {
    const Integer whole = over / under;
    if (whole > limit) break;
    const auto times = static_cast<std::int64_t>(whole);
    const Raw<2> after{last[0] + times * next[0], last[1] + times * next[1]};
    if (after[0] > limit || after[1] > limit) break;
    last = next;
    next = after;
    over -= whole * under;
    std::swap(over, under);
  }
  return {next[1], next[0]};
}

TEMPLATE_TEST_CASE("ray against triangle: normals halfway between two are rounded correctly",
                   "[oracle]", q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  using Plane = Draw<S, 2>;
  using World = Draw<S, 3>;
  RayExam<S, 2> exam(0x71e5);
  RayExam<S, 3> exam_3d(0x71e53);
  constexpr int frac = direction_component<S>::frac;
  constexpr auto limit = std::int64_t{1} << (S::bits - 1);
  const auto half = [](const Raw<2>& v) { return Raw<2>{v[0] / 2, v[1] / 2}; };
  const auto turned = [](const Raw<2>& v) { return Raw<2>{-v[1], v[0]}; };

  exam.family("flat", 5'000, 99, 100, [&] {
    const auto edge = near_tie(exam.draw.random, frac, limit);
    const auto from = negated(half(edge));
    const auto behind = half(turned(edge));
    const auto direction = exam.draw.towards({0, 0}, behind);
    return std::pair{
        Ray<S, 2>{Plane::vec(negated(behind)), direction, S::max()},
        Triangle<S, 2>{Plane::vec(from), Plane::vec(Plane::plus(from, edge)), Plane::vec(behind)}};
  });
  exam_3d.family("upright", 5'000, 99, 100, [&] {
    const auto edge = near_tie(exam_3d.draw.random, frac, limit);
    const auto from = negated(half(edge));
    const auto to = Plane::plus(from, edge);
    const auto before = half(turned(edge));
    return std::pair{
        Ray<S, 3>{World::vec({before[0], before[1], 1}),
                  exam_3d.draw.towards({0, 0, 0}, {-before[0], -before[1], 0}), S::max()},
        Triangle<S, 3>{World::vec({from[0], from[1], 0}), World::vec({to[0], to[1], 0}),
                       World::vec({from[0], from[1], 100})}};
  });
  exam.finish(5'000);
  exam_3d.finish(5'000);
}

DETENT_RAY_TEST("ray against triangle", 0x7419, cases<TestType>, 1'000'000)

}  // namespace
}  // namespace detent::oracle
