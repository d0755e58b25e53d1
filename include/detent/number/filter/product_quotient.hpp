// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "detent/number/filter/leading.hpp"

namespace detent {

/// Filter: x f / (g y) for several x and f, with one reciprocal of g y; f, g and y are positive.
/// x may be off by less than three steps, y by less than one (docs/filters.md, lemma 39).
class ProductQuotient {
 public:
  template <int BG, int FG, int FY>
  constexpr ProductQuotient(const Fixed<BG, FG>& g, const Fixed<62, FY>& y) noexcept
      : is_sure_(y.raw() >= std::int64_t{1} << 36) {
    const Word<true> factor(g), other(y);
    const std::uint64_t product = multiply_words(factor.bits, other.bits).high;
    const int room = (product >> 63) != 0 ? 0 : 1;
    inverse_ = -static_cast<std::int64_t>(detail::reciprocal(product << room));
    exponent_ = factor.exponent + other.exponent + 64 - room;
  }

  /// The quotient with 14 bits more than T after the point.
  template <class T, int FX, int BF, int FF>
  [[nodiscard]] constexpr auto over(const Fixed<62, FX>& x, const Fixed<BF, FF>& f) const noexcept {
    using Value = Fixed<62, T::frac + 14>;
    const Word<(BF > 33)> factor(f);  // slopes are long enough
    const int down = FX + exponent_ - factor.exponent - 1 - Value::frac;
    // Both factors are negative: if GCC knows that one is positive, it computes three products.
    const auto part = high_of_twice(x.raw(), -static_cast<std::int64_t>(factor.bits >> 1));
    const std::int64_t value = high_of_twice(part, inverse_) >> (down & 63);
    constexpr std::int64_t unknown = 1 << 20;
    const std::int64_t error = ((value ^ (value >> 63)) >> 35) + 8;
    const bool is_sure = is_sure_ & (static_cast<std::uint32_t>(down) < 64);
    return Approximate{Value::assume_raw(value), Value::assume_raw(is_sure ? error : unknown)};
  }

 private:
  /// bits * 2^exponent, the number x > 0. If normal, the top bit is set.
  template <bool IsNormal>
  struct Word {
    template <int B, int F>
    explicit constexpr Word(const Fixed<B, F>& x) noexcept {
      static_assert(B <= 62);
      const auto raw = static_cast<std::uint64_t>(std::int64_t{x.raw()});
      const int zeros = IsNormal ? std::countl_zero(raw | 1) : 63 - B;  // GCC branches on 0
      bits = raw << zeros;
      exponent = -F - zeros;
    }
    std::uint64_t bits;
    int exponent;
  };

  /// The high word of 2 a b. Without the factor 2 GCC multiplies numbers of 128 bits.
  [[nodiscard]] static constexpr std::int64_t high_of_twice(std::int64_t a,
                                                            std::int64_t b) noexcept {
    const auto twice = static_cast<std::int64_t>(static_cast<std::uint64_t>(a) << 1);
    return detail::high_word(twice, b);
  }

  bool is_sure_;
  std::int64_t inverse_;  // -2^126 / the leading word of g y
  int exponent_;          // of that word
};

}  // namespace detent
