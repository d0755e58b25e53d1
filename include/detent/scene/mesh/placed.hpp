// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/scene/mesh/asset.hpp"
#include "detent/scene/mesh/parts.hpp"
#include "detent/scene/put.hpp"
#include "detent/scene/shape_tag.hpp"

namespace detent {

/// A transformed mesh: a surface of the triangles `placed(transform, triangle)`, each coordinate
/// rounded once and clamped to the range of the scalar. If the transform only translates, and
/// everything stays in range, the triangles of the mesh are translated exactly.
///
/// The caller owns the asset, which must outlive it; without one there are no triangles.
template <Scalar S>
struct PlacedMesh {
  const MeshAsset<S>* asset = nullptr;
  Transform<S, 3> transform{};

  [[nodiscard]] friend constexpr bool operator==(const PlacedMesh&,
                                                 const PlacedMesh&) noexcept = default;
};

template <Scalar S>
PlacedMesh(const MeshAsset<S>*) -> PlacedMesh<S>;
template <Scalar S>
PlacedMesh(const MeshAsset<S>*, Transform<S, 3>) -> PlacedMesh<S>;

template <>
inline constexpr bool is_surface<PlacedMesh> = true;

/// Appends to a digest: id and digest of the mesh (zeros for none), and the transform.
template <class D, Scalar S>
constexpr void append(D& digest, const PlacedMesh<S>& mesh) noexcept {
  digest.add(mesh.asset ? mesh.asset->id() : std::uint32_t{0},
             mesh.asset ? mesh.asset->digest() : std::uint64_t{0}, mesh.transform);
}

/// Its fields in a `Desync`: see fields.hpp.
template <Scalar S, class F>
constexpr void for_each_field(const PlacedMesh<S>& mesh, const F& f) {
  f("mesh", mesh.asset ? mesh.asset->id() : std::uint32_t{0});
  f("digest of its triangles", mesh.asset ? mesh.asset->digest() : std::uint64_t{0});
  for_each_field(mesh.transform, f);
}

/// The mesh moved by a vector: the translation is rounded to nearest and clamped.
template <Scalar S>
[[nodiscard]] constexpr PlacedMesh<S> translated(const PlacedMesh<S>& mesh,
                                                 const Vec<S, 3>& by) noexcept {
  auto result = mesh;
  result.transform.translation = nearest_to<S>(mesh.transform.translation + by);
  return result;
}

/// The mesh moved from a local frame to the world: the transforms are composed and rounded.
template <Scalar S>
[[nodiscard]] constexpr PlacedMesh<S> placed(const Transform<S, 3>& transform,
                                             const PlacedMesh<S>& mesh) noexcept {
  return {mesh.asset, compose(transform, mesh.transform)};
}

namespace detail {

template <Scalar S>
inline constexpr std::uint8_t shape_tag<PlacedMesh<S>> = 7;

/// Wraps visit(triangles): it gets the transformed triangles when called with those of the asset.
template <Scalar S, class Visit>
[[nodiscard]] constexpr auto in_place(const PlacedMesh<S>& mesh, const Visit& visit) noexcept {
  return [&](std::span<const MeshTriangle<S>> triangles) {
    std::array<MeshTriangle<S>, StaticTree<S, 3>::leaf_size> there;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      there[i] = {put(mesh.transform, triangles[i].triangle), triangles[i].index};
    }
    return visit(std::span<const MeshTriangle<S>>(there).first(triangles.size()));
  };
}

/// Whether every triangle is translated exactly. A query that can be moved back exactly then goes
/// to the mesh, whose own traversals are faster.
template <Scalar S>
[[nodiscard]] constexpr bool moves_exactly(const PlacedMesh<S>& mesh) noexcept {
  if (!is_fixed<S> || mesh.asset == nullptr || !only_moves(mesh.transform)) return false;
  const auto bounds = bounding_box(mesh.asset->mesh());
  return is_in_range<S>(bounds.min + mesh.transform.translation) &&
         is_in_range<S>(bounds.max + mesh.transform.translation);
}

}  // namespace detail

