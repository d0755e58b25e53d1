// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#ifdef DETENT_ORACLE_SHORT_INTEGERS
#include "oracle/short_integer.hpp"
#else
#include <boost/multiprecision/cpp_int.hpp>
#endif

#include "detent/math/direction.hpp"
#include "detent/math/vec.hpp"
#include "detent/shape/ray.hpp"

/// The reference for the queries: the definitions of the shapes, evaluated in exact integers and
/// fractions. It may use the library only to read the raw numbers of a shape, and none of its
/// formulas may be the library's own, so that a wrong idea cannot confirm itself.
namespace detent::oracle {

#ifdef DETENT_ORACLE_SHORT_INTEGERS
using Integer = ShortInteger;

/// An instant is 2^-38 of the time of a raw unit. A ray enters a capsule of three-bit coordinates
/// at a grid time or more than an instant away from one: next to a grid time, their parabola of
/// integers below 2^28 * 147 is at least 1, and its slope is at most the length of the ray.
inline constexpr unsigned instant_bits = 38;
#else
/// More than the widest product below; checked, so an overflow throws.
#ifdef DETENT_ORACLE_LONG_INTEGERS
inline constexpr unsigned integer_bits = 1024;
#else
inline constexpr unsigned integer_bits = 512;
#endif
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<integer_bits, integer_bits,
                                           boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::checked, void>,
    boost::multiprecision::et_off>;

/// An instant is 2^-128 of the time of a raw unit.
inline constexpr unsigned instant_bits = 128;
#endif

template <int N>
using Vector = std::array<Integer, static_cast<std::size_t>(N)>;

template <int N>
using Raw = std::array<std::int64_t, static_cast<std::size_t>(N)>;

template <std::size_t N>
Integer dot(const std::array<Integer, N>& a, const std::array<Integer, N>& b) {
  Integer sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

template <std::size_t N>
std::array<Integer, N> difference(const std::array<Integer, N>& a,
                                  const std::array<Integer, N>& b) {
  std::array<Integer, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = a[i] - b[i];
  return result;
}

inline Vector<3> cross(const Vector<3>& a, const Vector<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Integer cross(const Vector<2>& a, const Vector<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

inline bool is_zero(const Integer& a) { return a.is_zero(); }

template <std::size_t N>
bool is_zero(const std::array<Integer, N>& a) {
  for (const auto& component : a) {
    if (!component.is_zero()) return false;
  }
  return true;
}

/// A fraction with a positive denominator: a time along a ray, in raw units.
struct Moment {
  Integer over = 0;
  Integer under = 1;

  static Moment fraction(const Integer& over, const Integer& under) {
    return under.sign() < 0 ? Moment{-over, -under} : Moment{over, under};
  }

  friend bool operator<(const Moment& a, const Moment& b) {
    return a.over * b.under < b.over * a.under;
  }
  friend bool operator==(const Moment& a, const Moment& b) {
    return a.over * b.under == b.over * a.under;
  }
};

/// The largest integer <= `over / under`, for under > 0.
inline Integer floor_quotient(const Integer& over, const Integer& under) {
  Integer quotient = over / under;  // towards zero
  if (over.sign() < 0 && quotient * under != over) --quotient;
  return quotient;
}

inline std::int64_t floor(const Moment& t) {
  return static_cast<std::int64_t>(floor_quotient(t.over, t.under));
}

/// `over / 2^shift` rounded to the nearest integer, ties to even.
inline Integer nearest_even(const Integer& over, int shift) {
  const Integer one = Integer(1) << static_cast<unsigned>(shift);
  const Integer down = floor_quotient(over, one);
  const Integer twice_rest = 2 * (over - down * one);
  const bool odd = (down % 2) != 0;
  return twice_rest > one || (twice_rest == one && odd) ? down + 1 : down;
}

template <Scalar S, int N>
Vector<N> raw(const Vec<S, N>& v) {
  Vector<N> result;
  for (int i = 0; i < N; ++i) {
    result[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(v[i].raw());
  }
  return result;
}

template <Scalar S, int N>
Raw<N> raw(const Direction<S, N>& direction) {
  Raw<N> result;
  for (int i = 0; i < N; ++i) {
    result[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(direction[i].raw());
  }
  return result;
}

template <std::size_t N>
std::array<Integer, N> widen(const std::array<std::int64_t, N>& a) {
  std::array<Integer, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = a[i];
  return result;
}

template <std::size_t N>
std::array<std::int64_t, N> negated(std::array<std::int64_t, N> a) {
  for (auto& component : a) component = -component;
  return a;
}

template <Scalar S>
Integer raw(S value) {
  return static_cast<std::int64_t>(value.raw());
}

/// The raw bits of a number of any width.
template <class I>
Integer whole(const I& raw) {
  if constexpr (sizeof(I) <= sizeof(std::int64_t)) {
    return static_cast<std::int64_t>(raw);
  } else {
    constexpr int words = static_cast<int>(sizeof(I) / sizeof(std::uint64_t));
    const Wide<words> wide(raw);
    const Wide<words> magnitude = wide.is_negative() ? -wide : wide;
    Integer result = 0;
    for (int i = words - 1; i >= 0; --i) result = (result << 64) + magnitude.word(i);
    return wide.is_negative() ? Integer(-result) : result;
  }
}

/// A ray in raw units: the point at time t is `origin + t * direction / one`, 0 <= t <= max.
template <int N>
struct Line {
  Vector<N> origin;
  Vector<N> direction;
  Integer one;
  Integer max;
  Raw<N> raw_direction;
  int shift = 0;
  std::int64_t lowest = 0;
  std::int64_t highest = 0;
};

template <Scalar S, int N>
Line<N> line(const Ray<S, N>& ray) {
  Line<N> result;
  result.origin = raw(ray.origin);
  result.raw_direction = raw(ray.direction);
  result.direction = widen(result.raw_direction);
  result.shift = direction_component<S>::frac;
  result.one = Integer(1) << static_cast<unsigned>(result.shift);
  result.max = raw(ray.max_distance);
  result.lowest = static_cast<std::int64_t>(S::lowest().raw());
  result.highest = static_cast<std::int64_t>(S::max().raw());
  return result;
}

}  // namespace detent::oracle
