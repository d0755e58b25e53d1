// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "oracle/solid.hpp"

namespace detent::oracle {

/// The least translation that separates two shapes: by `depth` raw units, rounded up, along
/// `normal`, a vector of any length from a to b.
template <int N>
struct Push {
  Vector<N> normal;
  Integer depth;
};

/// Nothing if the shapes share no point. Not for two planes.
[[nodiscard]] std::optional<Push<2>> least_push(const Solid<2>& a, const Solid<2>& b);
[[nodiscard]] std::optional<Push<3>> least_push(const Solid<3>& a, const Solid<3>& b);

/// Component i of the unit vector along `v`, rounded to nearest, in steps of 1 / one.
template <int N>
[[nodiscard]] Integer unit_component(const Vector<N>& v, std::size_t i, const Integer& one) {
  const Integer twice = 2 * v[i] * one;
  const Integer rounded = (sqrt(Integer(twice * twice / dot(v, v))) + 1) / 2;  // no ties
  return v[i] < 0 ? Integer(-rounded) : rounded;
}

}  // namespace detent::oracle
