// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/number/require_cxx20.hpp"

// Eight numbers side by side. Where the machine has the vector instructions, Lanes are a compiler's
// vector (an extension of GCC and Clang). Elsewhere, and for constants, they are an array with the
// same operations, and so the same numbers.                    (tests/cull/lanes.test.cpp)

namespace detent::detail {

inline constexpr std::size_t lane_count = 8;

template <class T>
class ArrayLanes {
 public:
  explicit constexpr ArrayLanes(T x) noexcept { numbers_.fill(x); }

  /// first + step * bytes[k] in lane k.
  constexpr ArrayLanes(T first, T step,
                       const std::array<std::uint8_t, lane_count>& bytes) noexcept {
    for (std::size_t k = 0; k < lane_count; ++k) {
      numbers_[k] = static_cast<T>(first + static_cast<T>(bytes[k]) * step);
    }
  }

  constexpr void raise(const ArrayLanes& x) noexcept {
    for (std::size_t k = 0; k < lane_count; ++k) {
      numbers_[k] = x.numbers_[k] > numbers_[k] ? x.numbers_[k] : numbers_[k];
    }
  }
  constexpr void lower(const ArrayLanes& x) noexcept {
    for (std::size_t k = 0; k < lane_count; ++k) {
      numbers_[k] = x.numbers_[k] < numbers_[k] ? x.numbers_[k] : numbers_[k];
    }
  }
  /// A bit for each lane that is not above the same lane of x.
  [[nodiscard]] constexpr std::uint32_t up_to(const ArrayLanes& x) const noexcept {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < lane_count; ++k) {
      bits |= numbers_[k] <= x.numbers_[k] ? std::uint32_t{1} << k : 0;
    }
    return bits;
  }
  constexpr void store(std::array<T, lane_count>& to) const noexcept { to = numbers_; }

 private:
  std::array<T, lane_count> numbers_{};
};

#if defined(__GNUC__)
template <class T>
class VectorLanes {
  typedef T Vector __attribute__((vector_size(lane_count * sizeof(T))));

 public:
  explicit VectorLanes(T x) noexcept : numbers_(x - Vector{}) {}
  VectorLanes(T first, T step, const std::array<std::uint8_t, lane_count>& bytes) noexcept
      : numbers_(first + step * Vector{T(bytes[0]), T(bytes[1]), T(bytes[2]), T(bytes[3]),
                                       T(bytes[4]), T(bytes[5]), T(bytes[6]), T(bytes[7])}) {}

  void raise(const VectorLanes& x) noexcept {
    numbers_ = x.numbers_ > numbers_ ? x.numbers_ : numbers_;
  }
  void lower(const VectorLanes& x) noexcept {
    numbers_ = x.numbers_ < numbers_ ? x.numbers_ : numbers_;
  }
  [[nodiscard]] std::uint32_t up_to(const VectorLanes& x) const noexcept {
    const auto within = numbers_ <= x.numbers_;  // all bits of a lane, or none
    const auto bits = within & decltype(within){1, 2, 4, 8, 16, 32, 64, 128};
    std::uint32_t sum = 0;
    for (std::size_t k = 0; k < lane_count; ++k) sum |= static_cast<std::uint32_t>(bits[k]);
    return sum;
  }
  void store(std::array<T, lane_count>& to) const noexcept {
    to = std::bit_cast<std::array<T, lane_count>>(numbers_);
  }

 private:
  Vector numbers_;
};
#endif

// Below AVX2 some of these operations have no instruction, and an array takes three quarters of the
// time.
#if defined(__GNUC__) && defined(__AVX2__)
template <class T>
using Lanes = VectorLanes<T>;
#else
template <class T>
using Lanes = ArrayLanes<T>;
#endif

}  // namespace detent::detail
