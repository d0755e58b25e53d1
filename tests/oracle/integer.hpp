// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#ifdef DETENT_ORACLE_SHORT_INTEGERS
#include "oracle/short_integer.hpp"
#else
#include "oracle/long_integer.hpp"
#endif

/// The oracle: the definitions of the shapes, evaluated in exact integers and fractions. It
/// includes nothing of the library and shares none of its formulas, so that a wrong idea cannot
/// confirm itself. `exact.hpp` reads the library's shapes.
namespace detent::oracle {

#ifdef DETENT_ORACLE_SHORT_INTEGERS
using Integer = ShortInteger;
#else
using Integer = LongInteger;
#endif

template <int N>
using Vector = std::array<Integer, static_cast<std::size_t>(N)>;

template <int N>
using Raw = std::array<std::int64_t, static_cast<std::size_t>(N)>;

/// Of integers or rational numbers.
template <class Number, std::size_t N>
Number dot(const std::array<Number, N>& a, const std::array<Number, N>& b) {
  Number sum = 0;
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

template <std::size_t N>
std::array<Integer, N> widen(const std::array<std::int64_t, N>& a) {
  std::array<Integer, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = a[i];
  return result;
}

template <class T, std::size_t N>
std::array<T, N> negated(std::array<T, N> a) {
  for (auto& component : a) component = -component;
  return a;
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

inline Integer floor(const Moment& t) { return floor_quotient(t.over, t.under); }

/// `over / under` rounded to the nearest integer, ties to even, for under != 0.
inline Integer nearest_quotient(const Integer& over, const Integer& under) {
  if (under.sign() < 0) return nearest_quotient(-over, -under);
  const Integer down = floor_quotient(over, under);
  const Integer twice_rest = 2 * (over - down * under);
  const bool odd = (down % 2) != 0;
  return twice_rest > under || (twice_rest == under && odd) ? Integer(down + 1) : down;
}

/// `over / 2^shift` rounded to the nearest integer, ties to even.
inline Integer nearest_even(const Integer& over, int shift) {
  return nearest_quotient(over, Integer(1) << static_cast<unsigned>(shift));
}

}  // namespace detent::oracle
