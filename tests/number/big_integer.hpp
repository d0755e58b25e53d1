// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <concepts>
#include <cstdint>

#include "detent/number/fixed.hpp"
#include "support/random.hpp"

namespace detent::test {

/// The oracle of the number layer: unbounded integers that share no code with ours.
using BigInteger = boost::multiprecision::cpp_int;
using BigRational = boost::multiprecision::cpp_rational;

inline BigInteger power_of_two(int exponent) { return BigInteger(1) << exponent; }

template <std::integral I>
requires(sizeof(I) <= 8) BigInteger big(I value) { return BigInteger(value); }

template <int Words>
BigInteger big(const Wide<Words>& value) {
  BigInteger sum = 0;
  for (int i = Words - 1; i >= 0; --i) sum = (sum << 64) + value.word(i);
  return value.is_negative() ? BigInteger(sum - power_of_two(64 * Words)) : sum;
}

#if DETENT_NATIVE_INT128
inline BigInteger big(Int128 value) {
  return (BigInteger(static_cast<std::int64_t>(value >> 64)) << 64) +
         static_cast<std::uint64_t>(value);
}
#endif

/// The value of a Fixed, in units of 2^-Frac.
template <int Bits, int Frac>
BigInteger big_raw(const Fixed<Bits, Frac>& x) {
  return big(x.raw());
}

template <int Bits, int Frac>
BigRational rational(const Fixed<Bits, Frac>& x) {
  if constexpr (Frac >= 0) {
    return BigRational(big(x.raw()), power_of_two(Frac));
  } else {
    return BigRational(big(x.raw()) * power_of_two(-Frac));
  }
}

inline BigInteger floor_of(const BigInteger& numerator, const BigInteger& denominator) {
  BigInteger quotient, remainder;
  divide_qr(numerator, denominator, quotient, remainder);
  const bool below = remainder != 0 && (remainder < 0) != (denominator < 0);
  return below ? BigInteger(quotient - 1) : quotient;
}

inline BigInteger floor_of(const BigRational& x) { return floor_of(numerator(x), denominator(x)); }

/// Rounded to nearest, ties to even.
inline BigInteger nearest_of(const BigRational& x) {
  const BigInteger below = floor_of(x);
  const BigRational rest = x - below;
  const BigRational half(1, 2);
  const bool up = rest > half || (rest == half && below % 2 != 0);
  return up ? BigInteger(below + 1) : below;
}

/// The residue of x modulo 2^bits in [-2^(bits-1), 2^(bits-1)), as two's complement keeps it.
inline BigInteger wrapped(const BigInteger& x, int bits) {
  const BigInteger modulus = power_of_two(bits);
  BigInteger residue = x % modulus;
  if (residue < 0) residue += modulus;
  return residue >= modulus / 2 ? BigInteger(residue - modulus) : residue;
}

/// The bits of x in the integer type, which x fits.
template <class I>
I integer_from(const BigInteger& x) {
  BigInteger rest = x < 0 ? BigInteger(x + power_of_two(384)) : x;
  std::array<std::uint64_t, 6> words;
  for (auto& word : words) {
    word = static_cast<std::uint64_t>(rest & ~std::uint64_t{0});
    rest >>= 64;
  }
  if constexpr (sizeof(I) <= 8) {
    return static_cast<I>(words[0]);
  } else {
    return static_cast<I>(Wide<6>::from_words(words));
  }
}

/// The number with this raw integer, clamped to |raw| <= 2^Bits and to its container.
template <class F>
F fixed_from(BigInteger raw) {
  const BigInteger low = -power_of_two(F::bits);
  const BigInteger high =
      detail::fills_container(F::bits) ? power_of_two(F::bits) - 1 : power_of_two(F::bits);
  if (raw < low) raw = low;
  if (raw > high) raw = high;
  return F::assume_raw(integer_from<typename F::raw_type>(raw));
}

/// x in units of the grid of T.
template <class T>
BigRational on_grid(const BigRational& x) {
  if constexpr (T::frac >= 0) {
    return x * power_of_two(T::frac);
  } else {
    return x / power_of_two(-T::frac);
  }
}

/// Whether T can represent this number.
template <class T>
bool fits(const BigRational& x) {
  const BigRational raw = on_grid<T>(x);
  return denominator(raw) == 1 && numerator(raw) >= big(T::lowest().raw()) &&
         numerator(raw) <= big(T::max().raw());
}

/// The raw integer clamped to the range of T.
template <class T>
BigInteger clamped(const BigInteger& raw) {
  if (raw > big(T::max().raw())) return big(T::max().raw());
  if (raw < big(T::lowest().raw())) return big(T::lowest().raw());
  return raw;
}

/// Bits whose magnitude has every bit length with equal probability, often an extreme or next to a
/// power of two.
template <int Words>
Wide<Words> random_wide(Random& random) {
  std::array<std::uint64_t, Words> words{};
  for (auto& word : words) word = random.next();
  const Wide<Words> pattern = Wide<Words>::from_words(words);
  const int shift = static_cast<int>(random.below(64 * Words));
  switch (random.below(6)) {
    case 0:
      return pattern;
    case 1:
      return Wide<Words>(random.between(-2, 2));
    case 2:
      return (Wide<Words>(1) << shift) + Wide<Words>(random.between(-2, 2));
    case 3:
      return (Wide<Words>(-1) << shift) + Wide<Words>(random.between(-2, 2));
    default:
      return pattern >> shift;
  }
}

/// Any value of an integer type, distributed like `random_wide`.
template <class I>
I random_integer(Random& random) {
  if constexpr (sizeof(I) <= 8) {
    // The low half of a two-word draw would be nearly uniform; shift within the type instead.
    const auto pattern = static_cast<std::int64_t>(random.next());
    const int shift = static_cast<int>(random.below(8 * sizeof(I)));
    const auto near = random.between(-2, 2);
    switch (random.below(6)) {
      case 0:
        return static_cast<I>(pattern);
      case 1:
        return static_cast<I>(near);
      case 2:
        return static_cast<I>((std::uint64_t{1} << shift) + static_cast<std::uint64_t>(near));
      case 3:
        return static_cast<I>((~std::uint64_t{0} << shift) + static_cast<std::uint64_t>(near));
      default:
        return static_cast<I>(pattern >> (64 - 8 * sizeof(I) + static_cast<unsigned>(shift)));
    }
  } else {
    return static_cast<I>(random_wide<sizeof(I) / 8>(random));
  }
}

/// Any value of a Fixed type, often an end of its range or next to a power of two; also +2^Bits,
/// which only arithmetic produces.
template <class F>
F random_fixed(Random& random) {
  if constexpr (!detail::fills_container(F::bits)) {
    if (random.one_in(20)) return fixed_from<F>(power_of_two(F::bits));
  }
  const F x = F::from_raw(random_integer<typename F::raw_type>(random));
  // With far fewer bits than the container, nearly every value would be clamped, so it is scaled
  // down.
  constexpr int spare = value_bits<typename F::raw_type> - F::bits;
  if (spare == 0 || random.one_in(8)) return x;
  return F::from_raw(shift_right_floor(random_integer<typename F::raw_type>(random), spare));
}

}  // namespace detent::test
