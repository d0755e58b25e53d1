// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace detent::verify {

// Inputs are built from plain integers, without the library under test: if `normalize` is broken,
// only the rows that call it may differ.

/// A point or vector in raw units, with room for sums and small multiples.
template <int N>
struct Raw {
  std::int64_t at[N]{};

  constexpr std::int64_t& operator[](int i) noexcept { return at[i]; }
  constexpr const std::int64_t& operator[](int i) const noexcept { return at[i]; }

  constexpr Raw& operator+=(const Raw& other) noexcept {
    for (int i = 0; i < N; ++i) at[i] += other.at[i];
    return *this;
  }
  friend constexpr Raw operator+(Raw a, const Raw& b) noexcept { return a += b; }
  friend constexpr Raw operator-(Raw a, const Raw& b) noexcept { return a += b * -1; }
  friend constexpr Raw operator*(Raw a, std::int64_t factor) noexcept {
    for (int i = 0; i < N; ++i) a.at[i] *= factor;
    return a;
  }
};

/// floor(sqrt(n)), bit by bit.
constexpr std::uint64_t root(std::uint64_t n) noexcept {
  std::uint64_t result = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 62; bit != 0; bit >>= 2) {
    if (n >= result + bit) {
      n -= result + bit;
      result = (result >> 1) + bit;
    } else {
      result >>= 1;
    }
  }
  return result;
}

constexpr std::uint64_t magnitude(std::int64_t x) noexcept {
  return static_cast<std::uint64_t>(x < 0 ? -x : x);
}

template <int N>
constexpr std::uint64_t longest(const Raw<N>& v) noexcept {
  std::uint64_t result = 0;
  for (int i = 0; i < N; ++i) result = magnitude(v[i]) > result ? magnitude(v[i]) : result;
  return result;
}

/// `v` scaled by a power of two until its longest component has 31 bits.
template <int N>
constexpr Raw<N> levelled(const Raw<N>& v) noexcept {
  const int length = static_cast<int>(std::bit_width(longest(v)));
  const int up = length < 31 ? 31 - length : 0, down = length > 31 ? length - 31 : 0;
  Raw<N> result;
  for (int i = 0; i < N; ++i) {
    const auto component = static_cast<std::int64_t>((magnitude(v[i]) >> down) << up);
    result[i] = v[i] < 0 ? -component : component;
  }
  return result;
}

template <int N>
constexpr std::uint64_t squared(const Raw<N>& v) noexcept {
  std::uint64_t sum = 0;
  for (int i = 0; i < N; ++i) sum += magnitude(v[i]) * magnitude(v[i]);
  return sum;
}

/// The length of `v`, rounded down; above 2^31 the length of its longest component.
template <int N>
constexpr std::int64_t length(const Raw<N>& v) noexcept {
  const auto size = longest(v);
  return static_cast<std::int64_t>(size < std::uint64_t{1} << 31 ? root(squared(v)) : size);
}

/// The unit vector along `v` in steps of 1/one, its length off by less than two steps; the x axis
/// for the zero vector.
template <int N>
constexpr Raw<N> unit(const Raw<N>& v, std::int64_t one) noexcept {
  Raw<N> result;
  result[0] = one;
  const auto level = levelled(v);
  const auto size = root(squared(level));
  if (size == 0) return result;
  for (int i = 0; i < N; ++i) {
    const auto twice = (2 * magnitude(level[i]) * static_cast<std::uint64_t>(one) / size + 1) / 2;
    const auto component = static_cast<std::int64_t>(twice) > one  // the root was rounded down
                               ? one
                               : static_cast<std::int64_t>(twice);
    result[i] = level[i] < 0 ? -component : component;
  }
  return result;
}

/// Orthogonal integer axes, each of length `norm`.
///
/// Where `norm` divides 2^f - 1, 2^f or 2^f + 1, a multiple of an axis is a direction with f
/// fractional bits and exactly parallel to it, so that tangents, shared edges and parallels are
/// exact.
template <int N>
struct Frame {
  Raw<N> axes[N];
  std::int64_t norm;
};

inline constexpr Frame<2> frames_2d[] = {
    {{{{1, 0}}, {{0, 1}}}, 1},       {{{{4, 3}}, {{-3, 4}}}, 5},      {{{{12, 5}}, {{-5, 12}}}, 13},
    {{{{24, 7}}, {{-7, 24}}}, 25},   {{{{21, 20}}, {{-20, 21}}}, 29}, {{{{40, 9}}, {{-9, 40}}}, 41},
    {{{{60, 11}}, {{-11, 60}}}, 61}, {{{{1, 0}}, {{0, 1}}}, 1}};
inline constexpr Frame<3> frames_3d[] = {
    {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, 1},    {{{{1, 2, 2}}, {{2, 1, -2}}, {{2, -2, 1}}}, 3},
    {{{{2, 3, 6}}, {{3, -6, 2}}, {{6, 2, -3}}}, 7},  {{{{1, 4, 8}}, {{4, 7, -4}}, {{8, -4, 1}}}, 9},
    {{{{2, 6, 9}}, {{6, 7, -6}}, {{9, -6, 2}}}, 11}, {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, 1}};

/// How many steps of 1/one a unit of an axis of this norm has; 0 when that is not whole to within
/// one step over the axis.
constexpr std::int64_t steps_per_unit(std::int64_t norm, std::int64_t one) noexcept {
  for (std::int64_t length = one - 1; length <= one + 1; ++length) {
    if (length % norm == 0 && (norm == 1 ? length == one : true)) return length / norm;
  }
  return 0;
}

}  // namespace detent::verify
