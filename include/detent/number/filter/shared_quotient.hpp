// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/filter/leading.hpp"

namespace detent {

/// Filter: several quotients with the same denominator, of either sign, whose magnitude is above
/// 2^-7 if `is_sure`, and at most 1 + 2^-26 (docs/filters.md, lemma 41).
class SharedQuotient {
 public:
  explicit constexpr SharedQuotient(const Fixed<62, 60>& under) noexcept {
    const std::int64_t leading = under.raw() >> 29;
    constexpr std::int64_t too_short = (std::int64_t{1} << 24) + 1;
    is_sure = static_cast<std::uint64_t>(leading + too_short) > 2 * std::uint64_t{too_short};
    if (!is_sure) [[unlikely]]
      return;
    // 2^84 / under, off by less than 2^-23.9 of it. The last bit is set because 0 has no quotient.
    const std::int64_t first = (std::int64_t{1} << 55) / (leading | 1);
    const std::int64_t scaled = first * (std::int64_t{1} << 32);
    const std::int64_t missing =
        (std::int64_t{1} << 54) - detail::high_word(under.raw() * 4, scaled);
    inverse_ = scaled + ((first * (missing >> 7)) >> 15);
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
