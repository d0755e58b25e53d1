// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/number/scalar.hpp"

namespace detent {

/// Sorts numbers of [least, greatest] into 16 bins of equal width, in order, without a division.
/// The result is the same on every machine.
///
/// The width of a bin is the smallest power of two for which 16 bins suffice. So at least 9 are
/// used, unless the range holds fewer numbers.
template <Number T>
class Bins;

inline constexpr std::size_t bin_count = 16;

template <int Bits, int Frac>
class Bins<Fixed<Bits, Frac>> {
  using T = Fixed<Bits, Frac>;

 public:
  constexpr Bins(const T& least, const T& greatest) noexcept
      : least_(least), shift_((std::max)(bit_length((greatest - least).raw()) - 4, 0)) {}

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
  // cppcheck-suppress uninitMemberVar  // false positive: the members of the other Bins
  constexpr Bins(F least, F greatest) noexcept
      : least_(least), scale_(greatest > least ? static_cast<F>(15.99) / (greatest - least) : 0) {}

  [[nodiscard]] constexpr std::size_t operator()(F x) const noexcept {
    const F bin = (x - least_) * scale_;
    return bin > 0 ? static_cast<std::size_t>((std::min)(bin, F{15})) : 0;  // a NaN goes to bin 0
  }

 private:
  F least_, scale_;
};

/// Rounds sizes down to 14 bits, for products that are only compared with each other.
///
/// `longest` is the greatest size.
template <Number T>
class QuantizedSize;

template <int Bits, int Frac>
class QuantizedSize<Fixed<Bits, Frac>> {
  using T = Fixed<Bits, Frac>;

 public:
  explicit constexpr QuantizedSize(const T& longest) noexcept
      : shift_((std::max)(bit_length(longest.raw()) - 14, 0)) {}

  [[nodiscard]] constexpr Fixed<14, 0> operator()(const T& size) const noexcept {
    return Fixed<14, 0>::assume_raw(static_cast<std::int16_t>(size.raw() >> shift_));
  }

 private:
  int shift_;
};

template <Number F>
requires std::floating_point<F>
class QuantizedSize<F> {
 public:
  // cppcheck-suppress uninitMemberVar  // false positive: the members of the other QuantizedSize
  explicit constexpr QuantizedSize(F) noexcept {}
  [[nodiscard]] constexpr F operator()(F size) const noexcept { return size; }
};

/// a[i] = min(a[i], b[i]); for integers, one vector instruction.
template <Number T, std::size_t Size>
constexpr void lower(std::array<T, Size>& a, const std::array<T, Size>& b) noexcept {
  if constexpr (is_fixed<T>) {
    for (std::size_t i = 0; i < Size; ++i) {
      const auto x = a[i].raw(), y = b[i].raw();
      a[i] = T::assume_raw(y < x ? y : x);
    }
  } else {
    for (std::size_t i = 0; i < Size; ++i) a[i] = b[i] < a[i] ? b[i] : a[i];
  }
}

/// The mean of two numbers, within one step of their grid; monotone in both.
template <Number T>
[[nodiscard]] constexpr T mean(const T& a, const T& b) noexcept {
  if constexpr (is_fixed<T>) {
    return T::assume_raw(static_cast<typename T::raw_type>((a.raw() >> 1) + (b.raw() >> 1)));
  } else {
    return a / 2 + b / 2;
  }
}

/// A bijection of the type that reverses the order; applied twice it gives x again.
template <Number T>
[[nodiscard]] constexpr T reversed(const T& x) noexcept {
  if constexpr (is_fixed<T>) {
    return T::assume_raw(static_cast<typename T::raw_type>(~x.raw()));
  } else {
    return -x;
  }
}

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
