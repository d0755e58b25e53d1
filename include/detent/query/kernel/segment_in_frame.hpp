// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/number/filter/leading.hpp"
#include "detent/number/filter/ratio.hpp"
#include "detent/query/kernel/clip.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/point_obb.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/query/kernel/spanned_box.hpp"
#include "detent/shape/segment.hpp"

// The closest points and the least push of a box, which is its slabs, and a segment, by a
// filter in words: numbers of 20 bits propose where they are closest, and words prove it
// (docs/filters.md, lemma 27).

namespace detent::detail {

/// How a segment lies to a box: they share a point, or are closest at one end of the segment, or
/// at one point between its ends.
enum class ClosestAt { unsure, meets, start, end, between };

/// A segment in the frame of a box. Its point at t in [0, 1] is t d there, and the box is from `low`
/// to `high`.
template <Scalar S, int N = 3>
class SegmentInFrame {
 public:
  using Points = std::pair<Vec<S, N>, Vec<S, N>>;
  static constexpr int frac = S::frac + 30;
  static_assert(direction_component<S>::frac == 30);
  using Place = Fixed<62, frac>;
  using Error = Fixed<8, frac>;

  /// The box must not be empty. Coordinates are exact, because half steps occur only along axes of
  /// the world.
  template <class Box>
  constexpr SegmentInFrame(const Box& box, const Segment<S, N>& segment) noexcept
      : box_(box), segment_(segment) {
    const auto apart = box_.center - segment.start;
    const auto along = segment.end - segment.start;
    if (!fits<31>(apart) || !fits<30>(along) || !fits<31>(box_.half_extents)) return;
    for (int i = 0; i < N; ++i) {
      const auto& axis = box_.rotation.axis(i).vec();
      center_[i] = narrow_floor<Place>(narrow_dot<62>(axis, apart));
      d_[i] = narrow_dot<61>(axis, along);
      low_[i] = narrow_difference<62>(center_[i], Place(box_.half_extents[i]));
      high_[i] = narrow_sum<62>(center_[i], Place(box_.half_extents[i]));
    }
    find();
  }

  [[nodiscard]] constexpr ClosestAt closest_at() const noexcept { return closest_at_; }
  /// Below which coordinate of the box the closest point of the segment is: -1, or above which: 1;
  /// 0 on axes on which it is between both.
  [[nodiscard]] constexpr int side(int i) const noexcept { return sides_[at(i)]; }
  /// Whether the vector between the closest points is perpendicular to the segment.
  [[nodiscard]] constexpr bool is_across() const noexcept {
    return closest_at_ == ClosestAt::between || is_tie_;
  }
  /// The vector from the closest point of the box to that of the segment, off by at most `error` in
  /// each component, which is 0 at the ends of the segment.
  [[nodiscard]] constexpr const Vec<Place, N>& beyond() const noexcept { return beyond_; }
  [[nodiscard]] constexpr const Error& error() const noexcept { return error_; }

  [[nodiscard]] constexpr const Vec<Place, N>& low() const noexcept { return low_; }
  [[nodiscard]] constexpr const Vec<Place, N>& high() const noexcept { return high_; }
  [[nodiscard]] constexpr const Vec<Place, N>& along() const noexcept { return d_; }

  [[nodiscard]] constexpr const Rotation<S, N>& rotation() const noexcept { return box_.rotation; }

  /// The distance, rounded down.
  [[nodiscard]] constexpr Decided<Length<S>> distance_floor() const noexcept {
    switch (closest_at_) {
      case ClosestAt::unsure:
        return {Length<S>(), false};
      case ClosestAt::meets:
        return {Length<S>(0), true};
      case ClosestAt::between:
        return decide_floor<Length<S>>(approximate_distance());
      default:
        return {sqrt_floor<Length<S>>(squared()), true};
    }
  }

  /// |beyond|^2.
  [[nodiscard]] constexpr Fixed<126, 2 * frac> squared() const noexcept {
    return narrow_dot<126>(beyond_, beyond_);
  }
  [[nodiscard]] constexpr auto approximate_distance() const noexcept {
    return Approximate{sqrt_floor<Fixed<63, frac>>(squared()),
                       error_ + error_ + Error::from_raw(1)};
  }

  /// The closest points of the box and of a capsule around the segment, as `closest_points_in_frame`
  /// rounds them.
  [[nodiscard]] constexpr Decided<Points> closest_points(const S& radius) const noexcept {
    if (is_tie_ && segment_.start != segment_.end) return {Points(), false};
    switch (closest_at_) {
      case ClosestAt::unsure:
        return {Points(), false};
      case ClosestAt::meets: {
        const auto common = on_segment();
        return {{common.value, common.value}, common.is_sure};
      }
      case ClosestAt::between:
        return points_between(radius);
      default:
        return {
            points_at_end(closest_at_ == ClosestAt::start ? segment_.start : segment_.end, radius),
            true};
    }
  }

 private:
  using Clip = RayClip<S, Place, Place, 124>;
  using Rough = Fixed<20, 0>;
  using OverOrUnder = Fixed<125, 2 * frac>;
  using Spot = Fixed<63, frac>;  // in the world

