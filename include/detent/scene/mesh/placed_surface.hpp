// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "detent/scene/mesh/parts.hpp"
#include "detent/scene/put.hpp"

namespace detent {

namespace detail {

/// The surface of an asset, and how it is placed in the world. Specialised for `PlacedMesh` and
/// `PlacedField`, which become surfaces through it:
///   of(placed)             the surface of the asset, which must not be null
///   translation(placed)
///   only_moves(placed)     whether it only translates
///   put(placed, shape)     a triangle or box of the asset, in the world
template <class Placed>
struct AssetSurface;

}  // namespace detail

template <template <class> class Surface>
inline constexpr bool is_placed_surface = false;

namespace detail {

/// Wraps visit(triangles, ...): it gets the placed triangles when called with those of the asset.
template <template <class> class Placed, Scalar S, class Visit>
[[nodiscard]] constexpr auto in_place(const Placed<S>& placed, const Visit& visit) noexcept {
  return [&](std::span<const MeshTriangle<S>> triangles, auto&... limit) {
    std::array<MeshTriangle<S>, StaticTree<S, 3>::leaf_size> there;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      there[i] = {AssetSurface<Placed<S>>::put(placed, triangles[i].triangle), triangles[i].index};
    }
    return visit(std::span<const MeshTriangle<S>>(there).first(triangles.size()), limit...);
  };
}

/// Whether every triangle is translated exactly. A query that can be translated back exactly then
/// runs on the asset's surface, whose traversals are faster.
template <template <class> class Placed, Scalar S>
[[nodiscard]] constexpr bool moves_exactly(const Placed<S>& placed) noexcept {
  if (!is_fixed<S> || placed.asset == nullptr || !AssetSurface<Placed<S>>::only_moves(placed)) {
    return false;
  }
  const auto bounds = bounding_box(AssetSurface<Placed<S>>::of(placed));
  return is_in_range<S>(bounds.min + AssetSurface<Placed<S>>::translation(placed)) &&
         is_in_range<S>(bounds.max + AssetSurface<Placed<S>>::translation(placed));
}

}  // namespace detail

/// A box around all triangles, empty for none. It is the smallest if the placement only translates.
template <template <class> class Placed, Scalar S>
requires is_placed_surface<Placed>
[[nodiscard]] constexpr Aabb<S, 3> bounding_box(const Placed<S>& placed) noexcept {
  if (placed.asset == nullptr) return detail::no_box<Aabb<S, 3>>;
  const auto bounds = bounding_box(detail::AssetSurface<Placed<S>>::of(placed));
  return is_empty(bounds) ? bounds : detail::AssetSurface<Placed<S>>::put(placed, bounds);
}

/// The parts of a placed surface: see parts.hpp. Rounding keeps order, so rounded corners of
/// triangles lie within the rounded box of the exact ones.
template <template <class> class Placed, Scalar S>
requires is_placed_surface<Placed>
[[nodiscard]] constexpr auto whole_of(const Placed<S>& placed) noexcept {
  return whole_of(detail::AssetSurface<Placed<S>>::of(placed));
}
template <template <class> class Placed, Scalar S, class Part, class Visit>
requires is_placed_surface<Placed>
constexpr Walk visit_children(const Placed<S>& placed, const Part& part,
                              const Visit& visit) noexcept {
  return visit_children(detail::AssetSurface<Placed<S>>::of(placed), part,
                        [&](const Part& child, const Aabb<S, 3>& box) {
                          return visit(child, detail::AssetSurface<Placed<S>>::put(placed, box));
                        });
}
template <template <class> class Placed, Scalar S, class Part, class Visit>
requires is_placed_surface<Placed>
constexpr Walk at_leaf(const Placed<S>& placed, const Part& leaf, const Visit& visit) noexcept {
  return at_leaf(detail::AssetSurface<Placed<S>>::of(placed), leaf,
                 detail::in_place(placed, visit));
}

/// The traversals of a placed surface: those of the asset's surface if the query can be translated
/// back exactly, otherwise those through its parts.
template <template <class> class Placed, Scalar S, class Visit>
requires is_placed_surface<Placed>
constexpr Walk visit_along(const Placed<S>& placed, const Ray<S, 3>& ray,
                           const Visit& visit) noexcept {
  const auto origin = ray.origin - detail::AssetSurface<Placed<S>>::translation(placed);
  if (!detail::moves_exactly(placed) || !detail::is_in_range<S>(origin)) {
    return detail::visit_parts_along(placed, ray, visit);
  }
  return visit_along(detail::AssetSurface<Placed<S>>::of(placed),
                     Ray<S, 3>{nearest_to<S>(origin), ray.direction, ray.max_distance},
                     detail::in_place(placed, visit));
}
template <template <class> class Placed, Scalar S, class Visit>
requires is_placed_surface<Placed>
constexpr Walk visit_crossing(const Placed<S>& placed, const Segment<S, 3>& segment,
                              const Visit& visit) noexcept {
  const auto& by = detail::AssetSurface<Placed<S>>::translation(placed);
  const auto start = segment.start - by, end = segment.end - by;
  if (!detail::moves_exactly(placed) || !detail::is_in_range<S>(start) ||
      !detail::is_in_range<S>(end)) {
    return detail::visit_parts_crossing(placed, segment, visit);
  }
  return visit_crossing(detail::AssetSurface<Placed<S>>::of(placed),
                        Segment{nearest_to<S>(start), nearest_to<S>(end)},
                        detail::in_place(placed, visit));
}
/// The part of the box that leaves the range when translated back touches no triangle.
template <template <class> class Placed, Scalar S, class Visit>
requires is_placed_surface<Placed>
constexpr Walk visit_within(const Placed<S>& placed, const Aabb<S, 3>& box,
                            const Visit& visit) noexcept {
  if (!detail::moves_exactly(placed)) return detail::visit_parts_within(placed, box, visit);
  const auto& by = detail::AssetSurface<Placed<S>>::translation(placed);
  return visit_within(detail::AssetSurface<Placed<S>>::of(placed),
                      Aabb<S, 3>{nearest_to<S>(box.min - by), nearest_to<S>(box.max - by)},
                      detail::in_place(placed, visit));
}
template <template <class> class Placed, Scalar S, class Visit>
requires is_placed_surface<Placed>
constexpr Walk visit_around(const Placed<S>& placed, const Vec<S, 3>& point,
                            const Visit& visit) noexcept {
  const auto from = point - detail::AssetSurface<Placed<S>>::translation(placed);
  if (!detail::moves_exactly(placed) || !detail::is_in_range<S>(from)) {
    return detail::visit_parts_around(placed, point, visit);
  }
  return visit_around(detail::AssetSurface<Placed<S>>::of(placed), nearest_to<S>(from),
                      detail::in_place(placed, visit));
}

}  // namespace detent
