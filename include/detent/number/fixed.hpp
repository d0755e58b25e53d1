// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "detent/number/assert.hpp"
#include "detent/number/integer.hpp"

namespace detent {

template <int Bits, int Frac>
class Fixed;

/// Whether `T` is a `Fixed<Bits, Frac>`.
template <class T>
inline constexpr bool is_fixed = false;
template <int Bits, int Frac>
inline constexpr bool is_fixed<Fixed<Bits, Frac>> = true;

namespace detail {

/// 15, 31, 63, 127 and 255 bits fill their integer, so +2^Bits has no pattern.
constexpr bool fills_container(int bits) noexcept {
  return bits == 15 || bits == 31 || bits == 63 || bits == 127 || bits == 255;
}

/// The budget for an arithmetic result of magnitude up to and including 2^bits.
constexpr int result_bits(int bits) noexcept { return fills_container(bits) ? bits + 1 : bits; }

template <std::integral Int>
inline constexpr int integral_bits = static_cast<int>(sizeof(Int) * 8) -
                                     (std::is_signed_v<Int> ? 1 : 0);

/// Whether a `Fixed<Bits, Frac>` holds every number of a `Fixed<B, F>`.
template <int B, int F, int Bits, int Frac>
concept KeepsEveryNumber = F <= Frac && (B + Frac - F < Bits ||
                                         (B + Frac - F == Bits &&
                                          (!fills_container(Bits) || fills_container(B))));

/// An operand of arithmetic with a `Fixed`: another `Fixed` or a built-in integer.
template <class T>
concept Operand = is_fixed<T> || std::integral<T>;

/// Whether the integer `value` is outside [T::lowest(), T::max()]. `Int` may be any type, because
/// clang evaluates this before the constraints of a constructor.
template <class T, class Int>
constexpr bool is_out_of_range(const Int& value) noexcept;

/// Not constexpr: a constant expression that calls it does not compile, and the message shows this
/// name.
inline void this_integer_is_out_of_range() noexcept {}

#if defined(__GNUC__) && !defined(__clang__)
/// Never defined: GCC reports an error for every call that it does not prove dead.
[[gnu::error(
    "detent: this integer is out of the number's range: saturate_to<T>(n) clamps it")]] void
known_integer_is_out_of_range() noexcept;
#endif

}  // namespace detail

// The arguments of this constructor are nearly always constants, so once inlined, its checks and
// clamps cost nothing; but a compiler that optimises for size would not inline it.
// (tests/size: raycast/aabb)
#if defined(__GNUC__) && defined(__OPTIMIZE__)
#define DETENT_INLINE_CONSTANT __attribute__((always_inline))
#else
#define DETENT_INLINE_CONSTANT
#endif

/// clang checks the constant arguments of a call at every optimization level.
#if defined(__clang__)
#define DETENT_REFUSE_IF(condition, reason) __attribute__((diagnose_if(condition, reason, "error")))
#else
#define DETENT_REFUSE_IF(condition, reason)
#endif

/// clang 16, which Apple numbers 15, refuses consteval functions in the initializer of a member.
#if defined(__clang__) && (__clang_major__ == 15 || __clang_major__ == 16)
#define DETENT_CONSTEVAL constexpr
#else
#define DETENT_CONSTEVAL consteval
#endif

/// The number raw * 2^-Frac. The type carries a bound on its magnitude: |raw| <= 2^Bits.
///
/// Sums, differences and products are exact: the result type has the bits they need, and a result
/// that would need more than `widest_bits` does not compile. Numbers lose bits only in functions
/// whose name says so (rounding.hpp) and in `+=`, `-=`, `*=`, which round to the type of the left
/// side.
///
/// domain: inputs (text, integers, doubles, raw bits) are in [lowest(), max()], the range of a
///         two's complement integer of Bits + 1 bits; +2^Bits occurs only as the result of
///         arithmetic, such as -lowest(), and never where Bits fills its integer type
template <int Bits, int Frac>
class Fixed {
 public:
  using raw_type = IntegerFor<Bits>;
  static constexpr int bits = Bits;
  static constexpr int frac = Frac;

