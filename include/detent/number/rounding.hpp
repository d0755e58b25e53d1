// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/number/divide.hpp"
#include "detent/number/root.hpp"
#include "detent/number/scalar.hpp"
#if __STDC_HOSTED__
#include "detent/number/floating.hpp"
#endif

namespace detent {

namespace detail {

/// `raw` as a T, clamped to [T::lowest(), T::max()].
template <class T, class Int>
constexpr T clamp_raw(const Int& raw) noexcept {
  if constexpr (value_bits < Int >> T::bits) {
    if (raw > integer_cast<Int>((T::max)().raw())) return (T::max)();
    if (raw < integer_cast<Int>(T::lowest().raw())) return T::lowest();
  }
  return T::assume_raw(integer_cast<typename T::raw_type>(raw));
}

/// The same for a square root.
template <class T>
constexpr T clamp_root(std::uint64_t root) noexcept {
  if constexpr (T::bits > 63) {
    return clamp_raw<T>(Wide<2>(root));
  } else {
    constexpr auto greatest = static_cast<std::uint64_t>((T::max)().raw());
    return T::assume_raw(static_cast<typename T::raw_type>((std::min)(root, greatest)));
  }
}

/// Whether a `Fixed` of `Bits` bits can hold `raw`: |raw| <= 2^Bits, and its integer has a pattern
/// for it.
template <int Bits, class Int>
DETENT_INLINE_TINY constexpr bool is_within(const Int& raw) noexcept {
  if constexpr (Bits <= 62 && value_bits<Int> <= 63) {  // one addition and one comparison
    constexpr auto limit = std::uint64_t{1} << Bits;
    constexpr auto highest = 2 * limit - (fills_container(Bits) ? 1 : 0);
    return static_cast<std::uint64_t>(std::int64_t{raw}) + limit <= highest;
  }
  const int length = bit_length(raw);
  if (length <= Bits) return true;
  return length == Bits + 1 && low_bits_are_zero(raw, Bits) &&
         (is_negative(raw) || !fills_container(Bits));
}

/// floor(numerator / denominator) and the remainder, on the grid of T; `denominator` is not 0.
///
/// Computes value(n) / value(d) * 2^T::frac in integers: the shift goes to the side that keeps them
/// whole, and the denominator is made positive.
template <class T, class N, class D>
struct GridQuotient {
  static constexpr int shift = T::frac - N::frac + D::frac;
  static constexpr int numerator_bits = result_bits(N::bits + (std::max)(shift, 0));
  static constexpr int denominator_bits = result_bits(D::bits + (std::max)(-shift, 0));
  using Integer = IntegerFor<(std::max)({numerator_bits, denominator_bits, 31})>;

