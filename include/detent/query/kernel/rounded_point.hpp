// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/math/components.hpp"
#include "detent/number/filter/components.hpp"
#include "detent/number/filter/ratio.hpp"
#include "detent/query/kernel/least_common_point.hpp"

// Points rounded once: each coordinate to nearest, ties to even, and clamped.

namespace detent::detail {

/// The sign of x / sqrt(square) - y, exactly.
template <Number X, Number Square, Number Y>
[[nodiscard]] constexpr int compare_with_quotient(const X& x, const Square& square,
                                                  const Y& y) noexcept {
  const int x_sign = (x > 0) - (x < 0), y_sign = (y > 0) - (y < 0);
  if (x_sign != y_sign) return x_sign > y_sign ? 1 : -1;
  const auto left = x * x;
  const auto right = y * y * square;
  return x_sign * ((left > right) - (left < right));
}

/// over / under on the grid of 2^-25 steps of S, off by less than `error`; valid only if
/// `is_short`, which says that it is in the range of S (docs/filters.md, lemma 12).
template <Number S>
struct ShortQuotient {
  using Value = Fixed<63, S::frac + 25>;
  static constexpr Steps<8> error{};

  template <int BO, int FO, int BU, int FU>
  constexpr ShortQuotient(const Fixed<BO, FO>& over, const Fixed<BU, FU>& under) noexcept {
    const auto ratio = make_ratio(over, under);
    const int down = ratio.shift + FO - FU - Value::frac;
    if (down < 0 && ratio.factor != 0) return;
    value = Value::assume_raw(shift_right_floor(ratio.factor, down < 0 ? 0 : down));
    is_short = lowest<S> <= value && value <= largest<S>;
  }

