// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "detent/cull/byte_grid.hpp"
#include "detent/cull/lanes.hpp"
#include "detent/number/integer.hpp"

namespace detent {

/// The unit of ray distance during a tree traversal: a 32-bit number, so that a vector instruction
/// compares many.
///
/// No distance past `longest` matters: the ray has left all planes, or has ended.
template <Scalar S>
class SlabClock;

/// The distances at which a ray crosses planes perpendicular to one axis, rounded outward: the part
/// of the ray between two planes is never cut, but may be extended a little. For culling; the
/// shapes themselves decide.
///
/// Every plane is in [least, greatest].                    (tests/cull/slabs.test.cpp)
template <Scalar S>
class SlabTimes;

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

/// Times are in ticks of 2^shift / 2^16 raw units. The shift keeps `longest` below 2^23 ticks. It
/// keeps the margins of `SlabTimes`, at most four times 2^-16 of the reach and 2^14 raw units,
/// below 2^28.
template <int Bits, int Frac>
class SlabClock<Fixed<Bits, Frac>> {
  using S = Fixed<Bits, Frac>;

 public:
  using Time = std::int32_t;
  using Reach = Fixed<63, Frac>;

  /// For planes at most `reach` away, summed over the axes; a direction is longer than 1 - 2^-12.
  constexpr SlabClock(const Reach& reach, const S& limit) noexcept
      : longest_((std::min)(limit, detail::clamp_raw<S>(reach.raw() + (reach.raw() >> 8) + 1))),
        shift_((std::max)(
            {bit_length(longest_.raw()) + inverse_frac - 23, bit_length(reach.raw()) - 26, 4})) {}

  [[nodiscard]] constexpr const S& longest() const noexcept { return longest_; }
  [[nodiscard]] constexpr Time time(const S& distance) const noexcept {
    const std::int64_t raw = (std::min)(distance, longest_).raw();
    return static_cast<Time>((raw * (std::int64_t{1} << inverse_frac)) >> shift_);
  }

  [[nodiscard]] constexpr int shift() const noexcept { return shift_; }

 private:
  friend SlabTimes<S>;
  static constexpr int inverse_frac = 16;

  /// A distance clamped here is still beyond `longest`, or behind the origin, with 2^29 added.
  [[nodiscard]] static constexpr Time clamp(std::int64_t ticks) noexcept {
    constexpr std::int64_t most = std::int64_t{1} << 30;
    return static_cast<Time>(std::clamp(ticks, -most, most));
  }

  S longest_;
  int shift_ = 0;
};

/// One product of 32-bit integers per plane, for vectors of them.
///
/// With d the component of the direction and i = floor(2^16 / |d|) / 2^16, a distance x / |d| ahead
/// is in [x i, x i + x / 2^16): `margin`. Components shorter than 2^-14 would make i too large, so
/// they are lengthened to 2^-14. This moves no point of the ray by more than
/// `drift` = longest / 2^14, and only ahead. A distance is less than 2^32 2^30, and less than 2^49
/// is added to it.
template <int Bits, int Frac>
class SlabTimes<Fixed<Bits, Frac>> {
  using S = Fixed<Bits, Frac>;
  using Component = direction_component<S>;

 public:
  using Clock = SlabClock<S>;
  using Time = typename Clock::Time;

  /// An upper bound of the distance from `origin` to the planes.
  [[nodiscard]] static constexpr typename Clock::Reach reach(const S& origin, const S& least,
                                                             const S& greatest) noexcept {
    using Reach = typename Clock::Reach;
    return (std::max)(Reach(abs(least - origin)), Reach(abs(greatest - origin)));
  }

  constexpr SlabTimes(const Clock& clock, const S& origin, const Component& direction,
                      const S& least, const S& greatest) noexcept
      : origin_(origin.raw()), shift_(clock.shift()) {
    constexpr std::int64_t shortest = std::int64_t{1} << (std::max)(Component::frac - 14, 0);
    const std::int64_t speed = direction.raw();
    const std::int64_t size = speed < 0 ? -speed : speed;
    const std::int64_t inverse =
        (std::int64_t{1} << (Component::frac + Clock::inverse_frac)) / (std::max)(size, shortest);
    const std::int64_t drift =
        size < shortest ? (std::max<std::int64_t>(clock.longest().raw(), 0) >> 14) + 1 : 0;
    const std::int64_t margin = reach(origin, least, greatest).raw() + drift;
    factor_ = speed < 0 ? -inverse : inverse;
    between_ = static_cast<Time>((margin + drift * inverse) >> shift_) + 1;
  }

