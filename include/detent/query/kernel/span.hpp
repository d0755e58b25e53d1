// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/number/fraction.hpp"
#include "detent/shape/ray.hpp"

namespace detent::detail {

/// The part of a line inside a shape, from `enter` to `exit`, as exact distances of either sign.
template <Number N, Number D>
struct Span {
  Fraction<N, D> enter;
  Fraction<N, D> exit;
};

/// The first distance of `span` in [0, limit], rounded down.
template <Scalar S, Number N, Number D>
[[nodiscard]] constexpr std::optional<S> first_distance(const Span<N, D>& span,
                                                        const S& limit) noexcept {
  if (limit < 0 || span.exit.numerator < 0) return std::nullopt;
  if (span.enter.numerator <= 0) return S(0);
  return floor_within(span.enter, limit);
}

/// The part of `span` in [0, limit], rounded down.
template <Scalar S, Number N, Number D>
[[nodiscard]] constexpr std::optional<Interval<S>> interval_of(const Span<N, D>& span,
                                                               const S& limit) noexcept {
  const auto enter = first_distance(span, limit);
  if (!enter) return std::nullopt;
  return Interval<S>{*enter, floor_within(span.exit, limit).value_or(limit)};
}

}  // namespace detent::detail
