// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "oracle/integer.hpp"

// Every shape in integers: lengths in raw units, directions in steps of 1 / `one`.
namespace detent::oracle {

/// The points origin + t * direction / one, 0 <= t <= max.
template <int N>
struct Line {
  Vector<N> origin, direction;
  Integer one, max;
};

template <int N>
struct Ball {
  Vector<N> center;
  Integer radius;
};
template <int N>
struct Box {
  Vector<N> low, high;
};
template <int N>
struct TurnedBox {
  Vector<N> center, half;
  std::array<Vector<N>, N> axes;
  Integer one;
};
/// The points x with dot(normal, x) = offset * one.
template <int N>
struct Wall {
  Vector<N> normal;
  Integer offset, one;
};
template <int N>
struct Edge {
  Vector<N> start, end;
};
template <int N>
struct Face {
  std::array<Vector<N>, 3> corners;
};
template <int N>
struct Pill {
  Edge<N> core;
  Integer radius;
};
/// The convex hull of the points.
template <int N>
struct Cloud {
  std::vector<Vector<N>> points;
};

template <int N>
using Solid =
    std::variant<Ball<N>, Box<N>, TurnedBox<N>, Wall<N>, Edge<N>, Face<N>, Pill<N>, Cloud<N>>;

}  // namespace detent::oracle
