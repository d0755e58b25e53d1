// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/number/filter/components.hpp"
#include "detent/number/short_words.hpp"

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

/// x. GCC 12 would otherwise know that a sum of high words fits 64 bits of 128, and multiply all of
/// these.
template <int F>
[[nodiscard]] constexpr Fixed<63, F> of_unknown_size(const Fixed<62, F>& x) noexcept {
  return Fixed<63, F>::assume_raw(detail::in_register(std::int64_t{x.raw()}));
}

/// The result of `decide_opposite`. GCC 12 would combine shorter components in memory.
template <class Component>
using UnitFilter = Decided<std::array<Fixed<62, Component::frac>, 3>>;

namespace detail {

/// The sum of the high words of the squares, in steps of 2^-52.
[[nodiscard]] constexpr std::int64_t squared_high(const std::array<Fixed<63, 58>, 3>& v) noexcept {
  const auto high = [&](std::size_t i) { return high_word(v[i].raw(), v[i].raw()); };
  return high(0) + high(1) + high(2);
}

/// The high words of products with `factor`, in steps of 2^-55, off by less than `Error` of these
/// and rounded to nearest.
template <class Component, std::int64_t Error>
[[nodiscard]] DETENT_INLINE_FILTER constexpr UnitFilter<Component> decide_products(
    const std::array<Fixed<63, 58>, 3>& v, std::int64_t factor) noexcept {
  const auto component = [&](std::size_t i) {
    const auto value = Fixed<62, 55>::assume_raw(high_word(v[i].raw(), factor));
    return decide_nearest<Fixed<62, Component::frac>>(Approximate{value, Steps<Error>()});
  };
  return decide_all<std::array<Fixed<62, Component::frac>, 3>, 3>(component);
}

}  // namespace detail

/// Filter: the unit vector opposite to a vector whose components differ from those of `v` by less
/// than 2 steps (docs/filters.md, lemma 38).
template <class Component>
[[nodiscard]] DETENT_INLINE_FILTER constexpr UnitFilter<Component> decide_opposite(
    const std::array<Fixed<63, 58>, 3>& v) noexcept {
  const std::int64_t squared = detail::squared_high(v);
  if (squared < std::int64_t{1} << 49) [[unlikely]]
    return {{}, false};
  const auto positive = static_cast<std::uint64_t>(squared);
  const int half = std::countl_zero(positive) >> 1;
  // If GCC knew that a factor is positive, it would compute three products.
  const auto root = detail::reciprocal_root(positive << (2 * half)) >> (7 - half);
  return detail::decide_products<Component, (1 << 12)>(v, -static_cast<std::int64_t>(root));
}

/// Filter: the same in less time, if v is 1 to 2 long, or 1/2 to 2 if `MayBeHalf`. Its error is 2^12
/// or 2^15 steps of 2^-55, depending on that of v (docs/filters.md, lemma 45).
template <class Component, std::int64_t Error, bool MayBeHalf>
[[nodiscard]] DETENT_INLINE_FILTER constexpr UnitFilter<Component> decide_opposite_of_short(
    const std::array<Fixed<63, 58>, 3>& v) noexcept {
  const std::int64_t squared = detail::squared_high(v);
  constexpr std::int64_t one = std::int64_t{63} << 46;  // a little less than 1
  const int up = MayBeHalf && squared < one ? 1 : 0;
  const std::int64_t scaled = squared * (std::int64_t{1} << (2 * up));
  const std::uint64_t quarter = static_cast<std::uint64_t>(scaled) >> 34;  // in 2^-20
  if (!detail::has_reciprocal_root_chord(quarter)) [[unlikely]]
    return {{}, false};
  const std::int64_t y = detail::reciprocal_root_chord(quarter);
  // If GCC knew that it is positive, it would compute its sign.
  const auto word = static_cast<std::uint64_t>(detail::in_register(scaled));
  const std::int64_t root = detail::refined_reciprocal_root<30, 10>(word, -y);
  return detail::decide_products<Component, Error>(v, root * (std::int64_t{1} << up));
}

}  // namespace detent
