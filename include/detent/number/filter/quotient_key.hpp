// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "detent/number/filter/leading.hpp"

namespace detent {

/// Filter: x / sqrt(square) for square > 0 by its leading bits, in one word that orders such
/// quotients. In `float` and `double` it is their square, with the sign of x.
///
/// A key has 10 bits of the exponent and the 53 bits below the top one; it is off by less than 2^11
/// (docs/filters.md, lemma 17).
template <Number X>
class QuotientKey {
 public:
  constexpr QuotientKey() noexcept = default;

  template <Number Square>
  constexpr QuotientKey(const X& x, const Square& square) noexcept {
    if constexpr (!is_fixed<X>) {
      key_ = (x < X(0) ? -(x * x) : x * x) / square;
    } else {
      const auto over = detail::leading_word(abs(x).raw());
      if (over.word == 0) return;
      auto under = detail::leading_word(square.raw());
      // square = word * 4^half
      under.word >>= under.exponent & 1;
      const int half = (under.exponent + 1) >> 1;
      const auto high = multiply_words(over.word, detail::reciprocal_root(under.word)).high;
      const int zeros = std::countl_zero(high);
      const auto exponent = static_cast<std::uint64_t>(over.exponent - half - zeros + bias);
      // The top bit adds one to the exponent.
      const auto key = static_cast<std::int64_t>((exponent << digits) + (high << zeros >> 10));
      key_ = x < 0 ? -key : key;
    }
  }

  /// Whether the exact quotient is certainly less than that of b.
  [[nodiscard]] constexpr bool is_surely_less(const QuotientKey& b) const noexcept {
    if constexpr (!is_fixed<X>) {
      return key_ < b.key_;
    } else {
      return key_ < b.key_ - error;
    }
  }
  /// Whether the key is less, which does not prove that the quotient is.
  [[nodiscard]] friend constexpr bool operator<(const QuotientKey& a,
                                                const QuotientKey& b) noexcept {
    return a.key_ < b.key_;
  }

 private:
  static constexpr int digits = 53, bias = 512;
  static constexpr std::int64_t error = 1 << 12;  // of two keys
  static_assert(!is_fixed<X> || bits_of<X> < 300, "detent: 10 bits of the exponent are enough");

  std::conditional_t<is_fixed<X>, std::int64_t, X> key_{};
};

}  // namespace detent
