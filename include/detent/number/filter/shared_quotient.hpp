// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

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
    const auto product = wrapping_multiply<Int128>(over.raw(), inverse_);
    const auto high = integer_cast<std::int64_t>(shift_right_floor(product, 64));
    return Fixed<63, F - 8>::assume_raw(high >> down_);
  }

  bool is_sure;

 private:
  std::int64_t inverse_;  // 2^126 / under, scaled up
  int down_;
};

}  // namespace detent
