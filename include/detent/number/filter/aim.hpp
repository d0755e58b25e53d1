// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/number/filter/components.hpp"

namespace detent {

/// The vector times a power of two, so that the longest component has 63 bits; each component is
/// rounded down. 0 stays 0.
template <int B, int F, std::size_t N>
[[nodiscard]] constexpr std::array<Fixed<63, 33>, N> leading_bits(
    const std::array<Fixed<B, F>, N>& v) noexcept {
  using Raw = typename Fixed<B, F>::raw_type;
  std::array<Fixed<63, 33>, N> result;
  if constexpr (B <= 63) {
    std::uint64_t all = 1;
    for (const auto& c : v) {
      const std::int64_t raw = c.raw();
      all |= static_cast<std::uint64_t>(raw ^ (raw >> 63));
    }
    // A product, because GCC moves shifts to vector registers and back.
    const std::int64_t scale = std::int64_t{1} << (std::countl_zero(all) - 1);
    for (std::size_t i = 0; i < N; ++i) {
      result[i] = Fixed<63, 33>::assume_raw(wrapping_multiply<std::int64_t>(v[i].raw(), scale));
    }
  } else {
    bool fit_word = true;
    for (const auto& c : v) {
      const auto top = shift_right_floor(c.raw(), 62);
      bool fits = top == Raw(0);
      fits |= top == Raw(-1);
      fit_word &= fits;
    }
    if (fit_word) {
      std::array<Fixed<62, F>, N> words;
      for (std::size_t i = 0; i < N; ++i) words[i] = narrow<62>(v[i]);
      return leading_bits(words);
    }
    int length = 0;
    for (const auto& c : v) length = (std::max)(length, bit_length(c.raw()));
    for (std::size_t i = 0; i < N; ++i) {
      result[i] = Fixed<63, 33>::assume_raw(detail::scaled_word(v[i].raw(), length - 63));
    }
  }
  return result;
}

/// The result of `decide_unit`. GCC 12 would combine shorter components in memory.
template <class Component, std::size_t N>
using UnitFilter = Decided<std::array<Fixed<62, Component::frac>, N>>;

/// Filter: the unit vector along a vector whose components exceed those of `v` by more than -1 and
/// less than 2 steps (docs/filters.md, lemma 38).
template <class Component, int F, std::size_t N>
[[nodiscard]] constexpr UnitFilter<Component, N> decide_unit(
    const std::array<Fixed<62, F>, N>& v) noexcept {
  const auto high = [](std::int64_t a, std::int64_t b) {
    return integer_cast<std::int64_t>(shift_right_floor(wrapping_multiply<Int128>(a, b), 64));
  };
  // Twice v, as GCC otherwise knows that v fits 64 bits of a sum of 128, and multiplies all 128.
  std::array<std::int64_t, N> twice;
  std::int64_t squared = 0;
  for (std::size_t i = 0; i < N; ++i) {
    twice[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(v[i].raw()) << 1);
    squared += high(twice[i], twice[i]);
  }
  UnitFilter<Component, N> result;
  result.is_sure = squared >= std::int64_t{1} << 53;
  const auto positive = static_cast<std::uint64_t>(squared | 1);
  const int shift = std::countl_zero(positive) & ~1;
  const auto reciprocal =
      static_cast<std::int64_t>(detail::reciprocal_root(positive << shift) >> 1);
  for (std::size_t i = 0; i < N; ++i) {
    const std::int64_t part = shift_left(high(twice[i], reciprocal), shift / 2 + 1);
    const auto nearest = decide_nearest<Fixed<62, Component::frac>>(
        Approximate{detail::Share::assume_raw(part), Steps<(1 << 18) + (1 << 11)>()});
    result.value[i] = nearest.value;
    result.is_sure &= nearest.is_sure;  // no branch per component
  }
  return result;
}

}  // namespace detent
