// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "detent/number/filter/filtered.hpp"

namespace detent {

/// Whether a . (b x c) is 0, from its value in steps modulo 2^64: `no`, or `unsure` if that is 0.
///
/// Additions and products of words are exact modulo 2^64, however long the number is.
template <int B, int F>
[[nodiscard]] constexpr Filtered is_zero_volume(const std::array<Fixed<B, F>, 3>& a,
                                                const std::array<Fixed<B, F>, 3>& b,
                                                const std::array<Fixed<B, F>, 3>& c) noexcept {
  const auto word = [](const Fixed<B, F>& x) {
    return static_cast<std::uint64_t>(integer_cast<std::int64_t>(x.raw()));
  };
  const auto cofactor = [&](std::size_t i, std::size_t j) {
    return word(b[i]) * word(c[j]) - word(b[j]) * word(c[i]);
  };
  const std::uint64_t volume =
      word(a[0]) * cofactor(1, 2) + word(a[1]) * cofactor(2, 0) + word(a[2]) * cofactor(0, 1);
  return volume != 0 ? Filtered::no : Filtered::unsure;
}

}  // namespace detent
