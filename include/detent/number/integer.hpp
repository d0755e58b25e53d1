// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "detent/number/wide.hpp"

namespace detent {

/// The most value bits that a result may have; wider results do not compile.
inline constexpr int widest_bits = 639;

namespace detail {

template <int Bits>
constexpr auto container_for() noexcept {
  static_assert(Bits >= 1 && Bits <= widest_bits,
                "detent: this result does not fit the widest integer (640 bits): narrow<Bits>() an "
                "operand whose range you can prove, or round one with nearest_to<T>()");
  if constexpr (Bits <= 15) {
    return std::int16_t{};
  } else if constexpr (Bits <= 31) {
    return std::int32_t{};
  } else if constexpr (Bits <= 63) {
    return std::int64_t{};
  } else if constexpr (Bits <= 127) {
    return Int128{};
  } else if constexpr (Bits <= 255) {
    return Wide<4>{};
  } else if constexpr (Bits <= 319) {
    return Wide<5>{};
  } else if constexpr (Bits <= 447) {
    return Wide<7>{};
  } else {
    return Wide<10>{};
  }
}

template <class Int>
inline constexpr bool is_wide = false;
template <int Words>
inline constexpr bool is_wide<Wide<Words>> = true;

template <class Int>
inline constexpr int words_of = 1;
template <int Words>
inline constexpr int words_of<Wide<Words>> = Words;
#if DETENT_NATIVE_INT128
template <>
inline constexpr int words_of<Int128> = 2;
#endif

}  // namespace detail

/// The smallest signed integer that holds every |x| < 2^Bits.
template <int Bits>
using IntegerFor = decltype(detail::container_for<Bits>());

/// How many value bits a signed integer of this type has (31 for std::int32_t).
template <class Int>
inline constexpr int value_bits = static_cast<int>(sizeof(Int) * 8 - 1);

/// `x` in another integer type: sign-extended, or its low bits.
template <class To, class From>
[[nodiscard]] DETENT_INLINE_TINY constexpr To integer_cast(const From& x) noexcept {
  if constexpr (std::is_same_v<To, From>) {
    return x;
  } else {
    return static_cast<To>(x);
  }
}

namespace detail {

/// The unsigned type to wrap a built-in signed integer without undefined behaviour.
template <class Int>
struct unsigned_of {
  using type = std::make_unsigned_t<std::common_type_t<Int, std::int32_t>>;
};
#if DETENT_NATIVE_INT128
template <>
struct unsigned_of<Int128> {
  using type = UInt128;
};
#endif
template <class Int>
using unsigned_of_t = typename unsigned_of<Int>::type;

}  // namespace detail

/// a + b, a - b and a * b in the integer type `To`, modulo its size: correct whenever the exact
/// result fits. The operands may be of any integer types.
template <class To, class A, class B>
[[nodiscard]] DETENT_INLINE_TINY constexpr To wrapping_add(const A& a, const B& b) noexcept {
  if constexpr (detail::is_wide<To>) {
    return integer_cast<To>(a) + integer_cast<To>(b);
  } else {
    using U = detail::unsigned_of_t<To>;
    return static_cast<To>(static_cast<U>(integer_cast<To>(a)) +
                           static_cast<U>(integer_cast<To>(b)));
  }
}

template <class To, class A, class B>
[[nodiscard]] DETENT_INLINE_TINY constexpr To wrapping_subtract(const A& a, const B& b) noexcept {
  if constexpr (detail::is_wide<To>) {
    return integer_cast<To>(a) - integer_cast<To>(b);
  } else {
    using U = detail::unsigned_of_t<To>;
    return static_cast<To>(static_cast<U>(integer_cast<To>(a)) -
                           static_cast<U>(integer_cast<To>(b)));
  }
}

template <class To, class A, class B>
[[nodiscard]] DETENT_INLINE_TINY constexpr To wrapping_multiply(const A& a, const B& b) noexcept {
  if constexpr (detail::is_wide<To>) {
    // Operands keep their widths: shorter ones need fewer word products.
    constexpr int a_words = detail::words_of<A>, b_words = detail::words_of<B>;
    if constexpr (DETENT_SHORT_WORDS && a_words == 1 && b_words == 1) {
      const auto [low, high] = multiply_signed_halves(a, b);
      return integer_cast<To>(Wide<2>::from_words({low, high}));
    } else if constexpr (DETENT_SHORT_WORDS && sizeof(A) <= 4) {
      return multiply_by_half<detail::words_of<To>>(b, std::int32_t{a});
    } else if constexpr (DETENT_SHORT_WORDS && sizeof(B) <= 4) {
      return multiply_by_half<detail::words_of<To>>(a, std::int32_t{b});
    } else if constexpr (a_words == 1 && b_words == 1) {
      const std::int64_t x = integer_cast<std::int64_t>(a), y = integer_cast<std::int64_t>(b);
      const auto [low, high] =
          multiply_words(static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y));
      const std::uint64_t signed_high = high - (x < 0 ? static_cast<std::uint64_t>(y) : 0) -
                                        (y < 0 ? static_cast<std::uint64_t>(x) : 0);
      return integer_cast<To>(Wide<2>::from_words({low, signed_high}));
#if DETENT_NATIVE_INT128
    } else if constexpr (!DETENT_SHORT_WORDS && detail::words_of<To> >= 4 && a_words == 2 &&
                         b_words == 1) {
      return multiply_pair<detail::words_of<To>>(integer_cast<Wide<2>>(a), std::int64_t{b});
    } else if constexpr (!DETENT_SHORT_WORDS && detail::words_of<To> >= 4 && a_words == 1 &&
                         b_words == 2) {
      return multiply_pair<detail::words_of<To>>(integer_cast<Wide<2>>(b), std::int64_t{a});
#endif
    } else {
      return multiply<detail::words_of<To>>(integer_cast<Wide<(a_words < 2 ? 2 : a_words)>>(a),
                                            integer_cast<Wide<(b_words < 2 ? 2 : b_words)>>(b));
    }
  } else if constexpr (detail::words_of<To> == 2 && sizeof(A) <= 8 && sizeof(B) <= 8 &&
                       std::is_signed_v<A> && std::is_signed_v<B>) {
    // One instruction, which not every compiler emits for a product of unsigned patterns.
    return static_cast<To>(integer_cast<std::int64_t>(a)) * integer_cast<std::int64_t>(b);
  } else if constexpr (has_short_products && sizeof(To) == 8) {
    return static_cast<To>(multiply_low_halves(a, b));
  } else {
    using U = detail::unsigned_of_t<To>;
    return static_cast<To>(static_cast<U>(integer_cast<To>(a)) *
                           static_cast<U>(integer_cast<To>(b)));
  }
}

