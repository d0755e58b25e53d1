// SPDX-License-Identifier: MIT
#include "oracle/crossing_round.hpp"

#include <algorithm>

#include "oracle/crossing_parts.hpp"

namespace detent::oracle {
namespace {

#ifdef DETENT_ORACLE_SHORT_INTEGERS
/// An instant is 2^-38 of the time of a raw unit. A ray enters a capsule of three-bit coordinates
/// at a grid time or more than an instant away from one: next to a grid time, their parabola of
/// integers below 2^28 * 147 is at least 1, and its slope is at most the length of the ray.
constexpr unsigned instant_bits = 38;
#else
/// An instant is 2^-128 of the time of a raw unit.
constexpr unsigned instant_bits = 128;
#endif

/// The last integer of [from, beyond) that satisfies `holds`, given that all before it do. `guess`
/// only saves steps.
template <class Holds>
Integer last_where(Integer from, Integer beyond, const Integer& guess, Holds holds) {
  for (const int step : {-1, 2}) {
    const Integer next = guess + step;
    if (from < next && next < beyond) (holds(next) ? from : beyond) = next;
  }
  while (beyond - from > 1) {
    const Integer middle = from + (beyond - from) / 2;
    (holds(middle) ? from : beyond) = middle;
  }
  return from;
}

/// About half the time between entry and exit.
template <int N>
Integer half_chord([[maybe_unused]] const Outside<N>& outside) {
#ifdef DETENT_ORACLE_SHORT_INTEGERS
  return 0;  // their squares are too long, and few steps are left to save
#else
  const Integer square = outside.b * outside.b - outside.a * outside.c;
  return square.sign() < 0 ? Integer(0) : Integer(sqrt(square) / outside.a);
#endif
}

/// Whether every component of `given`, in units of the last place, is within over / under of
/// (offset[i] + t slope[i] / one) / length for the t that the predicates bound.
template <int N, class Normal>
bool is_near(const Normal& normal, const Raw<N>& given, const Vector<N>& offset,
             const Vector<N>& slope, const Integer& one, const Integer& length, int over,
             int under) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Integer start = offset[i] * one * under;
    const Integer low = (Integer(given[i]) * under - over) * length - start;
    const Integer high = (Integer(given[i]) * under + over) * length - start;
    const int sign = slope[i].sign();
    if (sign == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    const Integer rate = slope[i] * under;
    if (normal.entered_before(Moment::fraction(sign > 0 ? low : high, rate))) return false;
    if (!normal.entered_by(Moment::fraction(sign > 0 ? high : low, rate))) return false;
  }
  return true;
}

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

}  // namespace

template <int N>
bool SphereNormal<N>::entered_by(const Moment& t) const {
  return !(t < outside.lowest()) || outside.sign_at(t) <= 0;
}
template <int N>
bool SphereNormal<N>::entered_before(const Moment& t) const {
  return outside.lowest() < t || outside.sign_at(t) < 0;
}
template <int N>
bool SphereNormal<N>::within(const Raw<N>& given, int over, int under) const {
  return is_near<N>(*this, given, apart, line.direction, line.one, radius, over, under);
}

/// The time of closest approach decides. The distances come from a search over the raw numbers, on
/// which the parabola falls before that time and rises after it.
template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Ball<N>& ball) {
  if (ball.radius < 0) return {};
  const auto apart = difference(line.origin, ball.center);
  const Outside<N> outside(line, apart, ball.radius);
  const Moment closest = outside.lowest(), end{line.max, 1};
  const bool inside = outside.sign_at(Integer(0)) <= 0;
  if (!inside && (closest.over <= 0 || outside.sign_at(std::min(closest, end)) > 0)) return {};

  const Integer middle = floor(closest), half = half_chord(outside);
  const Integer bottom = std::clamp<Integer>(middle, 0, line.max);
  Integer enter = 0;
  if (!inside) {
    enter = last_where(0, bottom + 1, middle - half,
                       [&](const Integer& t) { return outside.sign_at(t) >= 0; });
  }
  Integer exit = line.max;
  if (outside.sign_at(exit) > 0) {
    exit = last_where(bottom, line.max, middle + half,
                      [&](const Integer& t) { return outside.sign_at(t) <= 0; });
  }
  if (inside || ball.radius == 0) return Crossing<N>{enter, exit, against(line)};
  return Crossing<N>{enter, exit, std::make_shared<SphereNormal<N>>(line, apart, ball.radius)};
}

