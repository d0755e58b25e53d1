// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "detent/number/scalar.hpp"

namespace detent {

/// Sorts numbers of [least, greatest] into 16 bins of equal width, in order: the same for every
/// number and machine, without a division.
///
/// The bins are a power of two wide, the smallest with which 16 suffice; so 9 or more are in use,
/// but for ranges that hold fewer numbers.
template <Number T>
class Bins;

inline constexpr std::size_t bin_count = 16;

template <int Bits, int Frac>
class Bins<Fixed<Bits, Frac>> {
  using T = Fixed<Bits, Frac>;

 public:
  constexpr Bins(const T& least, const T& greatest) noexcept
      : least_(least), shift_(std::max(bit_length((greatest - least).raw()) - 4, 0)) {}

  [[nodiscard]] constexpr std::size_t operator()(const T& x) const noexcept {
    return static_cast<std::size_t>((x - least_).raw() >> shift_);
  }

 private:
  T least_;
  int shift_;
};

template <Number F>
requires std::floating_point<F>
class Bins<F> {
 public:
  constexpr Bins(F least, F greatest) noexcept
      : least_(least), scale_(greatest > least ? F(15.99) / (greatest - least) : 0) {}

  [[nodiscard]] constexpr std::size_t operator()(F x) const noexcept {
    const F bin = (x - least_) * scale_;
    return bin > 0 ? static_cast<std::size_t>(std::min(bin, F(15))) : 0;  // a NaN is in the first
  }

 private:
  F least_, scale_;
};

/// x * count, exactly.
template <int Bits, int Frac>
[[nodiscard]] constexpr auto times(const Fixed<Bits, Frac>& x, std::uint32_t count) noexcept {
  return x * Fixed<32, 0>::assume_raw(std::int64_t{count});
}
template <std::floating_point F>
[[nodiscard]] constexpr F times(F x, std::uint32_t count) noexcept {
  return x * static_cast<F>(count);
}

}  // namespace detent
