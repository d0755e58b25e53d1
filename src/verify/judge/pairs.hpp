// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "oracle/closest_pair.hpp"
#include "oracle/contact_answer.hpp"
#include "verify/judge/exact.hpp"

namespace detent::verify::judge {

template <int Row, Scalar S, int N, class First, class Second>
std::optional<Wrong> judge(const PairCase<S, N, First, Second>& c, bool got) {
  const auto a = in_raw_units<S>(c.a);
  const auto b = in_raw_units<S>(c.b);
  return compare(oracle::meet(as_shape(a), as_shape(b)), got);
}

/// The distance of two shapes.
template <int Row, Scalar S, int N, class First, class Second>
std::optional<Wrong> judge(const PairCase<S, N, First, Second>& c, const S& got) {
  const auto a = in_raw_units<S>(c.a);
  const auto b = in_raw_units<S>(c.b);
  const auto exact = oracle::distance_floor(as_shape(a), as_shape(b));
  return compare(exact ? clamped<S>(*exact) : largest<S>, got);
}

/// An exact point of a shape as text, in raw units.
template <int N>
std::string exact_words(const oracle::Exact<N>& exact) {
  const auto list = [](const oracle::Position<N>& position) {
    std::string text;
    for (const auto& x : position) text += (text.empty() ? "{" : ", ") + x.str();
    return text + "}";
  };
  if (exact.radius.is_zero()) return list(exact.point);
  return list(exact.point) + " and on by " + exact.radius.str() + " along " + list(exact.direction);
}

/// The closest points of two shapes: their exact differences are checked.
template <int Row, Scalar S, int N, class First, class Second>
std::optional<Wrong> judge(const PairCase<S, N, First, Second>& c,
                           const std::array<Vec<S, N>, 2>& got) {
  const auto& a = as_shape(c.a);
  const auto& b = as_shape(c.b);
  if (!detent::detail::has_points(a) || !detent::detail::has_points(b)) {
    return compare(std::array<Vec<S, N>, 2>(), got);
  }
  const auto exact = oracle::closest_pair<S, N>(a, b);
  if (!exact) return Wrong{"a proof", words(got)};
  const bool is_right =
      oracle::is_rounded(exact->first, got[0]) && oracle::is_rounded(exact->second, got[1]);
  if (is_right) return std::nullopt;
  return Wrong{exact_words(exact->first) + ", " + exact_words(exact->second), words(got)};
}

/// Depth and normal of a contact are exact. The judge checks that its separation separates, and
/// that its points are on both surfaces, within the bounds of their docstrings.
template <int Row, Scalar S, int N, class First, class Second>
std::optional<Wrong> judge(const PairCase<S, N, First, Second>& c,
                           const std::optional<Contact<S, N>>& got) {
  const auto& a = as_shape(c.a);
  const auto& b = as_shape(c.b);
  const auto truth = oracle::least_push(oracle::exact(a), oracle::exact(b));
  if (!oracle::is_contact<S, N>(got, truth)) {
    if (!truth) return Wrong{"nothing", words(got)};
    std::string normal;
    for (const auto& x : truth->normal) normal += (normal.empty() ? "" : ", ") + x.str();
    return Wrong{"depth " + truth->depth.str() + " along {" + normal + "}", words(got)};
  }
  if (!got) return std::nullopt;
  if (!oracle::is_separation(a, b, *got)) return Wrong{"a separation", words(got)};
  if (!oracle::has_right_points(a, b, *got)) {
    return Wrong{"points of both surfaces", words(got)};
  }
  return std::nullopt;
}

}  // namespace detent::verify::judge
