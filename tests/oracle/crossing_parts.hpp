// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "oracle/crossing.hpp"
#include "oracle/half_space.hpp"

// The crossings of each shape, in a file for each kind.
namespace detent::oracle {

template <int N>
using MaybeCrossing = std::optional<Crossing<N>>;

template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Ball<N>& ball);
template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Pill<N>& pill);
template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Box<N>& box);
template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const TurnedBox<N>& box);
template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Wall<N>& wall);
template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Edge<N>& edge);
MaybeCrossing<2> crossing_of(const Line<2>& line, const Face<2>& face);
MaybeCrossing<3> crossing_of(const Line<3>& line, const Face<3>& face);
template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Cloud<N>& cloud);

template <int N>
NormalPointer<N> stored(const Vector<N>& direction) {
  return std::make_shared<StoredNormal<N>>(direction);
}
template <int N>
NormalPointer<N> normalized(const Vector<N>& along, const Line<N>& line) {
  return std::make_shared<NormalizedNormal<N>>(along, line.one);
}
/// The normal when a ray starts inside a solid, or hits a shape without an inside.
template <int N>
NormalPointer<N> against(const Line<N>& line) {
  return stored<N>(negated(line.direction));
}

template <int N>
MaybeCrossing<N> crossing_at(const Span& inside, NormalPointer<N> normal) {
  return Crossing<N>{floor(inside.enter), floor(inside.exit), std::move(normal)};
}

/// The times at which `line` is on the segment, which may be a point. If the line runs along the
/// segment, these are between its ends; otherwise the crossing must be between them.
template <int N>
std::optional<Span> on_edge(const Line<N>& line, const Edge<N>& edge);

}  // namespace detent::oracle