  DETENT_INLINE_TINY constexpr Fixed() noexcept = default;

  /// The integer `value`, which must be in [lowest(), max()]; `saturate_to<T>(n)` clamps others.
  ///
  /// A value known to be out of range does not compile: in constant expressions, in clang if the
  /// argument is a constant, in GCC if -O1 or higher finds it constant. Elsewhere it is asserted,
  /// then clamped.
  template <std::integral Int>
  DETENT_INLINE_CONSTANT explicit constexpr Fixed(Int value) noexcept DETENT_REFUSE_IF(
      detail::is_out_of_range<Fixed>(value),
      "detent: this integer is out of the number's range: saturate_to<T>(n) clamps it");

  /// Converts from a type all of whose numbers this type holds.
  template <int B, int F>
  requires detail::KeepsEveryNumber<B, F, Bits, Frac> DETENT_INLINE_TINY constexpr Fixed(
      const Fixed<B, F>& other) noexcept
      : raw_(shift_left(integer_cast<raw_type>(other.raw()), Frac - F)) {}

  // Deleted: compilers show the line with the name.
  // clang-format off
  template <std::floating_point D>
  Fixed(D) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
  template <int B, int F>
  requires(!detail::KeepsEveryNumber<B, F, Bits, Frac>)
  explicit Fixed(const Fixed<B, F>&) = delete;  // detent: write nearest_to<T>(x) or floor_to<T>(x)
  // clang-format on

  /// The number with these raw bits, clamped to [lowest(), max()].
  [[nodiscard]] DETENT_INLINE_TINY static constexpr Fixed from_raw(raw_type raw) noexcept {
    if constexpr (!detail::fills_container(Bits)) {
      if (raw > (max)().raw_) return (max)();
      if (raw < lowest().raw_) return lowest();
    }
    return Fixed(raw, RawTag{});
  }

  /// The number with these raw bits, which the caller knows to be within the budget.
  [[nodiscard]] DETENT_INLINE_TINY static constexpr Fixed assume_raw(raw_type raw) noexcept {
    DETENT_ASSERT(is_in_budget(raw));
    return Fixed(raw, RawTag{});
  }

  /// The exact decimal `text` rounded to nearest, ties to even; nothing when it is malformed or
  /// out of range.
  [[nodiscard]] static constexpr std::optional<Fixed> parse(std::string_view text) noexcept;

  /// `value` rounded to nearest, ties to even, and clamped; 0 for a NaN. For tools and tests.
  [[nodiscard]] static constexpr Fixed from_double(double value) noexcept requires(Bits <= 63);

  /// The nearest double; exact up to 53 significant bits. For tools and tests.
  [[nodiscard]] explicit constexpr operator double() const noexcept;

  /// The stored integer: the number times 2^Frac.
  [[nodiscard]] DETENT_INLINE_TINY constexpr raw_type raw() const noexcept { return raw_; }

  /// The greatest input: (2^Bits - 1) / 2^Frac.
  [[nodiscard]] DETENT_INLINE_TINY static constexpr Fixed(max)() noexcept {
    return Fixed(wrapping_subtract<raw_type>(shift_left(raw_type(1), Bits), raw_type(1)), RawTag{});
  }
  /// The least number: -2^Bits / 2^Frac.
  [[nodiscard]] DETENT_INLINE_TINY static constexpr Fixed lowest() noexcept {
    return Fixed(wrapping_subtract<raw_type>(raw_type(0), shift_left(raw_type(1), Bits)), RawTag{});
  }

  /// Rounds the exact result to nearest, ties to even; asserts that it is in range, and clamps.
  template <class T>
  requires detail::Operand<T>
  constexpr Fixed& operator+=(const T& other) noexcept;
  template <class T>
  requires detail::Operand<T>
  constexpr Fixed& operator-=(const T& other) noexcept;
  template <class T>
  requires detail::Operand<T>
  constexpr Fixed& operator*=(const T& other) noexcept;

