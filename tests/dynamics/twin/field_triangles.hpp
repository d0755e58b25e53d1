// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "detent/scene/height_field.hpp"

namespace detent::test {

/// The triangles of a height field, in the order of their indices.
template <Scalar S>
std::vector<Triangle<S, 3>> triangles_of(const HeightField<S>& field) {
  std::vector<Triangle<S, 3>> triangles(2 * std::size_t{field.columns - 1} * (field.rows - 1));
  visit_within(field, field.bounds, [&](std::span<const MeshTriangle<S>> parts) {
    for (const auto& part : parts) triangles.at(part.index) = part.triangle;
    return Walk::go_on;
  });
  return triangles;
}

}  // namespace detent::test
