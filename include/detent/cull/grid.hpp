// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "detent/number/scalar.hpp"

namespace detent::detail {

/// The grid of a scene's boxes: coordinates quantized so that their differences fit 32 bits, rounded
/// outward. Conservative: what it separates is disjoint, what it lets through is tested exactly.
template <Scalar S>
struct Grid {
  using Coordinate = S;
  using Time = S;
  using Area = S;
  static constexpr Coordinate beyond = std::numeric_limits<S>::infinity();
  static constexpr Coordinate below(const S& x) noexcept { return x; }
  static constexpr Coordinate above(const S& x) noexcept { return x; }
  static constexpr Area area_extent(Coordinate low, Coordinate high) noexcept { return high - low; }

  using Length = S;
  static constexpr Length padded(const S& length, const S& greatest) noexcept {
    return length + greatest / 256;
  }
  template <std::size_t N>
  static constexpr Length reach(const std::array<Length, N>& extents,
                                const std::array<S, N>& row) noexcept {
    Length sum = 0;
    for (std::size_t i = 0; i < N; ++i) sum += extents[i] * (row[i] < 0 ? -row[i] : row[i]);
    return sum;
  }
  /// The padding exceeds the rounding error of sums near `x`.
  static constexpr Coordinate below(const S& x, const Length& reach) noexcept {
    return x - (reach + (x < 0 ? -x : x) / 1048576);
  }
  static constexpr Coordinate above(const S& x, const Length& reach) noexcept {
    return x + (reach + (x < 0 ? -x : x) / 1048576);
  }
};

/// Scalars lie in [-2^28, 2^28] on the grid, and +-2^30 means unbounded. The ends of the scalar's
/// range map to +-2^30 too, because boxes are clamped there.
///
/// A shape with its margin may reach beyond the scalar's range. So lengths are added on the grid,
/// never in the scalar, whose range would cut the margin off. Sums are clamped to +-2^30. Clamping
/// keeps the order: boxes with a common point still have one, and rays end within 2^29.
template <int Bits, int Frac>
struct Grid<Fixed<Bits, Frac>> {
  using S = Fixed<Bits, Frac>;
  using Coordinate = std::int32_t;
  using Time = std::int64_t;
  using Area = std::uint64_t;
  static constexpr int shift = Bits > 28 ? Bits - 28 : 0;
  static constexpr Coordinate beyond = Coordinate{1} << 30;

  static constexpr Coordinate below(const S& x) noexcept {
    return x <= S::lowest() ? -beyond : Coordinate{x.raw()} >> shift;
  }
  static constexpr Coordinate above(const S& x) noexcept {
    const Coordinate raw{x.raw()};
    constexpr Coordinate dropped = (Coordinate{1} << shift) - 1;
    return x >= (S::max)() ? beyond : (raw >> shift) + ((raw & dropped) == 0 ? 0 : 1);
  }
  /// At most 2^30, so that twelve products of two of them fit 64 bits.
  static constexpr Area area_extent(Coordinate low, Coordinate high) noexcept {
    return (static_cast<Area>(high) - static_cast<Area>(low)) >> 1;
  }

  /// A length, in steps of the grid.
  using Length = std::int64_t;
  using Component = direction_component<S>;

  /// `length` and 2^-8 of `greatest`, neither negative, rounded up: below 2^29.
  static constexpr Length padded(const S& length, const S& greatest) noexcept {
    constexpr Length up = (Length{1} << (shift + 8)) - 1;
    return (256 * Length{length.raw()} + greatest.raw() + up) >> (shift + 8);
  }
  /// The sum of extents[i] |row[i]|, rounded up; at most 3 * 2^29 * 2^30 before the shift.
  template <std::size_t N>
  static constexpr Length reach(const std::array<Length, N>& extents,
                                const std::array<Component, N>& row) noexcept {
    Length sum = (Length{1} << Component::frac) - 1;
    for (std::size_t i = 0; i < N; ++i) {
      const Length cosine = row[i].raw();
      sum += extents[i] * (cosine < 0 ? -cosine : cosine);
    }
    return sum >> Component::frac;
  }
  /// x - reach and x + reach, rounded outward.
  static constexpr Coordinate below(const S& x, const Length& reach) noexcept {
    return clamp((Length{x.raw()} >> shift) - reach);
  }
  static constexpr Coordinate above(const S& x, const Length& reach) noexcept {
    return clamp(reach - (-Length{x.raw()} >> shift));
  }

 private:
  static constexpr Coordinate clamp(Length x) noexcept {
    return static_cast<Coordinate>(std::clamp<Length>(x, -beyond, beyond));
  }
};

/// One axis of a ray: the distances at which it passes coordinates of the grid.
///
/// A time is off by less than `slack` up to the longest ray; beyond that it does not matter.
template <Scalar S>
class CullingAxis {
 public:
  using Coordinate = typename Grid<S>::Coordinate;
  using Time = typename Grid<S>::Time;
  static constexpr Time slack = Time(is_fixed<S> ? 4 : 0);

  CullingAxis() noexcept = default;
  constexpr CullingAxis(const S& origin, const direction_component<S>& direction) noexcept
      : is_negative_(direction < 0) {
    if constexpr (is_fixed<S>) {
      // m / 2^s is 1 / |d|, rounded down with a relative error below 2^-30. A time of at most 2^29
      // is off by 1 for that and by 1 for its own rounding. Boxes are a step wider, so that a ray
      // along one of their sides lies inside; with a direction of 0 the times of both sides then
      // lie beyond all rays.
      const auto raw = static_cast<std::uint64_t>(direction.raw() < 0 ? -Time{direction.raw()}
                                                                      : Time{direction.raw()});
      const auto width = static_cast<int>(std::bit_width(raw));
      const auto m =
          raw == 0 ? Time{1} << 31 : static_cast<Time>((std::uint64_t{1} << (30 + width)) / raw);
      shift_ = raw == 0 ? 0 : 30 + width - direction_component<S>::frac;
      factor_ = is_negative_ ? -m : m;
      const Coordinate start = Coordinate{origin.raw()} >> Grid<S>::shift;
      enter_from_ = is_negative_ ? start - 1 : start + 1;
      exit_from_ = is_negative_ ? start + 1 : start - 1;
    } else {
      factor_ = S(1) / direction;
      enter_from_ = exit_from_ = origin;
    }
  }

  /// Whether the direction is negative: then the ray enters a box at its upper side.
  [[nodiscard]] constexpr bool is_negative() const noexcept { return is_negative_; }

  [[nodiscard]] constexpr Time enter(Coordinate side) const noexcept {
    return at(side, enter_from_);
  }
  [[nodiscard]] constexpr Time exit(Coordinate side) const noexcept { return at(side, exit_from_); }

 private:
  [[nodiscard]] constexpr Time at(Coordinate side, Coordinate from) const noexcept {
    if constexpr (is_fixed<S>) {
      // |side - from| < 2^31 and |factor| <= 2^31.
      return ((Time{side} - from) * factor_) >> shift_;
    } else {
      return (side - from) * factor_;
    }
  }

  Time factor_{};
  Coordinate enter_from_{};
  Coordinate exit_from_{};
  int shift_ = 0;
  bool is_negative_ = false;
};

}  // namespace detent::detail