  [[nodiscard]] static constexpr std::size_t at(int i) noexcept {
    return static_cast<std::size_t>(i);
  }

  /// The excess of a place over the box, with its sides.
  [[nodiscard]] constexpr Vec<Place, N> excess_of(const Vec<Place, N>& place) noexcept {
    return make_vec<N>([&](int i) {
      const auto& x = place[i];
      sides_[at(i)] = x < low_[i] ? -1 : x > high_[i] ? 1 : 0;
      const auto nearest = x < low_[i] ? low_[i] : x > high_[i] ? high_[i] : x;
      return narrow_difference<62>(x, nearest);
    });
  }

  constexpr void find() noexcept {
    beyond_ = excess_of({});
    const auto rise = narrow_dot<125>(d_, beyond_);
    if (rise >= 0) {
      closest_at_ = is_zero(beyond_) ? ClosestAt::meets : ClosestAt::start;
      is_tie_ = rise == 0 && !is_zero(beyond_);
      return;
    }
    beyond_ = excess_of(d_);
    if (is_zero(beyond_)) return enter();
    const auto fall = narrow_dot<125>(d_, beyond_);
    if (fall <= 0) {
      closest_at_ = ClosestAt::end;
      is_tie_ = fall == 0;
      return;
    }
    propose_sides();
    int outside = 0;
    for (const int side : sides_) outside += side * side;
    if (outside < 2) {
      enter();
    } else {
      check_between();
    }
  }

  /// Finds the sides as in `nearest_of_slabs`, with rounded numbers.
  constexpr void propose_sides() noexcept {
    const int length =
        (std::max)({Rough::bits, longest_bits(low_), longest_bits(high_), longest_bits(d_)});
    const int dropped = length - Rough::bits;
    const auto low = without_low_bits<Rough>(low_, dropped);
    const auto high = without_low_bits<Rough>(high_, dropped);
    const auto d = without_low_bits<Rough>(d_, dropped);
    // Whether the distance still falls at the time over / under.
    const auto falls_at = [&](const Rough& over, const Rough& under) {
      const auto rise = [&](int i) {
        const auto x = narrow_product<40>(over, d[i]);
        const auto least = narrow_product<40>(under, low[i]);
        const auto most = narrow_product<40>(under, high[i]);
        const auto nearest = x < least ? least : x > most ? most : x;
        return narrow_product<61>(d[i], narrow_difference<41>(x, nearest));
      };
      auto sum = narrow<63>(rise(0) + rise(1));
      if constexpr (N == 3) sum = narrow<63>(sum + rise(2));
      return sum < 0;
    };
    for (int i = 0; i < N; ++i) {
      const bool rises = d[i] >= 0;
      const auto under = abs(d[i]);
      const auto is_past = [&](const Rough& over) {
        return over <= 0 || (over < under && falls_at(over, under));
      };
      int& side = sides_[at(i)];
      side = 0;
      if (!is_past(rises ? low[i] : narrow_negative(high[i]))) {
        side = rises ? -1 : 1;
      } else if (is_past(rises ? high[i] : narrow_negative(low[i]))) {
        side = rises ? 1 : -1;
      }
    }
  }

  /// Checks exactly whether they share a point, and where the segment first enters the box.
  constexpr void enter() noexcept {
    Clip clip(S(1));
    for (int i = 0; i < N; ++i) clip.keep(i, low_[i], high_[i], d_[i]);
    if (clip.is_empty()) return;
    over_ = OverOrUnder::assume_raw(clip.enter().numerator.raw());
    under_ = OverOrUnder::assume_raw(clip.enter().denominator.raw());
    closest_at_ = ClosestAt::meets;
  }

  /// Checks whether the proposed sides are right: at the time of the least distance from the faces
  /// on these sides, all coordinates are surely beyond or between the faces as proposed.
  constexpr void check_between() noexcept {
    Vec<Place, N> bound, speed;
    auto longest = abs(d_.x);
    for (int i = 0; i < N; ++i) {
      longest = (std::max)(longest, abs(d_[i]));
      if (sides_[at(i)] == 0) continue;
      bound[i] = sides_[at(i)] < 0 ? low_[i] : high_[i];
      speed[i] = d_[i];
    }
    over_ = narrow_dot<125>(bound, speed);
    under_ = narrow_dot<125>(speed, speed);
    if (!(over_ > 0 && over_ < under_)) return;
    ratio_ = make_ratio_below_one(over_, under_);
    // The ratio is off by less than 2^-56, and the product drops less than one step.
    error_ = narrow<8>(narrow_floor<Error>(Fixed<62, frac + 56>::assume_raw(longest.raw())) +
                       Error::from_raw(2));
    bool is_right = true;
    for (int i = 0; i < N; ++i) {
      const auto x = place_[i] = narrow_floor<Place>(d_[i] * ratio_.quotient.value);
      const int side = sides_[at(i)];
      const auto above = narrow_difference<63>(x, high_[i]),
                 below = narrow_difference<63>(low_[i], x);
      is_right = is_right && (side < 0   ? below > error_
                              : side > 0 ? above > error_
                                         : above < -error_ && below < -error_);
      beyond_[i] = side < 0   ? narrow_difference<62>(x, low_[i])
                   : side > 0 ? narrow_difference<62>(x, high_[i])
                              : Place(0);
    }
    if (is_right) closest_at_ = ClosestAt::between;
  }

