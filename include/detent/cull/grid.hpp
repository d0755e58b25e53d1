// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "detent/number/rounding.hpp"
#include "detent/number/scalar.hpp"

namespace detent::detail {

/// The reach of a shape from its center or core, on the grid, rounded up. Every constructor adds
/// the margin that boxes need (quantized_box.hpp), unless the scalar's range cuts it off.
///                                  (tests/cull/grid.test.cpp, tests/scene/bounds.test.cpp)
template <Scalar S>
class Reach;

/// The grid of a scene's boxes: coordinates quantized so that their differences fit 32 bits,
/// rounded outward. Conservative: boxes that it separates are disjoint, all others are tested
/// exactly.
template <Scalar S>
struct Grid {
  using Coordinate = S;
  using Area = S;
  static constexpr Coordinate beyond = std::numeric_limits<S>::infinity();
  static constexpr Coordinate below(const S& x) noexcept { return x; }
  static constexpr Coordinate above(const S& x) noexcept { return x; }
  static constexpr S step(const S& x) noexcept { return x; }
  static constexpr S plane(Coordinate x) noexcept { return x; }
  static constexpr S scalar(Coordinate x) noexcept { return x; }
  static constexpr Area area_extent(Coordinate low, Coordinate high) noexcept { return high - low; }

  /// More than the rounding error of sums near `x` is added.
  static constexpr Coordinate below(const S& x, const Reach<S>& reach) noexcept {
    return x - (reach.steps() + (x < 0 ? -x : x) / 1048576);
  }
  static constexpr Coordinate above(const S& x, const Reach<S>& reach) noexcept {
    return x + (reach.steps() + (x < 0 ? -x : x) / 1048576);
  }
};

/// Scalars lie in [-2^28, 2^28] on the grid, and +-2^30 means unbounded. The ends of the scalar's
/// range map to +-2^30 too, because boxes are clamped there.
///
/// Sums with a reach are exact, then clamped to +-2^30. Clamping keeps the order: boxes with a
/// common point still have one, and rays end within 2^29.
template <int Bits, int Frac>
struct Grid<Fixed<Bits, Frac>> {
  using S = Fixed<Bits, Frac>;
  using Coordinate = std::int32_t;
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
  /// The last step at or below x.
  static constexpr std::int64_t step(const S& x) noexcept { return x.raw() >> shift; }
  /// A coordinate as a raw number, for `RaySlab`. Coordinates beyond the reach of any scalar plus a
  /// distance are clamped to less than 2^33 from every scalar.
  static constexpr std::int64_t plane(Coordinate x) noexcept {
    constexpr std::int64_t most = std::int64_t{11} << 29;
    return std::clamp(std::int64_t{x} * (std::int64_t{1} << shift), -most, most);
  }
  /// The scalar at a coordinate, clamped to the range.
  static constexpr S scalar(Coordinate x) noexcept { return clamp_raw<S>(plane(x)); }
  /// At most 2^30, so that twelve products of two of them fit 64 bits.
  static constexpr Area area_extent(Coordinate low, Coordinate high) noexcept {
    return (static_cast<Area>(high) - static_cast<Area>(low)) >> 1;
  }

  /// x - reach and x + reach, rounded outward.
  static constexpr Coordinate below(const S& x, const Reach<S>& reach) noexcept {
    return clamp((std::int64_t{x.raw()} >> shift) - reach.steps());
  }
  static constexpr Coordinate above(const S& x, const Reach<S>& reach) noexcept {
    return clamp(reach.steps() - (-std::int64_t{x.raw()} >> shift));
  }

 private:
  static constexpr Coordinate clamp(std::int64_t x) noexcept {
    return static_cast<Coordinate>(std::clamp<std::int64_t>(x, -beyond, beyond));
  }
};

template <Scalar S>
class Reach {
 public:
  constexpr Reach() noexcept = default;
  constexpr Reach(const S& length, const S& greatest) noexcept : steps_(length + greatest / 256) {}
  template <std::size_t N>
  constexpr Reach(const std::array<Reach, N>& extents, const std::array<S, N>& row) noexcept {
    for (std::size_t i = 0; i < N; ++i)
      steps_ += extents[i].steps() * (row[i] < 0 ? -row[i] : row[i]);
  }
  [[nodiscard]] constexpr S steps() const noexcept { return steps_; }

 private:
  S steps_ = 0;
};

template <int Bits, int Frac>
class Reach<Fixed<Bits, Frac>> {
  using S = Fixed<Bits, Frac>;
  using Component = direction_component<S>;
  static constexpr int shift = Grid<S>::shift;

 public:
  constexpr Reach() noexcept = default;
  /// `length` and 2^-8 of `greatest`, neither negative: below 2^29 steps.
  constexpr Reach(const S& length, const S& greatest) noexcept
      : steps_((256 * std::int64_t{length.raw()} + greatest.raw() +
                (std::int64_t{1} << (shift + 8)) - 1) >>
               (shift + 8)) {}
  /// The sum of extents[i] |row[i]|; at most 3 * 2^29 * 2^30 before the shift.
  template <std::size_t N>
  constexpr Reach(const std::array<Reach, N>& extents,
                  const std::array<Component, N>& row) noexcept {
    std::int64_t sum = (std::int64_t{1} << Component::frac) - 1;
    for (std::size_t i = 0; i < N; ++i) {
      const std::int64_t cosine = row[i].raw();
      sum += extents[i].steps() * (cosine < 0 ? -cosine : cosine);
    }
    steps_ = sum >> Component::frac;
  }
  [[nodiscard]] constexpr std::int64_t steps() const noexcept { return steps_; }

 private:
  std::int64_t steps_ = 0;
};

}  // namespace detent::detail
