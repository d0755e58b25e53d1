// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/number/filter/filtered.hpp"

namespace detent {

namespace detail {

/// floor(a b / 2^64).
[[nodiscard]] constexpr std::int64_t high_word(std::int64_t a, std::int64_t b) noexcept {
  return integer_cast<std::int64_t>(shift_right_floor(wrapping_multiply<Int128>(a, b), 64));
}

/// For x >= 0: word * 2^exponent <= x < (word + 1) * 2^exponent. The top bit of the word is set
/// unless x is 0.
struct LeadingWord {
  std::uint64_t word;
  int exponent;
};

template <class Int>
[[nodiscard]] constexpr LeadingWord leading_word(const Int& x) noexcept {
  if constexpr (words_of<Int> == 1) {
    const auto word = static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
    const int scale = std::countl_zero(word) & 63;
    return {word << scale, -scale};
  } else {
    const int exponent = positive_bit_length(x) - 64;
    return {integer_cast<std::uint64_t>(exponent < 0 ? shift_left(x, -exponent & 63)
                                                     : shift_right_floor(x, exponent)),
            exponent};
  }
}

/// floor(x / 2^(length - 64)) for 0 <= x < 2^length: its leading 64 bits.
template <class Int>
[[nodiscard]] constexpr std::uint64_t leading_word(const Int& x, int length) noexcept {
  if constexpr (words_of<Int> == 1) {
    return static_cast<std::uint64_t>(x) << (64 - length);
  } else {
    constexpr int words = words_of<Int>;
    return Wide<words>(shift_left(x, 64 * words - length)).word(words - 1);
  }
}

/// 2^126 / x for x >= 2^63, rounded down to within 2^-58 of it.
///
/// Dividing by one more than the leading half of x gives 33 bits, too small by less than
/// 2^-31 + 2^-32. A Newton step squares that error and stays below.
[[nodiscard]] constexpr std::uint64_t reciprocal(std::uint64_t x) noexcept {
  const std::uint64_t first = ~std::uint64_t{0} / ((x >> 32) + 1);
  constexpr std::uint64_t below_one = (std::uint64_t{1} << 62) - 1;
  const std::uint64_t missing = below_one - multiply_words(x, first << 30).high;
  return (first << 30) + ((first * (missing >> 2)) >> 30);
}

}  // namespace detail

/// A relative error: less than 2^-bits of the number.
struct Relative {
  int bits;
};

/// The leading bits of a number >= 0, word * 2^exponent: a cheap approximation of a long integer, a
/// root or a quotient. The top bit of the word is set unless the number is 0.
///
/// The relative error of sums, products and quotients of a dozen numbers is below 2^-56, with
/// square roots among them below 2^-42 (docs/filters.md, lemma 1).
struct Leading {
  std::uint64_t word = 0;
  int exponent = 0;

  constexpr Leading() noexcept = default;
  /// word * 2^exponent <= x < (word + 1) * 2^exponent
  template <int B, int F>
  explicit constexpr Leading(const Fixed<B, F>& x) noexcept {
    const auto leading = detail::leading_word(x.raw());
    word = leading.word;
    exponent = leading.exponent - F;
  }

  [[nodiscard]] friend constexpr Leading operator+(const Leading& a, const Leading& b) noexcept {
    if (a.exponent < b.exponent ? b.word != 0 : a.word == 0) return sum(b, a);
    return sum(a, b);
  }
  [[nodiscard]] friend constexpr Leading operator*(const Leading& a, const Leading& b) noexcept {
    return Leading(multiply_words(a.word, b.word).high, a.exponent + b.exponent + 64);
  }
  /// `b` must not be 0.
  [[nodiscard]] friend constexpr Leading operator/(const Leading& a, const Leading& b) noexcept {
    const auto high = multiply_words(a.word, detail::reciprocal(b.word)).high;
    return Leading(high, a.exponent - b.exponent - 62);
  }
  [[nodiscard]] friend constexpr Leading sqrt(const Leading& x) noexcept {
    if (x.word == 0) return x;
    const std::uint64_t even = x.word >> (x.exponent & 1);
    const auto high = multiply_words(even, detail::reciprocal_root(even)).high;
    return Leading(high, ((x.exponent + 1) >> 1) - 30);
  }

