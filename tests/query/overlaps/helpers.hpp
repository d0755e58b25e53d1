// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects.hpp"
#include "detent/query/overlaps.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {

/// Whether two shapes overlap; checks that swapping them or permuting the axes changes nothing.
template <class A, class B>
bool meet(const A& a, const B& b) {
  const auto turn = [](const auto& v) { return turned(v); };
  const bool answer = overlaps(a, b);
  CHECK(overlaps(b, a) == answer);
  CHECK(overlaps(changed(a, turn), changed(b, turn)) == answer);
  return answer;
}
/// `overlaps` for a segment and a shape.
template <Scalar S, int N, class Shape>
bool meet(const Segment<S, N>& segment, const Shape& shape) {
  const auto turn = [](const auto& v) { return turned(v); };
  const bool answer = intersects(segment, shape);
  CHECK(intersects(Segment{segment.end, segment.start}, shape) == answer);
  CHECK(intersects(changed(segment, turn), changed(shape, turn)) == answer);
  return answer;
}

/// Axis 0 is exactly along (3, 4), and slightly too long; the others are the default.
template <Scalar S, int N>
Rotation<S, N> three_four_fifths_frame() {
  return frame(three_four_fifths<S, N>(), Direction<S, N>::along(1));
}

}  // namespace detent::test
