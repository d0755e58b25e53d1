// SPDX-License-Identifier: MIT
//
// Raycasts in q16_16 and in double, which run the same source, agree within what the error analysis
// of the double allows; where they decide differently, a shape one raw unit larger or smaller
// explains it; a sphere may need more.
//
// A q16_16 is exact in a double, and so is a difference of two and a component of a direction. Every
// operation after that is off by a factor of at most 1 + u, u = 2^-53; terms in u^2 are left out.
//
// Box: the faces are met at quotients of exact numbers, each rounded once; the last one entered is
// found by comparing rounded products, so another is taken for it only if the two agree to 2 u.
// Hence |t_double - t| <= 3 u t. The fixed t is rounded down by less than one raw unit.
//
// Sphere: let M >= |m| |d| for the vector m from the center to the origin, r < |m|, and h = sqrt(D)
// the half chord. With three products each, b = m d and a = d d are off by 3 u M and 3 u, and
// c = |m|^2 - r^2 by (3 + 1) u M^2, for r^2 and c are |m|^2 together. So D = b^2 - a c is off by
// (2 * 3 + 1) u M^2 through b^2 and (3 + 4 + 1) u M^2 through a c: 15 u M^2, and by u h^2 itself.
// Its root is then off by at most 15 u M^2 / h + u h; and t = (-b - h) / a by that, 3 u M for b, u h
// for the root's rounding and (1 + 3 + 1) u t for the difference, a and the quotient: by
// 10 u M + 15 u M^2 / h in all, as t and h are at most M.
//
// The tolerances are not generous: the kept inputs below use more than half of them.

#include <cmath>

#include "decode.hpp"
#include "detent/query/raycast/aabb.hpp"
#include "detent/query/raycast/sphere.hpp"
#include "oracle/describe.hpp"

