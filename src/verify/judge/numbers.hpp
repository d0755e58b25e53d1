// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "verify/judge/exact.hpp"

namespace detent::verify::judge {

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const RootCase<S, N>& c, const Answer& got) {
  const Integer product = oracle::raw(c.a) * oracle::raw(c.b);
  Integer x = product + static_cast<std::int64_t>(c.beside_square.raw());
  if constexpr (Row == 1) {
    x = product * product + static_cast<std::int64_t>(c.beside_fourth_power.raw());
  }
  return compare(clamped<Answer>(x < 0 ? Integer(0) : Integer(sqrt(x))), got);
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const QuotientCase<S, N>& c, const Answer& got) {
  const Integer a = oracle::raw(c.a), b = oracle::raw(c.b), third = oracle::raw(c.c),
                d = oracle::raw(c.d);
  constexpr bool wide = Row % 2 == 1;
  const Integer over = wide ? Integer(a * b * third) : scaled(a, S::frac);
  const Integer under = wide ? Integer(d * (Row == 1 ? third : a)) : b;
  if (under == 0) {
    return compare(over > 0 ? S::max() : over < 0 ? S::lowest() : S(), got);
  }
  const auto t = oracle::Moment::fraction(over, under);
  return compare(
      clamped<S>(Row < 2 ? oracle::floor_quotient(t.over, t.under) : nearest_quotient(over, under)),
      got);
}

/// The value of a decimal text, times 2^frac and rounded; nothing for malformed text.
std::optional<Integer> meaning(const std::string& text, int frac);

/// The exact decimal of raw / 2^frac.
std::string spelling(std::int64_t raw, int frac);

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const TextCase<S, N>& c, const Answer& got) {
  if constexpr (Row == 0) {
    const auto value = meaning(std::string(c.text.view()), S::frac);
    const bool in_range = value && *value >= static_cast<std::int64_t>(S::lowest().raw()) &&
                          *value <= static_cast<std::int64_t>(S::max().raw());
    return compare(in_range ? Answer(clamped<S>(*value)) : Answer(), got);
  } else {
    const auto expected = spelling(static_cast<std::int64_t>(c.number.raw()), S::frac);
    if (expected == got.view()) return std::nullopt;
    return Wrong{'"' + expected + '"', words(got)};
  }
}

}  // namespace detent::verify::judge
