// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/number/rounding.hpp"

namespace detent {

/// Up to 256 equally spaced planes perpendicular to one axis, the first at `least`. They enclose
/// [least, greatest]. A coordinate between them is quantized to one byte, rounded down or up.
///                                                        (tests/cull/slabs.test.cpp)
template <Scalar S>
class ByteGrid;

/// The spacing is the least power of two of raw units that suffices.
template <int Bits, int Frac>
class ByteGrid<Fixed<Bits, Frac>> {
  using S = Fixed<Bits, Frac>;

 public:
  constexpr ByteGrid() noexcept = default;
  constexpr ByteGrid(const S& least, const S& greatest) noexcept : origin_(least) {
    const auto size = offset(greatest);
    while (ceiling(size) > 255) ++shift_;
  }

  /// The last plane at or below x, clamped to the grid.
  [[nodiscard]] constexpr std::uint8_t below(const S& x) const noexcept {
    return byte(offset(x) >> shift_);
  }
  /// The first plane at or above x, clamped to the grid.
  [[nodiscard]] constexpr std::uint8_t above(const S& x) const noexcept {
    return byte(ceiling(offset(x)));
  }
  /// The coordinate of a plane, clamped to the greatest number.
  [[nodiscard]] constexpr S plane(std::uint8_t k) const noexcept {
    return detail::clamp_raw<S>(origin() + k * step());
  }

  /// The raw coordinate of the first plane and the raw spacing.
  [[nodiscard]] constexpr std::int64_t origin() const noexcept { return origin_.raw(); }
  [[nodiscard]] constexpr std::int64_t step() const noexcept { return std::int64_t{1} << shift_; }

  [[nodiscard]] friend constexpr bool operator==(const ByteGrid&,
                                                 const ByteGrid&) noexcept = default;
  template <class D>
  friend constexpr void append(D& digest, const ByteGrid& grid) noexcept {
    digest.add(grid.origin_, grid.shift_);
  }

 private:
  [[nodiscard]] constexpr std::int64_t offset(const S& x) const noexcept {
    return std::int64_t{x.raw()} - origin_.raw();
  }
  [[nodiscard]] constexpr std::int64_t ceiling(std::int64_t offset) const noexcept {
    return (offset + step() - 1) >> shift_;
  }
  [[nodiscard]] static constexpr std::uint8_t byte(std::int64_t k) noexcept {
    return static_cast<std::uint8_t>(std::clamp<std::int64_t>(k, 0, 255));
  }

  S origin_{};
  std::uint8_t shift_ = 0;
};

#if __STDC_HOSTED__
template <Scalar F>
requires std::floating_point<F>
class ByteGrid<F> {
 public:
  constexpr ByteGrid() noexcept = default;
  constexpr ByteGrid(F least, F greatest) noexcept
      : origin_(least), step_(greatest / 254 - least / 254) {}

  [[nodiscard]] constexpr std::uint8_t below(F x) const noexcept {
    return byte((x - origin_) / step_ - F{1} / 1024);
  }
  [[nodiscard]] constexpr std::uint8_t above(F x) const noexcept {
    return byte((x - origin_) / step_ + (F{1} + F{1} / 1024));
  }
  [[nodiscard]] constexpr F plane(std::uint8_t k) const noexcept { return origin_ + k * step_; }

  [[nodiscard]] constexpr F origin() const noexcept { return origin_; }
  [[nodiscard]] constexpr F step() const noexcept { return step_; }

  [[nodiscard]] friend constexpr bool operator==(const ByteGrid&,
                                                 const ByteGrid&) noexcept = default;
  template <class D>
  friend constexpr void append(D& digest, const ByteGrid& grid) noexcept {
    digest.add(grid.origin_, grid.step_);
  }

 private:
  [[nodiscard]] static constexpr std::uint8_t byte(F k) noexcept {
    return k > 0 ? static_cast<std::uint8_t>((std::min)(k, F{255})) : 0;  // a NaN is 0
  }

  F origin_ = 0, step_ = 0;
};
#endif

}  // namespace detent
