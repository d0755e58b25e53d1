// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "detent/query/kernel/gjk.hpp"
#include "detent/query/kernel/posed.hpp"
#include "detent/query/time_of_impact/impact.hpp"

namespace detent::detail {

/// The relation of two posed bodies: their distance, rounded down, and the direction from the
/// closest point of b to that of a, which is the best separating axis; no axis if they touch.
template <Scalar S, int N, Number Between>
struct GapBetween {
  Between distance;
  std::optional<Direction<S, N>> axis;
};

template <Scalar S, class A, class B, int N = A::dimension>
[[nodiscard]] constexpr auto separation_of(const A& a, const B& b) noexcept {
  using P = Posed<S>;
  using Between = decltype((P() + P()) + (P() + P()));
  return with_gjk(a, b, [](auto search) -> GapBetween<S, N, Between> {
    using T = std::remove_cvref_t<decltype(search.closest_feature()[0].x)>;
    const auto squared = search.squared_distance(squared_distance_of_none<T, N>());
    if (squared.numerator == 0) return {Between(0), std::nullopt};
    return {
        sqrt_floor<Between>(squared),
        with_direction(search.closest_feature(), [](const auto& v) { return direction_of<S>(v); })};
  });
}

/// How far apart two bodies are along `axis`, less than 0 where they overlap.
template <class A, class B, Scalar S, int N>
[[nodiscard]] constexpr auto gap_along(const Direction<S, N>& axis, const A& a,
                                       const B& b) noexcept {
  return dot(axis, a.extreme(axis, b.some(), false)) - dot(axis, b.extreme(axis, a.some(), true));
}

/// The search for the time of impact of two moving polytopes, each grown by a radius.
///
/// If at two times the gap along an axis exceeds the deviation of the corners from uniform motion,
/// the bodies are apart at all times in between: along the axis, each corner of one body is then
/// beyond each corner of the other. From a time at which they are apart, the search takes the axis
/// between the closest points, advances as far as this holds, and repeats.
///
/// source: Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems (1996), 2.3: conservative
///         advancement; Catto, Continuous Collision (2013): to the end along a fixed axis
template <class A, class B, Number Reach>
class ImpactSearch {
 public:
  using S = typename A::Coordinate;
  using Time = direction_component<S>;
  static constexpr int N = A::dimension;

  /// `reach` is the sum of the radii.
  constexpr ImpactSearch(const A& a, const B& b, const Reach& reach) noexcept
      : a_(a), b_(b), reach_(reach), error_(a.error() + b.error()) {}

  /// The impact, and the number of steps.
  struct Result {
    std::optional<Impact<S>> impact;
    int steps;
  };

  [[nodiscard]] constexpr Result first(const S& target) const noexcept {
    Time t(0);
    auto from_a = a_.at(t);
    auto from_b = b_.at(t);
    auto view = view_of(from_a, from_b);
    const auto hit = [&](int step) { return Result{Impact<S>{t, view.distance, true}, step}; };
    if (view.touches(target)) return hit(1);
    const auto end_a = a_.at(Time(1));
    const auto end_b = b_.at(Time(1));
    for (int step = 1;; ++step) {
      if (step == most_steps) return {Impact<S>{t, view.distance, false}, step};
      const Path path(*this, *view.axis, t, gap_along(*view.axis, from_a, from_b));
      const auto at_start = path.slack_at_start(), at_end = path.slack(Time(1), end_a, end_b);
      if (!(at_start > 0)) return hit(step);
      if (at_end > 0) return {std::nullopt, step};
      const Time next = path.advance(at_start, at_end);
      if (!(next > t)) return hit(step);
      t = next;
      from_a = a_.at(t);
      from_b = b_.at(t);
      view = view_of(from_a, from_b);
      if (view.touches(target)) return hit(step + 1);
    }
  }

 private:
  static constexpr int most_steps = 128, most_trials = 64;

  using PosedA = std::remove_cvref_t<decltype(std::declval<A>().at(Time()))>;
  using PosedB = std::remove_cvref_t<decltype(std::declval<B>().at(Time()))>;

  /// An upper bound on the distance of the bodies, and the best separating axis.
  struct View {
    S distance;
    std::optional<Direction<S, N>> axis;

