// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/math/components.hpp"
#include "detent/math/direction.hpp"
#include "detent/number/filter/components.hpp"
#include "detent/number/filter/ratio.hpp"

namespace detent::detail {

/// How many bits finer the time grid must be for a normal to turn by less than an eighth of its own
/// step; at most `Most`, which is enough for any radius.
template <int Most, Number R>
[[nodiscard]] constexpr int finer_by(const R& radius) noexcept {
  return (std::max)(Most + 1 - bits_of<R> + headroom(radius), 0);
}

/// The direction of a vector whose components are off by less than 6; unsure where that could
/// change it, or if the vector is shorter than 2^58.
template <Scalar S, Number V, int N>
[[nodiscard]] constexpr Decided<Direction<S, N>> direction_of_words(const Vec<V, N>& v) noexcept {
  using Component = direction_component<S>;
  using Magnitude = IntegerFor<(std::max)(bits_of<V>, 63)>;
  const auto magnitude = magnitudes<Magnitude>(to_array(v));
  bool is_long = false;
  for (const auto& m : magnitude) is_long = is_long | (m >= shift_left(Magnitude(1), 58));
  if (!is_long) return {{}, false};
  const auto shares = detail::shares(magnitude);
  std::array<Component, static_cast<std::size_t>(N)> unit;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    constexpr Steps<decltype(shares.error)::raw() + (1 << 9)> error;
    const auto nearest = decide_nearest<Component>(Approximate{shares.value[i], error});
    if (!nearest.is_sure) return {{}, false};
    unit[i] = with_sign(nearest.value, v[static_cast<int>(i)] < 0);
  }
  return {Direction<S, N>::assume_unit(from_array(unit)), true};
}

/// Words of a vector between two features and of its motion, both perpendicular to the features, in
/// steps for which the radius has 61 bits.
template <int N>
struct TouchWords {
  Vec<Fixed<62, 0>, N> place;  // at most one time of the grid of S before the touch
  Vec<Fixed<61, 60>, N> way;
  Fixed<62, 0> radius;
};

/// The direction that `Approach::with_touch` gives for a point, an edge or a corner. Unsure where
/// the errors of words could change it, or where Newton's method might end before the last time of
/// the finer grid. The touch must be at least 2^-Margin of such a time off (docs/filters.md, lemmas
/// 19 and 25).
///
/// In steps of 2^-27 of the finer times, the radius has 61 bits. The touch is at the lesser root of
/// a t^2 - 2 b t + c = 0: t = c / (2 b) (1 + x + 2 x^2 + 5 x^3 + ...) for x = a c / (2 b)^2.
template <Scalar S, int Margin, int N, class ToWorld>
[[nodiscard]] constexpr Decided<Direction<S, N>> direction_by_words(
    const TouchWords<N>& words, const ToWorld& to_world) noexcept {
  using Word = Fixed<62, 0>;
  const auto& p = words.place;
  const auto& w = words.way;
  const auto along = narrow_floor<Fixed<63, 0>>(dot(p, w));
  const auto beyond =
      narrow_floor<Fixed<63, -60>>(narrow_difference<126>(squared_length(p), square(words.radius)));
  const auto b = static_cast<std::uint64_t>(along.raw()),
             c = static_cast<std::uint64_t>(beyond.raw());
  const auto squared = narrow_floor<Fixed<63, 60>>(squared_length(w));
  const auto a = static_cast<std::uint64_t>(squared.raw());
  if (a > (std::uint64_t{1} << 60) + (std::uint64_t{1} << 40)) return {{}, false};  // a skew frame
  if (along.raw() < Word::raw_type{1} << 50 || b >> 62 != 0) return {{}, false};
  if (beyond < 0 || c >= b >> 6) return {{}, false};
  // Times in half steps.
  const int zeros = std::countl_zero(b);
  const std::uint64_t inverse = reciprocal(b << zeros);
  const std::uint64_t first = multiply_words(c << (zeros - 2), inverse).high;
  if (first >= b >> 9) return {{}, false};
  const std::uint64_t x =
      multiply_words(a << 3, multiply_words(first << (zeros + 1), inverse).high).high;
  const std::uint64_t xx = multiply_words(x, x).high, xxx = multiply_words(xx, x).high;
  const std::uint64_t time = first + multiply_words(first, x + 2 * xx + 5 * xxx).high;
  constexpr int fine = 28;
  constexpr std::uint64_t margin = std::uint64_t{1} << (fine - Margin);
  const std::uint64_t rest = time & ((std::uint64_t{1} << fine) - 1);
  if (rest < margin || rest >= (std::uint64_t{1} << fine) - margin) return {{}, false};
  using Time = Fixed<54, 0>;
  const auto until = Time::assume_raw(static_cast<Time::raw_type>((time - rest) >> 1));
  const auto outward = to_world(make_vec<N>(
      [&](int i) { return narrow_difference<62>(p[i], narrow_floor<Word>(until * w[i])); }));
  return direction_of_words<S>(outward);
}