 private:
  struct RawTag {};
  DETENT_INLINE_TINY constexpr Fixed(raw_type raw, RawTag) noexcept : raw_(raw) {}

  static DETENT_INLINE_TINY constexpr bool is_in_budget(const raw_type& raw) noexcept {
    if constexpr (detail::fills_container(Bits)) {
      return true;
    } else {
      constexpr raw_type limit = shift_left(raw_type(1), Bits);
      constexpr raw_type least = wrapping_subtract<raw_type>(raw_type(0), limit);
      constexpr raw_type most = wrapping_subtract<raw_type>(limit, raw_type(1));
      return raw >= least && integer_cast<raw_type>(raw - raw_type(1)) <= most;
    }
  }

  raw_type raw_ = raw_type(0);
};

/// 32-bit coordinates in 1/65536: the world is 65,536 units wide.
using q16_16 = Fixed<31, 16>;
/// The same grid for maps 16,384 units wide: most intermediate results fit 64 bits.
using q14_16 = Fixed<29, 16>;
/// A world 16,777,216 units wide in steps of 1/256.
using q24_8 = Fixed<31, 8>;
/// 16-bit coordinates in 1/256: a world 256 units wide.
using q8_8 = Fixed<15, 8>;

namespace detail {

template <int B, int F>
DETENT_INLINE_TINY constexpr const Fixed<B, F>& as_fixed(const Fixed<B, F>& x) noexcept {
  return x;
}
template <std::integral Int>
DETENT_INLINE_TINY constexpr auto as_fixed(Int x) noexcept {
  using Whole = Fixed<integral_bits<Int>, 0>;
  return Whole::assume_raw(integer_cast<typename Whole::raw_type>(x));
}

template <class A, class B>
concept FixedOperands = (is_fixed<A> && is_fixed<B>) || (is_fixed<A> && std::integral<B>);

template <class A, class B>
inline constexpr int common_frac = (std::max)(A::frac, B::frac);
/// The bits of an operand once it is shifted to `Frac` fractional bits.
template <class A, int Frac>
inline constexpr int aligned_bits = A::bits + Frac - A::frac;
template <class A, class B>
inline constexpr int sum_bits = result_bits((std::max)(aligned_bits<A, common_frac<A, B>>,
                                                       aligned_bits<B, common_frac<A, B>>)+1);

template <class Raw, int Frac, class A>
DETENT_INLINE_TINY constexpr Raw aligned_raw(const A& a) noexcept {
  constexpr int shift = Frac - A::frac;
  if constexpr (shift > value_bits<Raw>) {
    return Raw(0);  // modulo the size of Raw
  } else {
    return shift_left(integer_cast<Raw>(a.raw()), shift);
  }
}

}  // namespace detail

template <int Bits1, int Frac1, int Bits2, int Frac2>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr auto operator+(
    const Fixed<Bits1, Frac1>& a, const Fixed<Bits2, Frac2>& b) noexcept {
  constexpr int frac = (std::max)(Frac1, Frac2);
  using Sum = Fixed<detail::sum_bits<Fixed<Bits1, Frac1>, Fixed<Bits2, Frac2>>, frac>;
  using Raw = typename Sum::raw_type;
  return Sum::assume_raw(
      wrapping_add<Raw>(detail::aligned_raw<Raw, frac>(a), detail::aligned_raw<Raw, frac>(b)));
}

template <int Bits1, int Frac1, int Bits2, int Frac2>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr auto operator-(
    const Fixed<Bits1, Frac1>& a, const Fixed<Bits2, Frac2>& b) noexcept {
  constexpr int frac = (std::max)(Frac1, Frac2);
  using Difference = Fixed<detail::sum_bits<Fixed<Bits1, Frac1>, Fixed<Bits2, Frac2>>, frac>;
  using Raw = typename Difference::raw_type;
  return Difference::assume_raw(
      wrapping_subtract<Raw>(detail::aligned_raw<Raw, frac>(a), detail::aligned_raw<Raw, frac>(b)));
}

template <int Bits1, int Frac1, int Bits2, int Frac2>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr auto operator*(
    const Fixed<Bits1, Frac1>& a, const Fixed<Bits2, Frac2>& b) noexcept {
  using Product = Fixed<detail::result_bits(Bits1 + Bits2), Frac1 + Frac2>;
  using Raw = typename Product::raw_type;
  return Product::assume_raw(wrapping_multiply<Raw>(a.raw(), b.raw()));
}

template <int B, int F>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr auto operator-(const Fixed<B, F>& x) noexcept {
  using Negative = Fixed<detail::result_bits(B), F>;
  using Raw = typename Negative::raw_type;
  return Negative::assume_raw(wrapping_subtract<Raw>(Raw(0), x.raw()));
}
template <int B, int F>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr auto operator-(Fixed<B, F>&& x) noexcept {
  return -std::as_const(x);
}

/// The negative of a literal: -1_q16_16 is a q16_16 too. Literals are `const` values to select this
/// overload. It compiles only for constants whose negative is in range.
template <int B, int F>
[[nodiscard]] DETENT_CONSTEVAL Fixed<B, F> operator-(const Fixed<B, F>&& x) {
  if (x == Fixed<B, F>::lowest() && detail::fills_container(B)) {
    detail::this_integer_is_out_of_range();
  }
  return Fixed<B, F>::assume_raw(integer_cast<typename Fixed<B, F>::raw_type>((-x).raw()));
}

/// The magnitude, exactly.
template <int B, int F>
[[nodiscard]] constexpr auto abs(const Fixed<B, F>& x) noexcept {
  using Magnitude = Fixed<detail::result_bits(B), F>;
  return is_negative(x.raw()) ? Magnitude(-x) : Magnitude(x);
}

/// Compares two numbers of any types, exactly.
template <class A, class B>
requires detail::FixedOperands<A, B>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr std::strong_ordering operator<=>(
    const A& left, const B& right) noexcept {
  if constexpr (std::integral<B>) {  // the sign needs no common grid
    if (right == 0) return left.raw() <=> typename A::raw_type(0);
  }
  const auto& a = detail::as_fixed(left);
  const auto& b = detail::as_fixed(right);
  using FixedA = std::remove_cvref_t<decltype(a)>;
  using FixedB = std::remove_cvref_t<decltype(b)>;
  using Common = IntegerFor<(std::max)(FixedA::bits, FixedB::bits)>;
  constexpr int shift = FixedA::frac - FixedB::frac;
  if constexpr (shift == 0) {
    return integer_cast<Common>(a.raw()) <=> integer_cast<Common>(b.raw());
  } else {
    constexpr int frac = detail::common_frac<FixedA, FixedB>;
    constexpr int width = detail::result_bits(
        (std::max)(detail::aligned_bits<FixedA, frac>, detail::aligned_bits<FixedB, frac>));
    if constexpr (width <= 62 || width <= value_bits<Common>) {
      using Raw = IntegerFor<width>;
      return detail::aligned_raw<Raw, frac>(a) <=> detail::aligned_raw<Raw, frac>(b);
    } else if constexpr (shift < 0) {
      // a * 2^k < b exactly when a < floor(b / 2^k), or both are equal and b has a remainder.
      const auto whole = integer_cast<Common>(shift_right_floor(b.raw(), -shift));
      const auto order = integer_cast<Common>(a.raw()) <=> whole;
      if (order != 0 || low_bits_are_zero(b.raw(), -shift)) return order;
      return std::strong_ordering::less;
    } else {
      // cppcheck-suppress compareBoolExpressionWithInt  // false positive: an ordering, not a bool
      return 0 <=> (b <=> a);
    }
  }
}

template <class A, class B>
requires detail::FixedOperands<A, B>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr bool operator==(const A& a, const B& b) noexcept {
  return (a <=> b) == 0;
}

template <class T, class Int>
constexpr bool detail::is_out_of_range(const Int& value) noexcept {
  if constexpr (std::integral<Int>) {
    const auto whole = as_fixed(value);
    return whole > (T::max)() || whole < T::lowest();
  } else {
    return false;
  }
}

template <int Bits, int Frac>
template <std::integral Int>
constexpr Fixed<Bits, Frac>::Fixed(Int value) noexcept {
  const bool is_out_of_range = detail::is_out_of_range<Fixed>(value);
  if (is_out_of_range && std::is_constant_evaluated()) detail::this_integer_is_out_of_range();
#if defined(__GNUC__) && !defined(__clang__)
  // The comparison must be constant too: for wide integers it may not be, even if the value is.
  if (__builtin_constant_p(is_out_of_range) && is_out_of_range) {
    detail::known_integer_is_out_of_range();
  }
#endif
  DETENT_ASSERT(!is_out_of_range);
  // Where Frac exceeds Bits, 0 is the only integer in range.
  const auto whole = detail::as_fixed(value);
  if (whole > (max)()) {
    raw_ = (max)().raw_;
  } else if (whole < lowest()) {
    raw_ = lowest().raw_;
  } else if constexpr (Frac >= 0 && Frac <= Bits) {
    raw_ = shift_left(integer_cast<raw_type>(value), Frac);
  } else if constexpr (Frac < 0) {
    raw_ = integer_cast<raw_type>(shift_right_floor(whole.raw(), -Frac));
  }
}

template <int Bits, int Frac>
constexpr Fixed<Bits, Frac> Fixed<Bits, Frac>::from_double(double value) noexcept
    requires(Bits <= 63) {
  const auto pattern = std::bit_cast<std::uint64_t>(value);
  const bool negative = (pattern >> 63) != 0;
  const int exponent = static_cast<int>((pattern >> 52) & 0x7ff);
  std::uint64_t mantissa = pattern & ((std::uint64_t{1} << 52) - 1);
  if (exponent == 0x7ff && mantissa != 0) return Fixed();
  if (exponent != 0) mantissa |= std::uint64_t{1} << 52;
  // |value| = mantissa * 2^(max(exponent, 1) - 1075); `shift` moves it to the raw grid.
  const int shift = (std::max)(exponent, 1) - 1075 + Frac;
  if (shift >= 0) {
    if (mantissa != 0 && static_cast<int>(std::bit_width(mantissa)) + shift > Bits) {
      return negative ? lowest() : (max)();
    }
    mantissa <<= mantissa == 0 ? 0 : shift;
  } else if (shift < -54) {
    mantissa = 0;
  } else {
    const std::uint64_t half = std::uint64_t{1} << (-shift - 1);
    mantissa = (mantissa + half - 1 + ((mantissa >> -shift) & 1)) >> -shift;
  }
  if (mantissa > static_cast<std::uint64_t>((max)().raw_)) return negative ? lowest() : (max)();
  const auto magnitude = static_cast<std::int64_t>(mantissa);
  return Fixed(static_cast<raw_type>(negative ? -magnitude : magnitude), RawTag{});
}

template <int Bits, int Frac>
constexpr Fixed<Bits, Frac>::operator double() const noexcept {
  // 62 leading bits and a sticky bit below them decide the rounding.
  const int excess = (std::max)(bit_length(raw_) - 62, 0);
  auto leading = integer_cast<std::int64_t>(shift_right_floor(raw_, excess));
  if (!low_bits_are_zero(raw_, excess)) leading |= 1;
  const auto power_of_two = [](int k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + k) << 52);
  };
  return static_cast<double>(leading) * power_of_two(excess - Frac);
}

}  // namespace detent

/// For `std::unordered_map`; the hash of the raw integer.
template <int Bits, int Frac>
struct std::hash<detent::Fixed<Bits, Frac>> {
  [[nodiscard]] std::size_t operator()(const detent::Fixed<Bits, Frac>& x) const noexcept
      requires(Bits <= 63) {
    return std::hash<typename detent::Fixed<Bits, Frac>::raw_type>()(x.raw());
  }
};

#undef DETENT_INLINE_CONSTANT
#undef DETENT_REFUSE_IF
