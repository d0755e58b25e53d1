// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <type_traits>

#include "detent/number/filter/filtered.hpp"
#include "detent/number/filter/ratio.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/query/kernel/segment_in_frame.hpp"

namespace detent::detail {

/// Where a segment at an inexact place is closest to a box along the axes, by words: a filter
/// (docs/filters.md, lemma 30).
template <Scalar S, int N>
class ThinInSlabs {
 public:
  static constexpr int frac = S::frac + 30;
  using Place = Fixed<63, frac>;
  using Places = Vec<Place, N>;
  static constexpr Steps<1 << 9> error{};

  /// `low` and `high` are the faces of the box, relative to the start of the segment, and `along`
  /// is d in the world.
  template <Number L, Number D, Number W>
  constexpr ThinInSlabs(const Vec<L, N>& low, const Vec<L, N>& high, const Vec<D, N>& d,
                        const Vec<W, N>& along) noexcept {
    Place longest{}, longest_along{};
    for (int i = 0; i < N; ++i) {
      low_[i] = floor_to<Place>(low[i]);
      high_[i] = floor_to<Place>(high[i]);
      d_[i] = floor_to<Place>(d[i]);
      longest = (std::max)(longest, magnitude(d_[i]));
      longest_along = (std::max)(longest_along, magnitude(floor_to<Place>(along[i])));
    }
    if (!fits<61>(low_) || !fits<61>(high_) || !fits<61>(d_) || !fits<61>(longest_along)) return;
    if (longest_along > longest + longest) return;  // a skew frame
    find(longest);
  }

  [[nodiscard]] constexpr ClosestAt closest_at() const noexcept { return closest_at_; }
  /// The closest point of the segment, within `error`; exact at the ends.
  [[nodiscard]] constexpr const Places& place() const noexcept { return x_; }
  /// On which side of the box it is: -1, 0 or 1.
  [[nodiscard]] constexpr int side(int i) const noexcept { return side_of(x_, i); }
  /// Its excess over the box, within `error`.
  [[nodiscard]] constexpr Places excess() const noexcept { return excess_of(x_); }

  /// The closest point of a segment in the world that has this place, within 2^11 steps.
  [[nodiscard]] constexpr auto on_segment(const Segment<S, N>& segment) const noexcept {
    return make_vec<N>([&](int i) {
      const finer<S, 30> start(segment.start[i]);
      return narrow_sum<62>(start,
                            approximate_product(segment.end[i] - segment.start[i], ratio_).value);
    });
  }

 private:
  using Dot = Fixed<126, 2 * frac>;

  [[nodiscard]] static constexpr Place magnitude(const Place& x) noexcept {
    return x < 0 ? narrow_negative(x) : x;
  }
  [[nodiscard]] constexpr Places excess_of(const Places& x) const noexcept {
    return make_vec<N>([&](int i) {
      return narrow_difference<63>(x[i], x[i] < low_[i]    ? low_[i]
                                         : x[i] > high_[i] ? high_[i]
                                                           : x[i]);
    });
  }