  /// a / sqrt(square) with a relative error below 2^-43 (docs/filters.md, lemma 31); `square` must
  /// not be 0.
  [[nodiscard]] friend constexpr Leading over_root(const Leading& a,
                                                   const Leading& square) noexcept {
    const std::uint64_t even = square.word >> (square.exponent & 1);
    const auto high = multiply_words(a.word, detail::reciprocal_root(even)).high;
    return Leading(high, a.exponent - ((square.exponent + 1) >> 1) - 30);
  }

  /// The number times 2^Frac, rounded down; the product must be below 2^62.
  template <int Frac>
  [[nodiscard]] constexpr std::int64_t scaled() const noexcept {
    return static_cast<std::int64_t>(word >> std::clamp(-exponent - Frac, 0, 63));
  }

 private:
  constexpr Leading(std::uint64_t bits, int scale) noexcept {
    const int zeros = std::countl_zero(bits) & 63;
    word = bits << zeros;
    exponent = scale - zeros;
  }

  /// a + b, where a has the greater exponent or b is 0.
  [[nodiscard]] static constexpr Leading sum(const Leading& a, const Leading& b) noexcept {
    Leading result = a;
    result.word += b.word >> std::clamp(a.exponent - b.exponent, 0, 63);
    if (result.word < a.word) {
      result.word = (result.word >> 1) | (std::uint64_t{1} << 63);
      ++result.exponent;
    }
    return result;
  }
};

namespace detail {

/// word_a 2^exponent_a - word_b 2^exponent_b in steps of the greater power, for words below 2^63.
/// The shorter number is rounded down to such a step.
[[nodiscard]] constexpr Fixed<63, 0> aligned_difference(std::uint64_t word_a, int exponent_a,
                                                        std::uint64_t word_b,
                                                        int exponent_b) noexcept {
  const int excess = exponent_a - exponent_b;
  const auto a = static_cast<std::int64_t>(word_a >> std::clamp(-excess, 0, 63));
  const auto b = static_cast<std::int64_t>(word_b >> std::clamp(excess, 0, 63));
  return Fixed<63, 0>::assume_raw(a - b);
}

}  // namespace detail

/// a - b in steps of 2^-63 of the greater power of two, for numbers with this error: each is off by
/// less than 2^(63 - bits) steps, and halving and aligning the words takes less than 2.
[[nodiscard]] constexpr Approximate<Fixed<63, 0>> difference(const Leading& a, const Leading& b,
                                                             const Relative& error) noexcept {
  return {detail::aligned_difference(a.word >> 1, a.exponent, b.word >> 1, b.exponent),
          Fixed<63, 0>::assume_raw((std::int64_t{1} << (64 - error.bits)) + 2)};
}

/// The exact number rounded down to the grid of `T`; also unsure if it is 0 or does not fit.
template <class T>
[[nodiscard]] constexpr Decided<T> decide_floor(const Approximate<Leading, Relative>& x) noexcept {
  const auto [word, exponent] = x.value;
  const int dropped = -(exponent + T::frac);
  if (word == 0 || dropped <= 64 - T::bits || dropped > 64) return {T(), false};
  const std::uint64_t error = word >> x.error.bits;
  const std::uint64_t lowest = word - error, highest = word + error;
  const auto floor = [&](std::uint64_t bits) { return dropped == 64 ? 0 : bits >> dropped; };
  return {T::assume_raw(static_cast<typename T::raw_type>(floor(highest))),
          highest >= word && floor(lowest) == floor(highest)};
}

/// The leading bits of a vector's squared length, with a relative error below 2^-59
/// (docs/filters.md, lemma 31).
template <int B, int F, std::size_t N>
[[nodiscard]] constexpr Leading squared_leading(const std::array<Fixed<B, F>, N>& v) noexcept {
  Leading squared;
  for (const auto& c : v) {
    const Leading component(abs(c));
    squared = squared + component * component;
  }
  return squared;
}

/// p x - q y rounded to the nearest point of the grid of `T`, where |p x| and |q y| are at most 1
/// and the error of their difference is below 2^-42.
template <class T, int BX, int FX, int BY, int FY>
[[nodiscard]] constexpr Decided<T> decide_nearest_difference(const Leading& p,
                                                             const Fixed<BX, FX>& x,
                                                             const Leading& q,
                                                             const Fixed<BY, FY>& y) noexcept {
  using Difference = Fixed<62, 60>;
  const auto term = [](const Leading& factor, const auto& number) {
    const auto magnitude = (factor * Leading(abs(number))).template scaled<Difference::frac>();
    return number < 0 ? -magnitude : magnitude;
  };
  constexpr Steps<std::int64_t{1} << (Difference::frac - 42)> error;
  return decide_nearest<T>(Approximate{Difference::assume_raw(term(p, x) - term(q, y)), error});
}

/// The sign of a b - c d, for non-negative numbers. Products of more than 128 bits are computed
/// only if those of the leading words, less than 2 steps too small, do not decide.
template <Number A, Number B, Number C, Number D>
[[nodiscard]] constexpr int compare_products(const A& a, const B& b, const C& c,
                                             const D& d) noexcept {
  const auto exact = [&] {
    const auto left = a * b;
    const auto right = c * d;
    return (left > right) - (left < right);
  };
  if constexpr (127 < bits_of<A> + bits_of<B> || 127 < bits_of<C> + bits_of<D>) {
    const Leading x(a), y(b), z(c), w(d);
    const auto difference = detail::aligned_difference(
        multiply_words(x.word, y.word).high >> 1, x.exponent + y.exponent,
        multiply_words(z.word, w.word).high >> 1, z.exponent + w.exponent);
    return sign_or_exact(decide(Approximate{difference, Fixed<63, 0>::assume_raw(2)}), exact);
  } else {
    return exact();
  }
}

/// The sign of |v| - length, for a length >= 0.
template <Number T, std::size_t N, Number L>
[[nodiscard]] constexpr int compare_length(const std::array<T, N>& v, const L& length) noexcept {
  const auto exact = [&] {
    const auto sign = [&](const auto& squared) {
      return (squared > square(length)) - (squared < square(length));
    };
    const auto two = square(v[0]) + square(v[1]);
    if constexpr (N == 2) {
      return sign(two);
    } else {
      return sign(two + square(v[2]));
    }
  };
  if constexpr (127 < 2 * bits_of<T> + 2 || 127 < 2 * bits_of<L>) {
    const Leading squared = squared_leading(v);
    const Leading limit = Leading(length) * Leading(length);
    return sign_or_exact(decide(difference(squared, limit, Relative{56})), exact);
  } else {
    return exact();
  }
}

/// The leading bits of the square root of x >= 0: at least 31 bits, or all bits of a shorter root,
/// which must fit `T`. The exact root is not below the value.
template <class T, int B, int F>
[[nodiscard]] constexpr Approximate<T> sqrt_leading(const Fixed<B, F>& x) noexcept {
  static_assert(F == 2 * T::frac);
  using Raw = typename T::raw_type;
  if constexpr (B <= 63) {
    return {sqrt_floor<T>(x), T::assume_raw(1)};
  } else {
    const Wide<2> n(integer_cast<Int128>(x.raw()));
    std::uint64_t high = n.word(1);
    const std::uint64_t low = n.word(0);
    if (high == 0)
      return {T::assume_raw(static_cast<Raw>(square_root_floor(low))), T::assume_raw(1)};
    const int shift = std::countl_zero(high) & ~1;
    if (shift != 0) high = (high << shift) | (low >> (64 - shift));
    const int scale = 32 - shift / 2;
    const std::uint64_t root = detail::at_most_root(detail::root_or_next(high), high);
    return {T::assume_raw(static_cast<Raw>(root << scale)),
            T::assume_raw(static_cast<Raw>(std::uint64_t{1} << scale))};
  }
}

}  // namespace detent
