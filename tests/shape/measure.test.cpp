// SPDX-License-Identifier: MIT
#include "detent/shape/measure.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include "oracle/draw.hpp"
#include "oracle/space.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("area, volume: simple boxes and triangles have the obvious values", "[measure]",
                   q16_16, q14_16, q24_8, q8_8, float, double) {
  using S = TestType;
  CHECK(area(Triangle{at<S, 2>(1, 1), at<S, 2>(4, 1), at<S, 2>(1, 3)}) == 3);
  CHECK(area(Triangle{at<S, 2>(1, 1), at<S, 2>(1, 3), at<S, 2>(4, 1)}) == 3);
  CHECK(area(Triangle{at<S, 2>(0, 0), at<S, 2>(1, 0), at<S, 2>(0, 1)}) == num<S>(0.5));
  CHECK(area(Triangle{at<S, 3>(0, 0, 5), at<S, 3>(3, 4, 5), at<S, 3>(-4, 3, 5)}) == num<S>(12.5));
  CHECK(area(Triangle{at<S, 3>(1, 2, 3), at<S, 3>(2, 4, 6), at<S, 3>(3, 6, 9)}) == 0);
  CHECK(area(Aabb{at<S, 2>(-1, 2), at<S, 2>(3, 2.5)}) == 2);
  CHECK(volume(Aabb{at<S, 3>(-1, 2, 0), at<S, 3>(3, 2.5, 8)}) == 16);
  CHECK(area(Obb<S, 2>{at<S, 2>(9, 9), at<S, 2>(1, 3), {}}) == 12);
  CHECK(volume(Obb<S, 3>{at<S, 3>(9, 9, 9), at<S, 3>(1, 3, 0.5), {}}) == 12);
  CHECK(volume(Aabb{at<S, 3>(-1, 2, 0), at<S, 3>(-2, 1, 8)}) == 0);
  CHECK(area(Obb<S, 2>{at<S, 2>(9, 9), at<S, 2>(-1, -3), {}}) == 0);
}

TEMPLATE_TEST_CASE("area: of any triangle in 3D, rounded down", "[measure][oracle]", q16_16, q14_16,
                   q24_8, q8_8) {
  using S = TestType;
  using oracle::Integer;
  oracle::Draw<S, 3> draw(0xa5ea);
  INFO(draw.random);
  for (int i = 0; i < 10'000; ++i) {
    const auto corner = [&] {
      return draw.vec(draw.random.coin() ? draw.extreme_point() : draw.point(draw.scale()));
    };
    const Triangle<S, 3> triangle{corner(), corner(), corner()};
    const auto a = oracle::raw(triangle.a), b = oracle::raw(triangle.b),
               c = oracle::raw(triangle.c);
    // Heron's formula for squared sides: 16 A^2 = 4 u v - (u + v - w)^2.
    const auto squared = [](const auto& p, const auto& q) {
      const auto d = oracle::difference(p, q);
      return oracle::dot(d, d);
    };
    const Integer u = squared(a, b), v = squared(b, c), w = squared(c, a);
    const Integer sixteen = 4 * u * v - (u + v - w) * (u + v - w);
    // The area in steps of 2^-frac is A 2^-frac raw squares.
    const auto given = area(triangle);
    Integer steps(static_cast<std::int64_t>(given.raw()));
    const Integer unit = Integer(4) << static_cast<unsigned>(S::frac);
    const bool right =
        steps * steps * unit * unit <= sixteen && sixteen < (steps + 1) * (steps + 1) * unit * unit;
    if (!right) FAIL("case " << i << ", got " << steps);
  }
}

/// Whether `given` steps of 2^-frac are nearest to raw * numerator pi / denominator, where raw is
/// in steps of 2^-(frac + shift). pi is bounded by two fractions of 2^-160.
bool is_nearest_to_pi(const oracle::Integer& given, const oracle::Integer& raw, int numerator,
                      int denominator, int shift) {
  const oracle::Integer below("0x3243f6a8885a308d313198a2e03707344a4093822");
  const oracle::Integer scale = oracle::Integer(denominator) << static_cast<unsigned>(160 + shift);
  const oracle::Integer low = 2 * raw * numerator * below;
  const oracle::Integer high = 2 * raw * numerator * (below + 1);
  return (2 * given - 1) * scale <= high && low <= (2 * given + 1) * scale;
}

TEMPLATE_TEST_CASE("area, volume: of discs and balls, to nearest", "[measure][oracle]", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  using oracle::Integer;
  oracle::Draw<S, 3> draw(0xd15c);
  INFO(draw.random);
  for (int i = 0; i < 10'000; ++i) {
    const auto raw = draw.random.coin() ? std::abs(draw.extreme()) : draw.random.between(0, 4096);
    const S radius = draw.scalar(raw);
    const Integer r = oracle::raw(radius);
    const auto flat = area(Sphere<S, 2>{{}, radius});
    const auto full = volume(Sphere<S, 3>{{}, radius});
    INFO("radius " << r);
    CHECK(is_nearest_to_pi(oracle::whole(flat.raw()), r * r, 1, 1, S::frac));
    CHECK(is_nearest_to_pi(oracle::whole(full.raw()), r * r * r, 4, 3, 2 * S::frac));
  }
  CHECK(area(Sphere<S, 2>{{}, S(-1)}) == 0);
  CHECK(volume(Sphere<S, 3>{{}, S(-1)}) == 0);
}

TEMPLATE_TEST_CASE("area, volume: of discs and balls in floating point", "[measure]", float,
                   double) {
  using S = TestType;
  CHECK(area(Sphere<S, 2>{{}, 2}) == Approx(12.566370614));
  CHECK(volume(Sphere<S, 3>{{}, 3}) == Approx(113.097335529));
}

}  // namespace
}  // namespace detent::test
