// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "detent/number/filter/leading.hpp"

namespace detent {

/// Filter: several quotients with the same denominator, from 2^-7 to 2 if `is_sure`
/// (docs/filters.md, lemma 37).
class SharedQuotient {
 public:
  explicit constexpr SharedQuotient(const Fixed<62, 60>& under) noexcept {
    const std::int64_t raw = under.raw();
    is_sure = raw >= std::int64_t{1} << 53;
    const auto word = static_cast<std::uint64_t>(raw);
    const int zeros = std::countl_zero(word | 1);  // GCC branches on 0
    inverse_ = static_cast<std::int64_t>(detail::reciprocal(word << zeros));
    down_ = (10 - zeros) & 63;
  }

  /// over / under, with 8 bits less after the point.
  template <int F>
  [[nodiscard]] constexpr Fixed<63, F - 8> operator()(const Fixed<63, F>& over) const noexcept {
    return Fixed<63, F - 8>::assume_raw(detail::high_word(over.raw(), inverse_) >> down_);
  }

  bool is_sure;

 private:
  std::int64_t inverse_;  // 2^126 / under, scaled up
  int down_;
};

/// The same without shifts by unknown counts, for a denominator of either sign whose magnitude is
/// from 2^-7 to 1: less accurate, and faster (docs/filters.md, lemma 41).
class QuickQuotient {
 public:
  explicit constexpr QuickQuotient(const Fixed<62, 60>& under) noexcept {
    const std::int64_t sign = under.raw() >> 63;
    const auto word = static_cast<std::uint64_t>((under.raw() ^ sign) - sign);
    is_sure = word >= std::uint64_t{1} << 53;
    if (!is_sure) [[unlikely]]
      return;
    // 2^92 / word, too small by less than 2^-23 of it.
    const std::uint64_t first = (std::uint64_t{1} << 63) / ((word >> 29) + 1);
    const std::uint64_t missing =
        (std::uint64_t{1} << 55) - multiply_words(word << 3, first << 24).high;
    const auto inverse =
        static_cast<std::int64_t>((first << 24) + ((first * (missing >> 8)) >> 23));
    inverse_ = (inverse ^ sign) - sign;
  }

  /// over / under, with 8 bits less after the point.
  template <int F>
  [[nodiscard]] constexpr Fixed<63, F - 8> operator()(const Fixed<63, F>& over) const noexcept {
    return Fixed<63, F - 8>::assume_raw(
        detail::in_register(detail::high_word(over.raw(), inverse_)));
  }

  bool is_sure;

 private:
  std::int64_t inverse_ = 0;  // 2^116 / under
};

}  // namespace detent
