// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/number/filter/filtered.hpp"
#include "detent/number/filter/leading.hpp"
#include "detent/number/next_up.hpp"
#include "detent/query/kernel/approach.hpp"
#include "detent/query/kernel/touch_witness.hpp"

namespace detent::detail {

/// Whether one of two bodies is a point and the other one a box along the axes.
template <class A, class B>
inline constexpr bool are_point_and_box = (is_point<A> && is_aligned_box<B>) ||
                                          (is_aligned_box<A> && is_point<B>);

/// The first touch, within a radius, of a point and a box along the axes, of which `a` moves along
/// `way`, by words: a filter for the search of `TouchWitness` (docs/filters.md, lemma 29).
template <class A, class B, Number W, Scalar S, Number R>
class BoxTouch {
 public:
  static constexpr int dimension = A::dimension;
  using Way = Vec<W, dimension>;
  using Feature = typename TouchWitness<A, B, W, S, R>::Feature;

  constexpr BoxTouch(const A& a, const B& b, const Way& way, const R& radius) noexcept
      : exact_low_(b.low() - a.high()),
        exact_high_(b.high() - a.low()),
        way_(way),
        low_(placed(exact_low_)),
        high_(placed(exact_high_)),
        radius_(radius) {}

  /// The first time of at least `time` and at most `limit` at which they are within the radius,
  /// rounded down, or nothing if there is none. Before `time` they must be apart.
  [[nodiscard]] constexpr Decided<std::optional<S>> first(S time, const S& limit) noexcept {
    constexpr Decided<std::optional<S>> unsure{std::nullopt, false};
    constexpr Decided<std::optional<S>> none{std::nullopt, true};
    // So no component of v has more than 62 bits.
    if (!fits<61>(low_) || !fits<61>(high_)) return unsure;
    now_ = state_at(time);
    if (is_apart(now_) != Filtered::yes) return unsure;
    if (closes_in(now_) == Filtered::no) return none;
    for (int i = 0; i < 6; ++i) {
      if (closes_in(now_) != Filtered::yes) return unsure;
      if (!(time < limit)) return none;
      const S steps = proposed();
      if (steps > 0) {
        time = steps < limit - time ? S(narrow<S::bits>(time + steps)) : previous_raw(limit);
        now_ = state_at(time);
        if (is_apart(now_) != Filtered::yes || closes_in(now_) != Filtered::yes) return unsure;
      }
      const S next = next_raw(time);
      next_ = state_at(next);
      const auto is_still_apart = is_apart(next_);
      if (is_still_apart == Filtered::no) return {time, true};
      if (is_still_apart == Filtered::unsure) return unsure;
      if (closes_in(next_) == Filtered::no) {
        constexpr auto two_steps = Fixed<2, S::frac>::assume_raw(2);
        return is_beyond(now_, narrow<bits_of<R> + 1>(radius_ + two_steps)) == Filtered::yes
                   ? none
                   : unsure;
      }
      time = next;
      now_ = next_;
    }
    return unsure;
  }

  /// The only axis on which the box and the point are apart from the time found to the next one, or
  /// -1 if there are more or if it is unsure.
  [[nodiscard]] constexpr int only_axis() const noexcept {
    int axis = -1;
    for (int i = 0; i < dimension; ++i) {
      const int side = side_of(i);
      if (side == unsure_side || (side != 0 && axis >= 0)) return -1;
      if (side != 0) axis = i;
    }
    return axis;
  }
  /// The feature of the differences that has the closest one from the time found to the next one.
  [[nodiscard]] constexpr std::optional<Feature> feature() const noexcept {
    Feature feature{{}, 1};
    auto& first = feature.corners[0];
    for (int i = 0; i < dimension; ++i) {
      if (side_of(i) == unsure_side) return std::nullopt;
      first[i] = side_of(i) > 0 ? exact_high_[i] : exact_low_[i];
    }
    for (int i = 0; i < dimension; ++i) {
      if (side_of(i) != 0) continue;
      if (feature.count == dimension) return std::nullopt;
      auto& corner = feature.corners[static_cast<std::size_t>(feature.count++)];
      corner = first;
      corner[i] = exact_high_[i];
    }
    return feature;
  }

