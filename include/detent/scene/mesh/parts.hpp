// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "detent/cull/static_tree/along.hpp"
#include "detent/query/distance/aabb.hpp"
#include "detent/query/overlaps/aabb_aabb.hpp"
#include "detent/scene/mesh/may_cross.hpp"
#include "detent/scene/mesh/surface.hpp"

// A surface as a tree of parts, each with a box; a leaf is a few triangles. It has
//   whole_of(surface)                       -> the root part, in bounding_box(surface)
//   visit_children(surface, part, visit)    calls visit(child, box) for the children of a part
//   at_leaf(surface, part, visit)           returns visit(triangles) for a part that is_leaf()
// and Part::most_children, and Part::room, the most parts pending in a traversal. They are never
// called for an empty surface.
//
// The traversals here use these, for surfaces that have no faster ones.

namespace detent::detail {

/// A surface as the target of a walk. key_of(box) returns how near a box is, or nothing if it is
/// irrelevant; still(key) returns whether the box is still relevant when its turn comes.
template <class KeyType, class Surface, class KeyOf, class Still>
struct SurfaceParts {
  using Key = KeyType;
  using Part = decltype(whole_of(std::declval<const Surface&>()));
  static constexpr std::size_t most_children = Part::most_children, room = Part::room;
  struct Node {
    std::array<Part, most_children> children;
    std::array<Key, most_children> keys;
    std::uint32_t met;
  };

  const Surface& surface;
  const KeyOf& key_of;
  const Still& still;

  [[nodiscard]] constexpr Node node(const Part& part) const noexcept {
    Node result{};
    std::size_t count = 0;
    visit_children(surface, part, [&](const Part& child, const auto& box) {
      if (const auto key = key_of(box)) {
        result.children[count] = child;
        result.keys[count++] = *key;
      }
      return Walk::go_on;
    });
    result.met = (std::uint32_t{1} << count) - 1;
    return result;
  }
  [[nodiscard]] constexpr std::uint32_t meets(const Node& node,
                                              std::array<Key, most_children>& keys) const noexcept {
    keys = node.keys;
    return node.met;
  }
  [[nodiscard]] constexpr Part child(const Node& node, std::size_t k) const noexcept {
    return node.children[k];
  }
  [[nodiscard]] constexpr bool reaches(const Key& key) const noexcept { return still(key); }
};

/// Visits triangles of a surface, the nearest parts first: calls visit(triangles).
template <class Key, class Surface, class KeyOf, class Still, class Visit>
constexpr Walk visit_parts(const Surface& surface, const KeyOf& key_of, const Still& still,
                           const Visit& visit) noexcept {
  const auto bounds = bounding_box(surface);
  if (is_empty(bounds) || !key_of(bounds)) return Walk::go_on;
  const SurfaceParts<Key, Surface, KeyOf, Still> parts{surface, key_of, still};
  return visit_nearest_first(whole_of(surface), parts,
                             [&](const auto& leaf) { return at_leaf(surface, leaf, visit); });
}

/// Visits the triangles of the parts whose boxes satisfy matters(box).
template <class Surface, class Matters, class Visit>
constexpr Walk visit_parts_where(const Surface& surface, const Matters& matters,
                                 const Visit& visit) noexcept {
  return visit_parts<Unordered>(
      surface,
      [&](const auto& box) { return matters(box) ? std::optional(Unordered()) : std::nullopt; },
      [](const Unordered&) { return true; }, visit);
}

template <template <class> class Surface, Scalar S, class Visit>
constexpr Walk visit_parts_along(const Surface<S>& surface, const Ray<S, 3>& ray,
                                 const Visit& visit) noexcept {
  const auto bounds = bounding_box(surface);
  if (ray.max_distance < 0 || is_empty(bounds)) return Walk::go_on;
  using Time = typename Ticks<S>::Time;
  const StaticRay<S, 3> prepared(ray, bounds);
  S limit = ray.max_distance;
  auto last = prepared.time(limit);
  return visit_parts<Time>(
      surface, [&](const Aabb<S, 3>& box) { return prepared.meets(box, last); },
      [&](const Time& enter) { return enter <= last; },
      [&](std::span<const MeshTriangle<S>> triangles) {
        const Walk walk = visit(triangles, limit);
        last = prepared.time(limit);
        return walk;
      });
}

template <template <class> class Surface, Scalar S, class Visit>
constexpr Walk visit_parts_within(const Surface<S>& surface, const Aabb<S, 3>& box,
                                  const Visit& visit) noexcept {
  return visit_parts_where(
      surface, [&](const Aabb<S, 3>& part) { return overlaps(part, box); }, visit);
}

template <template <class> class Surface, Scalar S, class Visit>
constexpr Walk visit_parts_crossing(const Surface<S>& surface, const Segment<S, 3>& segment,
                                    const Visit& visit) noexcept {
  return visit_parts_where(
      surface, [&](const Aabb<S, 3>& part) { return may_cross(segment, part); }, visit);
}

template <template <class> class Surface, Scalar S, class Visit>
constexpr Walk visit_parts_around(const Surface<S>& surface, const Vec<S, 3>& point,
                                  const Visit& visit) noexcept {
  S limit = largest<S>;
  return visit_parts<S>(
      surface,
      [&](const Aabb<S, 3>& part) {
        const S to_part = distance(part, point);
        return to_part <= limit ? std::optional(to_part) : std::nullopt;
      },
      [&](const S& to_part) { return to_part <= limit; },
      [&](std::span<const MeshTriangle<S>> triangles) { return visit(triangles, limit); });
}

}  // namespace detent::detail
