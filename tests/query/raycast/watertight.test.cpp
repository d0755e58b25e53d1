// SPDX-License-Identifier: MIT
#include "oracle/draw.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

// What meshes need of the raycast against triangles: where they meet there is no way through. Exact
// answers give that for free; these tests ask the rays that rounding would let slip.

using oracle::cross;
using oracle::difference;
using oracle::dot;
using oracle::Integer;
using oracle::Raw;
using oracle::widen;

template <Scalar S>
using Draw = oracle::Draw<S, 3>;

/// Six times the volume of the tetrahedron a b c d, positive for d on the left of a b c.
Integer volume(const Raw<3>& a, const Raw<3>& b, const Raw<3>& c, const Raw<3>& d) {
  return dot(cross(difference(widen(b), widen(a)), difference(widen(c), widen(a))),
             difference(widen(d), widen(a)));
}

template <Scalar S>
Triangle<S, 3> triangle(const Raw<3>& a, const Raw<3>& b, const Raw<3>& c) {
  return {Draw<S>::vec(a), Draw<S>::vec(b), Draw<S>::vec(c)};
}

TEMPLATE_TEST_CASE("ray against triangles: no ray escapes from a tetrahedron", "[raycast]", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  Draw<S> draw(0x7e74);
  auto& random = draw.random;
  INFO(random);
  long escaped = 0;
  long asked = 0;
  long sharp = 0;
  while (asked < 50'000) {
    const auto scale = std::int64_t{1} << random.between(3, S::bits - 2);
    std::array<Raw<3>, 4> corners{draw.point(scale), draw.point(scale), draw.point(scale),
                                  draw.point(scale)};
    if (volume(corners[0], corners[1], corners[2], corners[3]) < 0) {
      std::swap(corners[0], corners[1]);
    }
    Raw<3> inside{};
    for (const auto& corner : corners) inside = Draw<S>::plus(inside, corner);
    for (auto& component : inside) component /= 4;
    const std::array<std::array<std::size_t, 3>, 4> faces{
        {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
    bool encloses = true;
    for (const auto& [i, j, k] : faces) {
      encloses = encloses && volume(corners[i], corners[j], corners[k], inside) > 0;
    }
    if (!encloses) continue;

    for (int n = 0; n < 20; ++n) {
      // At a corner, at a point of an edge, or anywhere.
      const auto& a = corners[random.below(4)];
      const auto& b = corners[random.below(4)];
      Raw<3> target = a;
      const auto part = random.between(0, 64);
      for (std::size_t i = 0; i < 3; ++i) target[i] += (b[i] - a[i]) * part / 64;
      const auto direction = random.one_in(4) ? draw.any_direction() : draw.towards(inside, target);
      const Ray<S, 3> ray{Draw<S>::vec(inside), direction};
      int hits = 0;
      for (const auto& [i, j, k] : faces) {
        hits += raycast(ray, triangle<S>(corners[i], corners[j], corners[k])).has_value() ? 1 : 0;
      }
      ++asked;
      escaped += hits == 0 ? 1 : 0;
      sharp += hits > 1 ? 1 : 0;
    }
  }
  CHECK(escaped == 0);
  // Some rays did meet two faces at once, so the edges were asked.
  INFO(sharp << " rays met an edge");
  CHECK(sharp > 0);
}

TEMPLATE_TEST_CASE("ray against triangles: none slips between two that share an edge", "[raycast]",
                   q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  Draw<S> draw(0xed6e);
  auto& random = draw.random;
  INFO(random);
  long slipped = 0;
  long asked = 0;
  HitRate first;
  while (asked < 50'000) {
    const auto scale = std::int64_t{1} << random.between(6, S::bits - 3);
    const auto a = draw.point(scale);
    const auto b = draw.point(scale);
    const auto c = draw.point(scale);
    const auto d = draw.point(scale);
    // From far enough to be before all of both triangles, through the middle half of the edge, off
    // by at most a raw unit or two for the grid.
    Raw<3> middle = a;
    const auto part = random.between(16, 48);
    for (std::size_t i = 0; i < 3; ++i) middle[i] += (b[i] - a[i]) * part / 64;
    const auto direction = random.one_in(4) ? draw.axis_direction() : draw.any_direction();
    const auto origin = Draw<S>::moved(middle, direction, -4 * scale);
    const Ray<S, 3> ray{Draw<S>::vec(origin), direction};

    // Seen along the ray, c and d are 16 raw units or more to either side of the edge and not
    // beyond its ends, and the edge is 16 units or longer: then the ray is well within both
    // together.
    const auto along = widen(oracle::raw(direction));
    const auto seen = [&](const Raw<3>& from, const Raw<3>& to) {
      return cross(along, difference(widen(to), widen(from)));
    };
    const auto edge = seen(a, b);
    const Integer square = dot(edge, edge);
    const auto side_c = dot(edge, difference(widen(c), widen(a)));
    const auto side_d = dot(edge, difference(widen(d), widen(a)));
    if (square < 256 * dot(along, along) || side_c.sign() * side_d.sign() >= 0) continue;
    if (side_c * side_c < 256 * square || side_d * side_d < 256 * square) continue;
    const auto beside = [&](const Raw<3>& p) {
      const Integer place = dot(edge, seen(a, p));
      return place >= 0 && place <= square;
    };
    if (!beside(c) || !beside(d)) continue;

    const bool hits_c = raycast(ray, triangle<S>(a, b, c)).has_value();
    const bool hits_d = raycast(ray, triangle<S>(b, a, d)).has_value();
    ++asked;
    first.count(hits_c);
    slipped += !hits_c && !hits_d ? 1 : 0;
  }
  CHECK(slipped == 0);
  INFO(first);
  CHECK(first.is_balanced());
}

TEMPLATE_TEST_CASE("ray against triangles: a shared edge or corner is hit by all around it",
                   "[raycast]", q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  Draw<S> draw(0xfa4);
  auto& random = draw.random;
  INFO(random);
  long missed = 0;
  for (int n = 0; n < 50'000; ++n) {
    // Exactly through the common corner, or a point of the common edge: the ray leads along an axis
    // of integers.
    const auto& frame = draw.frame();
    const auto scale = std::int64_t{1} << random.between(3, S::bits - 3);
    const auto corner = draw.point(scale);
    const auto steps = scale / frame.norm;
    const auto origin = Draw<S>::plus(corner, frame.axes[0], -random.between(0, steps));
    const Ray<S, 3> ray{Draw<S>::vec(origin), Draw<S>::stretched(frame.axes[0], frame.norm)};
    auto previous = draw.point(scale);
    for (int i = 0; i < 5; ++i) {
      const auto next = draw.point(scale);
      missed += raycast(ray, triangle<S>(corner, previous, next)).has_value() ? 0 : 1;
      previous = next;
      const auto edge = draw.point(scale / 8);
      const auto a = Draw<S>::plus(corner, edge, random.between(0, 7));
      const auto b = Draw<S>::plus(corner, edge, -random.between(0, 7));
      missed += raycast(ray, triangle<S>(a, b, next)).has_value() ? 0 : 1;
    }
  }
  CHECK(missed == 0);
}

}  // namespace
}  // namespace detent::test
