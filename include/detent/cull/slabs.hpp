// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "detent/cull/byte_grid.hpp"
#include "detent/cull/lanes.hpp"
#include "detent/number/integer.hpp"
#include "detent/number/scalar.hpp"

// A ray against the slabs of boxes. All ray traversals of trees, in scenes and meshes, use these
// distances.

namespace detent {

/// The unit of ray distance during traversal.
///
/// Distances beyond `longest` are irrelevant: there the ray has left all planes, or has ended.
template <Scalar S>
class Ticks;

/// One axis of a ray: the distances at which it enters and leaves slabs, in ticks, rounded outward.
/// The constructor adds the margin, so the part of the ray between two planes is never cut, but may
/// be extended a little. For culling; the shapes themselves decide.  (tests/cull/slabs.test.cpp)
template <Scalar S>
class RaySlab;

/// The distances at which a ray enters and leaves through planes of a grid. A plane is encoded as a
/// byte b: its distance is that of plane 0 plus b steps.
template <class Time>
class GridTimes {
 public:
  constexpr GridTimes(Time enter, Time leave, Time step) noexcept
      : enter_(enter), leave_(leave), step_(step) {}

  template <class Lanes>
  [[nodiscard]] constexpr Lanes enter(
      const std::array<std::uint8_t, detail::lane_count>& planes) const noexcept {
    return Lanes(enter_, step_, planes);
  }
  template <class Lanes>
  [[nodiscard]] constexpr Lanes leave(
      const std::array<std::uint8_t, detail::lane_count>& planes) const noexcept {
    return Lanes(leave_, step_, planes);
  }

 private:
  Time enter_, leave_, step_;
};

/// A tick is 2^exponent steps of the coordinates, and at least 2^-23 of `longest`: 32-bit times, of
/// which one vector instruction compares eight.
template <int Bits, int Frac>
class Ticks<Fixed<Bits, Frac>> {
  using S = Fixed<Bits, Frac>;

 public:
  using Time = std::int32_t;
  using Reach = Fixed<63, Frac>;

  /// Ticks of one step, for rays of any length in 64 bits.
  constexpr Ticks() noexcept = default;
  /// For planes at most `reach` away, summed over the axes; a direction is longer than 1 - 2^-12.
  constexpr Ticks(const Reach& reach, const S& limit) noexcept
      : longest_((std::min)(limit, detail::clamp_raw<S>(reach.raw() + (reach.raw() >> 8) + 1))),
        exponent_((std::max)(bit_length(longest_.raw()) - 23, -finest)),
        margin_(1 + (std::int64_t{3} << (std::max)(exponent_, 0))) {}

  [[nodiscard]] constexpr const S& longest() const noexcept { return longest_; }
  [[nodiscard]] constexpr int exponent() const noexcept { return exponent_; }
  /// The margin of `RaySlab` in steps: one, plus as many as take three ticks or more.
  [[nodiscard]] constexpr std::int64_t margin() const noexcept { return margin_; }
  [[nodiscard]] constexpr Time time(const S& distance) const noexcept {
    const std::int64_t raw = (std::min)(distance, longest_).raw();
    return static_cast<Time>((raw * (std::int64_t{1} << finest)) >> (exponent_ + finest));
  }

  /// Clamps a time. A clamped time is beyond `longest` or behind the origin, by at least 2^29
  /// ticks.
  [[nodiscard]] static constexpr Time clamp(std::int64_t time) noexcept {
    constexpr std::int64_t most = std::int64_t{1} << 30;
    return static_cast<Time>(std::clamp(time, -most, most));
  }

 private:
  static constexpr int finest = 12;