template <int N>
int NearAxis<N>::sign_at(const Moment& t) const {
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
template <int N>
std::vector<Moment> NearAxis<N>::candidates() const {
  std::vector<Moment> times{{0, 1}, {line.max, 1}};
  const auto& d = line.direction;
  const Integer dd = dot(d, d), de = dot(d, along), ee = dot(along, along);
  const auto apart = difference(line.origin, start);
  const Integer dm = dot(d, apart), em = dot(along, apart);
  times.push_back(Moment{-dm * line.one, dd});
  times.push_back(Moment{(de - dm) * line.one, dd});
  const Integer whole = dd * ee - de * de;
  if (!whole.is_zero()) times.push_back(Moment{(de * em - ee * dm) * line.one, whole});
  return times;
}

template <int N>
std::optional<Moment> NearAxis<N>::inside() const {
  std::optional<Moment> touching;
  for (const auto& t : candidates()) {
    if (t.over < 0 || Moment{line.max, 1} < t) continue;
    const int sign = sign_at(t);
    if (sign < 0) return t;
    if (sign == 0 && !touching) touching = t;
  }
  return touching;
}

template <int N>
bool CapsuleNormal<N>::entered_by(const Moment& t) const {
  return !(t < entered) || near.sign_at(t) <= 0;
}
template <int N>
bool CapsuleNormal<N>::entered_before(const Moment& t) const {
  return entered < t || near.sign_at(t) < 0;
}
template <int N>
bool CapsuleNormal<N>::within(const Raw<N>& given, int errors, int of) const {
  return is_near<N>(*this, given, offset, slope, near.line.one, length, errors, of);
}
template <int N>
std::string CapsuleNormal<N>::text() const {
  return "within " + std::to_string(over) + " / " + std::to_string(under) +
         " units of the capsule's";
}

template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Pill<N>& pill) {
  const auto& [start, end] = pill.core;
  const NearAxis<N> near{line, start, difference(end, start), pill.radius};
  if (near.radius < 0) return {};
  const auto inside = near.inside();
  if (!inside) return {};
  const Integer within = floor(*inside);
  const auto is_outside = [&](const Integer& t) { return near.sign_at({t, 1}) > 0; };
  const bool starts_inside = !is_outside(0);

  // The last raw number before the entry; or the next one, if the ray enters exactly there.
  Integer enter = 0;
  if (!starts_inside) {
    enter = last_where(0, within + 1, within, is_outside);
    const Integer parts = Integer(1) << instant_bits;
    const Moment just_before{(enter + 1) * parts - 1, parts};
    if (enter < within && near.sign_at(just_before) > 0) ++enter;
  }
  Integer exit = line.max;
  if (is_outside(exit)) {
    exit = last_where(within, line.max, within, [&](const Integer& t) { return !is_outside(t); });
  }
  const bool has_normal = !starts_inside && near.radius > 0;
  return Crossing<N>{enter, exit, has_normal ? capsule_normal(near, *inside) : against(line)};
}

template struct SphereNormal<2>;
template struct SphereNormal<3>;
template struct NearAxis<2>;
template struct NearAxis<3>;
template struct CapsuleNormal<2>;
template struct CapsuleNormal<3>;
template MaybeCrossing<2> crossing_of(const Line<2>&, const Ball<2>&);
template MaybeCrossing<3> crossing_of(const Line<3>&, const Ball<3>&);
template MaybeCrossing<2> crossing_of(const Line<2>&, const Pill<2>&);
template MaybeCrossing<3> crossing_of(const Line<3>&, const Pill<3>&);

}  // namespace detent::oracle