 private:
  static constexpr int frac = S::frac + 30;
  static_assert(direction_component<S>::frac == 30);
  using Corner = decltype(std::declval<const B&>().some() - std::declval<const A&>().some());
  using Place = Fixed<63, frac>;
  using Places = Vec<Place, dimension>;
  static constexpr int unsure_side = 2;

  struct State {
    Places offset;
    Places v;
    decltype(narrow_dot<127>(Places(), Places())) squared;
    decltype(narrow_dot<126>(Places(), Way())) rate;
  };

  [[nodiscard]] static constexpr Places placed(const Corner& corner) noexcept {
    return make_vec<dimension>([&](int i) { return floor_to<Place>(corner[i]); });
  }

  [[nodiscard]] constexpr State state_at(const S& time) const noexcept {
    State state;
    for (int i = 0; i < dimension; ++i) {
      const auto offset = narrow_floor<Place>(way_[i] * time);
      const auto nearest = offset < low_[i] ? low_[i] : offset > high_[i] ? high_[i] : offset;
      state.offset[i] = offset;
      state.v[i] = narrow_difference<63>(nearest, offset);
    }
    state.squared = narrow_dot<127>(state.v, state.v);
    state.rate = narrow_dot<126>(state.v, way_);
    return state;
  }

  template <Number Radius>
  [[nodiscard]] constexpr Filtered is_beyond(const State& state,
                                             const Radius& radius) const noexcept {
    using Beyond = Fixed<127, 2 * frac>;
    auto sum = Fixed<65, 2 * frac>::assume_raw(dimension);
    for (int i = 0; i < dimension; ++i) {
      const auto& x = state.v[i];
      const Place magnitude = x < 0 ? narrow_negative(x) : x;
      sum = narrow<65>(sum + Fixed<63, 2 * frac>::assume_raw(magnitude.raw()));
    }
    return decide(
        Approximate{Beyond(narrow_difference<127>(state.squared, square(radius))), sum + sum});
  }
  [[nodiscard]] constexpr Filtered is_apart(const State& state) const noexcept {
    return is_beyond(state, radius_);
  }
  /// Whether v.w > 0.
  [[nodiscard]] constexpr Filtered closes_in(const State& state) const noexcept {
    using Error = Fixed<W::frac + 3, frac + W::frac>;
    constexpr auto error = Error::assume_raw(typename Error::raw_type{1} << (W::frac + 2));
    return decide(Approximate{state.rate, error});
  }

  /// About how many steps of the time until the touch, if the same axes exceed until then, or until
  /// |v| is least.
  [[nodiscard]] constexpr S proposed() const noexcept {
    Way speed{};
    for (int i = 0; i < dimension; ++i) {
      if (now_.v[i] != 0) speed[i] = way_[i];
    }
    const Leading a(narrow_dot<2 * W::frac + 4>(speed, speed)), b(now_.rate);
    const Leading c(narrow_difference<127>(now_.squared, square(radius_)));
    const auto bb = b * b, ac = a * c;
    const auto rest = difference(bb, ac, Relative{56}).value;
    if (!(rest > 0)) return floor_below<S>(b / a);
    Leading discriminant(rest);
    discriminant.exponent += (std::max)(bb.exponent, ac.exponent) + 1;
    return floor_below<S>(c / (b + sqrt(discriminant)));
  }

  /// The side of the box on which the point is from the time found to the next one: -1, 0, 1 or
  /// `unsure_side`.
  [[nodiscard]] constexpr int side_of(int i) const noexcept {
    const auto side_at = [&](const State& state) {
      constexpr auto step = Fixed<1, frac>::assume_raw(1);
      const auto& x = state.offset[i];
      if (x + step < low_[i]) return -1;
      if (x > high_[i]) return 1;
      return x > low_[i] && x + step < high_[i] ? 0 : unsure_side;
    };
    const int side = side_at(now_);
    return side == side_at(next_) ? side : unsure_side;
  }

  Corner exact_low_, exact_high_;
  Way way_;
  Places low_, high_;
  R radius_;
  State now_{}, next_{};
};

}  // namespace detent::detail
