// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "detent/number/scalar.hpp"

// Stores and loads numbers as little-endian bytes of their own width, the same bytes that a digest
// takes.

namespace detent::detail {

template <class T>
struct word_of {};
template <class T>
requires(std::integral<T> || std::is_enum_v<T>) struct word_of<T> {
  using type = std::make_unsigned_t<T>;
};
template <int Bits, int Frac>
struct word_of<Fixed<Bits, Frac>> {
  using type = std::make_unsigned_t<typename Fixed<Bits, Frac>::raw_type>;
};
template <>
struct word_of<float> {
  using type = std::uint32_t;
};
template <>
struct word_of<double> {
  using type = std::uint64_t;
};

/// The bits of a number.
template <class T>
using Word = typename word_of<T>::type;

template <class T>
[[nodiscard]] constexpr Word<T> to_word(const T& value) noexcept {
  if constexpr (is_fixed<T>) {
    return static_cast<Word<T>>(value.raw());
  } else {
    return std::bit_cast<Word<T>>(value);
  }
}

/// The number with these bits. If a `Fixed` is narrower than its integer, bits out of range are
/// clamped.
template <class T>
[[nodiscard]] constexpr T from_word(Word<T> word) noexcept {
  if constexpr (is_fixed<T>) {
    return T::from_raw(static_cast<typename T::raw_type>(word));
  } else {
    return std::bit_cast<T>(word);
  }
}

// No loops: compilers merge accesses to single bytes that are written out, even at -O2. In a long
// source g++ must be told to inline the stores, which halves the time of a snapshot.
#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#define DETENT_INLINE_STORES __attribute__((always_inline))
#else
#define DETENT_INLINE_STORES
#endif

template <std::unsigned_integral W>
constexpr void store_word(std::byte* to, W word) noexcept {
  [&]<std::size_t... I>(std::index_sequence<I...>) DETENT_INLINE_STORES {
    ((to[I] = static_cast<std::byte>(word >> (8 * I))), ...);
  }
  (std::make_index_sequence<sizeof(W)>());
}
#undef DETENT_INLINE_STORES

template <std::unsigned_integral W>
[[nodiscard]] constexpr W load_word(const std::byte* from) noexcept {
  using Sum = std::conditional_t<(sizeof(W) < 8), std::uint32_t, std::uint64_t>;
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return static_cast<W>(((std::to_integer<Sum>(from[I]) << (8 * I)) | ...));
  }
  (std::make_index_sequence<sizeof(W)>());
}

}  // namespace detent::detail
