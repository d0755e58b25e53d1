// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/number/filter/components.hpp"

// Without it, in a long source, g++ passes the components through memory and waits for them.
#if defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define DETENT_INLINE_FILTER __attribute__((always_inline))
#else
#define DETENT_INLINE_FILTER
#endif

namespace detent {

/// a b rounded down to the grid of T, which must hold it, from one product of words.
template <class T, int BA, int FA, int BB, int FB>
[[nodiscard]] constexpr T floor_product(const Fixed<BA, FA>& a, const Fixed<BB, FB>& b) noexcept {
  constexpr int dropped = FA + FB - T::frac;
  const std::int64_t x = a.raw(), y = b.raw();
  if constexpr (dropped == 0) {
    return T::assume_raw(x * y);
  } else {
    static_assert(0 < dropped && BB + 64 - dropped <= 63);
    return T::assume_raw(detail::high_word(x, shift_left(y, 64 - dropped)));
  }
}

/// The numbers in multiples of a power of two times `unit`, by which `unit` is from 1/2 to 1. Unsure
/// if `unit` is not positive, or another is more than 4 times as long.
template <int F>
[[nodiscard]] constexpr Decided<std::array<Fixed<62, 60>, 3>> in_units(
    const Fixed<62, F>& x, const Fixed<62, F>& y, const Fixed<30, 0>& unit) noexcept {
  const std::int64_t whole = unit.raw(), limit = whole << (F + 2);
  const auto is_near = [&](std::int64_t a) { return a <= limit && a >= -limit; };
  if (whole <= 0 || !is_near(x.raw()) || !is_near(y.raw())) return {{}, false};
  const int up = std::countl_zero(static_cast<std::uint64_t>(whole)) - 4;
  const std::int64_t scale = std::int64_t{1} << (up - F);  // GCC moves shifts to vector registers
  const auto scaled = [&](std::int64_t a) { return Fixed<62, 60>::assume_raw(a * scale); };
  return {{scaled(x.raw()), scaled(y.raw()), Fixed<62, 60>::assume_raw(whole << up)}, true};
}

/// The result of `decide_opposite`. GCC 12 would combine shorter components in memory.
template <class Component, std::size_t N>
using UnitFilter = Decided<std::array<Fixed<62, Component::frac>, N>>;

/// Filter: the unit vector opposite to a vector whose components exceed those of `v` by more than -2
/// and less than 2 steps (docs/filters.md, lemma 38).
template <class Component, int F, std::size_t N>
[[nodiscard]] DETENT_INLINE_FILTER constexpr UnitFilter<Component, N> decide_opposite(
    const std::array<Fixed<62, F>, N>& v) noexcept {
  // Twice v, as GCC otherwise knows that v fits 64 bits of a sum of 128, and multiplies all 128.
  std::array<std::int64_t, N> twice;
  std::int64_t squared = 0;
  for (std::size_t i = 0; i < N; ++i) {
    twice[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(v[i].raw()) << 1);
    squared += detail::high_word(twice[i], twice[i]);
  }
  UnitFilter<Component, N> result;
  result.is_sure = squared >= std::int64_t{1} << 51;
  if (!result.is_sure) [[unlikely]]
    return result;
  const auto positive = static_cast<std::uint64_t>(squared);
  const int half = std::countl_zero(positive) >> 1;
  using Value = Fixed<62, 55>;
  // If GCC knew that a factor is positive, it would compute three products.
  const std::int64_t reciprocal =
      -static_cast<std::int64_t>(detail::reciprocal_root(positive << (2 * half)) >> (7 - half));
  for (std::size_t i = 0; i < N; ++i) {
    const auto nearest = decide_nearest<Fixed<62, Component::frac>>(Approximate{
        Value::assume_raw(detail::high_word(twice[i], reciprocal)), Steps<(1 << 12)>()});
    result.value[i] = nearest.value;
    result.is_sure = nearest.is_sure;
    if (!result.is_sure) [[unlikely]]
      return result;
  }
  return result;
}

}  // namespace detent

#undef DETENT_INLINE_FILTER
