// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <optional>

#include "detent/number/filter/leading.hpp"
#include "detent/number/rounding.hpp"

namespace detent {

namespace detail {

/// floor(x / 2^exponent), which must fit.
template <class Int>
[[nodiscard]] constexpr std::int64_t scaled_word(const Int& x, int exponent) noexcept {
  if (exponent <= 0) return shift_left(integer_cast<std::int64_t>(x), -exponent);
  return integer_cast<std::int64_t>(shift_right_floor(x, exponent));
}

}  // namespace detail

/// (x - sqrt(d) y) / length for several x and y, approximately, with two divisions in all: the
/// components of a unit vector from a center to a point where a line meets a sphere.
///
/// The unit is so small that the length is at least 2^60. |x| and sqrt(d) are at most 1 + 2^-28
/// times the length, the quotient is at most 1 + 2^-28, and |y| at most 1.
template <class T, class D, class Length>
class RootRatio;

template <class T, int BD, int FD, int BL, int FL>
class RootRatio<T, Fixed<BD, FD>, Fixed<BL, FL>> {
 public:
  constexpr RootRatio(const Fixed<BD, FD>& d, const Fixed<BL, FL>& length) noexcept {
    static_assert(FD % 2 == 0 && FD / 2 + T::frac == FL);
    const auto leading = detail::leading_word(length.raw());
    exponent_ = leading.exponent + 3;
    reciprocal_ = detail::reciprocal(leading.word) >> 1;
    if (d == 0) return;
    // d = word * 4^k; the top bit of the word or the one below it is set.
    auto [word, exponent] = detail::leading_word(d.raw());
    word >>= exponent & 1;
    const int k = (exponent + 1) >> 1;
    const auto root = multiply_words(word, detail::reciprocal_root(word)).high;  // sqrt(word) 2^30
    root_ = static_cast<std::int64_t>(root >> (std::min)(30 - T::frac - k + exponent_, 63));
  }

  /// The quotient rounded to nearest; nothing where it is so close to a tie that an error of 2^-42,
  /// or of one step of T squared, could change it.
  template <int BX>
  [[nodiscard]] constexpr std::optional<T> nearest(const Fixed<BX, FL>& x,
                                                   const T& y) const noexcept {
    constexpr int guard = 58 - T::frac;
    constexpr std::uint64_t half = std::uint64_t{1} << (guard - 1);
    constexpr std::uint64_t margin = std::uint64_t{1} << (59 - (std::min)(42, 2 * T::frac));
    const auto away = shift_right_floor(
        wrapping_multiply<Int128>(root_, static_cast<std::int64_t>(y.raw())), T::frac);
    const std::int64_t over =
        detail::scaled_word(x.raw(), exponent_) - integer_cast<std::int64_t>(away);
    const auto word = static_cast<std::uint64_t>(over < 0 ? -over : over);
    const std::uint64_t quotient = multiply_words(word, reciprocal_).high + half;  // times 2^58
    const auto rounded = static_cast<std::int64_t>((quotient + margin) >> guard);
    if (rounded != static_cast<std::int64_t>((quotient - margin) >> guard)) [[unlikely]] {
      return std::nullopt;
    }
    return T::assume_raw(static_cast<typename T::raw_type>(over < 0 ? -rounded : rounded));
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
  [[nodiscard]] constexpr std::optional<T> nearest(T x, T y) const noexcept {
    return (x - root_ * y) / length_;
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