/// The scale of `TouchWords` for a radius: its steps are 2^-scale of those of R; nothing for a
/// radius too short for them.
template <Scalar S, Number R>
[[nodiscard]] constexpr std::optional<int> word_scale(const R& radius) noexcept {
  // `finer_by` must not be clamped to 0.
  static_assert(bits_of<R> <= bits_of<direction_component<S>> + 3);
  const int empty = headroom(radius);
  if (empty > 24) return std::nullopt;
  return 61 - bits_of<R> + empty;
}
template <Number R>
[[nodiscard]] constexpr Fixed<62, 0> radius_word(const R& radius, int scale) noexcept {
  using Word = Fixed<62, 0>;
  return Word::assume_raw(shift_left(integer_cast<Word::raw_type>(radius.raw()), scale));
}

/// The same by `place`, the vector across at most one time of the grid of S before the touch, and by
/// `way`, both perpendicular to the edge.
template <Scalar S, Number P, Number W, int N, Number R, class ToWorld>
[[nodiscard]] constexpr Decided<Direction<S, N>> direction_at_touch(
    const Vec<P, N>& place, const Vec<W, N>& way, const R& radius,
    const ToWorld& to_world) noexcept {
  using Word = Fixed<62, 0>;
  using Part = Fixed<61, 60>;
  static_assert(W::frac <= Part::frac);
  const auto scale = word_scale<S>(radius);
  if (!scale) return {{}, false};
  const TouchWords<N> words{
      make_vec<N>([&](int i) {
        return Word::assume_raw(scaled_word(place[i].raw(), P::frac - R::frac - *scale));
      }),
      make_vec<N>([&](int i) { return Part(narrow<W::frac + 1>(way[i])); }),
      radius_word(radius, *scale)};
  return direction_by_words<S, 12>(words, to_world);
}

/// The same for an edge in any direction, by the `place` of one of its ends, in the world.
template <Scalar S, Number P, Number E, Number W, Number R>
[[nodiscard]] constexpr Decided<Direction<S, 3>> direction_across(const Vec<P, 3>& place,
                                                                  const Vec<E, 3>& edge,
                                                                  const Vec<W, 3>& way,
                                                                  const R& radius) noexcept {
  using Word = Fixed<62, 0>;
  using Part = Fixed<61, 60>;
  static_assert(bits_of<E> <= 33 && P::frac == E::frac + W::frac && E::frac == R::frac);
  const auto scale = word_scale<S>(radius);
  if (!scale) return {{}, false};
  const auto whole = squared_length(edge);
  // The share of the edge before the foot, rounded down to 2^-30, then the rest of it.
  const auto share = make_ratio(dot(edge, place), whole);
  using Before = Fixed<32, W::frac>;
  if (share.factor != 0 && share.shift < 31) return {{}, false};
  const auto before = Before::assume_raw(
      integer_cast<typename Before::raw_type>(share.factor >> (std::min)(share.shift, 63)));
  const auto after = place - edge * before;
  const auto rest = make_ratio(dot(edge, after), whole);
  const auto speed = make_ratio(dot(edge, way), whole);
  const auto part_of = [](const E& component, const auto& ratio, int down) {
    return integer_cast<typename Word::raw_type>(
        shift_right_floor(wrapping_multiply<Int128>(component.raw(), ratio.factor),
                          (std::min)(ratio.shift + down, 126)));
  };
  const int down = W::frac - *scale;
  if (rest.factor != 0 && rest.shift + down < 34) return {{}, false};
  if (speed.factor != 0 && speed.shift < 30) return {{}, false};
  const auto moved = make_vec<3>([&](int i) {
    const auto word = scaled_word(after[i].raw(), P::frac - R::frac - *scale);
    return Word::assume_raw(word - (rest.factor == 0 ? 0 : part_of(edge[i], rest, down)));
  });
  const auto across = make_vec<3>([&](int i) {
    const auto all = Part(way[i]).raw();
    return Part::assume_raw(all - (speed.factor == 0 ? 0 : part_of(edge[i], speed, -30)));
  });
  return direction_by_words<S, 10>(TouchWords<3>{moved, across, radius_word(radius, *scale)},
                                   [](const auto& v) { return v; });
}

/// The same for a corner or an edge of the differences of two bodies; in a frame, only for an edge
/// along an axis.
template <Scalar S, class Feature, Number W, int N, Number R, class ToWorld>
[[nodiscard]] constexpr Decided<Direction<S, N>> direction_on(const Feature& feature,
                                                              const Vec<W, N>& way,
                                                              const S& distance, const R& radius,
                                                              const ToWorld& to_world) noexcept {
  const auto& corner = feature.corners[0];
  const auto& other = feature.corners[feature.count == 2 ? 1 : 0];
  auto place = corner - way * distance;
  auto across = way;
  int varying = 0;
  for (int i = 0; i < N; ++i) {
    if (corner[i] == other[i]) continue;
    place[i] = {};
    across[i] = {};
    ++varying;
  }
  if (varying != feature.count - 1) return {{}, false};
  return direction_at_touch<S>(place, across, radius, to_world);
}

}  // namespace detent::detail