  /// The point of the segment at over_ / under_, rounded to nearest.
  [[nodiscard]] constexpr Decided<Vec<S, N>> on_segment() const noexcept {
    if (over_ == 0) return {segment_.start, true};
    if (over_ == under_) return {segment_.end, true};
    const auto ratio = make_ratio_below_one(over_, under_);
    return decide_each<S, N>([&](int i) {
      const auto& start = segment_.start[i];
      return decide_between<S>(start, segment_.end[i] - start, ratio);
    });
  }
  /// The closest point of the box in its frame; `place` is that of the segment.
  [[nodiscard]] constexpr Vec<Place, N> on_box(const Vec<Place, N>& place) const noexcept {
    return make_vec<N>([&](int i) {
      const Place extent(box_.half_extents[i]);
      return side(i) > 0   ? extent
             : side(i) < 0 ? narrow_negative(extent)
                           : narrow_difference<62>(place[i], center_[i]);
    });
  }

  [[nodiscard]] constexpr Points points_at_end(const Vec<S, N>& end,
                                               const S& radius) const noexcept {
    const auto place = closest_at_ == ClosestAt::start ? Vec<Place, N>() : d_;
    const auto in_world = nearest_to<S>(box_.center + from_frame(box_.rotation, on_box(place)));
    if (squared() <= square(radius)) return {in_world, in_world};
    return {in_world, nearly_rounded_beyond(end, radius,
                                            from_frame(box_.rotation, narrow_negative(beyond_)))};
  }

  [[nodiscard]] constexpr Decided<Points> points_between(const S& radius) const noexcept {
    Decided<Points> result{Points(), true};
    auto& [in_world, outward] = result.value;
    const auto decide_at = [&](auto& point, int i, const auto& x) {
      const auto nearest = decide_coordinate<S>(x);
      point[i] = nearest.value;
      result.is_sure = result.is_sure && nearest.is_sure;
    };
    // No axis exceeds 1 by a step, so the errors of three places add up, and one for the floor.
    const auto world_error = error_ + error_ + error_ + Error::from_raw(1);
    const auto from_center = from_frame(box_.rotation, on_box(place_));
    for (int i = 0; i < N; ++i) {
      decide_at(
          in_world, i,
          Approximate{narrow_sum<63>(Spot(box_.center[i]), narrow_floor<Spot>(from_center[i])),
                      world_error});
    }
    const auto length = approximate_distance();
    if (length.value + length.error < radius) {
      outward = in_world;
      return result;
    }
    if (!(length.value - length.error > radius)) return {Points(), false};
    if (radius == 0) {
      const auto on_axis = on_segment();
      outward = on_axis.value;
      result.is_sure = result.is_sure && on_axis.is_sure;
      return result;
    }
    const auto to_box = from_frame(box_.rotation, narrow_negative(beyond_));
    const auto across = make_vec<N>([&](int i) { return narrow_floor<Spot>(to_box[i]); });
    bool is_long = false;
    for (int i = 0; i < N; ++i) {
      is_long = is_long || abs(across[i]) * Fixed<7, 0>(64) > radius;
    }
    if (!is_long) return {Points(), false};
    const auto moves = step_along(radius, to_array(across));
    for (int i = 0; i < N; ++i) {
      const auto& start = segment_.start[i];
      const auto ahead = approximate_product(segment_.end[i] - start, ratio_).value;
      const auto x = narrow_sum<62>(finer<S, 30>(start) + ahead, moves.value[at(i)]);
      decide_at(outward, i, Approximate{x, Steps<1 << 19>()});
    }
    return result;
  }

  SpannedBox<S, N> box_;
  Segment<S, N> segment_;
  ClosestAt closest_at_ = ClosestAt::unsure;
  bool is_tie_ = false;  // the distance does not change at the end
  Vec<Place, N> center_, low_, high_, d_;
  std::array<int, std::size_t{N}> sides_{};
  Vec<Place, N> beyond_, place_;
  Error error_;
  OverOrUnder over_, under_;  // of the time
  BoundedRatio<OverOrUnder, OverOrUnder, 63, Steps<128>> ratio_{};
};

/// Whether this filter pays for the queries of this kind of box and a segment.
template <class Box>
inline constexpr bool has_segment_in_frame = false;
template <Scalar S, int N>
inline constexpr bool has_segment_in_frame<Obb<S, N>> = is_fixed<S>&& filter_pays<S>;
template <Scalar S>
inline constexpr bool has_segment_in_frame<Aabb<S, 3>> = is_fixed<S>&& filter_pays<S>;

}  // namespace detent::detail