  S longest_ = largest<S>;
  int exponent_ = 0;
  std::int64_t margin_ = 4;
};

/// m / 2^shift ticks per step is 1 / |d|, rounded down by less than one part in 2^29. Below 2^29
/// ticks, the product and its own rounding lose less than two. So the ray enters a plane one step
/// early, and leaves it one step and three ticks late: `margin`.
///
/// A direction of 0 counts as the least nonzero one. A ray along a side of a box is then in the box
/// from before its start to beyond its end, because crossing the margin of four steps takes longer
/// than any ray lasts.
///
/// Coordinates are in steps of a grid; planes are less than 2^33 from the origin or from the sides of
/// a moving box, so products fit 64 bits.
template <int Bits, int Frac>
class RaySlab<Fixed<Bits, Frac>> {
  using S = Fixed<Bits, Frac>;
  using Component = direction_component<S>;

 public:
  using Time = std::int64_t;

  constexpr RaySlab() noexcept = default;
  /// For planes on a grid; `origin` is the last step at or below the origin of the ray.
  constexpr RaySlab(std::int64_t origin, const Component& direction, const Ticks<S>& ticks) noexcept
      : RaySlab(origin, origin, direction, ticks) {}
  /// For a moving box, whose sides start at `low` and `high`: its front enters a slab first, and
  /// its back leaves it last.
  constexpr RaySlab(std::int64_t low, std::int64_t high, const Component& direction,
                    const Ticks<S>& ticks) noexcept {
    const std::int64_t speed = direction.raw();
    const auto size =
        static_cast<std::uint64_t>(std::max<std::int64_t>(speed < 0 ? -speed : speed, 1));
    const auto width = static_cast<int>(std::bit_width(size));
    const auto inverse = static_cast<std::int64_t>((std::uint64_t{1} << (29 + width)) / size);
    const std::int64_t later = ticks.margin();
    shift_ = (std::max)(29 + width - Component::frac + ticks.exponent(), 0);
    factor_ = speed < 0 ? -inverse : inverse;
    enter_from_ = speed < 0 ? low - 1 : high + 1;
    leave_from_ = speed < 0 ? high + later : low - later;
    between_ = static_cast<typename Ticks<S>::Time>(
        (std::min)((((1 + later) * inverse) >> shift_) + 1, std::int64_t{1} << 28));
  }
  /// For planes whose coordinates are scalars.
  constexpr RaySlab(const S& origin, const Component& direction, const Ticks<S>& ticks) noexcept
      : RaySlab(std::int64_t{origin.raw()}, direction, ticks) {}

  /// Whether the ray enters a slab at its greatest coordinate.
  [[nodiscard]] constexpr bool is_backward() const noexcept { return factor_ < 0; }

  /// A lower bound of the distance at which the ray enters through a plane, and an upper bound of
  /// the distance at which it leaves through one.
  [[nodiscard]] constexpr Time enter(std::int64_t plane) const noexcept {
    return ((plane - enter_from_) * factor_) >> shift_;
  }
  [[nodiscard]] constexpr Time leave(std::int64_t plane) const noexcept {
    return ((plane - leave_from_) * factor_) >> shift_;
  }
  [[nodiscard]] constexpr Time enter(const S& plane) const noexcept { return enter(plane.raw()); }
  [[nodiscard]] constexpr Time leave(const S& plane) const noexcept { return leave(plane.raw()); }

  /// The same for planes of a grid, in 32 bits; not for a moving box.
  ///
  /// A step is at most 2^21 ticks, so 255 steps are less than 2^29. A ray with longer steps is so
  /// nearly parallel to the planes that it crosses less than four steps in the 2^23 ticks that
  /// matter. It gets steps of exactly 2^21 ticks, and four steps are added.
  [[nodiscard]] constexpr auto on_grid(const ByteGrid<S>& grid) const noexcept {
    using Short = typename Ticks<S>::Time;
    constexpr std::int64_t longest_step = 1 << 21;
    const std::int64_t step = (grid.step() * factor_) >> shift_;
    if (-longest_step <= step && step <= longest_step) {
      const Short first = Ticks<S>::clamp(enter(grid.origin()));
      // The step is rounded down, and it is added up to 255 times.
      return GridTimes<Short>(first, first + between_ + 255, static_cast<Short>(step));
    }
    const std::int64_t origin = is_backward() ? enter_from_ + 1 : enter_from_ - 1;
    const std::int64_t turned = step < 0 ? -longest_step : longest_step;
    const Short first = Ticks<S>::clamp(((grid.origin() - origin) * turned) / grid.step() - 1);
    return GridTimes<Short>(first, first + static_cast<Short>(4 * longest_step + 2),
                            static_cast<Short>(turned));
  }

