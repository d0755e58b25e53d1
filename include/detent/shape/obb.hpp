// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "detent/math/rotation.hpp"
#include "detent/shape/fields.hpp"

namespace detent {

/// A box rotated by `rotation` about its center; an oriented rectangle in 2D.
///
/// `rotation.axis(i)` is the box's local axis i in the world. Raycasts treat the box as slabs, {x :
/// |dot(axis(i), x - center)| <= half_extents[i] for all i}, with the axes exactly as stored. A
/// half extent of 0 makes it flat; a negative one makes it empty.
template <Scalar S, int N>
struct Obb {
  Vec<S, N> center;
  Vec<S, N> half_extents;
  Rotation<S, N> rotation;

  [[nodiscard]] friend constexpr bool operator==(const Obb&, const Obb&) noexcept = default;
};

template <Scalar S, int N>
struct detail::ShapeFields<Obb<S, N>> {
  static constexpr std::string_view name = "obb", names[] = {"center", "half_extents", "rotation"};

  template <class Self, class F>
  static constexpr auto of(Self& box, const F& f) {
    return f(box.center, box.half_extents, box.rotation);
  }
};

template <Scalar S, int N>
Obb(Vec<S, N>, Vec<S, N>, Rotation<S, N>) -> Obb<S, N>;

/// Whether the box holds no point: some half extent is negative.
template <Scalar S, int N>
[[nodiscard]] constexpr bool is_empty(const Obb<S, N>& box) noexcept {
  for (int i = 0; i < N; ++i) {
    if (box.half_extents[i] < 0) return true;
  }
  return false;
}

}  // namespace detent
