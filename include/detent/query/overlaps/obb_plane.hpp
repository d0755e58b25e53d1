// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/number/filter/filtered.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/plane.hpp"

namespace detent {

/// Whether `box`, which is solid, has a point in `plane`, with the normal exactly as stored.
///
/// The box is the one that its edges span: center + sum of s[i] half_extents[i] axis(i) with
/// |s[i]| <= 1.
///
/// domain: every input; a box with a negative half extent is empty and overlaps nothing
/// exact:  yes or no exact                                       (tests/oracle/obb_plane.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.2.3
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Obb<S, N>& box, const Plane<S, N>& plane) noexcept {
  if (is_empty(box)) return false;
  // Below (sqrt(3) + 1) 2^b for coordinates below 2^b.
  constexpr int bits = detail::along_bits<S, S> + 1;
  const auto height = narrow_difference<bits>(dot(plane.normal, box.center), plane.offset);
  const auto along =
      make_vec<N>([&](int i) { return abs(dot(plane.normal, box.rotation.axis(i))); });
  const auto exact = [&] { return narrow_abs(height) <= dot(box.half_extents, along); };
  if constexpr (filter_pays<S>) {
    // Cosines truncated to the bits of an axis are too small by less than one unit.
    using Cosine = direction_component<S>;
    const auto cosines = make_vec<N>([&](int i) { return narrow_floor<Cosine>(along[i]); });
    const auto unit = make_vec<N>([](int) { return Cosine::from_raw(1); });
    const auto reach = narrow_dot<bits>(box.half_extents, cosines);
    // std::max, because GCC 12 turns the comparison of a magnitude into a branch.
    const auto slack = narrow_difference<bits>(reach, (std::max)(height, narrow_negative(height)));
    return or_exact(decide(Approximate{slack, narrow_dot<bits>(box.half_extents, unit)}), exact);
  } else {
    return exact();
  }
}

template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Plane<S, N>& plane, const Obb<S, N>& box) noexcept {
  return overlaps(box, plane);
}

}  // namespace detent
