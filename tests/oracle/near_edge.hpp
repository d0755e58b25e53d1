// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/solid.hpp"

/// Whether a shape is within a distance of a segment. Each shape has finitely many candidates that
/// include the closest point, and each candidate is tested by the definition of distance. No
/// regions and no reasoning about the location of the closest point are needed.
namespace detent::oracle {

template <int N>
bool near_edge(const Edge<N>& a, const Edge<N>& b, const Integer& reach);
template <int N>
bool near_edge(const Face<N>& face, const Edge<N>& edge, const Integer& reach);
template <int N>
bool near_edge(const Wall<N>& wall, const Edge<N>& edge, const Integer& reach);
template <int N>
bool near_edge(const Box<N>& box, const Edge<N>& edge, const Integer& reach);
template <int N>
bool near_edge(const TurnedBox<N>& box, const Edge<N>& edge, const Integer& reach);
template <int N>
bool near_edge(const Cloud<N>& cloud, const Edge<N>& edge, const Integer& reach);

}  // namespace detent::oracle
