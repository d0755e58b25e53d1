// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/number/plane_grid.hpp"

namespace detent {

/// The distances at which a ray crosses planes that lie across one axis, rounded outward: the part
/// of the ray that is really between two planes is never left out, and a little more may be let in.
/// For culling, where the shapes themselves decide in the end.
///
/// Every plane is in [least, greatest], and no distance past `longest` matters.
///                                                        (tests/number/slab_times.test.cpp)
template <Scalar S>
class SlabTimes;

/// One product of 64-bit integers for each plane, so that compilers vectorise a loop over planes.
///
/// With d the component of the direction and i = floor(2^16 / |d|) / 2^16, a distance x / |d| is in
/// [x i, x i + x / 2^16): `margin`. Components shorter than 2^-14 would make i too large; they are
/// lengthened to that, which moves no point of the ray by more than `drift` = longest / 2^14.
/// A distance is less than 2^32 2^30 and what is added to it less than 2^49; planes of a grid are
/// no more than one step of 2^25 beyond the range of S.
template <int Bits, int Frac>
class SlabTimes<Fixed<Bits, Frac>> {
  using S = Fixed<Bits, Frac>;
  using Component = direction_component<S>;

 public:
  /// A distance on a grid 2^16 times as fine as that of S.
  using Time = std::int64_t;
  using Reach = Fixed<63, Frac>;

  [[nodiscard]] static constexpr Time time(const S& distance) noexcept {
    return Time{distance.raw()} * (Time{1} << inverse_frac);
  }

  /// An upper bound of how far the planes are from `origin`.
  [[nodiscard]] static constexpr Reach reach(const S& origin, const S& least,
                                             const S& greatest) noexcept {
    return std::max(Reach(abs(least - origin)), Reach(abs(greatest - origin)));
  }

  /// The distance within which a ray has left a box whose sides are `reach` away, in sum, and
  /// which is not past `limit`: a direction is longer than 1 - 2^-12.
  [[nodiscard]] static constexpr S longest(const Reach& reach, const S& limit) noexcept {
    const auto raw = reach.raw();
    return std::min(limit, detail::clamp_raw<S>(raw + (raw >> 8) + 1));
  }

  constexpr SlabTimes(const S& origin, const Component& direction, const S& least,
                      const S& greatest, const S& longest) noexcept {
    constexpr std::int64_t shortest = std::int64_t{1} << std::max(Component::frac - 14, 0);
    const std::int64_t speed = direction.raw();
    const std::int64_t size = speed < 0 ? -speed : speed;
    const std::int64_t inverse =
        (std::int64_t{1} << (Component::frac + inverse_frac)) / std::max(size, shortest);
    const std::int64_t drift =
        size < shortest ? (std::max<std::int64_t>(longest.raw(), 0) >> 14) + 1 : 0;
    const std::int64_t margin = reach(origin, least, greatest).raw() + drift;
    factor_ = speed < 0 ? -inverse : inverse;
    enter_ = origin.raw() * factor_ + margin;
    leave_ = origin.raw() * factor_ - margin - drift * inverse;
  }

  /// A lower bound of the distance to the plane through which the ray enters, and an upper bound of
  /// that to the plane through which it leaves.
  [[nodiscard]] constexpr Time enter(const S& plane) const noexcept {
    return plane.raw() * factor_ - enter_;
  }
  [[nodiscard]] constexpr Time leave(const S& plane) const noexcept {
    return plane.raw() * factor_ - leave_;
  }

  /// The same for planes of a grid, told by their bytes.
  class OnGrid {
   public:
    constexpr OnGrid() noexcept = default;
    constexpr OnGrid(const SlabTimes& slab, const PlaneGrid<S>& grid) noexcept
        : enter_(grid.origin() * slab.factor_ - slab.enter_),
          leave_(grid.origin() * slab.factor_ - slab.leave_),
          step_(grid.step() * slab.factor_) {}

    [[nodiscard]] constexpr Time enter(std::uint8_t plane) const noexcept {
      return enter_ + plane * step_;
    }
    [[nodiscard]] constexpr Time leave(std::uint8_t plane) const noexcept {
      return leave_ + plane * step_;
    }

   private:
    Time enter_ = 0, leave_ = 0, step_ = 0;
  };

 private:
  static constexpr int inverse_frac = 16;
  std::int64_t factor_ = 0;
  Time enter_ = 0, leave_ = 0;
};

#if __STDC_HOSTED__
template <Scalar F>
requires std::floating_point<F>
class SlabTimes<F> {
 public:
  using Time = F;
  using Reach = F;

  [[nodiscard]] static constexpr F time(F distance) noexcept { return distance; }
  [[nodiscard]] static constexpr F reach(F origin, F least, F greatest) noexcept {
    return std::max(abs(least - origin), abs(greatest - origin));
  }
  [[nodiscard]] static constexpr F longest(F reach, F limit) noexcept {
    return std::min(limit, reach * 2);
  }

  constexpr SlabTimes(F origin, F direction, F least, F greatest, F longest) noexcept
      : origin_(origin) {
    constexpr F shortest = F(1) / (1 << 14), error = F(1) / (1 << 20);
    const F size = std::max(abs(direction), shortest);
    const F drift = abs(direction) < shortest ? longest * shortest : 0;
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

  class OnGrid {
   public:
    constexpr OnGrid() noexcept = default;
    constexpr OnGrid(const SlabTimes& slab, const PlaneGrid<F>& grid) noexcept
        : enter_(slab.enter(grid.origin())),
          leave_(slab.leave(grid.origin())),
          step_(grid.step() * slab.factor_) {}

    [[nodiscard]] constexpr F enter(std::uint8_t plane) const noexcept {
      return enter_ + plane * step_;
    }
    [[nodiscard]] constexpr F leave(std::uint8_t plane) const noexcept {
      return leave_ + plane * step_;
    }

   private:
    F enter_ = 0, leave_ = 0, step_ = 0;
  };

 private:
  F origin_, factor_, enter_, leave_;
};
#endif

}  // namespace detent
