// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/number/filter/components.hpp"

namespace detent {

/// A vector of up to three components of at most 31 bits: its square fits a word. Machines without
/// a product of words in one instruction have no use for it.
template <int F, std::size_t N>
requires(N <= 3) class ShortVector {
 public:
  explicit constexpr ShortVector(const std::array<Fixed<31, F>, N>& v) noexcept {
    for (std::size_t i = 0; i < N; ++i) {
      v_[i] = std::int64_t{v[i].raw()};
      squared_ += static_cast<std::uint64_t>(v_[i] * v_[i]);
    }
  }

  /// Whether it is longer than `length`, which is not negative.
  template <int B>
  requires(B <= 32)
      [[nodiscard]] constexpr bool is_longer_than(const Fixed<B, F>& length) const noexcept {
    const auto word = static_cast<std::uint64_t>(length.raw());
    return squared_ > word * word;
  }

  /// The vector over its length, for several steps along it; it must not be 0.
  class Unit {
   public:
    explicit constexpr Unit(const ShortVector& v) noexcept : v_(v.v_) {
      const int shift = std::countl_zero(v.squared_) & ~1;
      scale_ = shift / 2;
      half_ = static_cast<std::int64_t>(detail::reciprocal_root(v.squared_ << shift) >> 1);
    }

    /// length * v / |v|, within 2^-13 + 2^-28 steps of S, for |length| < 2^31 steps
    /// (docs/filters.md, lemma 33).
    template <int B>
    requires(B <= 31) [[nodiscard]] constexpr auto steps(const Fixed<B, F>& length) const noexcept {
      using Step = finer<Fixed<B, F>, 30>;
      Approximate<std::array<Step, N>, Steps<(1 << 17) + (1 << 10)>> result;
      const std::int64_t scaled = std::int64_t{length.raw()} * (std::int64_t{1} << scale_);
      for (std::size_t i = 0; i < N; ++i) {
        const auto product = wrapping_multiply<Int128>(v_[i] * scaled, half_);
        const auto high = integer_cast<std::int64_t>(shift_right_floor(product, 64));
        result.value[i] = Step::assume_raw(2 * high);
      }
      return result;
    }

   private:
    std::array<std::int64_t, N> v_;
    int scale_;          // |v| 2^scale is at least 2^31 and below 2^32
    std::int64_t half_;  // 2^93 / (|v| 2^scale)
  };
  [[nodiscard]] constexpr Unit unit() const noexcept { return Unit(*this); }

 private:
  std::array<std::int64_t, N> v_{};  // copies of short words, written in parts, would stall
  std::uint64_t squared_ = 0;
};

namespace detail {

/// Whether differences of numbers of type T may be components of a `ShortVector`.
template <class T>
inline constexpr bool has_short_vectors = false;
template <int B, int F>
inline constexpr bool has_short_vectors<Fixed<B, F>> = has_long_registers&& B > 15 && B <= 31;

}  // namespace detail

}  // namespace detent
