// SPDX-License-Identifier: MIT
#include "oracle/travel.hpp"

#include <algorithm>
#include <concepts>

#include "oracle/cores.hpp"
#include "oracle/nearest_parts.hpp"

namespace detent::oracle {
namespace {

/// A vector over / under with its squared length.
template <int N>
struct Apart {
  Vector<N> over;
  Moment squared;
};

/// The vector from a point of `b` to one of `a`: one is a corner and the other in a corner, edge or
/// face, or both are in edges. All of these are candidates, and the least is the distance of the
/// hulls, which must not meet. It is not reduced: over is any positive multiple.
template <int N>
Apart<N> closest(const Hull<N>& a, const Hull<N>& b) {
  const Integer under = lcm(a.under, b.under);
  const auto p = points_over(a, under), q = points_over(b, under);
  std::optional<Apart<N>> least;
  const auto offer = [&](const Moment& squared, const auto& over) {
    if (!least || squared < least->squared) least = Apart<N>{over(), squared};
  };
  const auto offer_points = [&](const auto& points, const auto& corners, bool points_are_a) {
    for (const auto& corner : corners) {
      const auto place = nearest_outside<N>(points, corner);
      offer(place.squared, [&] {
        Vector<N> over;
        for (std::size_t i = 0; i < over.size(); ++i) {
          over[i] = place.over[i] - corner[i] * place.under;
          if (!points_are_a) over[i] = -over[i];
        }
        return over;
      });
    }
  };
  offer_points(p, q, true);
  offer_points(q, p, false);
  for (std::size_t i = 0; N == 3 && i < p.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < q.size(); ++k) {
        for (std::size_t l = 0; l < k; ++l) {
          const auto squared = between_inner_points(Edge<N>{p[i], p[j]}, Edge<N>{q[k], q[l]});
          if (!squared) continue;
          offer(*squared, [&] {
            if constexpr (N == 3) {
              // Perpendicular to both edges, towards p.
              auto over = cross(difference(p[j], p[i]), difference(q[l], q[k]));
              if (dot(over, difference(p[i], q[k])) < 0) over = negated(over);
              return over;
            } else {
              return Vector<N>{};
            }
          });
        }
      }
    }
  }
  least->squared.under *= under * under;
  return *least;
}

/// The hull of a body while it moves by direction * t / (one under), from < t < to.
template <int N>
Hull<N> swept(const Hull<N>& hull, const Vector<N>& direction, const Integer& one,
              const Integer& from, const Integer& to, const Integer& under) {
  Hull<N> result{{}, hull.under * one * under};
  for (const auto& t : {from, to}) {
    for (const auto& point : hull.over) {
      auto moved = point;
      for (std::size_t i = 0; i < moved.size(); ++i) {
        moved[i] = point[i] * one * under + direction[i] * t * hull.under;
      }
      result.over.push_back(moved);
    }
    if (from == to) break;
  }
  return result;
}

template <class Core>
concept Thin = std::same_as<Core, Edge<2>> || std::same_as<Core, Edge<3>>;
template <class Core>
concept Turned = std::same_as<Core, TurnedBox<2>> || std::same_as<Core, TurnedBox<3>>;

/// Returns f(a, b, box) for the swept core and the other one, in the frame of the box if there is
/// one, otherwise with a null pointer.
template <int N, class A, class B, class F>
auto with_hulls(const Travel<N>& travel, const A& a, const B& b, const Integer& from,
                const Integer& to, const Integer& under, const F& f) {
  const TurnedBox<N>* none = nullptr;
  if constexpr (Thin<A> && Turned<B>) {
    const auto placed =
        in_frame(b, swept(hull_of(a), travel.direction, travel.one, from, to, under));
    return f(placed.thin, placed.box, &b);
  } else if constexpr (Turned<A> && Thin<B>) {
    const auto placed =
        in_frame(a, swept(hull_of(b), negated(travel.direction), travel.one, from, to, under));
    return f(placed.box, placed.thin, &a);
  } else {
    return f(swept(hull_of(a), travel.direction, travel.one, from, to, under), hull_of(b), none);
  }
}

template <int N>
std::optional<int> clearance_of(const Travel<N>& travel, const Integer& from, const Integer& to,
                                const Integer& under) {
  const auto of = [&](const auto& shape, const auto& target) -> std::optional<int> {
    const auto a = core(shape);
    const auto b = core(target);
    if constexpr (std::same_as<std::decay_t<decltype(a)>, Wall<N>>) {
      return {};
    } else {
      if (!has_points(shape) || !has_points(target)) return {};
      const Integer reach = radius(shape) + radius(target);
      const auto sign = [&](const Moment& squared) {
        const Moment limit{reach * reach, 1};
        return squared < limit ? -1 : squared == limit ? 0 : 1;
      };
      if constexpr (std::same_as<std::decay_t<decltype(b)>, Wall<N>>) {
        return sign(
            squared_apart(b, swept(hull_of(a), travel.direction, travel.one, from, to, under)));
      } else {
        return with_hulls(travel, a, b, from, to, under,
                          [&](const auto& p, const auto& q, const auto*) {
                            if (hulls_meet(p, q)) return reach == 0 ? 0 : -1;
                            return reach == 0 ? 1 : sign(closest(p, q).squared);
                          });
      }
    }
  };
  return std::visit(of, travel.shape, travel.target);
}

template <int N>
Vector<N> gap_of(const Travel<N>& travel, const Integer& time, const Integer& under) {
  const auto of = [&](const auto& shape, const auto& target) -> Vector<N> {
    const auto a = core(shape);
    const auto b = core(target);
    using A = std::decay_t<decltype(a)>;
    using B = std::decay_t<decltype(b)>;
    if constexpr (std::same_as<A, Wall<N>> || std::same_as<B, Wall<N>>) {
      return {};
    } else {
      return with_hulls(travel, a, b, time, time, under,
                        [&](const auto& p, const auto& q, const auto* box) {
                          const auto over = closest(p, q).over;
                          if (box == nullptr) return over;
                          Vector<N> turned{};
                          for (std::size_t i = 0; i < turned.size(); ++i) {
                            for (std::size_t j = 0; j < turned.size(); ++j) {
                              turned[j] += box->axes[i][j] * over[i];
                            }
                          }
                          return turned;
                        });
    }
  };
  return std::visit(of, travel.shape, travel.target);
}

}  // namespace

std::optional<int> clearance(const Travel<2>& travel, const Integer& from, const Integer& to,
                             const Integer& under) {
  return clearance_of<2>(travel, from, to, under);
}
std::optional<int> clearance(const Travel<3>& travel, const Integer& from, const Integer& to,
                             const Integer& under) {
  return clearance_of<3>(travel, from, to, under);
}

Vector<2> gap(const Travel<2>& travel, const Integer& time, const Integer& under) {
  return gap_of<2>(travel, time, under);
}
Vector<3> gap(const Travel<3>& travel, const Integer& time, const Integer& under) {
  return gap_of<3>(travel, time, under);
}

}  // namespace detent::oracle
