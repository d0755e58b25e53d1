// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "detent/number/scalar.hpp"

namespace detent::detail {

/// The numbers of a broad phase: coordinates on a grid coarse enough that differences of them fit
/// 32 bits, rounded outward. What it keeps apart is apart; what it lets through is asked exactly.
template <Scalar S>
struct Culling {
  using Coordinate = S;
  using Time = S;
  using Area = S;
  static constexpr Coordinate beyond = std::numeric_limits<S>::infinity();
  static constexpr Coordinate below(const S& x) noexcept { return x; }
  static constexpr Coordinate above(const S& x) noexcept { return x; }
  static constexpr Area area_extent(Coordinate low, Coordinate high) noexcept { return high - low; }
};

/// Scalars lie in [-2^28, 2^28] on the grid, and +-2^30 means without end: so does an end of the
/// scalar's range, at which boxes are cut off.
template <int Bits, int Frac>
struct Culling<Fixed<Bits, Frac>> {
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
};

/// One axis of a ray, for the distances at which it passes coordinates of the grid.
///
/// A time is off by less than `slack` where it matters, which is up to the longest ray.
template <Scalar S>
class CullingAxis {
 public:
  using Grid = Culling<S>;
  using Coordinate = typename Grid::Coordinate;
  using Time = typename Grid::Time;
  static constexpr Time slack = Time(is_fixed<S> ? 4 : 0);

  CullingAxis() noexcept = default;
  constexpr CullingAxis(const S& origin, const direction_component<S>& direction) noexcept
      : is_negative_(direction < 0) {
    if constexpr (is_fixed<S>) {
      // m / 2^s is 1 / |d|, rounded down by less than 2^-30 of itself: a time of at most 2^29 is
      // off by 1 for that and by 1 for being rounded. Boxes are a step wider, so that a ray along
      // one of their sides lies inside; a direction of 0 then passes both sides beyond all rays.
      const auto raw = static_cast<std::uint64_t>(direction.raw() < 0 ? -Time{direction.raw()}
                                                                      : Time{direction.raw()});
      const auto width = static_cast<int>(std::bit_width(raw));
      const auto m =
          raw == 0 ? Time{1} << 31 : static_cast<Time>((std::uint64_t{1} << (30 + width)) / raw);
      shift_ = raw == 0 ? 0 : 30 + width - direction_component<S>::frac;
      factor_ = is_negative_ ? -m : m;
      const Coordinate start = Coordinate{origin.raw()} >> Grid::shift;
      enter_from_ = is_negative_ ? start - 1 : start + 1;
      exit_from_ = is_negative_ ? start + 1 : start - 1;
    } else {
      factor_ = S(1) / direction;
      enter_from_ = exit_from_ = origin;
    }
  }

  /// Whether the ray comes from above: then it enters at the upper side of a box.
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
