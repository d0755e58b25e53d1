// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/number/rounding.hpp"

namespace detent {

/// length * v / |v| for length >= 0, or 0 where v is 0, each component off by less than
/// 2^-13 + 2^-20 steps of S.
///
/// With every |v_i| scaled by the same power of two, the longest to 62 bits, the high words of the
/// squares lack less than 2^-54 of the whole, and what scaling down drops is less. So
/// `reciprocal_root` gives |v_i| / |v| within 2^-44 + 2^-53, and a length has no more than 31 bits.
template <class S, int B, int F, std::size_t N>
[[nodiscard]] constexpr std::array<finer<S, 30>, N> rough_along(
    const S& length, const std::array<Fixed<B, F>, N>& v) noexcept {
  using Magnitude = IntegerFor<std::max(B, 63)>;
  std::array<Magnitude, N> magnitude;
  Magnitude all(0);
  for (std::size_t i = 0; i < N; ++i) {
    const auto raw = integer_cast<Magnitude>(v[i].raw());
    magnitude[i] = sign_of(raw) < 0 ? wrapping_subtract<Magnitude>(Magnitude(0), raw) : raw;
    all = std::max(all, magnitude[i]);
  }
  const int scale = 62 - positive_bit_length(all);
  std::array<std::uint64_t, N> scaled;
  std::uint64_t squared = 1;  // at least 2^58, but for the vector 0
  for (std::size_t i = 0; i < N; ++i) {
    scaled[i] = integer_cast<std::uint64_t>(scale >= 0 ? shift_left(magnitude[i], scale)
                                                       : shift_right_floor(magnitude[i], -scale));
    squared += multiply_words(scaled[i], scaled[i]).high;
  }
  const int shift = std::countl_zero(squared) & ~1;
  const std::uint64_t reciprocal = detail::reciprocal_root(squared << shift);

  std::array<finer<S, 30>, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    const std::uint64_t share = multiply_words(scaled[i], reciprocal).high << (shift / 2);  // Q62
    const auto part = static_cast<std::int64_t>(
        multiply_words(share, static_cast<std::uint64_t>(length.raw()) << 32).high);
    result[i] = finer<S, 30>::assume_raw(v[i].raw() < 0 ? -part : part);
  }
  return result;
}

}  // namespace detent
