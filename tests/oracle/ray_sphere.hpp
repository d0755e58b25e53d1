// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/shape/sphere.hpp"
#include "oracle/answer.hpp"

namespace detent::oracle {

/// Squared distance of the ray from the center less radius^2: a parabola over time.
template <int N>
struct Outside {
  Integer a, b, c;  // a t^2 + 2 b t + c

  Outside(const Line<N>& line, const Vector<N>& apart, const Integer& radius)
      : a(dot(line.direction, line.direction)),
        b(dot(apart, line.direction) * line.one),
        c((dot(apart, apart) - radius * radius) * line.one * line.one) {}

  [[nodiscard]] Moment lowest() const { return {-b, a}; }
  [[nodiscard]] int sign_at(std::int64_t t) const {
    return Integer((a * t + 2 * b) * t + c).sign();
  }
  [[nodiscard]] int sign_at(const Moment& t) const {
    return Integer((a * t.over + 2 * b * t.under) * t.over + c * t.under * t.under).sign();
  }
};

/// A sphere's normal has irrational components: the ray enters at the time t, and component i is
/// `(apart[i] * one + t * direction[i]) / radius`. Each given component becomes bounds on t; the
/// parabola decides on which side of a bound t is.
template <int N>
struct SphereNormal final : Normal<N> {
  Line<N> line;
  Vector<N> apart;  // from the centre to the ray's origin
  Integer radius;
  Outside<N> outside;

  SphereNormal(Line<N> ray, Vector<N> to_origin, Integer exact, Outside<N> parabola)
      : line(std::move(ray)),
        apart(std::move(to_origin)),
        radius(std::move(exact)),
        outside(std::move(parabola)) {}

  [[nodiscard]] bool entered_by(const Moment& t) const {
    return !(t < outside.lowest()) || outside.sign_at(t) <= 0;
  }
  [[nodiscard]] bool entered_before(const Moment& t) const {
    return outside.lowest() < t || outside.sign_at(t) < 0;
  }
  /// Whether every component is within `over / under` units in the last place.
  [[nodiscard]] bool within(const Raw<N>& given, int over, int under) const {
    for (std::size_t i = 0; i < given.size(); ++i) {
      const Integer offset = apart[i] * line.one * under;
      const Integer low = (Integer(given[i]) * under - over) * radius - offset;
      const Integer high = (Integer(given[i]) * under + over) * radius - offset;
      const int sign = line.direction[i].sign();
      if (sign == 0) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      const Integer slope = line.direction[i] * under;
      if (entered_before(Moment::fraction(sign > 0 ? low : high, slope))) return false;
      if (!entered_by(Moment::fraction(sign > 0 ? high : low, slope))) return false;
    }
    return true;
  }
  [[nodiscard]] bool allows(const Raw<N>& given) const override { return within(given, 1, 1); }
  [[nodiscard]] std::string text() const override { return "within one unit of the sphere's"; }
};

/// No root is taken: the time of closest approach decides, and the distances come from bisection
/// over the raw numbers, on which the parabola falls before that time and rises after it.
template <Scalar S, int N>
Expected<N> expected_raycast(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {
  const auto line = oracle::line(ray);
  const Integer radius = raw(sphere.radius);
  if (radius < 0 || line.max < 0) return {};

  const auto apart = difference(line.origin, raw(sphere.center));
  const Outside<N> outside(line, apart, radius);
  const auto max = static_cast<std::int64_t>(line.max);
  const Moment closest = outside.lowest();
  const bool inside = outside.sign_at(0) <= 0;
  if (!inside) {
    if (closest.over <= 0) return {};
    if (outside.sign_at(std::min(closest, Moment{line.max, 1})) > 0) return {};
  }

  const std::int64_t bottom = closest.over <= 0               ? 0
                              : Moment{line.max, 1} < closest ? max
                                                              : floor(closest);
  // The last raw number not past the entry.
  std::int64_t enter = 0;
  for (std::int64_t beyond = bottom + 1; !inside && beyond - enter > 1;) {
    const std::int64_t middle = enter + (beyond - enter) / 2;
    (outside.sign_at(middle) >= 0 ? enter : beyond) = middle;
  }
  // The last raw number not past the exit.
  std::int64_t exit = bottom;
  if (outside.sign_at(max) <= 0) exit = max;
  for (std::int64_t beyond = max; beyond - exit > 1;) {
    const std::int64_t middle = exit + (beyond - exit) / 2;
    (outside.sign_at(middle) <= 0 ? exit : beyond) = middle;
  }
  if (inside || radius == 0) return hit(line, enter, exit, against(line));
  return hit<N>(line, enter, exit, std::make_shared<SphereNormal<N>>(line, apart, radius, outside));
}

}  // namespace detent::oracle
