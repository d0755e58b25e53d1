// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <optional>
#include <string>
#include <variant>

#include "detent/query/cast.hpp"
#include "oracle/cast_point.hpp"
#include "oracle/cores.hpp"
#include "oracle/exact.hpp"
#include "oracle/push.hpp"
#include "oracle/travel.hpp"

/// Describes a wrong result of a cast; empty if it is right.
namespace detent::oracle {

template <class A, Scalar S, int N, class B>
Travel<N> travel_of(const A& shape, const Direction<S, N>& direction, const B& target) {
  return {exact(shape), exact(target), widen(raw(direction)), one_of<S>()};
}

/// The oracle decides whether a body that moved between two times touched another one. So it needs
/// no search: a distance k is right if the bodies are apart until just before k, but not until just
/// before k + 1.
template <Scalar S, int N>
std::string fault_of_distance(const Travel<N>& travel, const std::optional<CastHit<S, N>>& found,
                              const S& limit) {
  const Integer parts = Integer(1) << 60;
  const auto before = [&](const Integer& k) { return *clearance(travel, 0, k * parts - 1, parts); };
  if (limit < 0 || !clearance(travel, 0, 0, 1)) return found ? "a hit of nothing" : "";
  const bool is_hit = *clearance(travel, 0, raw(limit), 1) <= 0;
  if (is_hit != found.has_value()) return is_hit ? "missed" : "no hit";
  if (!found) return "";
  const Integer k = raw(found->distance);
  if (k > raw(limit)) return "too far";
  if (k > 0 && before(k) <= 0) return "too late";
  if (k < raw(limit) && before(k + 1) > 0) return "too early";
  return "";
}

/// For a hit after the start: the point is the exact one, rounded; any number of a coordinate that is
/// clamped.
template <class A, class B, Scalar S, int N>
std::string fault_of_point(const Travel<N>& travel, const A& a, const Direction<S, N>& direction,
                           const B& b, const CastHit<S, N>& found) {
  const auto exact = closest_of_target(travel, a, direction, found.distance, b);
  if (!exact) return "no proof of the closest point";
  return is_rounded(*exact, found.point) ? "" : "not the closest point";
}

/// For polytopes: between the distance and one unit more, the plane perpendicular to the normal
/// through the target's outermost corners touches the shape, up to the rounding of the normal.
template <int N>
bool is_supporting(const Travel<N>& travel, const Vector<N>& inward, const Integer& k) {
  const auto of = [&](const auto& shape, const auto& target) {
    using A = std::decay_t<decltype(core(shape))>;
    using B = std::decay_t<decltype(core(target))>;
    if constexpr (std::same_as<A, Wall<N>> || std::same_as<B, Wall<N>> ||
                  (std::same_as<A, TurnedBox<N>> && std::same_as<B, Edge<N>>) ||
                  (std::same_as<B, TurnedBox<N>> && std::same_as<A, Edge<N>>)) {
      return true;  // not polytopes, or in the frame of the box
    } else {
      const auto a = hull_of(core(shape)), b = hull_of(core(target));
      const Integer under = lcm(a.under, b.under);
      const auto p = points_over(a, under), q = points_over(b, under);
      std::optional<Integer> lowest;
      Integer slack = 0;
      for (const auto& from : p) {
        for (const auto& to : q) {
          const auto apart = difference(to, from);
          const Integer height = dot(inward, apart);
          if (!lowest || height < *lowest) lowest = height;
          for (const auto& c : apart) slack = std::max<Integer>(slack, 2 * N * abs(c));
        }
      }
      const Integer speed = dot(inward, travel.direction);
      return *lowest * travel.one >= k * speed * under - slack * travel.one &&
             *lowest * travel.one <= (k + 1) * speed * under + slack * travel.one;
    }
  };
  return std::visit(of, travel.shape, travel.target);
}

/// For a hit after the start: the normal is that of the plane, within 1 ULP that of the closest
/// points at the touch, or that of a supporting plane of polytopes.
template <class A, class B, Scalar S, int N>
std::string fault_of_normal(const Travel<N>& travel, const A& a, const B& b,
                            const CastHit<S, N>& found) {
  const auto given = widen(raw(found.normal));
  if constexpr (std::is_same_v<B, Plane<S, N>>) {
    const bool is_normal = found.normal == b.normal || found.normal == -b.normal;
    return is_normal && dot(given, travel.direction) < 0 ? "" : "not the plane's normal";
  } else {
    const Integer k = raw(found.distance);
    if (raw(detail::radius_of(a)) + raw(detail::radius_of(b)) == 0) {
      if (given == negated(travel.direction)) return "";  // slides along a flat difference
      return is_supporting(travel, negated(given), k) ? "" : "the normal is not that of a face";
    }
    // The last time on a fine grid at which they are apart.
    const Integer parts = Integer(1) << 50;
    Integer apart = k * parts;
    if (*clearance(travel, apart, apart, parts) <= 0) return "";  // touches there exactly
    for (Integer half = parts / 2; half > 0; half /= 2) {
      const Integer middle = apart + half;
      if (*clearance(travel, apart, middle, parts) > 0) apart = middle;
    }
    const auto toward_shape = gap(travel, apart, parts);
    for (std::size_t i = 0; i < given.size(); ++i) {
      const Integer fine = unit_component<N>(toward_shape, i, one_of<S>() * 1024);
      const Integer off = abs(fine - given[i] * 1024);
      if (off > 1024) return "the normal is off by 2^-10 * " + off.str();
    }
    return "";
  }
}

template <class A, class B, Scalar S, int N>
std::string fault_of(const Travel<N>& travel, const A& a, const Direction<S, N>& direction,
                     const B& b, const std::optional<CastHit<S, N>>& found, const S& limit) {
  auto fault = fault_of_distance(travel, found, limit);
  if (!fault.empty() || !found || *clearance(travel, 0, 0, 1) <= 0) return fault;
  fault = fault_of_normal(travel, a, b, *found);
  return fault.empty() ? fault_of_point(travel, a, direction, b, *found) : fault;
}

}  // namespace detent::oracle
