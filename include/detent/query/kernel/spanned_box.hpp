// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"

namespace detent::detail {

/// A box on the grid of half steps, which has the center of every box.
template <Scalar S, int N = 3>
struct SpannedBox {
  using Half = Fixed<S::bits + 1, S::frac + 1>;

  explicit constexpr SpannedBox(const Obb<S, N>& box) noexcept
      : center(make_vec<N>([&](int i) { return Half(box.center[i]); })),
        half_extents(make_vec<N>([&](int i) { return Half(box.half_extents[i]); })),
        rotation(box.rotation) {}
  explicit constexpr SpannedBox(const Aabb<S, N>& box) noexcept
      : center(make_vec<N>([&](int i) { return half_of(box.min[i] + box.max[i]); })),
        half_extents(make_vec<N>([&](int i) { return half_of(box.max[i] - box.min[i]); })) {}

  Vec<Half, N> center, half_extents;
  Rotation<S, N> rotation;

 private:
  template <Number T>
  [[nodiscard]] static constexpr Half half_of(const T& x) noexcept {
    return Half::assume_raw(integer_cast<typename Half::raw_type>(x.raw()));
  }
};

}  // namespace detent::detail