/// x * 2^count modulo the size of `Int`; `count` in [0, width of Int).
template <class Int>
[[nodiscard]] DETENT_INLINE_TINY constexpr Int shift_left(const Int& x, int count) noexcept {
  if constexpr (detail::is_wide<Int>) {
    return x << count;
  } else {
    return static_cast<Int>(static_cast<detail::unsigned_of_t<Int>>(x) << count);
  }
}

/// floor(x / 2^count) for any count >= 0.
template <class Int>
[[nodiscard]] DETENT_INLINE_TINY constexpr Int shift_right_floor(const Int& x, int count) noexcept {
  constexpr int last = value_bits<Int>;
  return static_cast<Int>(x >> (count < last ? count : last));
}

/// floor(x / 2^Count) for a compile-time count in (0, 64).
template <int Count, class Int>
[[nodiscard]] constexpr Int shift_right_by(const Int& x) noexcept {
  if constexpr (std::is_same_v<Int, Wide<2>>) {
    const auto high = static_cast<std::uint64_t>(static_cast<std::int64_t>(x.word(1)) >> Count);
    return Int::from_words({(x.word(0) >> Count) | (x.word(1) << (64 - Count)), high});
  } else {
    return static_cast<Int>(x >> Count);
  }
}

/// Whether the low `count` bits of x are all zero; any count >= 0.
template <class Int>
[[nodiscard]] constexpr bool low_bits_are_zero(const Int& x, int count) noexcept {
  if (count == 0) return true;
  if (count > value_bits<Int>) return x == Int(0);
  return shift_left(x, value_bits<Int> + 1 - count) == Int(0);
}

/// -1, 0 or 1.
template <class Int>
[[nodiscard]] DETENT_INLINE_TINY constexpr int sign_of(const Int& x) noexcept {
  if constexpr (detail::is_wide<Int>) {
    return x.is_negative() ? -1 : (x == Int(0) ? 0 : 1);
  } else {
    return (x > 0) - (x < 0);
  }
}

/// Whether x < 0. GCC 12 does not reduce `sign_of(x) < 0` to this.
template <class Int>
[[nodiscard]] DETENT_INLINE_TINY constexpr bool is_negative(const Int& x) noexcept {
  if constexpr (detail::is_wide<Int>) {
    return x.is_negative();
  } else {
    return x < 0;
  }
}

/// How many bits |x| needs: 0 for 0, otherwise floor(log2 |x|) + 1.
template <class Int>
[[nodiscard]] constexpr int bit_length(const Int& x) noexcept {
  if constexpr (detail::words_of<Int> == 1) {
    const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
    return static_cast<int>(std::bit_width(x < 0 ? 0 - bits : bits));
  } else {
    constexpr int words = detail::words_of<Int>;
    const Wide<words> wide = integer_cast<Wide<words>>(x);
    const Wide<words> magnitude = wide.is_negative() ? -wide : wide;
    for (int i = words - 1; i >= 0; --i) {
      if (magnitude.word(i) != 0) {
        return 64 * i + static_cast<int>(std::bit_width(magnitude.word(i)));
      }
    }
    return 0;
  }
}

/// `bit_length` of x > 0.
template <class Int>
[[nodiscard]] constexpr int positive_bit_length(const Int& x) noexcept {
  if constexpr (detail::words_of<Int> == 1) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(x)));
  } else if constexpr (detail::words_of<Int> == 2) {
    const Wide<2> wide(x);
    const bool is_long = wide.word(1) != 0;
    return (is_long ? 64 : 0) + static_cast<int>(std::bit_width(wide.word(is_long ? 1 : 0)));
  } else {
    return bit_length(x);
  }
}

}  // namespace detent
