// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "detent/number/filter/leading.hpp"

namespace detent {

// Components of unit vectors.

namespace detail {

template <class Magnitude, int B, int F, std::size_t N>
[[nodiscard]] constexpr std::array<Magnitude, N> magnitudes(
    const std::array<Fixed<B, F>, N>& v) noexcept {
  std::array<Magnitude, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    const auto raw = integer_cast<Magnitude>(v[i].raw());
    result[i] = is_negative(raw) ? wrapping_subtract<Magnitude>(Magnitude(0), raw) : raw;
  }
  return result;
}

/// A magnitude of at most 1.
using Share = Fixed<63, 62>;

/// x, or -x if `is_reversed`; branchless where words are long, because signs are unpredictable.
template <class T>
[[nodiscard]] constexpr T with_sign(const T& x, bool is_reversed) noexcept {
  using Raw = typename T::raw_type;
  if constexpr (has_long_registers) {
    const auto sign = -static_cast<Raw>(is_reversed);
    return T::assume_raw(static_cast<Raw>((x.raw() ^ sign) - sign));
  } else {
    return T::assume_raw(static_cast<Raw>(is_reversed ? -x.raw() : x.raw()));
  }
}

/// m[i] / |m| within 2^-44 + 2^-53 (docs/filters.md, lemma 2); 0 where m is 0.
template <class Magnitude, std::size_t N>
[[nodiscard]] constexpr auto shares(const std::array<Magnitude, N>& m) noexcept {
  Approximate<std::array<Share, N>, Steps<(1 << 18) + (1 << 9)>> result;
  std::uint64_t squared = 1;  // at least 2^58 unless m is 0
  int length = 0;             // of the longest
  if constexpr (words_of<Magnitude> == 1) {
    std::uint64_t all = 0;
    for (const auto& c : m) all |= static_cast<std::uint64_t>(c);
    length = static_cast<int>(std::bit_width(all));
  } else {
    for (const auto& c : m) length = (std::max)(length, positive_bit_length(c));
  }
  for (std::size_t i = 0; i < N; ++i) {
    const auto part = [&] {
      if constexpr (words_of<Magnitude> == 1) {
        return static_cast<std::uint64_t>(m[i]) << (63 - length) >> 1;  // branchless
      } else {
        const int scale = 62 - length;
        return integer_cast<std::uint64_t>(scale >= 0 ? shift_left(m[i], scale)
                                                      : shift_right_floor(m[i], -scale));
      }
    }();
    squared += multiply_words(part, part).high;
    result.value[i] = Share::assume_raw(static_cast<std::int64_t>(part));
  }
  const int shift = std::countl_zero(squared) & ~1;
  const std::uint64_t reciprocal = reciprocal_root(squared << shift);
  for (auto& share : result.value) {
    const auto part = static_cast<std::uint64_t>(share.raw());
    share = Share::assume_raw(
        static_cast<std::int64_t>(multiply_words(part, reciprocal).high << (shift / 2)));
  }
  return result;
}

/// x / sqrt(square) for |x| < 2^62 and 0 < square < 2^62, off by less than 2^-44 of it and 2.
template <int BX, int BS>
[[nodiscard]] constexpr Fixed<62, 0> over_root(const Fixed<BX, 0>& x,
                                               const Fixed<BS, 0>& square) noexcept {
  const auto squared = static_cast<std::uint64_t>(square.raw());
  const int shift = std::countl_zero(squared) & ~1;
  const auto magnitude = static_cast<std::uint64_t>(x.raw() < 0 ? -x.raw() : x.raw());
  const auto high = multiply_words(magnitude, reciprocal_root(squared << shift)).high;
  const auto quotient = static_cast<std::int64_t>(high >> (30 - shift / 2));
  return Fixed<62, 0>::assume_raw(x.raw() < 0 ? -quotient : quotient);
}

/// floor(x / 2^exponent), which must fit.
template <class Int>
[[nodiscard]] constexpr std::int64_t scaled_word(const Int& x, int exponent) noexcept {
  if (exponent <= 0) return shift_left(integer_cast<std::int64_t>(x), -exponent);
  return integer_cast<std::int64_t>(shift_right_floor(x, exponent));
}

}  // namespace detail

/// The shares of a vector's components, computed once for several steps along it or back.
template <int B, int F, std::size_t N>
[[nodiscard]] constexpr auto shares_of(const std::array<Fixed<B, F>, N>& v) noexcept {
  using Magnitude = IntegerFor<(std::max)(B, 63)>;
  return detail::shares(detail::magnitudes<Magnitude>(v));
}

