// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "detent/cull/static_tree/along.hpp"
#include "detent/query/distance/aabb.hpp"
#include "detent/query/overlaps/aabb_aabb.hpp"
#include "detent/scene/mesh/may_cross.hpp"
#include "detent/scene/mesh/surface.hpp"

// A surface as a tree of parts, each with a box; a leaf is a few triangles. It has
//   whole_of(surface)                -> the root part, in bounding_box(surface)
//   any_child(surface, part, test)   -> whether test(child, box) is true for any child of a part
//   at_leaf(surface, part, visit)    -> visit(triangles) for a part that is_leaf()
// and Part::room, the most parts that wait in a traversal. They are never called for an empty
// surface.
//
// The traversals here use these, for surfaces that have no faster ones.

namespace detent {

namespace detail {

/// Visits triangles of a surface, roughly nearest first. key_of(box) returns how near a box is, as
/// a Key, or nothing if it does not matter; matters(key) returns whether it still does when its
/// turn comes; visit(triangles) returns whether to go on.
template <class Key, class Surface, class KeyOf, class Matters, class Visit>
constexpr void visit_parts(const Surface& surface, const KeyOf& key_of, const Matters& matters,
                           const Visit& visit) noexcept {
  using Part = decltype(whole_of(surface));
  struct Entry {
    Key key;
    Part part;
  };
  const auto bounds = bounding_box(surface);
  if (is_empty(bounds)) return;
  std::array<Entry, Part::room> stack;
  std::size_t used = 0;
  if (const auto key = key_of(bounds)) stack[used++] = {*key, whole_of(surface)};
  while (used != 0) {
    const auto [key, part] = stack[--used];
    if (!matters(key)) continue;
    if (part.is_leaf()) {
      if (!at_leaf(surface, part, visit)) return;
      continue;
    }
    const auto base = used;
    any_child(surface, part, [&](const Part& child, const auto& box) {
      const auto child_key = key_of(box);
      if (!child_key) return false;
      auto place = used++;
      for (; place > base && stack[place - 1].key < *child_key; --place) {
        stack[place] = stack[place - 1];
      }
      stack[place] = {*child_key, child};
      return false;
    });
  }
}

/// Visits the triangles of the parts whose boxes satisfy matters(box), until visit(triangles)
/// returns true. Returns whether it did.
template <class Surface, class Matters, class Visit>
constexpr bool visit_parts_where(const Surface& surface, const Matters& matters,
                                 const Visit& visit) noexcept {
  bool found = false;
  visit_parts<bool>(
      surface, [&](const auto& box) { return matters(box) ? std::optional(false) : std::nullopt; },
      [](bool) { return true; },
      [&](auto triangles) {
        found = visit(triangles);
        return !found;
      });
  return found;
}

}  // namespace detail

template <template <class> class Surface, Scalar S, class Visit>
requires is_surface<Surface>
constexpr void visit_along(const Surface<S>& surface, const Ray<S, 3>& ray,
                           const Visit& visit) noexcept {
  const auto bounds = bounding_box(surface);
  if (ray.max_distance < 0 || is_empty(bounds)) return;
  using Time = typename SlabTimes<S>::Time;
  const detail::StaticRay<S, 3> prepared(ray, bounds);
  auto limit = prepared.time(ray.max_distance);
  detail::visit_parts<Time>(
      surface, [&](const Aabb<S, 3>& box) { return prepared.meets(box, limit); },
      [&](const Time& enter) { return enter <= limit; },
      [&](std::span<const MeshTriangle<S>> triangles) {
        const S left = visit(triangles);
        limit = prepared.time(left);
        return left >= 0;
      });
}

template <template <class> class Surface, Scalar S, class Visit>
requires is_surface<Surface>
constexpr bool visit_within(const Surface<S>& surface, const Aabb<S, 3>& box,
                            const Visit& visit) noexcept {
  return detail::visit_parts_where(
      surface, [&](const Aabb<S, 3>& part) { return overlaps(part, box); }, visit);
}

template <template <class> class Surface, Scalar S, class Visit>
requires is_surface<Surface>
constexpr bool visit_crossing(const Surface<S>& surface, const Segment<S, 3>& segment,
                              const Visit& visit) noexcept {
  return detail::visit_parts_where(
      surface, [&](const Aabb<S, 3>& part) { return detail::may_cross(segment, part); }, visit);
}

template <template <class> class Surface, Scalar S, class Visit>
requires is_surface<Surface>
constexpr void visit_around(const Surface<S>& surface, const Vec<S, 3>& point,
                            const Visit& visit) noexcept {
  S limit = largest<S>;
  detail::visit_parts<S>(
      surface,
      [&](const Aabb<S, 3>& part) {
        const S to_part = distance(part, point);
        return to_part <= limit ? std::optional(to_part) : std::nullopt;
      },
      [&](const S& to_part) { return to_part <= limit; },
      [&](std::span<const MeshTriangle<S>> triangles) {
        limit = visit(triangles);
        return true;
      });
}

}  // namespace detent
