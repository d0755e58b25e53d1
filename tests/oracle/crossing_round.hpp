// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/crossing.hpp"

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
  [[nodiscard]] int sign_at(const Integer& t) const {
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
  Vector<N> apart;  // from the center to the ray's origin
  Integer radius;
  Outside<N> outside;

  SphereNormal(const Line<N>& ray, const Vector<N>& to_origin, const Integer& exact)
      : line(ray), apart(to_origin), radius(exact), outside(ray, to_origin, exact) {}

  /// Whether every component is within `over / under` units in the last place.
  [[nodiscard]] bool within(const Raw<N>& given, int over, int under) const;
  [[nodiscard]] bool allows(const Raw<N>& given) const override { return within(given, 1, 1); }
  [[nodiscard]] std::string text() const override { return "within one unit of the sphere's"; }
  /// Whether the entry is at t or before it.
  [[nodiscard]] bool entered_by(const Moment& t) const;
  [[nodiscard]] bool entered_before(const Moment& t) const;
};

/// A ray against a capsule by the distance from the axis, a convex function of time, which is
/// compared with the radius at any rational time. No cylinder, no plane and no root.
template <int N>
struct NearAxis {
  Line<N> line;
  Vector<N> start, along;
  Integer radius;

  /// The sign of (distance from the axis at time t - radius).
  [[nodiscard]] int sign_at(const Moment& t) const;
  /// A time at which the ray is in the capsule; strictly inside if there is such a time.
  [[nodiscard]] std::optional<Moment> inside() const;

 private:
  [[nodiscard]] std::vector<Moment> candidates() const;
};

/// The normal where a ray enters points away from the axis: component i is (offset[i] + t slope[i]
/// / one) / length at the time t of entry. Each given component becomes bounds on t; the distance
/// decides on which side of a bound the entry is.
template <int N>
struct CapsuleNormal final : Normal<N> {
  NearAxis<N> near;
  Moment entered;  // at this time, or before it
  Vector<N> offset, slope;
  Integer length;
  /// Allowed error in units of the last place.
  int over = 1, under = 1;

  /// Whether the entry is at t or before it.
  [[nodiscard]] bool entered_by(const Moment& t) const;
  [[nodiscard]] bool entered_before(const Moment& t) const;
  [[nodiscard]] bool within(const Raw<N>& given, int errors, int of) const;
  [[nodiscard]] bool allows(const Raw<N>& given) const override {
    return within(given, over, under);
  }
  [[nodiscard]] std::string text() const override;
};

}  // namespace detent::oracle