/// length * v / |v| for length >= 0, or 0 if v is 0. A length has at most 31 bits, so the error of
/// a share becomes 2^-13 + 2^-22 steps of S, and the floor adds 2^-30.
template <class S, int B, int F, std::size_t N, class Shares>
[[nodiscard]] constexpr auto step_along(const S& length, const std::array<Fixed<B, F>, N>& v,
                                        const Shares& shares) noexcept {
  using Step = finer<S, 30>;
  Approximate<std::array<Step, N>, Steps<(1 << 17) + (1 << 10)>> result;
  for (std::size_t i = 0; i < N; ++i) {
    using Raw = typename Step::raw_type;
    const auto part =
        static_cast<Raw>(multiply_words(static_cast<std::uint64_t>(shares.value[i].raw()),
                                        static_cast<std::uint64_t>(length.raw()) << 32)
                             .high);
    result.value[i] = detail::with_sign(Step::assume_raw(part), is_negative(v[i].raw()));
  }
  return result;
}
template <class S, int B, int F, std::size_t N>
[[nodiscard]] constexpr auto step_along(const S& length,
                                        const std::array<Fixed<B, F>, N>& v) noexcept {
  return step_along(length, v, shares_of(v));
}

/// (x - sqrt(d) y) / length for several x and y, approximately, with two divisions in all: the
/// components of a unit vector from a center to a point where a line meets a sphere.
///
/// The unit is small enough for the length to be at least 2^60. |x| and sqrt(d) are at most
/// 1 + 2^-28 times the length, the quotient is at most 1 + 2^-28, and |y| at most 1. The quotient
/// is off by less than 2^-42, or one step of T squared.
template <class T, class D, class Length>
class RootRatio;

template <class T, int BD, int FD, int BL, int FL>
class RootRatio<T, Fixed<BD, FD>, Fixed<BL, FL>> {
 public:
  constexpr RootRatio(const Fixed<BD, FD>& d, const Fixed<BL, FL>& length) noexcept {
    static_assert(FD % 2 == 0 && FD / 2 + T::frac == FL);
    const Leading leading(length);
    exponent_ = leading.exponent + FL + 3;
    reciprocal_ = detail::reciprocal(leading.word) >> 1;
    if (d == 0) return;
    // d = word * 4^k; the top bit of the word or the one below it is set.
    auto [word, exponent] = Leading(d);
    word >>= exponent & 1;
    const int k = (exponent + FD + 1) >> 1;
    const auto root = multiply_words(word, detail::reciprocal_root(word)).high;  // sqrt(word) 2^30
    root_ = static_cast<std::int64_t>(root >> (std::min)(30 - T::frac - k + exponent_, 63));
  }

  /// The quotient rounded to nearest.
  template <int BX>
  [[nodiscard]] constexpr Decided<T> decide_nearest(const Fixed<BX, FL>& x,
                                                    const T& y) const noexcept {
    using Quotient = Fixed<63, 58>;
    constexpr Steps<std::int64_t{1} << (59 - (std::min)(42, 2 * T::frac))> error;
    const auto away = shift_right_floor(
        wrapping_multiply<Int128>(root_, static_cast<std::int64_t>(y.raw())), T::frac);
    const std::int64_t over =
        detail::scaled_word(x.raw(), exponent_) - integer_cast<std::int64_t>(away);
    const auto word = static_cast<std::uint64_t>(over < 0 ? -over : over);
    const auto magnitude = static_cast<std::int64_t>(multiply_words(word, reciprocal_).high);
    const auto nearest =
        detent::decide_nearest<T>(Approximate{Quotient::assume_raw(magnitude), error});
    return {over < 0 ? narrow_negative(nearest.value) : nearest.value, nearest.is_sure};
  }

 private:
  int exponent_;              // of the unit
  std::uint64_t reciprocal_;  // of the length
  std::int64_t root_ = 0;     // sqrt(d)
};

template <class T, std::floating_point D, class Length>
class RootRatio<T, D, Length> {
 public:
  // cppcheck-suppress uninitMemberVar  // false positive: the members of the other one
  constexpr RootRatio(D d, Length length) noexcept : root_(sqrt_floor<D>(d)), length_(length) {}
  [[nodiscard]] constexpr Decided<T> decide_nearest(T x, T y) const noexcept {
    return {(x - root_ * y) / length_, true};
  }

 private:
  D root_;
  Length length_;
};

template <class T, Number D, Number Length>
[[nodiscard]] constexpr auto root_ratio(const D& d, const Length& length) noexcept {
  return RootRatio<T, D, Length>(d, length);
}

}  // namespace detent