  Value value;
  bool is_short = false;
};

/// over / under, rounded to nearest, for under > 0.
template <Number S, Number Over, Number Under>
[[nodiscard]] constexpr S rounded(const Over& over, const Under& under) noexcept {
  if constexpr (is_fixed<S>) {
    const ShortQuotient<S> quotient(over, under);
    if (quotient.is_short) {
      const auto nearest = decide_nearest<S>(Approximate{quotient.value, quotient.error});
      return or_exact(nearest, [&] { return quotient_nearest<S>(over, under); });
    }
  }
  return quotient_nearest<S>(over, under);
}
template <Scalar S, Number Over, Number Under, int N>
[[nodiscard]] constexpr Vec<S, N> rounded(const RationalPoint<Over, Under, N>& p) noexcept {
  return make_vec<N>([&](int i) { return rounded<S>(p.over[i], p.under); });
}

/// from + step * ratio, rounded to nearest and clamped, for a ratio below 1.
template <Number S, Number From, Number Step, Number Over, Number Under, int Frac, class Error>
[[nodiscard]] constexpr S nearest_between(
    const From& from, const Step& step,
    const BoundedRatio<Over, Under, Frac, Error>& ratio) noexcept {
  const auto exact = [&] {
    return rounded<S>(from * ratio.under + step * ratio.over, ratio.under);
  };
  if constexpr (is_fixed<S>) {
    return or_exact(decide_between<S>(from, step, ratio), exact);
  } else {
    return exact();
  }
}

template <Scalar S, int N>
[[nodiscard]] constexpr const Vec<S, N>& rounded(const Vec<S, N>& p) noexcept {
  return p;
}

/// A coordinate of a point on a finer grid, off by less than 2^8 steps.
template <Scalar S, Number Over, Number Under, int N>
[[nodiscard]] constexpr auto approximate_coordinate(const RationalPoint<Over, Under, N>& p,
                                                    int i) noexcept {
  using Finer = finer<S, 30>;
  const ShortQuotient<S> quotient(p.over[i], p.under);
  return quotient.is_short ? floor_to<Finer>(quotient.value)
                           : quotient_floor<Finer>(p.over[i], p.under);
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto approximate_coordinate(const Vec<S, N>& p, int i) noexcept {
  return finer<S, 30>(p[i]);
}

/// The sign of x / sqrt(square) - (y - coordinate i of p), exactly.
template <Number X, Number Square, Number Y, Number Over, Number Under, int N>
[[nodiscard]] constexpr int compare_with_quotient(const X& x, const Square& square, const Y& y,
                                                  const RationalPoint<Over, Under, N>& p,
                                                  int i) noexcept {
  return compare_with_quotient(x * p.under, square, y * p.under - p.over[i]);
}
template <Number X, Number Square, Number Y, Scalar S, int N>
[[nodiscard]] constexpr int compare_with_quotient(const X& x, const Square& square, const Y& y,
                                                  const Vec<S, N>& p, int i) noexcept {
  return compare_with_quotient(x, square, y - p[i]);
}

/// The error of p + radius v / |v|: the step is off by less than 2^17 + 2^10, and p by 2^8.
inline constexpr Steps<1 << 18> beyond_error{};

/// Coordinate i of p + radius v / |v| before it is rounded: a sum and its error, in range.
template <Scalar S, class Point, class Moves>
[[nodiscard]] constexpr auto approximate_beyond(const Point& p, const Moves& moves,
                                                int i) noexcept {
  auto sum =
      narrow_sum<62>(approximate_coordinate<S>(p, i), moves.value[static_cast<std::size_t>(i)]);
  // Beyond the range by more than the error, the result is the end of the range.
  using Sum = std::remove_cvref_t<decltype(sum)>;
  constexpr Sum most(largest<S>), least(lowest<S>);
  if (sum > most) sum = most;
  if (sum < least) sum = least;
  return Approximate{sum, beyond_error};
}

/// Calls write(i, x) for each coordinate x of the point p, which is rational or on the grid, + moves,
/// which are within their error of radius v / |v|. Coordinates that the filter does not decide are
/// written again.
template <Scalar S, class Point, Number V, int N, class Moves, class Write>
constexpr void write_rounded_beyond(const Point& p, const S& radius, const Vec<V, N>& v,
                                    const Moves& moves, const Write& write) noexcept {
  using Near = Fixed<bits_of<S> + 2, S::frac>;
  bool is_sure = true;
  for (int i = 0; i < N; ++i) {
    const auto sum =
        narrow_sum<62>(approximate_coordinate<S>(p, i), moves.value[static_cast<std::size_t>(i)]);
    const auto nearest = decide_nearest<Near>(Approximate{sum, beyond_error});
    const bool is_in_range = lowest<S> <= nearest.value && nearest.value <= largest<S>;
    is_sure = is_sure & nearest.is_sure & is_in_range;  // one branch, which is predictable
    write(i, S::assume_raw(static_cast<typename S::raw_type>(nearest.value.raw())));
  }
  if (is_sure) return;
  for (int i = 0; i < N; ++i) {
    const auto nearest = decide_nearest<S>(approximate_beyond<S>(p, moves, i));
    write(i, or_exact(nearest, [&](const S& upper) {
            const auto middle = midpoint_below(upper);
            return nearest_at_midpoint(
                upper, compare_with_quotient(radius * v[i], squared_length(v), middle, p, i));
          }));
  }
}
template <Scalar S, class Point, Number V, int N, class Moves>
[[nodiscard]] constexpr Vec<S, N> rounded_beyond(const Point& p, const S& radius,
                                                 const Vec<V, N>& v, const Moves& moves) noexcept {
  Vec<S, N> result;
  write_rounded_beyond(p, radius, v, moves, [&](int i, const S& x) { result[i] = x; });
  return result;
}

/// The point p, which is rational or on the grid, + radius v / |v| for radius >= 0 and v not 0.
template <Scalar S, class Point, Number V, int N>
[[nodiscard]] constexpr Vec<S, N> rounded_beyond(const Point& p, const S& radius,
                                                 const Vec<V, N>& v) noexcept {
  if (radius == 0) return rounded<S>(p);
  if constexpr (!is_fixed<S>) {
    const auto length = sqrt_floor<S>(squared_length(v));
    const auto from = rounded<S>(p);
    return make_vec<N>([&](int i) { return from[i] + radius * (v[i] / length); });
  } else {
    return rounded_beyond(p, radius, v, step_along(radius, to_array(v)));
  }
}

/// The same for a v too long for an exact comparison: within 1/2 + 2^-12 ULP of the exact point.
template <Scalar S, Number Over, Number Under, Number V, int N>
[[nodiscard]] constexpr Vec<S, N> nearly_rounded_beyond(const RationalPoint<Over, Under, N>& p,
                                                        const S& radius,
                                                        const Vec<V, N>& v) noexcept {
  if (radius == 0) return rounded<S>(p);
  if constexpr (!is_fixed<S>) {
    return rounded_beyond(p, radius, v);
  } else {
    const auto moves = step_along(radius, to_array(v));
    return make_vec<N>(
        [&](int i) { return nearest_to<S>(approximate_beyond<S>(p, moves, i).value); });
  }
}

/// The same for a p on the grid. A coordinate above 0 counts as 2^-25 steps less, which is how a
/// quotient by 1 is rounded: the result is that for the equal rational point.
template <Scalar S, Number V, int N>
[[nodiscard]] constexpr Vec<S, N> nearly_rounded_beyond(const Vec<S, N>& p, const S& radius,
                                                        const Vec<V, N>& v) noexcept {
  if constexpr (!is_fixed<S>) {
    return rounded_beyond(p, radius, v);
  } else {
    if (radius == 0) return p;
    using Finer = finer<S, 30>;
    constexpr auto less = Finer::from_raw(1 << 5);
    const auto moves = step_along(radius, to_array(v));
    return make_vec<N>([&](int i) {
      const auto from = Finer(p[i]) - (p[i] > 0 ? less : Finer(0));
      return nearest_to<S>(from + moves.value[static_cast<std::size_t>(i)]);
    });
  }
}

/// The point of the coordinates decide(i); sure if all of them are.
template <Scalar S, int N, class Decide>
[[nodiscard]] constexpr Decided<Vec<S, N>> decide_each(const Decide& decide) noexcept {
  return decide_all<Vec<S, N>, std::size_t{N}>(
      [&](std::size_t i) { return decide(static_cast<int>(i)); });
}

/// The same by any vector in the direction of v; unsure if another one's error might round it
/// otherwise: both are within 2^18 steps of the exact point.
template <Scalar S, class Point, Number V, int N>
[[nodiscard]] constexpr Decided<Vec<S, N>> decide_beyond(const Point& p, const S& radius,
                                                         const Vec<V, N>& v) noexcept {
  const auto moves = step_along(radius, to_array(v));
  return decide_each<S, N>([&](int i) {
    const auto sum = approximate_beyond<S>(p, moves, i).value;
    return decide_nearest<S>(Approximate{sum, Steps<1 << 19>()});
  });
}

/// A coordinate rounded to nearest; unsure, too, if it is out of range.
template <Scalar S, Number X, class Error>
[[nodiscard]] constexpr Decided<S> decide_coordinate(const Approximate<X, Error>& x) noexcept {
  if (x.value < lowest<S> || largest<S> < x.value) return {S(), false};
  return decide_nearest<S>(x);
}
/// The same for a point with the coordinates at(i), off by less than `error`.
template <Scalar S, int N, class At, class Error>
[[nodiscard]] constexpr Decided<Vec<S, N>> decide_point(const At& at, const Error& error) noexcept {
  return decide_each<S, N>([&](int i) { return decide_coordinate<S>(Approximate{at(i), error}); });
}

}  // namespace detent::detail
