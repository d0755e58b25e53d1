// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "oracle/solid.hpp"

namespace detent::oracle {

/// A shape that moves by direction / one in a raw unit of time, and a fixed target.
template <int N>
struct Travel {
  Solid<N> shape, target;
  Vector<N> direction;
  Integer one;
};

/// The sign of the least distance of the shape's core from the target's, at any time from `from` to
/// `to` in steps of 1 / under, minus both radii. Nothing if a shape is empty.
[[nodiscard]] std::optional<int> clearance(const Travel<2>& travel, const Integer& from,
                                           const Integer& to, const Integer& under);
[[nodiscard]] std::optional<int> clearance(const Travel<3>& travel, const Integer& from,
                                           const Integer& to, const Integer& under);

/// A vector of any length from the target's core to the shape's, between their closest points at a
/// time at which they are apart. If a box is represented by slabs, the vector is rotated back from
/// its frame.
[[nodiscard]] Vector<2> gap(const Travel<2>& travel, const Integer& time, const Integer& under);
[[nodiscard]] Vector<3> gap(const Travel<3>& travel, const Integer& time, const Integer& under);

}  // namespace detent::oracle