 private:
  std::int64_t factor_ = 0, enter_from_ = 0, leave_from_ = 0;
  typename Ticks<S>::Time between_ = 0;
  int shift_ = 0;
};

/// One axis of a ray, or of a moving box, against planes of a scene's grid, in 32 bits and eight at
/// a time. Covers `reach` steps along the ray, fewer than 2^29, in ticks of 2^exponent steps, fewer
/// than 2^26.                                                           (tests/cull/slabs.test.cpp)
///
/// The part that matters moves by at most |d| reach steps on this axis. So planes are clamped to
/// the range from 16 steps behind it to 16 steps beyond its end, and measured from there: x steps
/// take x factor >> shift ticks, fewer than 10 reach, rounded down by less than three. A component
/// |d| below 4 / reach counts as a power of two from 4 / reach to 8 / reach: the ray enters no
/// later, and is at most eight steps too far when it leaves.
template <Scalar S, class Lanes>
class LaneSlab {
  using Component = direction_component<S>;
  static constexpr std::int64_t around = 16;
  static constexpr int lost = 3;
  static constexpr std::int64_t bound = std::int64_t{1} << 29;

 public:
  using Time = std::int32_t;
  using Planes = std::array<Time, detail::lane_count>;

  constexpr LaneSlab() noexcept = default;
  /// For a box that starts between `low` and `high`; if one of them is at 2^29 steps or more, the
  /// box is unbounded.
  constexpr LaneSlab(std::int64_t low, std::int64_t high, const Component& direction,
                     std::int64_t reach, int exponent) noexcept {
    const std::int64_t speed = direction.raw();
    if (low <= -bound || high >= bound) {
      enter_ = Lanes(Time{0});
      leave_ = Lanes(static_cast<Time>(2 * bound));
      return;
    }
    is_backward_ = speed < 0;
    if (is_backward_) low = std::exchange(high, ~low), low = ~low;
    auto size = static_cast<std::uint64_t>(std::max<std::int64_t>(speed < 0 ? -speed : speed, 1));
    std::int64_t ahead = 1;  // the grid is at most a step off
    const auto longest = static_cast<std::uint64_t>(reach);
    if (size * longest < std::uint64_t{4} << Component::frac) {
      size = std::uint64_t{1} << (Component::frac + 3 - static_cast<int>(std::bit_width(longest)));
      ahead += 8;
    }
    const auto width = static_cast<int>(std::bit_width(size));
    factor_ = static_cast<std::uint32_t>((std::uint64_t{1} << (29 + width)) / size);
    shift_ = 29 + width - Component::frac + exponent;
    const auto moved = static_cast<std::int64_t>((size * longest) >> Component::frac) + 1;
    mirror_ = Lanes(is_backward_ ? Time{-1} : Time{0});
    enter_from_ = Lanes(static_cast<Time>(high - around));
    leave_from_ = Lanes(static_cast<Time>(low - around));
    span_ = Lanes(static_cast<Time>(moved + 2 * around));
    enter_ = Lanes(static_cast<Time>(-ticks(around + 1) - lost));
    leave_ = Lanes(static_cast<Time>(lost - ticks(around - ahead)));
  }

  /// Whether it enters a slab at its greatest coordinate.
  [[nodiscard]] constexpr bool is_backward() const noexcept { return is_backward_; }

