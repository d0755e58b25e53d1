// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "detent/number/filter/leading.hpp"

namespace detent {

/// over / under, divided once, to multiply several numbers (`add_product`). For `float` and
/// `double`, just the two numbers.
template <Number Over, Number Under>
struct Ratio {
  Over over;
  Under under;
  // Of the raw numbers: factor * 2^-shift is over / under with a relative error below 2^-56.
  std::int64_t factor = 0;
  int shift = 0;
};

/// A ratio of known magnitude, with the approximate quotient of the raw numbers. For `float` and
/// `double`, just the two numbers.
template <Number Over, Number Under, int Frac, class Error>
struct BoundedRatio {
  Over over;
  Under under;
  Approximate<Fixed<63, Frac>, Error> quotient{};
};

/// over / under for under > 0.
template <Number Over, Number Under>
[[nodiscard]] constexpr Ratio<Over, Under> make_ratio(const Over& over,
                                                      const Under& under) noexcept {
  if constexpr (!is_fixed<Over>) {
    return {over, under};
  } else {
    using Magnitude = IntegerFor<(std::max)(Over::bits, 63)>;
    const auto raw = integer_cast<Magnitude>(over.raw());
    if (raw == Magnitude(0)) return {over, under};
    const bool negative = is_negative(raw);
    const auto magnitude = negative ? wrapping_subtract<Magnitude>(Magnitude(0), raw) : raw;
    const int over_length = positive_bit_length(magnitude);
    const int under_length = positive_bit_length(under.raw());
    const auto factor = static_cast<std::int64_t>(
        multiply_words(detail::leading_word(magnitude, over_length),
                       detail::reciprocal(detail::leading_word(under.raw(), under_length)))
            .high);
    return {over, under, negative ? -factor : factor, 62 + under_length - over_length};
  }
}

/// over / under for 0 < over < under. base + x * ratio lies between base and base + x, so both must
/// be in range.
template <Number Over, Number Under>
[[nodiscard]] constexpr BoundedRatio<Over, Under, 63, Steps<128>> make_ratio_below_one(
    const Over& over, const Under& under) noexcept {
  if constexpr (!is_fixed<Over>) {
    return {over, under};
  } else {
    using Positive = IntegerFor<(std::max)({Over::bits, Under::bits, 63})>;
    const int length = positive_bit_length(under.raw());
    const auto leading = [length](const auto& x) {
      return detail::leading_word(integer_cast<Positive>(x.raw()), length);
    };
    // The reciprocal is never too large, so this stays below 2^63.
    const auto quotient =
        2 * multiply_words(leading(over), detail::reciprocal(leading(under))).high;
    return {over, under, {Fixed<63, 63>::assume_raw(static_cast<std::int64_t>(quotient)), {}}};
  }
}

/// over / under without a division, for an `under` that is the squared length of a direction: 1
/// within 2^-28, or 2^-12 in 16 bits.
///
/// 1 / (1 + e) = 1 - e + ...: the rest of the series is e^2 < 2^-56 (2^-24), and |over| < 2^63
/// (2^31).
template <Number Over, Number Under>
[[nodiscard]] constexpr auto make_ratio_to_unit(const Over& over, const Under& under) noexcept {
  if constexpr (!is_fixed<Over>) {
    return BoundedRatio<Over, Under, 0, Steps<0>>{over, under};
  } else {
    constexpr int frac = Under::frac;
    static_assert(Over::bits <= frac + 3);
    using Product = IntegerFor<Over::bits + frac / 2 + 2>;
    const auto excess = wrapping_subtract<std::int64_t>(under.raw(), std::int64_t{1} << frac);
    DETENT_ASSERT(detail::is_within<frac / 2 + 2>(excess));
    const auto correction = integer_cast<std::int64_t>(
        shift_right_floor(wrapping_multiply<Product>(over.raw(), excess), frac));
    return BoundedRatio<Over, Under, frac, Steps<256>>{
        over, under, {Fixed<63, frac>::assume_raw(over.raw() - correction), {}}};
  }
}

namespace detail {

/// base + x * over / under rounded to nearest, ties to even, and clamped. `whole` is
/// floor(x * over / under), computed from a quotient with an error below a half.
///
/// The remainder is small enough to be computed modulo its integer's size. It shows on which side
/// of a half the exact quotient lies.
template <class S, class T, class Over, class Under>
[[nodiscard]] constexpr S add_quotient(const S& base, const T& x, const Over& over,
                                       const Under& under, std::int64_t whole) noexcept {
  using Rest = IntegerFor<(std::max)(Under::bits + 1, 63)>;
  const auto rest = wrapping_subtract<Rest>(wrapping_multiply<Rest>(x.raw(), over.raw()),
                                            wrapping_multiply<Rest>(whole, under.raw()));
  const auto beyond_half = wrapping_subtract<Rest>(shift_left(rest, 1), under.raw());
  const std::int64_t sum = std::int64_t{base.raw()} + whole;
  const bool up = wrapping_add<Rest>(beyond_half, sum & 1) > Rest(0);  // a tie: up if sum is odd
  return clamp_raw<S>(sum + (up ? 1 : 0));
}

}  // namespace detail

/// base + x * ratio rounded to nearest, ties to even, and clamped; |x * ratio| must be below 2^34
/// steps of S.
template <Scalar S, Number T, Number Over, Number Under>
[[nodiscard]] constexpr S add_product(const S& base, const T& x,
                                      const Ratio<Over, Under>& ratio) noexcept {
  if constexpr (!is_fixed<S>) {
    return (base * ratio.under + x * ratio.over) / ratio.under;
  } else if constexpr (T::bits > 63) {
    return quotient_nearest<S>(base * ratio.under + x * ratio.over, ratio.under);
  } else {
    static_assert(T::frac + Over::frac - Under::frac == S::frac);
    const auto product = wrapping_multiply<Int128>(x.raw(), ratio.factor);
    const auto whole = integer_cast<std::int64_t>(shift_right_floor(product, ratio.shift));
    return detail::add_quotient(base, x, ratio.over, ratio.under, whole);
  }
}

template <Scalar S, Number T, Number Over, Number Under, int Frac, class Error>
[[nodiscard]] constexpr S add_product(
    const S& base, const T& x, const BoundedRatio<Over, Under, Frac, Error>& ratio) noexcept {
  if constexpr (!is_fixed<S>) {
    return (base * ratio.under + x * ratio.over) / ratio.under;
  } else {
    static_assert(T::frac + Over::frac - Under::frac == S::frac);
    static_assert(T::bits + 64 - Frac < 63);
    // The product's whole part is in the high word, its fraction in the low one.
    const auto [value, error] = ratio.quotient;
    const std::int64_t scaled = std::int64_t{x.raw()} * (std::int64_t{1} << (64 - Frac));
    const Wide<2> product(wrapping_multiply<Int128>(scaled, value.raw()));
    // |x| is at most 2^T::bits.
    const auto product_error = static_cast<std::uint64_t>(error.raw()) << (T::bits + 64 - Frac);
    const auto whole = static_cast<std::int64_t>(product.word(1));
    // After adding a half and the error, a fraction below twice the error was near a half.
    const std::uint64_t fraction = product.word(0) + ((std::uint64_t{1} << 63) + product_error);
    const std::int64_t nearest = base.raw() + whole + (fraction < product.word(0) ? 1 : 0);
    const bool is_sure = fraction >= 2 * product_error;
    const auto exact = [&] {
      return detail::add_quotient(base, x, ratio.over, ratio.under, whole);
    };
    if constexpr (Frac == 63) {
      return or_exact(
          Decided<S>{S::assume_raw(static_cast<typename S::raw_type>(nearest)), is_sure}, exact);
    } else {
      return or_exact(Decided<S>{detail::clamp_raw<S>(nearest), is_sure}, exact);
    }
  }
}

/// x * ratio with 30 more fractional bits than x.
template <int B, int F, Number Over, Number Under>
[[nodiscard]] constexpr auto approximate_product(
    const Fixed<B, F>& x, const BoundedRatio<Over, Under, 63, Steps<128>>& ratio) noexcept {
  static_assert(B <= 32);  // 2^32 times 2^7 steps of 2^-63, and one for the floor
  using Product = Fixed<B + 30, F + 30>;
  using Raw = typename Product::raw_type;
  const auto product = wrapping_multiply<Int128>(x.raw(), ratio.quotient.value.raw());
  return Approximate{Product::assume_raw(integer_cast<Raw>(shift_right_floor(product, 33))),
                     Steps<256>()};
}

/// from + step * ratio rounded to nearest; unsure, too, if it is out of the range of S
/// (docs/filters.md, lemma 16).
template <class S, int BF, int FF, int BS, int FS, Number Over, Number Under>
[[nodiscard]] constexpr Decided<S> decide_between(
    const Fixed<BF, FF>& from, const Fixed<BS, FS>& step,
    const BoundedRatio<Over, Under, 63, Steps<128>>& ratio) noexcept {
  using Value = Fixed<62, S::frac + 25>;
  static_assert(BS + Value::frac - FS <= 61 && BF + Value::frac - FF <= 61);
  const auto ahead =
      wrapping_multiply<Int128>(floor_to<Value>(step).raw(), ratio.quotient.value.raw());
  const auto value = Value::assume_raw(floor_to<Value>(from).raw() +
                                       integer_cast<std::int64_t>(shift_right_floor(ahead, 63)));
  if (value < lowest<S> || largest<S> < value) return {S(), false};
  return decide_nearest<S>(Approximate{value, Steps<64>()});
}

/// sqrt(square - over^2 / under) >= 0 rounded down to the grid of `T` and clamped: a side of a
/// right triangle, given the ratio over / under.
///
/// Only the ratio has an error: it is multiplied by `over`, plus one step for the floor of the
/// product. The filter is unsure if that might cross another square.
template <Number T, Number Square, Number Over, Number Under, int Frac, class Error>
[[nodiscard]] constexpr Decided<T> decide_side_floor(
    const Square& square, const BoundedRatio<Over, Under, Frac, Error>& ratio) noexcept {
  static_assert(Square::frac == 2 * T::frac && 2 * Over::frac - Under::frac == Square::frac);
  if (shift_right_floor(square.raw(), 62) != typename Square::raw_type(0)) return {T(), false};
  const auto [value, error] = ratio.quotient;
  constexpr int up = (std::max)(Over::bits - Frac, 0), down = (std::max)(Frac - Over::bits, 0);
  const auto rest_error =
      2 * (std::max)(shift_right_floor(error.raw() << up, down), std::int64_t{1});
  const auto product = wrapping_multiply<Int128>(ratio.over.raw(), value.raw());
  // Below 2^62, as no product of `over` and the quotient is negative.
  const auto rest = integer_cast<std::int64_t>(square.raw()) -
                    integer_cast<std::int64_t>(shift_right_floor(product, Frac));
  const std::int64_t root =
      short_root_floor(static_cast<std::uint64_t>(std::max<std::int64_t>(rest, 0)));
  const std::int64_t beyond = rest - root * root;
  return {detail::clamp_root<T>(static_cast<std::uint64_t>(root)),
          rest_error <= beyond && beyond <= 2 * root - rest_error};
}

namespace detail {

/// The root, rounded down and clamped, of a number that is at most `rest` and exceeds rest - error;
/// it is `rest` if `is_exact`. 0 <= rest < 2^62.
template <Number T>
[[nodiscard]] constexpr Decided<T> decide_root_floor(std::int64_t rest, std::int64_t error,
                                                     bool is_exact) noexcept {
  const std::int64_t root = short_root_floor(static_cast<std::uint64_t>(rest));
  const bool is_sure = rest - root * root >= error || is_exact;
  if constexpr (T::bits < 31) return {clamp_root<T>(static_cast<std::uint64_t>(root)), is_sure};
  return {T::assume_raw(static_cast<typename T::raw_type>(root)), is_sure};
}

}  // namespace detail

/// Filter: the distance from a point to a segment, rounded down and clamped, from products of the
/// vectors w from its start to the point and e to its end: w^2, w e and e^2 (docs/filters.md,
/// lemma 43).
template <Number T, int F>
[[nodiscard]] constexpr Decided<T> decide_segment_distance(const Fixed<62, F>& square,
                                                           const Fixed<62, F>& along,
                                                           const Fixed<62, F>& whole) noexcept {
  static_assert(F == 2 * T::frac);
  const std::int64_t over = along.raw(), under = whole.raw();
  const bool is_inside = 0 < over && over < under;
  std::int64_t removed = over >= under ? 2 * over - under : 0;
  if (is_inside) {
    const auto left = static_cast<std::uint64_t>(over), all = static_cast<std::uint64_t>(under);
    const int zeros = std::countl_zero(all | 1);  // GCC branches on 0
    const std::uint64_t share =
        multiply_words(left << zeros, detail::reciprocal(all << zeros)).high;
    removed = static_cast<std::int64_t>(multiply_words(left << 2, share).high);
  }
  return detail::decide_root_floor<T>(square.raw() - removed, 18, !is_inside);
}

/// Filter: the distance from a point to an endless ray, rounded down and clamped, from products of
/// the vector w from its origin to the point and its direction d: w^2, w d and d^2 (docs/filters.md,
/// lemma 44). |along| must be below 2^61 steps.
template <Number T, int F, int FA>
[[nodiscard]] constexpr Decided<T> decide_line_distance(const Fixed<62, F>& square,
                                                        const Fixed<61, FA>& along,
                                                        const Fixed<61, 60>& whole) noexcept {
  static_assert(F == 2 * T::frac && FA == T::frac + 30);
  // GCC computes three products if it knows a sign.
  const std::int64_t over = detail::in_register(std::max<std::int64_t>(along.raw(), 0));
  const std::int64_t excess = whole.raw() - (std::int64_t{1} << 60);
  const std::int64_t share = over - detail::high_word(over, shift_left(excess, 4)) - 1;
  const std::int64_t removed = detail::high_word(shift_left(over, 2), shift_left(share, 2));
  return detail::decide_root_floor<T>(square.raw() - removed, 68, over == 0);
}

}  // namespace detent
