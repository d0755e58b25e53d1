// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>
#include <string>

#include "oracle/boost_integer.hpp"
#include "oracle/exact.hpp"
#include "verify/converted.hpp"
#include "verify/describe.hpp"

// Functions that are not templates are defined in judge.cpp, so that the parts of the corpus do not
// each compile the decimals.

namespace detent::verify::judge {

using oracle::Integer;
using oracle::nearest_quotient;
using Real = boost::multiprecision::cpp_bin_float_100;

struct Wrong {
  std::string expected;
  std::string got;
};

// Where the contract leaves a margin, errors exceed half a unit by so little that only values next
// to a tie have two correct results.

/// The maximum error for rotations, and for normals of spheres (in thousandths).
const Real& rotation_margin();
inline constexpr int normal_margin = 501;

template <class T>
std::optional<Wrong> compare(const T& expected, const T& got) {
  if (expected == got) return std::nullopt;
  return Wrong{words(expected), words(got)};
}

/// An integer as a T, clamped.
template <class T>
T clamped(const Integer& raw) {
  const Integer low = static_cast<std::int64_t>(T::lowest().raw());
  const Integer high = static_cast<std::int64_t>(T::max().raw());
  const auto inside = static_cast<std::int64_t>(raw < low ? low : raw > high ? high : raw);
  return T::from_raw(static_cast<typename T::raw_type>(inside));
}

/// Converts a 32-bit scalar to the q16_16 with the same raw bits: the oracles of shapes work in raw
/// units, so they are compiled for one scalar only.
template <Scalar S, class T>
auto in_raw_units(const T& x) {
  if constexpr (S::bits > 16) {
    return converted<q16_16>(x);
  } else {
    return x;
  }
}
/// Raw units as a vector of scalars, clamped.
template <Number T, std::size_t N>
Vec<T, static_cast<int>(N)> clamped(const std::array<Integer, N>& raw) {
  Vec<T, static_cast<int>(N)> result;
  for (std::size_t i = 0; i < N; ++i) result[static_cast<int>(i)] = clamped<T>(raw[i]);
  return result;
}

inline Integer scaled(const Integer& x, int bits) {
  return x * (Integer(1) << static_cast<unsigned>(bits));
}

/// The nearest integer to a number that is not a tie.
Integer nearest(const Real& x);
Real steps(int frac);
Real real(const Integer& x);
template <int Bits, int Frac>
Real real(const Fixed<Bits, Frac>& x) {
  return Real(static_cast<std::int64_t>(x.raw())) / steps(Frac);
}
const Real& two_pi();
template <Scalar S>
Real radians(Angle<S> angle) {
  return Real(angle.raw()) / steps(32) * two_pi();
}
/// In (-2^31, 2^31], in units of 2^-32 turn.
template <Scalar S>
std::int64_t signed_units(Angle<S> angle) {
  const auto raw = static_cast<std::int64_t>(angle.raw());
  return raw > std::int64_t{1} << 31 ? raw - (std::int64_t{1} << 32) : raw;
}
std::uint32_t wrapped(const Integer& units);

template <Scalar S, int N>
oracle::Raw<N> raw_of(const Vec<S, N>& v) {
  oracle::Raw<N> raw{};
  for (int i = 0; i < N; ++i) {
    raw[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(v[i].raw());
  }
  return raw;
}

}  // namespace detent::verify::judge