/// A box around all triangles, empty for none. It is the smallest if the transform only translates.
template <Scalar S>
[[nodiscard]] constexpr Aabb<S, 3> bounding_box(const PlacedMesh<S>& mesh) noexcept {
  if (mesh.asset == nullptr || mesh.asset->mesh().triangles.empty()) {
    return detail::no_box<Aabb<S, 3>>;
  }
  return detail::put(mesh.transform, bounding_box(mesh.asset->mesh()));
}

/// The parts of a transformed mesh: see parts.hpp. Rounding keeps order, so rounded corners of
/// triangles lie within the rounded box of the exact ones.
template <Scalar S>
[[nodiscard]] constexpr auto whole_of(const PlacedMesh<S>& mesh) noexcept {
  return whole_of(mesh.asset->mesh());
}
template <Scalar S, class Test>
constexpr bool any_child(const PlacedMesh<S>& mesh, const detail::StaticPart& part,
                         const Test& test) noexcept {
  return any_child(mesh.asset->mesh(), part,
                   [&](const detail::StaticPart& child, const Aabb<S, 3>& box) {
                     return test(child, detail::put(mesh.transform, box));
                   });
}
template <Scalar S, class Visit>
constexpr bool at_leaf(const PlacedMesh<S>& mesh, const detail::StaticPart& leaf,
                       const Visit& visit) noexcept {
  return at_leaf(mesh.asset->mesh(), leaf, detail::in_place(mesh, visit));
}

/// The traversals of a placed mesh: those of the mesh if possible, else those through its parts.
template <Scalar S, class Visit>
constexpr void visit_along(const PlacedMesh<S>& mesh, const Ray<S, 3>& ray,
                           const Visit& visit) noexcept {
  const auto origin = ray.origin - mesh.transform.translation;
  if (!detail::moves_exactly(mesh) || !detail::is_in_range<S>(origin)) {
    return visit_along<PlacedMesh>(mesh, ray, visit);
  }
  visit_along(mesh.asset->mesh(), Ray<S, 3>{nearest_to<S>(origin), ray.direction, ray.max_distance},
              detail::in_place(mesh, visit));
}
template <Scalar S, class Visit>
constexpr bool visit_crossing(const PlacedMesh<S>& mesh, const Segment<S, 3>& segment,
                              const Visit& visit) noexcept {
  const auto start = segment.start - mesh.transform.translation;
  const auto end = segment.end - mesh.transform.translation;
  if (!detail::moves_exactly(mesh) || !detail::is_in_range<S>(start) ||
      !detail::is_in_range<S>(end)) {
    return visit_crossing<PlacedMesh>(mesh, segment, visit);
  }
  return visit_crossing(mesh.asset->mesh(), Segment{nearest_to<S>(start), nearest_to<S>(end)},
                        detail::in_place(mesh, visit));
}
/// The part of the box that is out of range once moved back touches no triangle.
template <Scalar S, class Visit>
constexpr bool visit_within(const PlacedMesh<S>& mesh, const Aabb<S, 3>& box,
                            const Visit& visit) noexcept {
  if (!detail::moves_exactly(mesh)) return visit_within<PlacedMesh>(mesh, box, visit);
  const auto& by = mesh.transform.translation;
  return visit_within(mesh.asset->mesh(),
                      Aabb<S, 3>{nearest_to<S>(box.min - by), nearest_to<S>(box.max - by)},
                      detail::in_place(mesh, visit));
}
template <Scalar S, class Visit>
constexpr void visit_around(const PlacedMesh<S>& mesh, const Vec<S, 3>& point,
                            const Visit& visit) noexcept {
  const auto from = point - mesh.transform.translation;
  if (!detail::moves_exactly(mesh) || !detail::is_in_range<S>(from)) {
    return visit_around<PlacedMesh>(mesh, point, visit);
  }
  visit_around(mesh.asset->mesh(), nearest_to<S>(from), detail::in_place(mesh, visit));
}

}  // namespace detent