  static constexpr Division<Integer> divide(const N& n, const D& d, Integer& divisor) noexcept {
    auto numerator = shift_left(integer_cast<Integer>(n.raw()), (std::max)(shift, 0));
    divisor = shift_left(integer_cast<Integer>(d.raw()), (std::max)(-shift, 0));
    if (is_negative(divisor)) {
      numerator = static_cast<Integer>(-numerator);
      divisor = static_cast<Integer>(-divisor);
    }
    return divide_floor(numerator, divisor);
  }
};

template <class T, class N>
constexpr T quotient_by_zero(const N& n) noexcept {
  const int sign = sign_of(n.raw());
  return sign > 0 ? (T::max)() : (sign < 0 ? T::lowest() : T());
}

}  // namespace detail

/// `x` rounded down to the grid of `T`, clamped to [T::lowest(), T::max()].
template <class T, int B, int F>
[[nodiscard]] constexpr T floor_to(const Fixed<B, F>& x) noexcept {
  constexpr int shift = F - T::frac;
  if constexpr (shift >= 0) {
    return detail::clamp_raw<T>(shift_right_floor(x.raw(), shift));
  } else {
    using Raw = IntegerFor<detail::result_bits(B - shift)>;
    return detail::clamp_raw<T>(shift_left(integer_cast<Raw>(x.raw()), -shift));
  }
}

/// `x` rounded up to the grid of `T`, clamped to [T::lowest(), T::max()].
template <class T, int B, int F>
[[nodiscard]] constexpr T ceil_to(const Fixed<B, F>& x) noexcept {
  // One bit more, because -T::lowest() is greater than T::max().
  using Wider = Fixed<detail::result_bits(T::bits + 1), T::frac>;
  return floor_to<T>(-floor_to<Wider>(-x));
}

/// `x` rounded to the nearest point of the grid of `T`, ties to even, clamped to
/// [T::lowest(), T::max()].
template <class T, int B, int F>
[[nodiscard]] constexpr T nearest_to(const Fixed<B, F>& x) noexcept {
  constexpr int shift = F - T::frac;
  if constexpr (shift <= 0) {
    return floor_to<T>(x);
  } else {
    if constexpr (detail::fills_container(B) && B > 31 && shift < B) {
      using Exact = typename Fixed<B, F>::raw_type;
      // Rounds the part below the grid alone, since a sum with x might need twice the bits.
      const Exact whole = shift_right_floor(x.raw(), shift);
      const Exact rest = wrapping_subtract<Exact>(x.raw(), shift_left(whole, shift));
      const Exact middle = shift_left(Exact(1), shift - 1);
      const bool is_up = rest > middle || (rest == middle && !low_bits_are_zero(whole, 1));
      return detail::clamp_raw<T>(wrapping_add<Exact>(whole, Exact(is_up ? 1 : 0)));
    }
    using Raw = IntegerFor<(std::max)(B, shift) + 1>;
    const Raw raw = integer_cast<Raw>(x.raw());
    const Raw below_half = wrapping_subtract<Raw>(shift_left(Raw(1), shift - 1), Raw(1));
    const bool odd = !low_bits_are_zero(shift_right_floor(raw, shift), 1);
    const Raw raised = wrapping_add<Raw>(wrapping_add<Raw>(raw, below_half), Raw(odd ? 1 : 0));
    return detail::clamp_raw<T>(shift_right_floor(raised, shift));
  }
}

// Deleted: compilers show the line with the name.
// clang-format off
template <std::floating_point T, int B, int F>
T nearest_to(const Fixed<B, F>&) = delete;  // detent: write T(double(x))
// clang-format on

/// `nearest_to` for results that are expected to exceed the range of `T` and be clamped.
template <class T, int B, int F>
[[nodiscard]] constexpr T saturate_to(const Fixed<B, F>& x) noexcept {
  return nearest_to<T>(x);
}

/// The integer `n` as a `Fixed`, exact or clamped to [T::lowest(), T::max()]. For an `n` in range,
/// write T(n).
template <class T, std::integral Int>
requires is_fixed<T>
[[nodiscard]] constexpr T saturate_to(Int n) noexcept { return nearest_to<T>(detail::as_fixed(n)); }

namespace detail {

/// A built-in integer type other than `bool`.
template <class T>
concept BuiltInInteger = std::integral<T> && !std::same_as<std::remove_cv_t<T>, bool>;

/// Holds every value of T.
template <BuiltInInteger T>
using WholeFor = Fixed<integral_bits<T>, 0>;

template <BuiltInInteger T>
constexpr T to_integer(const WholeFor<T>& x) noexcept {
  if constexpr (!std::is_signed_v<T>) {
    if (is_negative(x.raw())) return T(0);
  }
  return static_cast<T>(x.raw());
}

}  // namespace detail

/// `x` as a built-in integer, rounded as the name says and clamped to the integer's range:
/// floor_to<int>(2.75_q16_16) is 2, ceil_to<int> 3, nearest_to<int> 3; ties go to the even integer.
template <detail::BuiltInInteger T, int B, int F>
[[nodiscard]] constexpr T floor_to(const Fixed<B, F>& x) noexcept {
  return detail::to_integer<T>(floor_to<detail::WholeFor<T>>(x));
}
template <detail::BuiltInInteger T, int B, int F>
[[nodiscard]] constexpr T ceil_to(const Fixed<B, F>& x) noexcept {
  return detail::to_integer<T>(ceil_to<detail::WholeFor<T>>(x));
}
template <detail::BuiltInInteger T, int B, int F>
[[nodiscard]] constexpr T nearest_to(const Fixed<B, F>& x) noexcept {
  return detail::to_integer<T>(nearest_to<detail::WholeFor<T>>(x));
}
template <detail::BuiltInInteger T, int B, int F>
[[nodiscard]] constexpr T saturate_to(const Fixed<B, F>& x) noexcept {
  return nearest_to<T>(x);
}

/// `x` in fewer bits. The caller must prove that |x| <= 2^(Bits - F). Asserted in debug builds.
template <int Bits, int B, int F>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr Fixed<Bits, F> narrow(
    const Fixed<B, F>& x) noexcept {
  using Raw = typename Fixed<Bits, F>::raw_type;
  DETENT_ASSERT(detail::is_within<Bits>(x.raw()));
  return Fixed<Bits, F>::assume_raw(integer_cast<Raw>(x.raw()));
}

/// `floor_to<T>(x)`. The caller must prove that it fits.
template <class T, int B, int F>
[[nodiscard]] constexpr T narrow_floor(const Fixed<B, F>& x) noexcept {
  const auto raw = shift_right_floor(x.raw(), F - T::frac);
  DETENT_ASSERT(detail::is_within<T::bits>(raw));
  return T::assume_raw(integer_cast<typename T::raw_type>(raw));
}

/// a * b, a + b, a - b: `narrow` without the wider integer of the unproved result.
template <int Bits, int Bits1, int Frac1, int Bits2, int Frac2>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr Fixed<Bits, Frac1 + Frac2> narrow_product(
    const Fixed<Bits1, Frac1>& a, const Fixed<Bits2, Frac2>& b) noexcept {
  using Raw = typename Fixed<Bits, Frac1 + Frac2>::raw_type;
  DETENT_ASSERT(detail::is_within<Bits>((a * b).raw()));
  return Fixed<Bits, Frac1 + Frac2>::assume_raw(wrapping_multiply<Raw>(a.raw(), b.raw()));
}
template <int Bits, int Bits1, int Frac1, int Bits2, int Frac2>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr auto narrow_sum(
    const Fixed<Bits1, Frac1>& a, const Fixed<Bits2, Frac2>& b) noexcept {
  using Sum = Fixed<Bits, (std::max)(Frac1, Frac2)>;
  using Raw = typename Sum::raw_type;
  DETENT_ASSERT(detail::is_within<Bits>((a + b).raw()));
  return Sum::assume_raw(wrapping_add<Raw>(detail::aligned_raw<Raw, Sum::frac>(a),
                                           detail::aligned_raw<Raw, Sum::frac>(b)));
}
template <int Bits, int Bits1, int Frac1, int Bits2, int Frac2>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr auto narrow_difference(
    const Fixed<Bits1, Frac1>& a, const Fixed<Bits2, Frac2>& b) noexcept {
  using Difference = Fixed<Bits, (std::max)(Frac1, Frac2)>;
  using Raw = typename Difference::raw_type;
  DETENT_ASSERT(detail::is_within<Bits>((a - b).raw()));
  return Difference::assume_raw(
      wrapping_subtract<Raw>(detail::aligned_raw<Raw, Difference::frac>(a),
                             detail::aligned_raw<Raw, Difference::frac>(b)));
}

/// -x in the type of x. The caller must prove that it fits; it always does, except for the lowest
/// number of a type that fills its integer.
template <int B, int F>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr Fixed<B, F> narrow_negative(
    const Fixed<B, F>& x) noexcept {
  return narrow<B>(-x);
}

/// |x| in the type of x, with the condition of `narrow_negative`.
template <int B, int F>
[[nodiscard]] constexpr Fixed<B, F> narrow_abs(const Fixed<B, F>& x) noexcept {
  return is_negative(x.raw()) ? narrow_negative(x) : x;
}

/// x / 2, exactly.
template <int B, int F>
[[nodiscard]] constexpr Fixed<B, F + 1> half(const Fixed<B, F>& x) noexcept {
  return Fixed<B, F + 1>::assume_raw(x.raw());
}

/// x * 2^count in `Bits`. The caller must prove that it fits. `float` and `double` are returned
/// unchanged.
template <int Bits, int B, int F>
[[nodiscard]] constexpr Fixed<Bits, F> scale_up(const Fixed<B, F>& x, int count) noexcept {
  using Raw = typename Fixed<Bits, F>::raw_type;
  DETENT_ASSERT(sign_of(x.raw()) == 0 || bit_length(x.raw()) + count <= Bits + 1);
  return Fixed<Bits, F>::assume_raw(shift_left(integer_cast<Raw>(x.raw()), count));
}

/// x / 2^count rounded down to the grid of x, in `Bits`. The caller must prove that it fits.
template <int Bits, int B, int F>
[[nodiscard]] constexpr Fixed<Bits, F> scale_down(const Fixed<B, F>& x, int count) noexcept {
  return narrow<Bits>(Fixed<B, F>::assume_raw(shift_right_floor(x.raw(), count)));
}

/// How often x > 0 can be doubled without exceeding its bits.
template <int B, int F>
[[nodiscard]] constexpr int headroom(const Fixed<B, F>& x) noexcept {
  return B - bit_length(x.raw());
}

/// n / d rounded down to the grid of `T` and clamped. n / 0 is the end of the range with the sign
/// of n, 0 / 0 is 0.
template <class T, int BN, int FN, int BD, int FD>
[[nodiscard]] constexpr T quotient_floor(const Fixed<BN, FN>& n, const Fixed<BD, FD>& d) noexcept {
  if (sign_of(d.raw()) == 0) return detail::quotient_by_zero<T>(n);
  using Grid = detail::GridQuotient<T, Fixed<BN, FN>, Fixed<BD, FD>>;
  typename Grid::Integer divisor;
  return detail::clamp_raw<T>(Grid::divide(n, d, divisor).quotient);
}

/// n / d rounded to the nearest point of the grid of `T`, ties to even, and clamped; n / 0 as for
/// `quotient_floor`.
template <class T, int BN, int FN, int BD, int FD>
[[nodiscard]] constexpr T quotient_nearest(const Fixed<BN, FN>& n,
                                           const Fixed<BD, FD>& d) noexcept {
  if (sign_of(d.raw()) == 0) return detail::quotient_by_zero<T>(n);
  using Grid = detail::GridQuotient<T, Fixed<BN, FN>, Fixed<BD, FD>>;
  using Integer = typename Grid::Integer;
  Integer divisor;
  auto [quotient, remainder] = Grid::divide(n, d, divisor);
  const auto to_next = wrapping_subtract<Integer>(divisor, remainder);
  const bool odd = !low_bits_are_zero(quotient, 1);
  const bool is_above = remainder > to_next, is_tie = remainder == to_next;
  // Without a branch, because it is unpredictable which way a quotient is rounded.
  const bool is_up = is_above | (is_tie & odd);
  return detail::clamp_raw<T>(wrapping_add<Integer>(quotient, Integer(is_up ? 1 : 0)));
}

/// Quotients with a built-in integer on one or both sides, such as quotient_nearest<q16_16>(1, 3).
template <class T, detail::Operand N, detail::Operand D>
requires is_fixed<T> &&(std::integral<N> || std::integral<D>) [[nodiscard]] constexpr T
    quotient_floor(const N& n, const D& d) noexcept {
  return quotient_floor<T>(detail::as_fixed(n), detail::as_fixed(d));
}
template <class T, detail::Operand N, detail::Operand D>
requires is_fixed<T> &&(std::integral<N> || std::integral<D>) [[nodiscard]] constexpr T
    quotient_nearest(const N& n, const D& d) noexcept {
  return quotient_nearest<T>(detail::as_fixed(n), detail::as_fixed(d));
}

/// Quotients as built-in integers, such as the index of a cell: quotient_floor<int>(x, size).
template <detail::BuiltInInteger T, int BN, int FN, int BD, int FD>
[[nodiscard]] constexpr T quotient_floor(const Fixed<BN, FN>& n, const Fixed<BD, FD>& d) noexcept {
  return detail::to_integer<T>(quotient_floor<detail::WholeFor<T>>(n, d));
}
template <detail::BuiltInInteger T, int BN, int FN, int BD, int FD>
[[nodiscard]] constexpr T quotient_nearest(const Fixed<BN, FN>& n,
                                           const Fixed<BD, FD>& d) noexcept {
  return detail::to_integer<T>(quotient_nearest<detail::WholeFor<T>>(n, d));
}

/// The square root of `x`, rounded down to the grid of `T` and clamped; 0 for a negative `x`.
template <class T, int B, int F>
[[nodiscard]] constexpr T sqrt_floor(const Fixed<B, F>& x) noexcept {
  using Raw = typename Fixed<B, F>::raw_type;
  if (x.raw() < Raw(0)) return T();
  // sqrt(raw * 2^-F) * 2^frac = sqrt(raw * 2^shift). A negative shift may drop bits first, since
  // floor(sqrt(floor(y))) = floor(sqrt(y)).
  constexpr int shift = 2 * T::frac - F;
  static_assert(B + shift <= 128, "detent: sqrt_floor takes at most 128 bits on its result's grid");
  if constexpr (B + shift <= 63) {  // a raw of +2^B needs one bit more
    const auto raw = shift < 0 ? shift_right_floor(x.raw(), -shift) : x.raw();
    const auto n = static_cast<std::uint64_t>(integer_cast<std::int64_t>(raw));
    return detail::clamp_root<T>(square_root_floor(n << (std::max)(shift, 0)));
  } else if constexpr (B + (std::max)(shift, 0) <= 126) {
    const auto raw = integer_cast<Int128>(x.raw());
    const Wide<2> n(shift < 0 ? shift_right_floor(raw, -shift) : shift_left(raw, shift));
    if constexpr (T::bits == 31) {
      if ((n.word(1) | n.word(0) >> 62) != 0) return n.is_negative() ? T() : (T::max)();
      return T::assume_raw(static_cast<typename T::raw_type>(short_root_floor(n.word(0))));
    }
    return detail::clamp_root<T>(square_root_floor(n.word(1), n.word(0)));
  } else {
    using Long = Wide<(B <= 255 ? 4 : 5)>;
    const Long raw = integer_cast<Long>(x.raw());
    const Long n = shift < 0 ? raw >> -shift : raw << (std::max)(shift, 0);
    if (n.word(2) != 0) return detail::clamp_raw<T>(Wide<2>::from_words({0, 1}));  // n = 2^128
    return detail::clamp_root<T>(square_root_floor(n.word(1), n.word(0)));
  }
}

namespace detail {

/// Whether |a - b| is below 2^32 steps for numbers a, b of type T, and the machine squares it in a
/// register.
template <class T>
inline constexpr bool has_short_differences = false;
template <int F>
inline constexpr bool has_short_differences<Fixed<31, F>> = has_long_registers;

}  // namespace detail

/// sqrt((a[0] - b[0])^2 + (a[1] - b[1])^2 + ...), rounded down and clamped.
///
/// Each square fits a word. If one of them, or their sum, is at least 2^62, the root exceeds T;
/// otherwise the sum of up to three fits a word.
template <class T, std::size_t N>
requires(detail::has_short_differences<T>&& N <= 3) [[nodiscard]] constexpr T
    distance_floor(const std::array<T, N>& a, const std::array<T, N>& b) noexcept {
  std::uint64_t sum = 0, all = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const auto d = static_cast<std::uint64_t>(std::int64_t{a[i].raw()} - b[i].raw());
    sum += d * d;
    all |= d * d;
  }
  if ((all | sum) >> 62 != 0) return (T::max)();
  return T::assume_raw(static_cast<typename T::raw_type>(short_root_floor(sum)));
}

