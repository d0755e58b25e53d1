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

namespace detent::detail {

/// How many bits finer the time grid must be for a normal to turn by less than an eighth of its own
/// step; at most `Most`, which is enough for any radius.
template <int Most, Number R>
[[nodiscard]] constexpr int finer_by(const R& radius) noexcept {
  return (std::max)(Most + 1 - bits_of<R> + headroom(radius), 0);
}

/// The direction of a vector whose components are off by less than 6; nothing where that could
/// change it, or if the vector is shorter than 2^58.
template <Scalar S, Number V, int N>
[[nodiscard]] constexpr std::optional<Direction<S, N>> direction_of_words(
    const Vec<V, N>& v) noexcept {
  using Component = direction_component<S>;
  using Length = Fixed<59, 0>;
  constexpr auto least = Length::assume_raw(Length::raw_type{1} << 58);
  if (!(abs(v[longest_axis(v)]) >= least)) return std::nullopt;
  using Magnitude = IntegerFor<(std::max)(bits_of<V>, 63)>;
  const auto shares = detail::shares(magnitudes<Magnitude>(to_array(v)));
  std::array<Component, static_cast<std::size_t>(N)> unit;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    constexpr Steps<decltype(shares.error)::raw() + (1 << 9)> error;
    const auto nearest = decide_nearest<Component>(Approximate{shares.value[i], error});
    if (!nearest.is_sure) return std::nullopt;
    unit[i] = v[static_cast<int>(i)] < 0 ? narrow_negative(nearest.value) : nearest.value;
  }
  return Direction<S, N>::assume_unit(from_array(unit));
}

/// The direction that `Approach::with_touch` gives for a point, an edge or a corner, by words of
/// `place`, the vector across it at most one time of the grid of S before the touch, and of `way`,
/// both perpendicular to the edge. Nothing where their errors could change it, or where Newton's
/// method might end before the last time of the finer grid (docs/filters.md, lemma 19).
///
/// In steps of 2^-27 of the finer times, the radius has 61 bits. The touch is at the lesser root of
/// a t^2 - 2 b t + c = 0: t = c / (2 b) (1 + x + 2 x^2 + 5 x^3 + ...) for x = a c / (2 b)^2.
template <Scalar S, Number P, Number W, int N, Number R, class ToWorld>
[[nodiscard]] constexpr std::optional<Direction<S, N>> direction_at_touch(
    const Vec<P, N>& place, const Vec<W, N>& way, const R& radius,
    const ToWorld& to_world) noexcept {
  using Word = Fixed<62, 0>;
  using Part = Fixed<61, 60>;
  // `finer_by` must not be clamped to 0.
  static_assert(W::frac <= Part::frac && bits_of<R> <= bits_of<direction_component<S>> + 3);
  const int empty = headroom(radius);
  if (empty > 24) return std::nullopt;
  const int scale = 61 - bits_of<R> + empty;
  const auto p = make_vec<N>([&](int i) {
    return Word::assume_raw(scaled_word(place[i].raw(), P::frac - R::frac - scale));
  });
  const auto w = make_vec<N>([&](int i) { return Part(narrow<W::frac + 1>(way[i])); });
  const auto r = Word::assume_raw(shift_left(integer_cast<Word::raw_type>(radius.raw()), scale));
  const auto along = narrow_floor<Fixed<63, 0>>(dot(p, w));
  const auto beyond =
      narrow_floor<Fixed<63, -60>>(narrow_difference<126>(squared_length(p), square(r)));
  const auto b = static_cast<std::uint64_t>(along.raw()),
             c = static_cast<std::uint64_t>(beyond.raw());
  const auto squared = narrow_floor<Fixed<63, 60>>(squared_length(w));
  const auto a = static_cast<std::uint64_t>(squared.raw());
  if (a > (std::uint64_t{1} << 60) + (std::uint64_t{1} << 40)) return std::nullopt;  // a skew frame
  if (along.raw() < Word::raw_type{1} << 50 || b >> 62 != 0) return std::nullopt;
  if (beyond < 0 || c >= b >> 6) return std::nullopt;
  // Times in half steps.
  const int zeros = std::countl_zero(b);
  const std::uint64_t inverse = reciprocal(b << zeros);
  const std::uint64_t first = multiply_words(c << (zeros - 2), inverse).high;
  if (first >= b >> 9) return std::nullopt;
  const std::uint64_t x =
      multiply_words(a << 3, multiply_words(first << (zeros + 1), inverse).high).high;
  const std::uint64_t xx = multiply_words(x, x).high, xxx = multiply_words(xx, x).high;
  const std::uint64_t time = first + multiply_words(first, x + 2 * xx + 5 * xxx).high;
  constexpr int fine = 28;
  constexpr std::uint64_t margin = std::uint64_t{1} << (fine - 12);
  const std::uint64_t rest = time & ((std::uint64_t{1} << fine) - 1);
  if (rest < margin || rest >= (std::uint64_t{1} << fine) - margin) return std::nullopt;
  using Time = Fixed<54, 0>;
  const auto until = Time::assume_raw(static_cast<Time::raw_type>((time - rest) >> 1));
  const auto outward = to_world(make_vec<N>(
      [&](int i) { return narrow_difference<62>(p[i], narrow_floor<Word>(until * w[i])); }));
  return direction_of_words<S>(outward);
}

/// `direction_at_touch` for a corner, or an edge along an axis, of the differences of two bodies.
template <Scalar S, class Feature, Number W, int N, Number R, class ToWorld>
[[nodiscard]] constexpr std::optional<Direction<S, N>> direction_on(
    const Feature& feature, const Vec<W, N>& way, const S& distance, const R& radius,
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
  if (varying != feature.count - 1) return std::nullopt;
  return direction_at_touch<S>(place, across, radius, to_world);
}

}  // namespace detent::detail