  constexpr void find(const Place& longest) noexcept {
    auto margin = Dot();
    for (int i = 0; i < N; ++i) {
      margin = narrow<126>(margin + Dot::assume_raw(magnitude(d_[i]).raw()));
    }
    const auto rise_at = [&](const Places& x) -> Dot { return narrow_dot<126>(d_, excess_of(x)); };
    const Dot first = rise_at(x_);
    if (first > margin) {
      closest_at_ = ClosestAt::start;
      return;
    }
    const Dot last = rise_at(d_);
    if (last < -margin) {
      closest_at_ = ClosestAt::end;
      x_ = d_;
      return;
    }
    if (!(first < -margin) || !(last > margin)) return;
    // Newton's method on the derivative, from where a line between its ends is 0, with bisection
    // where a step leaves the part of the segment in which its sign changes.
    go_to(narrow_negative(first), narrow<126>(last - first));
    auto from = Places(), to = d_;
    for (int i = 0; i < 10; ++i) {
      Places bound{}, speed{};
      for (int k = 0; k < N; ++k) {
        if (side(k) == 0) continue;
        bound[k] = side(k) < 0 ? low_[k] : high_[k];
        speed[k] = d_[k];
      }
      const Dot over = narrow_dot<126>(bound, speed), under = narrow_dot<126>(speed, speed);
      const auto before = x_;
      const bool is_on_segment = over > 0 && over < under;
      if (is_on_segment) {
        go_to(over, under);
        bool is_same = true;
        for (int k = 0; k < N; ++k) is_same = is_same && side_of(before, k) == side(k);
        if (is_same) {
          // m^2 / 2^16 in the steps of u^2.
          const auto part = narrow_floor<Fixed<126, 2 * frac - 16>>(square(longest));
          if (part.raw() <= under.raw() && are_sure()) closest_at_ = ClosestAt::between;
          return;
        }
      }
      (rise_at(before) < Dot() ? from : to) = before;
      if (!is_on_segment || !is_between(from, to, longest)) x_ = middle(from, to);
    }
  }
  [[nodiscard]] static constexpr Places middle(const Places& a, const Places& b) noexcept {
    return make_vec<N>([&](int i) {
      return Place::assume_raw(shift_right_floor(narrow_sum<63>(a[i], b[i]).raw(), 1));
    });
  }
  /// Whether x is between two points of the segment, by its longest component.
  [[nodiscard]] constexpr bool is_between(const Places& a, const Places& b,
                                          const Place& longest) const noexcept {
    int k = 0;
    while (magnitude(d_[k]) < longest) ++k;
    return d_[k] > 0 ? a[k] < x_[k] && x_[k] < b[k] : b[k] < x_[k] && x_[k] < a[k];
  }
  [[nodiscard]] constexpr int side_of(const Places& x, int i) const noexcept {
    return x[i] < low_[i] ? -1 : x[i] > high_[i] ? 1 : 0;
  }
  constexpr void go_to(const Dot& over, const Dot& under) noexcept {
    ratio_ = make_ratio_below_one(over, under);
    x_ = make_vec<N>([&](int i) { return narrow_floor<Place>(d_[i] * ratio_.quotient.value); });
  }
  /// Whether the errors change no side of the closest point.
  [[nodiscard]] constexpr bool are_sure() const noexcept {
    constexpr auto most = Place::assume_raw(error.raw());
    bool are = true;
    for (int i = 0; i < N; ++i) {
      const auto above = narrow_difference<63>(x_[i], high_[i]);
      const auto below = narrow_difference<63>(low_[i], x_[i]);
      are = are && (above > most || below > most || (above < -most && below < -most));
    }
    return are;
  }

  Places low_{}, high_{}, d_{}, x_{};
  ClosestAt closest_at_ = ClosestAt::unsure;
  BoundedRatio<Dot, Dot, 63, Steps<128>> ratio_{};
};

/// A point beyond `spot` by `radius`, as `nearly_rounded_beyond` rounds it; `toward` is an excess in
/// the world, within 2^11 steps, or its opposite. (docs/filters.md, lemma 30)
template <Scalar S, int N, Number V>
[[nodiscard]] constexpr Decided<Vec<S, N>> decide_toward(Vec<Fixed<62, S::frac + 30>, N> spot,
                                                         const S& radius,
                                                         const Vec<V, N>& toward) noexcept {
  // The direction is off by less than sqrt(3) 2^11 / |v|: with |v| > radius / 8, the step by 2^15.
  const auto v = make_vec<N>([&](int i) { return floor_to<Fixed<63, S::frac + 30>>(toward[i]); });
  bool is_long = false;
  for (int i = 0; i < N; ++i) is_long = is_long || abs(v[i]) * Fixed<4, 0>(8) > radius;
  if (!is_long) return {{}, false};
  const auto moves = step_along(radius, to_array(v));
  for (int i = 0; i < N; ++i) {
    spot[i] = narrow_sum<62>(spot[i], moves.value[static_cast<std::size_t>(i)]);
  }
  return decide_point<S, N>([&](int i) { return spot[i]; }, Steps<1 << 19>());
}

/// The point of a segment closest to a box, or beyond it by `radius` toward the box, as
/// `nearly_rounded_beyond` rounds it; `outward` is the excess in the world, within 2^11 steps.
template <Scalar S, int N, Number V>
[[nodiscard]] constexpr Decided<Vec<S, N>> decide_on_thin(const ThinInSlabs<S, N>& closest,
                                                          const Segment<S, N>& segment,
                                                          const S& radius,
                                                          const Vec<V, N>& outward) noexcept {
  const bool is_between = closest.closest_at() == ClosestAt::between;
  const auto& end = closest.closest_at() == ClosestAt::start ? segment.start : segment.end;
  if (radius == 0 && !is_between) return {end, true};
  const auto spot = is_between
                        ? closest.on_segment(segment)
                        : make_vec<N>([&](int i) { return Fixed<62, S::frac + 30>(end[i]); });
  if (radius > 0) return decide_toward(spot, radius, narrow_negative(outward));
  return decide_point<S, N>([&](int i) { return spot[i]; }, Steps<1 << 12>());
}

}  // namespace detent::detail