/// The square root of `x`, rounded up to the grid of `T` and clamped; 0 for a negative `x`.
template <class T, int B, int F>
[[nodiscard]] constexpr T sqrt_ceil(const Fixed<B, F>& x) noexcept {
  using Raw = typename T::raw_type;
  const T root = sqrt_floor<T>(x);
  if (root == (T::max)() || square(root) >= x) return root;
  return T::assume_raw(wrapping_add<Raw>(root.raw(), Raw(1)));
}

namespace detail {

template <class T, int B, int F>
constexpr T assign_nearest(const Fixed<B, F>& x) noexcept {
  DETENT_ASSERT(T::lowest() <= x && x <= (T::max)());
  return nearest_to<T>(x);
}

}  // namespace detail

template <int Bits, int Frac>
template <class T>
requires detail::Operand<T>
constexpr Fixed<Bits, Frac>& Fixed<Bits, Frac>::operator+=(const T& other) noexcept {
  return *this = detail::assign_nearest<Fixed>(*this + detail::as_fixed(other));
}
template <int Bits, int Frac>
template <class T>
requires detail::Operand<T>
constexpr Fixed<Bits, Frac>& Fixed<Bits, Frac>::operator-=(const T& other) noexcept {
  return *this = detail::assign_nearest<Fixed>(*this - detail::as_fixed(other));
}
template <int Bits, int Frac>
template <class T>
requires detail::Operand<T>
constexpr Fixed<Bits, Frac>& Fixed<Bits, Frac>::operator*=(const T& other) noexcept {
  return *this = detail::assign_nearest<Fixed>(*this * detail::as_fixed(other));
}

}  // namespace detent
