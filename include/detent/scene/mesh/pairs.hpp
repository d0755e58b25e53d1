// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>

#include "detent/query/overlaps/triangle_triangle.hpp"
#include "detent/scene/mesh/parts.hpp"

namespace detent {

namespace detail {

template <Scalar S>
[[nodiscard]] constexpr bool any_meet(std::span<const MeshTriangle<S>> ours,
                                      std::span<const MeshTriangle<S>> theirs) noexcept {
  for (const auto& one : ours) {
    const auto box = bounding_box(one);
    for (const auto& other : theirs) {
      if (overlaps(box, bounding_box(other)) && overlaps(one.triangle, other.triangle)) return true;
    }
  }
  return false;
}

template <Scalar S>
[[nodiscard]] constexpr auto longest_side(const Aabb<S, 3>& box) noexcept {
  return (std::max)({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
}

/// Whether a triangle of one part touches one of another. Descends into the part with the longer
/// box, so the recursion is no deeper than both trees together.
template <class A, class PartA, class B, class PartB, class Box>
[[nodiscard]] constexpr bool parts_meet(const A& a, const PartA& of_a, const Box& box_a, const B& b,
                                        const PartB& of_b, const Box& box_b) noexcept {
  if (!overlaps(box_a, box_b)) return false;
  if (of_a.is_leaf() && of_b.is_leaf()) {
    return at_leaf(a, of_a, [&](const auto& ours) {
             return at_leaf(b, of_b,
                            [&](const auto& theirs) { return stop_if(any_meet(ours, theirs)); });
           }) == Walk::stop;
  }
  if (of_b.is_leaf() || (!of_a.is_leaf() && longest_side(box_a) > longest_side(box_b))) {
    return visit_children(a, of_a, [&](const PartA& child, const Box& box) {
             return stop_if(parts_meet(a, child, box, b, of_b, box_b));
           }) == Walk::stop;
  }
  return visit_children(b, of_b, [&](const PartB& child, const Box& box) {
           return stop_if(parts_meet(a, of_a, box_a, b, child, box));
         }) == Walk::stop;
}

}  // namespace detail

/// Whether a triangle of one surface touches one of another: meshes and height fields.
///
/// domain: every input; a surface touches itself, unless it has no triangles
/// exact:  yes or no exact                               (tests/scene/mesh_pairs.test.cpp)
template <template <class> class A, template <class> class B, Scalar S>
requires(is_surface<A>&& is_surface<B>)
    [[nodiscard]] constexpr bool overlaps(const A<S>& a, const B<S>& b) noexcept {
  const auto box_a = bounding_box(a), box_b = bounding_box(b);
  if (is_empty(box_a) || is_empty(box_b)) return false;
  return detail::parts_meet(a, whole_of(a), box_a, b, whole_of(b), box_b);
}

}  // namespace detent
