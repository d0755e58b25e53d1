// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "detent/shape/shape.hpp"
#include "oracle/half_spaces.hpp"

namespace detent::oracle {

/// Whether the segment has a point in all slabs of a box. For every axis: the start's coordinate,
/// the change from start to end, and the ends of the slab.
template <int N>
bool meets_slabs(const Vector<N>& start, const Vector<N>& step, const Vector<N>& low,
                 const Vector<N>& high) {
  std::array<HalfSpace, 2 * static_cast<std::size_t>(N)> spaces;
  for (std::size_t i = 0; i < start.size(); ++i) {
    spaces[2 * i] = {low[i] - start[i], -step[i]};
    spaces[2 * i + 1] = {start[i] - high[i], step[i]};
  }
  return span(spaces, 1).has_value();
}

template <Scalar S, int N>
bool meets(const Segment<S, N>& segment, const Aabb<S, N>& box) {
  const auto start = raw(segment.start);
  return meets_slabs<N>(start, difference(raw(segment.end), start), raw(box.min), raw(box.max));
}

/// The box as slabs, in units of a raw unit times the step of a direction.
template <Scalar S, int N>
bool meets(const Segment<S, N>& segment, const Obb<S, N>& box) {
  const auto from_center = difference(raw(segment.start), raw(box.center));
  const auto edge = difference(raw(segment.end), raw(segment.start));
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  Vector<N> start, step, low, high;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const auto axis = widen(raw(box.rotation.axis(static_cast<int>(i))));
    start[i] = dot(axis, from_center);
    step[i] = dot(axis, edge);
    high[i] = one * raw(box.half_extents)[i];
    low[i] = -high[i];
  }
  return meets_slabs<N>(start, step, low, high);
}

}  // namespace detent::oracle
