// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "detent/number/fraction.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/ray.hpp"

namespace detent::detail {

/// Whether a branch misprediction costs more than a few word operations. On small processors it
/// does not.
#if UINTPTR_MAX > 0xffffffff
inline constexpr bool selects_by_mask = DETENT_NATIVE_INT128 == 1;
#else
inline constexpr bool selects_by_mask = false;
#endif

/// The part of a ray inside all slabs, as two exact fractions compared by cross-multiplying.
///
/// `Numerator` holds a distance to a slab's face, `Denominator` the ray's speed across the slab,
/// and `ProductBits` bounds the product of one of each.
///
/// source: the slab method of Kay and Kajiya, Ray Tracing Complex Scenes (1986)
template <Scalar S, Number Numerator, Number Denominator, int ProductBits>
class RayClip {
 public:
  static constexpr int no_slab = -1;

  explicit constexpr RayClip(const S& limit) noexcept
      : enter_{Numerator(0), Denominator(1)}, exit_{Numerator(limit), Denominator(1)} {}

  /// Keeps the distances t with low <= speed * t <= high.
  constexpr void keep(int slab, const Numerator& low, const Numerator& high,
                      const Denominator& speed) noexcept {
    if constexpr (is_fixed<S> && selects_by_mask) {
      if (speed != 0) {
        const auto forward = forward_of(speed, speed, speed);
        raise_enter(slab, {forward_of(low, high, speed), forward});
        lower_exit({forward_of(high, low, speed), forward});
      } else if (high < 0 || low > 0) {
        exit_ = {Numerator(-1), Denominator(1)};
      }
      return;
    }
    if (speed > 0) {
      raise_enter(slab, {low, speed});
      lower_exit({high, speed});
    } else if (speed < 0) {
      const auto forward = narrow_negative(speed);
      raise_enter(slab, {narrow_negative(high), forward});
      lower_exit({narrow_negative(low), forward});
    } else if (low > 0 || high < 0) {
      exit_ = {Numerator(-1), Denominator(1)};
    }
  }

  [[nodiscard]] constexpr bool is_empty() const noexcept { return less(exit_, enter_); }

  /// The slab entered last, in case of a tie the first one given; `no_slab` if the ray starts
  /// inside all.
  [[nodiscard]] constexpr int entered() const noexcept { return entered_; }

  /// Where the ray enters, as a fraction.
  [[nodiscard]] constexpr const Fraction<Numerator, Denominator>& enter() const noexcept {
    return enter_;
  }

  // If not empty, 0 <= enter <= exit <= limit.
  [[nodiscard]] constexpr std::optional<S> first_distance() const noexcept {
    if (is_empty()) return std::nullopt;
    return narrow_floor<S>(enter_);
  }

  [[nodiscard]] constexpr std::optional<Interval<S>> interval() const noexcept {
    if (is_empty()) return std::nullopt;
    return Interval<S>{narrow_floor<S>(enter_), narrow_floor<S>(exit_)};
  }

 private:
  using Distance = Fraction<Numerator, Denominator>;

  /// a or b, branchless: which slab is entered last is unpredictable.
  template <Number T>
  static constexpr T select(bool is_first, const T& a, const T& b) noexcept {
    using Raw = decltype(a.raw() ^ b.raw());
    return T::assume_raw(static_cast<typename T::raw_type>(
        b.raw() ^ ((a.raw() ^ b.raw()) & -static_cast<Raw>(is_first))));
  }
  static constexpr Distance select(bool is_first, const Distance& a, const Distance& b) noexcept {
    return {select(is_first, a.numerator, b.numerator),
            select(is_first, a.denominator, b.denominator)};
  }

  /// x, or -y if the ray goes backward; branchless.
  template <Number T>
  static constexpr T forward_of(const T& x, const T& y, const Denominator& speed) noexcept {
    using Raw = decltype(x.raw() ^ y.raw());
    const auto sign = static_cast<Raw>(speed.raw() >> (8 * sizeof(speed.raw()) - 1));
    const auto chosen = x.raw() ^ ((x.raw() ^ y.raw()) & sign);
    return T::assume_raw(static_cast<typename T::raw_type>((chosen ^ sign) - sign));
  }

  static constexpr bool less(const Distance& a, const Distance& b) noexcept {
    return narrow_product<ProductBits>(a.numerator, b.denominator) <
           narrow_product<ProductBits>(b.numerator, a.denominator);
  }

  constexpr void raise_enter(int slab, const Distance& candidate) noexcept {
    if constexpr (is_fixed<S> && selects_by_mask) {
      const bool is_later = less(enter_, candidate);
      enter_ = select(is_later, candidate, enter_);
      entered_ = is_later ? slab : entered_;
      return;
    }
    if (candidate.numerator <= 0 || !less(enter_, candidate)) return;
    enter_ = candidate;
    entered_ = slab;
  }
  constexpr void lower_exit(const Distance& candidate) noexcept {
    if constexpr (is_fixed<S> && selects_by_mask) {
      exit_ = select(less(candidate, exit_), candidate, exit_);
      return;
    }
    if (less(candidate, exit_)) exit_ = candidate;
  }

  Distance enter_;
  Distance exit_;
  int entered_ = no_slab;
};

/// The part of `ray` in `box`.
template <Scalar S, int N>
[[nodiscard]] constexpr auto clip(const Ray<S, N>& ray, const Aabb<S, N>& box) noexcept {
  using Speed = direction_component<S>;
  using Gap = decltype(box.min.x - ray.origin.x);
  // No component of a direction exceeds 1, which takes one bit less than its type has.
  RayClip<S, Gap, Speed, bits_of<Gap> + bits_of<Speed> - 1> clip(ray.max_distance);
  for (int i = 0; i < N; ++i) {
    clip.keep(i, box.min[i] - ray.origin[i], box.max[i] - ray.origin[i], ray.direction[i]);
  }
  return clip;
}

}  // namespace detent::detail
