// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/query/cast/hit.hpp"
#include "oracle/closest_pair.hpp"
#include "oracle/travel.hpp"

/// The point of a target closest to a moved shape, in rational numbers.
namespace detent::oracle {

/// The difference of the closest points of two hulls that are apart along `normal`, if that is the
/// direction between them: from b to a.
template <int N>
Position<N> difference_along(Vector<N> normal, const Corners<N>& a, const Corners<N>& b) {
  Integer common = 0;
  for (const auto& x : normal) common = gcd(common, x);
  Position<N> n;
  for (std::size_t i = 0; i < n.size(); ++i) n[i] = normal[i] / common;
  Rational least = dot(n, a.front()), most = dot(n, b.front());
  for (const auto& corner : a) least = std::min(least, dot(n, corner));
  for (const auto& corner : b) most = std::max(most, dot(n, corner));
  return along(Position<N>{}, n, Rational((least - most) / dot(n, n)));
}

/// The point of `target` closest to `shape` moved by `distance`, whose cores were not closer before;
/// nothing if a proof fails.
template <Scalar S, int N, class A, class B>
std::optional<Exact<N>> closest_of_target(const Travel<N>& travel, const A& shape,
                                          const Direction<S, N>& direction, const S& distance,
                                          const B& target) {
  const auto& a = detail::core_of(shape);
  const auto& b = detail::core_of(target);
  using CoreA = std::remove_cvref_t<decltype(a)>;
  using CoreB = std::remove_cvref_t<decltype(b)>;
  const auto moved = [&](Corners<N> corners, const Rational& by) {
    for (auto& corner : corners) corner = along(corner, position(direction), by);
    return corners;
  };
  const Rational way = rational(distance);
  const Rational radius_a = rational(S(detail::radius_of(shape)));
  const Rational radius_b = rational(S(detail::radius_of(target)));
  std::optional<Exact<N>> result;
  if constexpr (detail::is_kind<CoreB, Plane>) {
    const auto n = position(b.normal);
    result = Exact<N>{nearest_corner<N>(n, rational(b.offset), moved(corners_of(a), way)).second};
  } else if constexpr (is_in_frame<CoreB, CoreA>) {
    const auto ends = moved(corners_of(a), way);
    result = closest_in_frame(b, ends.front(), ends.back(), radius_a, true, false).first;
  } else if constexpr (is_in_frame<CoreA, CoreB>) {
    const auto ends = moved(corners_of(b), -way);
    result = closest_in_frame(a, ends.front(), ends.back(), radius_b, true, false).second;
    result->point = along(result->point, position(direction), way);
  } else {
    const auto of_a = moved(corners_of(a), way), of_b = corners_of(b);
    const Integer k = raw(distance);
    Position<N> v{};
    if (radius_a + radius_b > 0 || *clearance(travel, k, k, 1) > 0) {
      v = difference_along<N>(negated(gap(travel, k, 1)), of_b, of_a);
    }
    const auto pair = closest_polytopes<N>(of_b, of_a, v, radius_b, radius_a);
    if (!pair) return std::nullopt;
    result = pair->first;
  }
  result->is_rounded_once = radius_b == 0;
  return result;
}

}  // namespace detent::oracle