  /// Lower bounds of the times at which it enters through planes, and upper bounds of those at
  /// which it leaves; times outside the part that matters have bounds outside it too.
  [[nodiscard]] constexpr Lanes enter(const Planes& planes) const noexcept {
    return times(planes, enter_from_, enter_);
  }
  [[nodiscard]] constexpr Lanes leave(const Planes& planes) const noexcept {
    return times(planes, leave_from_, leave_);
  }

 private:
  [[nodiscard]] constexpr std::int64_t ticks(std::int64_t steps) const noexcept {
    return (steps * std::int64_t{factor_}) >> shift_;
  }
  [[nodiscard]] constexpr Lanes times(const Planes& planes, const Lanes& from,
                                      const Lanes& first) const noexcept {
    Lanes x(planes);
    x.flip(mirror_);
    x.subtract(from);
    x.raise(Lanes(Time{0}));
    x.lower(span_);
    x.scale(factor_, shift_);
    x.add(first);
    return x;
  }

  Lanes mirror_{Time{0}}, enter_from_{Time{0}}, leave_from_{Time{0}}, span_{Time{0}};
  Lanes enter_{Time{0}}, leave_{Time{0}};
  std::uint32_t factor_ = 0;
  int shift_ = 0;
  bool is_backward_ = false;
};

#if __STDC_HOSTED__
template <Scalar F>
requires std::floating_point<F>
class Ticks<F> {
 public:
  using Time = F;
  using Reach = F;

  /// For planes at any distance: times have no margin except their own rounding.
  constexpr Ticks() noexcept = default;
  constexpr Ticks(F reach, F limit) noexcept
      : reach_(reach), longest_((std::min)(limit, reach * 2)), shortest_(F{1} / (1 << 14)) {}

  [[nodiscard]] constexpr F reach() const noexcept { return reach_; }
  [[nodiscard]] constexpr F longest() const noexcept { return longest_; }
  /// Shorter components of a direction are lengthened.
  [[nodiscard]] constexpr F shortest() const noexcept { return shortest_; }
  [[nodiscard]] constexpr F time(F distance) const noexcept { return distance; }

 private:
  F reach_ = 0, longest_ = 0, shortest_ = 0;
};

template <Scalar F>
requires std::floating_point<F>
class RaySlab<F> {
 public:
  using Time = F;

  constexpr RaySlab() noexcept = default;
  constexpr RaySlab(F origin, F direction, const Ticks<F>& ticks) noexcept
      : RaySlab(origin, origin, direction, ticks) {}
  constexpr RaySlab(F low, F high, F direction, const Ticks<F>& ticks) noexcept
      : enter_from_(direction < 0 ? low : high),
        leave_from_(direction < 0 ? high : low),
        is_backward_(direction < 0) {
    const F size = (std::max)(abs(direction), ticks.shortest());
    const F drift = abs(direction) < ticks.shortest() ? ticks.longest() * ticks.shortest() : 0;
    const F margin = (ticks.reach() + drift) / (1 << 20);
    factor_ = is_backward_ ? -1 / size : 1 / size;
    if (margin > 0) {
      enter_ = margin / size;
      leave_ = (margin + drift) / size;
    }
  }

  [[nodiscard]] constexpr bool is_backward() const noexcept { return is_backward_; }
  [[nodiscard]] constexpr F enter(F plane) const noexcept {
    return (plane - enter_from_) * factor_ - enter_;
  }
  [[nodiscard]] constexpr F leave(F plane) const noexcept {
    return (plane - leave_from_) * factor_ + leave_;
  }

  [[nodiscard]] constexpr GridTimes<F> on_grid(const ByteGrid<F>& grid) const noexcept {
    return {enter(grid.origin()), leave(grid.origin()), grid.step() * factor_};
  }

 private:
  F enter_from_ = 0, leave_from_ = 0, factor_ = 0, enter_ = 0, leave_ = 0;
  bool is_backward_ = false;
};
#endif

}  // namespace detent
