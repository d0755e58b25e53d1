// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "detent/shape/capsule.hpp"
#include "oracle/answer.hpp"
#include "oracle/point.hpp"

namespace detent::oracle {

/// A ray against a capsule by the distance from the axis, a convex function of time, which is
/// compared with the radius at any rational time. No cylinder, no plane and no root.
template <int N>
struct NearAxis {
  Line<N> line;
  Vector<N> start, along;
  Integer radius;

  /// The sign of (distance from the axis at time t - radius).
  [[nodiscard]] int sign_at(const Moment& t) const {
    const Integer unit = line.one * t.under;
    Vector<N> apart;  // from the start of the axis, in steps of 1 / unit
    for (std::size_t i = 0; i < apart.size(); ++i) {
      apart[i] = (line.origin[i] - start[i]) * unit + line.direction[i] * t.over;
    }
    const Integer whole = dot(along, along), way = dot(apart, along);
    const Integer reach = radius * unit;
    if (way > 0 && way < whole * unit) {
      return Integer((dot(apart, apart) - reach * reach) * whole - way * way).sign();
    }
    if (way > 0) {
      for (std::size_t i = 0; i < apart.size(); ++i) apart[i] -= along[i] * unit;
    }
    return Integer(dot(apart, apart) - reach * reach).sign();
  }

  /// Times that include one of least distance: the ends of the ray, where it passes the ends of the
  /// axis, and where the two lines are closest, by Cramer's rule.
  [[nodiscard]] std::vector<Moment> candidates() const {
    std::vector<Moment> times{{0, 1}, {line.max, 1}};
    const auto& d = line.direction;
    const Integer dd = dot(d, d), de = dot(d, along), ee = dot(along, along);
    auto apart = difference(line.origin, start);
    const Integer dm = dot(d, apart), em = dot(along, apart);
    times.push_back(Moment{-dm * line.one, dd});
    times.push_back(Moment{(de - dm) * line.one, dd});
    const Integer whole = dd * ee - de * de;
    if (!whole.is_zero()) times.push_back(Moment{(de * em - ee * dm) * line.one, whole});
    return times;
  }

  /// A time at which the ray is in the capsule; strictly inside if there is such a time.
  [[nodiscard]] std::optional<Moment> inside() const {
    std::optional<Moment> touching;
    for (const auto& t : candidates()) {
      if (t.over < 0 || Moment{line.max, 1} < t) continue;
      const int sign = sign_at(t);
      if (sign < 0) return t;
      if (sign == 0 && !touching) touching = t;
    }
    return touching;
  }
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
  [[nodiscard]] bool entered_by(const Moment& t) const {
    return !(t < entered) || near.sign_at(t) <= 0;
  }
  [[nodiscard]] bool entered_before(const Moment& t) const {
    return entered < t || near.sign_at(t) < 0;
  }
  [[nodiscard]] bool within(const Raw<N>& given, int errors, int of) const {
    const Integer& one = near.line.one;
    for (std::size_t i = 0; i < given.size(); ++i) {
      const Integer start = offset[i] * one * of;
      const Integer low = (Integer(given[i]) * of - errors) * length - start;
      const Integer high = (Integer(given[i]) * of + errors) * length - start;
      const int sign = slope[i].sign();
      if (sign == 0) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      const Integer rate = slope[i] * of;
      if (entered_before(Moment::fraction(sign > 0 ? low : high, rate))) return false;
      if (!entered_by(Moment::fraction(sign > 0 ? high : low, rate))) return false;
    }
    return true;
  }
  [[nodiscard]] bool allows(const Raw<N>& given) const override {
    return within(given, over, under);
  }
  [[nodiscard]] std::string text() const override {
    return "within " + std::to_string(over) + " / " + std::to_string(under) +
           " units of the capsule's";
  }
};

/// The normal for the part of the axis closest to the entry: its start, its end, or the segment
/// between, for which the ray's origin and direction are projected perpendicular to the axis.
template <int N>
NormalPointer<N> capsule_normal(const NearAxis<N>& near, const Moment& inside) {
  auto normal = std::make_shared<CapsuleNormal<N>>();
  normal->near = near;
  normal->entered = inside;
  const auto& e = near.along;
  const auto& d = near.line.direction;
  const auto apart = difference(near.line.origin, near.start);
  const Integer ee = dot(e, e), way = dot(apart, e) * near.line.one, rate = dot(d, e);
  // The position along the axis at the entry is way + t rate, in steps of 1 / one; is it > `mark`?
  const auto is_beyond = [&](const Integer& mark) {
    if (rate.is_zero()) return way > mark;
    const auto t = Moment::fraction(mark - way, rate);
    return rate > 0 ? !normal->entered_by(t) : normal->entered_before(t);
  };
  normal->offset = apart;
  normal->slope = d;
  normal->length = near.radius;
  if (is_beyond(ee * near.line.one)) {
    normal->offset = difference(apart, e);
  } else if (is_beyond(0)) {
    for (std::size_t i = 0; i < e.size(); ++i) {
      normal->offset[i] = apart[i] * ee - e[i] * dot(apart, e);
      normal->slope[i] = d[i] * ee - e[i] * rate;
    }
    normal->length = near.radius * ee;
    normal->over = 501;
    normal->under = 1000;
  }
  return normal;
}

template <Scalar S, int N>
Expected<N> expected_raycast(const Ray<S, N>& ray, const Capsule<S, N>& capsule) {
  const auto start = raw(capsule.a);
  const NearAxis<N> near{oracle::line(ray), start, difference(raw(capsule.b), start),
                         raw(capsule.radius)};
  if (near.radius < 0 || near.line.max < 0) return {};
  const auto inside = near.inside();
  if (!inside) return {};
  const std::int64_t within = floor(*inside);
  const auto is_outside = [&](std::int64_t t) { return near.sign_at({t, 1}) > 0; };
  const bool starts_inside = !is_outside(0);

  // The last raw number before the entry; or the next one, if the ray enters exactly there.
  std::int64_t enter = 0;
  if (!starts_inside) {
    for (std::int64_t beyond = within + 1; beyond - enter > 1;) {
      const std::int64_t middle = enter + (beyond - enter) / 2;
      (is_outside(middle) ? enter : beyond) = middle;
    }
    const Integer parts = Integer(1) << instant_bits;
    const Moment just_before{(Integer(enter) + 1) * parts - 1, parts};
    if (enter < within && near.sign_at(just_before) > 0) ++enter;
  }
  // The last raw number not past the exit.
  const auto max = static_cast<std::int64_t>(near.line.max);
  std::int64_t exit = within;
  if (!is_outside(max)) exit = max;
  for (std::int64_t beyond = max; beyond - exit > 1;) {
    const std::int64_t middle = exit + (beyond - exit) / 2;
    (is_outside(middle) ? beyond : exit) = middle;
  }
  const bool has_normal = !starts_inside && near.radius > 0;
  return hit<N>(near.line, enter, exit,
                has_normal ? capsule_normal(near, *inside) : against(near.line));
}

}  // namespace detent::oracle
