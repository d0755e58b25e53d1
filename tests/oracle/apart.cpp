// SPDX-License-Identifier: MIT
#include "oracle/apart.hpp"

#include <algorithm>
#include <concepts>

#include "oracle/cores.hpp"
#include "oracle/meet.hpp"
#include "oracle/nearest_parts.hpp"

// The exact squared distance of the shapes' cores, less their radii.
namespace detent::oracle {
namespace {

/// Points that are not corners may remain: each candidate is a distance between points of the
/// hulls. Disjoint hulls are closest at a point of one or at two segments between points.
template <int N>
Moment squared_apart(const Hull<N>& a, const Hull<N>& b) {
  if (hulls_meet(a, b)) return {};
  const Integer under = lcm(a.under, b.under);
  const auto p = points_over(a, under), q = points_over(b, under);
  auto least = nearest_outside<N>(p, q.front()).squared;
  for (const auto& point : q) least = std::min(least, nearest_outside<N>(p, point).squared);
  for (const auto& point : p) least = std::min(least, nearest_outside<N>(q, point).squared);
  for (std::size_t i = 0; N == 3 && i < p.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < q.size(); ++k) {
        for (std::size_t l = 0; l < k; ++l) {
          const auto across = between_inner_points(Edge<N>{p[i], p[j]}, Edge<N>{q[k], q[l]});
          if (across) least = std::min(least, *across);
        }
      }
    }
  }
  return {least.over, least.under * under * under};
}

/// Parallel planes: the distance of one to the foot of the origin on the other.
template <int N>
Moment squared_apart(const Wall<N>& a, const Wall<N>& b) {
  if (meet(a, b)) return {};
  Hull<N> foot{{b.normal}, dot(b.normal, b.normal)};
  for (auto& component : foot.over.front()) component *= b.offset * b.one;
  return squared_apart(a, foot);
}

/// For points and segments an oriented box is its slabs: both in its frame, in steps of 1 / (one
/// under) raw units.
template <int N>
Moment squared_apart(const TurnedBox<N>& box, const Hull<N>& thin) {
  const auto placed = in_frame(box, thin);
  return squared_apart(placed.box, placed.thin);
}

template <int N, class A, class B>
Moment squared_apart_of_cores(const A& a, const B& b) {
  if constexpr (std::same_as<A, Wall<N>> && std::same_as<B, Wall<N>>) {
    return squared_apart(a, b);
  } else if constexpr (std::same_as<A, Wall<N>>) {
    return squared_apart(a, hull_of(b));
  } else if constexpr (std::same_as<A, TurnedBox<N>> && std::same_as<B, Edge<N>>) {
    return squared_apart(a, hull_of(b));
  } else if constexpr (std::same_as<B, Wall<N>> ||
                       (std::same_as<B, TurnedBox<N>> && std::same_as<A, Edge<N>>)) {
    return squared_apart_of_cores<N>(b, a);
  } else {
    return squared_apart(hull_of(a), hull_of(b));
  }
}

template <int N>
std::optional<Integer> distance_of(const Solid<N>& first, const Solid<N>& second) {
  const auto of = [](const auto& a, const auto& b) -> std::optional<Integer> {
    if (!has_points(a) || !has_points(b)) return {};
    const auto squared = squared_apart_of_cores<N>(core(a), core(b));
    const Integer apart = sqrt(floor_quotient(squared.over, squared.under));
    return std::max<Integer>(apart - radius(a) - radius(b), 0);
  };
  return std::visit(of, first, second);
}

}  // namespace

std::optional<Integer> distance_floor(const Solid<2>& a, const Solid<2>& b) {
  return distance_of<2>(a, b);
}
std::optional<Integer> distance_floor(const Solid<3>& a, const Solid<3>& b) {
  return distance_of<3>(a, b);
}

}  // namespace detent::oracle
