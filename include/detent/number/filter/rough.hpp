// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/number/filter/leading.hpp"
#include "detent/number/rounding.hpp"

namespace detent {

/// The leading bits of a number >= 0, word * 2^exponent: the filter's value for roots and quotients
/// of long integers. The top bit of the word is set unless the number is 0.
///
/// Sums, products and quotients of a dozen exact numbers have a relative error below 2^-56, below
/// 2^-42 with square roots among them. Before deciding, a caller checks whether that error could
/// matter. If so, it computes the exact number.
struct Rough {
  std::uint64_t word = 0;
  int exponent = 0;

  constexpr Rough() noexcept = default;
  template <int B, int F>
  explicit constexpr Rough(const Fixed<B, F>& x) noexcept {
    const auto leading = detail::leading_word(x.raw());
    word = leading.word;
    exponent = leading.exponent - F;
  }

  [[nodiscard]] friend constexpr Rough operator+(const Rough& a, const Rough& b) noexcept {
    if (a.exponent < b.exponent ? b.word != 0 : a.word == 0) return sum(b, a);
    return sum(a, b);
  }
  [[nodiscard]] friend constexpr Rough operator*(const Rough& a, const Rough& b) noexcept {
    return Rough(multiply_words(a.word, b.word).high, a.exponent + b.exponent + 64);
  }
  /// `b` must not be 0.
  [[nodiscard]] friend constexpr Rough operator/(const Rough& a, const Rough& b) noexcept {
    const auto high = multiply_words(a.word, detail::reciprocal(b.word)).high;
    return Rough(high, a.exponent - b.exponent - 62);
  }
  [[nodiscard]] friend constexpr Rough sqrt(const Rough& x) noexcept {
    if (x.word == 0) return x;
    const std::uint64_t even = x.word >> (x.exponent & 1);
    const auto high = multiply_words(even, detail::reciprocal_root(even)).high;
    return Rough(high, ((x.exponent + 1) >> 1) - 30);
  }

  /// The sign of a - b; 0 where a relative error of 2^-Bits could change it.
  template <int Bits>
  [[nodiscard]] static constexpr int compare(const Rough& a, const Rough& b) noexcept {
    const int excess = a.exponent - b.exponent;
    const auto x = static_cast<std::int64_t>((a.word >> 1) >> std::clamp(-excess, 0, 63));
    const auto y = static_cast<std::int64_t>((b.word >> 1) >> std::clamp(excess, 0, 63));
    constexpr std::int64_t margin = std::int64_t{1} << (64 - Bits);
    return x - y > margin ? 1 : y - x > margin ? -1 : 0;
  }

  /// The number times 2^Frac, rounded down; the product must be below 2^62.
  template <int Frac>
  [[nodiscard]] constexpr std::int64_t scaled() const noexcept {
    return static_cast<std::int64_t>(word >> std::clamp(-exponent - Frac, 0, 63));
  }

 private:
  constexpr Rough(std::uint64_t bits, int scale) noexcept {
    const int zeros = std::countl_zero(bits) & 63;
    word = bits << zeros;
    exponent = scale - zeros;
  }

  /// a + b, where a has the greater exponent or b is 0.
  [[nodiscard]] static constexpr Rough sum(const Rough& a, const Rough& b) noexcept {
    Rough result = a;
    result.word += b.word >> std::clamp(a.exponent - b.exponent, 0, 63);
    if (result.word < a.word) {
      result.word = (result.word >> 1) | (std::uint64_t{1} << 63);
      ++result.exponent;
    }
    return result;
  }
};

/// `x` rounded down to the grid of `T`; nothing where a relative error of 2^-42 could change it.
template <class T>
[[nodiscard]] constexpr std::optional<T> floor_of(const Rough& x) noexcept {
  const int dropped = -(x.exponent + T::frac);
  if (x.word == 0 || dropped <= 64 - T::bits || dropped > 64) return std::nullopt;
  const std::uint64_t margin = x.word >> 42;
  const std::uint64_t below = x.word - margin, above = x.word + margin;
  if (above < x.word) return std::nullopt;
  const auto floor = [&](std::uint64_t word) { return dropped == 64 ? 0 : word >> dropped; };
  if (floor(below) != floor(above)) return std::nullopt;
  return T::assume_raw(static_cast<typename T::raw_type>(floor(below)));
}

/// p x - q y rounded to the nearest point of the grid of `T`; nothing where an error of 2^-42 could
/// change it. |p x| and |q y| are at most 1.
template <class T, int BX, int FX, int BY, int FY>
[[nodiscard]] constexpr std::optional<T> nearest_difference(const Rough& p, const Fixed<BX, FX>& x,
                                                            const Rough& q,
                                                            const Fixed<BY, FY>& y) noexcept {
  constexpr int frac = 60, guard = frac - T::frac;
  const auto term = [](const Rough& factor, const auto& number) {
    const std::int64_t magnitude = (factor * Rough(abs(number))).template scaled<frac>();
    return number < 0 ? -magnitude : magnitude;
  };
  const std::int64_t raised = term(p, x) - term(q, y) + (std::int64_t{1} << (guard - 1));
  constexpr std::int64_t margin = std::int64_t{1} << (frac - 42);
  const std::int64_t nearest = (raised - margin) >> guard;
  if (nearest != (raised + margin) >> guard) return std::nullopt;
  return T::assume_raw(static_cast<typename T::raw_type>(nearest));
}

/// The sign of |v| - length, for a length >= 0.
template <Number T, std::size_t N, Number L>
[[nodiscard]] constexpr int compare_length(const std::array<T, N>& v, const L& length) noexcept {
  if constexpr (127 < 2 * bits_of<T> + 2 || 127 < 2 * bits_of<L>) {
    Rough squared;
    for (const auto& c : v) squared = squared + Rough(abs(c)) * Rough(abs(c));
    const int sign = Rough::compare<56>(squared, Rough(length) * Rough(length));
    if (sign != 0) return sign;
  }
  const auto sign = [&](const auto& squared) {
    return (squared > square(length)) - (squared < square(length));
  };
  const auto two = square(v[0]) + square(v[1]);
  if constexpr (N == 2) {
    return sign(two);
  } else {
    return sign(two + square(v[2]));
  }
}

}  // namespace detent
