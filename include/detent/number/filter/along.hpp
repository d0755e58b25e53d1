// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/number/unit.hpp"

namespace detent {

/// length * v / |v| for length >= 0, or 0 if v is 0; each component is off by less than
/// 2^-13 + 2^-20 steps of S.
///
/// `rough_shares` gives |v_i| / |v| within 2^-44 + 2^-53, and a length has at most 31 bits.
template <class S, int B, int F, std::size_t N>
[[nodiscard]] constexpr std::array<finer<S, 30>, N> rough_along(
    const S& length, const std::array<Fixed<B, F>, N>& v) noexcept {
  using Magnitude = IntegerFor<(std::max)(B, 63)>;
  const auto shares = detail::rough_shares(detail::magnitudes<Magnitude>(v));
  std::array<finer<S, 30>, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    using Raw = typename finer<S, 30>::raw_type;
    const auto part = static_cast<Raw>(
        multiply_words(shares[i], static_cast<std::uint64_t>(length.raw()) << 32).high);
    result[i] = finer<S, 30>::assume_raw(v[i].raw() < 0 ? -part : part);
  }
  return result;
}

}  // namespace detent
