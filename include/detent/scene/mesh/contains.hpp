// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/contains/triangle.hpp"
#include "detent/scene/mesh/surface.hpp"

namespace detent {

/// Whether `point` is on any triangle of `surface`, which has no inside.
///
/// exact:  yes or no exact                               (tests/scene/mesh_pairs.test.cpp)
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr bool contains(const Surface<S>& surface, const Vec<S, 3>& point) noexcept {
  return detail::any_triangle_within(surface, Aabb<S, 3>{point, point},
                                     [&](const auto& part) { return contains(part, point); });
}

}  // namespace detent
