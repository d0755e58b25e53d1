// SPDX-License-Identifier: MIT
#include "oracle/meet.hpp"

#include <concepts>

#include "oracle/corners.hpp"
#include "oracle/half_space.hpp"
#include "oracle/near_edge.hpp"
#include "oracle/nearest.hpp"
#include "oracle/simplex.hpp"

namespace detent::oracle {
namespace {

/// Whether two planes meet: two equations for a point, with each coordinate a difference of two
/// non-negative variables.
template <int N>
bool walls_meet(const Wall<N>& a, const Wall<N>& b) {
  Simplex simplex(2, 2 * static_cast<std::size_t>(N));
  std::size_t row = 0;
  for (const auto& wall : {a, b}) {
    for (std::size_t i = 0; i < wall.normal.size(); ++i) {
      simplex.at(row, 2 * i) = wall.normal[i];
      simplex.at(row, 2 * i + 1) = -wall.normal[i];
    }
    simplex.right(row++) = wall.offset * wall.one;
  }
  return simplex.is_feasible();
}

/// Whether the segment has a point in all slabs of a box. For every axis: the start's coordinate,
/// the change from start to end, and the ends of the slab.
template <int N>
bool meets_slabs(const Vector<N>& start, const Vector<N>& step, const Vector<N>& low,
                 const Vector<N>& high) {
  std::array<HalfSpace, 2 * N> spaces;
  for (std::size_t i = 0; i < start.size(); ++i) {
    spaces[2 * i] = {low[i] - start[i], -step[i]};
    spaces[2 * i + 1] = {start[i] - high[i], step[i]};
  }
  return span(spaces, 1).has_value();
}
template <int N>
bool edge_meets(const Edge<N>& edge, const Box<N>& box) {
  return meets_slabs<N>(edge.start, difference(edge.end, edge.start), box.low, box.high);
}
/// The box as slabs, in units of a raw unit times the step of a direction.
template <int N>
bool edge_meets(const Edge<N>& edge, const TurnedBox<N>& box) {
  const auto from_center = difference(edge.start, box.center);
  const auto along = difference(edge.end, edge.start);
  Vector<N> start, step, low, high;
  for (std::size_t i = 0; i < start.size(); ++i) {
    start[i] = dot(box.axes[i], from_center);
    step[i] = dot(box.axes[i], along);
    high[i] = box.one * box.half[i];
    low[i] = -high[i];
  }
  return meets_slabs<N>(start, step, low, high);
}

/// Round shapes are tested by the distance from a core. Against them or a segment a box is a set of
/// slabs; otherwise it is the hull of its corners.
template <int N, class A, class B>
bool do_meet(const A& a, const B& b) {
  if constexpr (std::same_as<B, Ball<N>>) {
    return b.radius >= 0 && is_within(nearest(a, b.center), b.radius);
  } else if constexpr (std::same_as<A, Ball<N>>) {
    return do_meet<N>(b, a);
  } else if constexpr (std::same_as<A, Pill<N>> && std::same_as<B, Pill<N>>) {
    return a.radius >= 0 && b.radius >= 0 && near_edge(a.core, b.core, a.radius + b.radius);
  } else if constexpr (std::same_as<B, Pill<N>>) {
    return b.radius >= 0 && near_edge(a, b.core, b.radius);
  } else if constexpr (std::same_as<A, Pill<N>>) {
    return do_meet<N>(b, a);
  } else if constexpr (std::same_as<A, Wall<N>> && std::same_as<B, Wall<N>>) {
    return walls_meet(a, b);
  } else if constexpr (std::same_as<A, Wall<N>>) {
    return wall_meets(a, hull_of(b));
  } else if constexpr (std::same_as<B, Wall<N>>) {
    return do_meet<N>(b, a);
  } else if constexpr (std::same_as<A, Edge<N>> && requires { edge_meets(a, b); }) {
    return edge_meets(a, b);
  } else if constexpr (std::same_as<B, Edge<N>> && requires { edge_meets(b, a); }) {
    return do_meet<N>(b, a);
  } else {
    return hulls_meet(hull_of(a), hull_of(b));
  }
}

}  // namespace

bool meet(const Solid<2>& a, const Solid<2>& b) {
  return std::visit([](const auto& x, const auto& y) { return do_meet<2>(x, y); }, a, b);
}
bool meet(const Solid<3>& a, const Solid<3>& b) {
  return std::visit([](const auto& x, const auto& y) { return do_meet<3>(x, y); }, a, b);
}

}  // namespace detent::oracle