    [[nodiscard]] constexpr bool touches(const S& target) const noexcept {
      return distance <= target || !axis;
    }
  };
  [[nodiscard]] constexpr View view_of(const PosedA& a, const PosedB& b) const noexcept {
    const auto cores = separation_of<S>(a, b);
    return {at_most(cores.distance), cores.axis};
  }

  /// An upper bound on the exact distance, from that of the posed cores rounded down.
  template <Number Between>
  [[nodiscard]] constexpr S at_most(const Between& cores) const noexcept {
    const auto most = next_above(cores) + error_ - reach_;
    return most > 0 ? ceil_to<S>(most) : S(0);
  }
  template <Number Between>
  [[nodiscard]] static constexpr auto next_above(const Between& x) noexcept {
    if constexpr (is_fixed<S>) {
      return x + S::from_raw(1);
    } else {
      return x;
    }
  }

  using Gap =
      decltype(gap_along(Direction<S, N>(), std::declval<PosedA>(), std::declval<PosedB>()));

  /// The motion along one axis, starting at one time.
  class Path {
   public:
    constexpr Path(const ImpactSearch& search, const Direction<S, N>& axis, const Time& start,
                   const Gap& gap) noexcept
        : search_(search),
          axis_(axis),
          norm_(sqrt_ceil<Time>(squared_length(axis))),
          start_(start),
          gap_(gap) {}

    [[nodiscard]] constexpr auto slack_at_start() const noexcept { return slack(start_, gap_); }

    /// If this is positive, the bodies are apart from the start to `t`.
    [[nodiscard]] constexpr auto slack(const Time& t) const noexcept {
      return slack(t, search_.a_.at(t), search_.b_.at(t));
    }
    /// The same, from the bodies at `t`.
    [[nodiscard]] constexpr auto slack(const Time& t, const PosedA& a,
                                       const PosedB& b) const noexcept {
      const auto gap = gap_along(axis_, a, b);
      return slack(t, gap < gap_ ? gap : gap_);
    }

    /// The latest time found at which the slack is positive, or the start; from the slacks at the
    /// start and at time 1.
    template <Number Slack>
    [[nodiscard]] constexpr Time advance(const Slack& at_start,
                                         const Slack& at_end) const noexcept {
      Time low = start_, high(1);
      auto at_low = at_start, at_high = at_end;
      // Beyond this time, the bodies' deviation exceeds the slack.
      const auto bend = search_.a_.bend() + search_.b_.bend();
      if (const Time d = sqrt_floor<Time>(Fraction{at_start, bend}); bend > 0 && low + d < high) {
        high = floor_to<Time>(low + d);
        at_high = slack(high);
        if (at_high > 0) return high;
      }
      for (int trial = 0; trial < most_trials; ++trial) {
        const Time middle = floor_to<Time>(half(low + high));
        if (!(middle > low)) break;
        // Every other trial is where a 32nd of the slack would be left if it were linear.
        Time t = middle;
        if (trial % 2 == 0) {
          const auto share = quotient_floor<Time>(at_low * 32 - at_start, (at_low - at_high) * 32);
          t = floor_to<Time>(low + (high - low) * share);
          if (!(t > low)) t = middle;
        }
        const auto found = slack(t);
        if (found > 0) {
          low = t;
          at_low = found;
          if (found * 8 < at_start) break;
        } else {
          high = t;
          at_high = found;
        }
      }
      return low;
    }

   private:
    [[nodiscard]] constexpr auto slack(const Time& t, const Gap& gap) const noexcept {
      const Time d = floor_to<Time>(t - start_);
      const auto straying =
          ceil_to<Gap>(search_.a_.straying(d)) + ceil_to<Gap>(search_.b_.straying(d));
      return gap - ceil_to<Gap>((search_.reach_ + search_.error_ + straying) * norm_);
    }

    const ImpactSearch& search_;
    Direction<S, N> axis_;
    Time norm_;
    Time start_;
    Gap gap_;
  };

  const A& a_;
  const B& b_;
  Reach reach_;
  decltype(std::declval<A>().error() + std::declval<B>().error()) error_;
};

}  // namespace detent::detail