  /// A lower bound of the distance at which the ray enters through a plane, and an upper bound of
  /// the distance at which it leaves through one.
  [[nodiscard]] constexpr Time enter(const S& plane) const noexcept { return ticks(plane.raw()); }
  [[nodiscard]] constexpr Time leave(const S& plane) const noexcept {
    return enter(plane) + between_;
  }

  /// The same for planes of a grid.
  ///
  /// A step is at most 2^21 ticks, so 255 steps are less than 2^29. A ray with longer steps is so
  /// nearly parallel to the planes that it crosses less than four steps in the 2^23 ticks that
  /// matter. It is turned to have steps of exactly 2^21 ticks, and four steps are added.
  [[nodiscard]] constexpr GridTimes<Time> on_grid(const ByteGrid<S>& grid) const noexcept {
    constexpr std::int64_t longest_step = 1 << 21;
    const std::int64_t step = (grid.step() * factor_) >> shift_;
    if (-longest_step <= step && step <= longest_step) {
      const Time enter = ticks(grid.origin());
      // The step is rounded down, and it is added up to 255 times.
      return {enter, enter + between_ + 255, static_cast<Time>(step)};
    }
    const std::int64_t turned = step < 0 ? -longest_step : longest_step;
    const Time enter = Clock::clamp(((grid.origin() - origin_) * turned) / grid.step() - 1);
    return {enter, enter + static_cast<Time>(4 * longest_step + 2), static_cast<Time>(turned)};
  }

 private:
  [[nodiscard]] constexpr Time ticks(std::int64_t plane) const noexcept {
    return Clock::clamp(((plane - origin_) * factor_) >> shift_);
  }

  std::int64_t origin_ = 0, factor_ = 0;
  Time between_ = 0;
  int shift_ = 0;
};

#if __STDC_HOSTED__
template <Scalar F>
requires std::floating_point<F>
class SlabClock<F> {
 public:
  using Time = F;
  using Reach = F;

  constexpr SlabClock(F reach, F limit) noexcept : longest_((std::min)(limit, reach * 2)) {}

  [[nodiscard]] constexpr F longest() const noexcept { return longest_; }
  [[nodiscard]] constexpr F time(F distance) const noexcept { return distance; }

 private:
  F longest_;
};

template <Scalar F>
requires std::floating_point<F>
class SlabTimes<F> {
 public:
  using Clock = SlabClock<F>;
  using Time = F;

  [[nodiscard]] static constexpr F reach(F origin, F least, F greatest) noexcept {
    return (std::max)(abs(least - origin), abs(greatest - origin));
  }

  constexpr SlabTimes(const Clock& clock, F origin, F direction, F least, F greatest) noexcept
      : origin_(origin) {
    constexpr F shortest = F{1} / (1 << 14), error = F{1} / (1 << 20);
    const F size = (std::max)(abs(direction), shortest);
    const F drift = abs(direction) < shortest ? clock.longest() * shortest : 0;
    const F margin = (reach(origin, least, greatest) + drift) / size * error;
    factor_ = direction < 0 ? -1 / size : 1 / size;
    enter_ = margin;
    leave_ = -margin - drift / size;
  }

  [[nodiscard]] constexpr F enter(F plane) const noexcept {
    return (plane - origin_) * factor_ - enter_;
  }
  [[nodiscard]] constexpr F leave(F plane) const noexcept {
    return (plane - origin_) * factor_ - leave_;
  }

  [[nodiscard]] constexpr GridTimes<F> on_grid(const ByteGrid<F>& grid) const noexcept {
    return {enter(grid.origin()), leave(grid.origin()), grid.step() * factor_};
  }

 private:
  F origin_, factor_, enter_, leave_;
};
#endif

}  // namespace detent