namespace detent::fuzz {
namespace {

constexpr double unit = 0x1p-16;
constexpr double u = 0x1p-53;

double widened(q16_16 x) { return static_cast<double>(x); }
Vec<double, 3> widened(const Vec<q16_16, 3>& v) {
  return {widened(v.x), widened(v.y), widened(v.z)};
}
Ray<double, 3> widened(const Ray<q16_16, 3>& ray) {
  const auto component = [&](int i) { return static_cast<double>(ray.direction[i]); };
  return {widened(ray.origin),
          Direction<double, 3>::assume_unit({component(0), component(1), component(2)}),
          widened(ray.max_distance)};
}
Aabb<double, 3> widened(const Aabb<q16_16, 3>& box) { return {widened(box.min), widened(box.max)}; }
Sphere<double, 3> widened(const Sphere<q16_16, 3>& sphere) {
  return {widened(sphere.center), widened(sphere.radius)};
}

q16_16 stepped(q16_16 x, int count) {
  return oracle::Draw<q16_16, 3>::scalar(std::int64_t{x.raw()} + count);
}
Aabb<q16_16, 3> stepped(const Aabb<q16_16, 3>& box, int count) {
  auto result = box;
  for (int i = 0; i < 3; ++i) {
    result.min[i] = stepped(box.min[i], -count);
    result.max[i] = stepped(box.max[i], count);
  }
  return result;
}
Sphere<q16_16, 3> stepped(const Sphere<q16_16, 3>& sphere, int count) {
  return {sphere.center, stepped(sphere.radius, count)};
}

/// At least |m| |d|.
double reach(const Ray<q16_16, 3>& ray, const Sphere<q16_16, 3>& sphere) {
  const auto m = widened(ray.origin) - widened(sphere.center);
  return 1.0001 * std::sqrt(dot(m, m));
}

// How many raw units of a shape change more than the rounding of a decision: one moves a box's
// faces by more than 3 u t <= 2^-34, and r^2 must change by more than what D is off by, or by four
// times that where it is the end of the ray that decides.
int explaining_step(const Ray<q16_16, 3>&, const Aabb<q16_16, 3>&, int sign) { return sign; }
int explaining_step(const Ray<q16_16, 3>& ray, const Sphere<q16_16, 3>& sphere, int sign) {
  const double r = widened(sphere.radius), far = reach(ray, sphere);
  const double changed = std::sqrt(std::max(0.0, r * r + sign * 4 * 18 * u * far * far));
  return static_cast<int>((changed - r) / unit) + sign;
}

double rounding(const Ray<q16_16, 3>&, const Aabb<q16_16, 3>&, double t) { return 3 * u * t; }
double rounding(const Ray<q16_16, 3>& ray, const Sphere<q16_16, 3>& sphere, double t) {
  const double far = reach(ray, sphere);
  // The chord from the exact interval, and at least its own rounding short of it.
  const auto interval = raycast_interval(ray, sphere);
  const double half_chord = (widened(interval->exit) - widened(interval->enter) - unit) / 2;
  if (half_chord <= 0 || interval->exit == ray.max_distance) return 2 * far + t;
  return 10 * u * far + 15 * u * far * far / half_chord;
}

/// How much of the tolerance is used up.
template <class Shape>
double used(const Ray<q16_16, 3>& ray, const Shape& shape) {
  const auto exact = raycast(ray, shape);
  const auto close = raycast(widened(ray), widened(shape));
  if (!exact || !close) return 0;
  const double excess = *close - widened(*exact), allowed = rounding(ray, shape, *close);
  return excess < 0 ? -excess / allowed : excess / (unit + allowed);
}

template <class Shape>
void check(Decoder<q16_16, 3>& decoder) {
  const auto shape = decoder.shape<Shape>();
  const auto ray = decoder.shape<Ray<q16_16, 3>>();
  const auto because = [&] { return oracle::describe(ray) + "; " + oracle::describe(shape); };
  require(used(ray, shape) <= 1, because);
  const bool hits = raycast(ray, shape).has_value();
  if (raycast(widened(ray), widened(shape)).has_value() != hits) {
    const int step = explaining_step(ray, shape, hits ? -1 : 1);
    const auto other = stepped(shape, step);
    if (stepped(other, -step) != shape) return;  // at an end of the range
    require(raycast(ray, other).has_value() != hits, because);
  }
}

Direction<q16_16, 3> stored(std::array<std::int32_t, 3> raw) {
  return Direction<q16_16, 3>::from_raw(raw).value();
}
Vec<q16_16, 3> at(std::int32_t x, std::int32_t y, std::int32_t z) {
  return {q16_16::from_raw(x), q16_16::from_raw(y), q16_16::from_raw(z)};
}

/// A face met at t = 5/3, and a sphere of radius 1/392 grazed from 29,000 units away: there the
/// tolerance is 111 raw units.
bool kept_inputs_come_near() {
  const Ray<q16_16, 3> from_origin{at(0, 0, 0), stored({644245094, 858993459, 0})};
  const Aabb<q16_16, 3> box{at(1 << 16, 0, 0), at(2 << 16, 4 << 16, 0)};
  const Ray<q16_16, 3> from_afar{at(-1444981261, -314457718, -1711825233),
                                 stored({-267997917, 957691068, 404878302})};
  const Sphere<q16_16, 3> sphere{at(-1924321472, 1398465691, -987661262), q16_16::from_raw(167)};
  return used(from_origin, box) > 0.5 && used(from_afar, sphere) > 0.5;
}

}  // namespace

void property(Bytes input) {
  static const bool near = kept_inputs_come_near();
  require(near, [] { return std::string("the tolerances are too generous"); });
  Source source(input);
  const bool box = source.below(2) == 0;
  Decoder<q16_16, 3> decoder(source);
  box ? check<Aabb<q16_16, 3>>(decoder) : check<Sphere<q16_16, 3>>(decoder);
}

}  // namespace detent::fuzz
