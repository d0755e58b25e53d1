// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "verify/draw/surfaces.hpp"
#include "verify/questions/cases.hpp"
#include "verify/questions/listed.hpp"

// Surfaces of triangles, whose results equal those of a loop over the triangles.

namespace detent::verify {

template <Scalar S, int N>
struct MeshCase {
  MeshTriangles<S> mesh;
  Ray<S, N> ray;
  Vec<S, N> point;
  Segment<S, N> segment;
  Sphere<S, N> sphere;
  Obb<S, N> obb;

  constexpr auto fields(const auto& f) const noexcept {
    return f(mesh, ray, point, segment, sphere, obb);
  }
};

/// A mesh and the storage it is a view of.
template <Scalar S>
class BuiltMesh {
 public:
  DETENT_VERIFY_NOINLINE explicit constexpr BuiltMesh(const MeshTriangles<S>& mesh) noexcept
      : count_(mesh.count) {
    for (std::size_t i = 0; i < count_; ++i) {
      triangles_[i] = {mesh.triangles[i], static_cast<std::uint32_t>(i)};
    }
    if (const auto built = build_mesh<S>(std::span(triangles_).first(count_), nodes_)) {
      bounds_ = built->tree.bounds;
      node_count_ = built->tree.nodes.size();
    }
  }
  [[nodiscard]] constexpr Mesh<S> view() const noexcept {
    return {{std::span(nodes_).first(node_count_), bounds_}, std::span(triangles_).first(count_)};
  }

 private:
  std::array<MeshTriangle<S>, MeshTriangles<S>::capacity> triangles_{};
  std::array<MeshNode<S>, tree_capacity(MeshTriangles<S>::capacity)> nodes_{};
  Aabb<S, 3> bounds_ = detail::no_box<Aabb<S, 3>>;
  std::size_t node_count_ = 0;
  std::size_t count_;
};
/// The tree as built: box, nodes and sorted triangles.
template <class D, Scalar S>
constexpr void append(D& digest, const BuiltMesh<S>& built) noexcept {
  const auto mesh = built.view();
  digest.add(mesh.tree.bounds, static_cast<std::uint32_t>(mesh.tree.nodes.size()));
  for (const auto& node : mesh.tree.nodes) digest.add(node);
  for (const auto& part : mesh.triangles) digest.add(part);
}

/// Groups of surfaces run in 3D only and one question in twelve, because each builds its surface.
struct SurfaceGroup : InDimensions<3> {
  static constexpr std::uint32_t share = 12;
};

/// The first of these names seeds the questions. With it the first question of each cell, which
/// compilers evaluate too, has few triangles.
struct Meshes : SurfaceGroup {
  static constexpr std::array<std::string_view, 9> names{
      "mesh/raycast_nearest", "mesh/raycast_any",      "mesh/raycast_all",
      "mesh/raycast_hit",     "mesh/overlaps/sphere",  "mesh/overlaps_all/obb",
      "mesh/intersects",      "mesh/nearest_triangle", "mesh/tree"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    SurfaceScene<S> scene(random);
    MeshCase<S, N> c;
    c.mesh = scene.mesh();
    scene.aim_at(c.mesh);
    c.ray = scene.aimed_ray();
    c.point = random.coin() ? scene.spot() : scene.sphere().center;
    c.segment = scene.segment();
    c.sphere = scene.sphere();
    c.obb = scene.obb();
    return c;
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const MeshCase<S, N>& c) noexcept {
    if constexpr (Row == 8) {
      return BuiltMesh<S>(c.mesh);
    } else {
      const BuiltMesh<S> built(c.mesh);
      return answer<Row>(c, built.view());
    }
  }

 private:
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const MeshCase<S, N>& c,
                                             const Mesh<S>& mesh) noexcept {
    if constexpr (Row == 0) {
      return raycast_nearest(c.ray, mesh);
    } else if constexpr (Row == 1) {
      return raycast_any(c.ray, mesh);
    } else if constexpr (Row == 2) {
      return Listed<MeshHit<S>, 3>([&](auto room) { return raycast_all(c.ray, mesh, room); });
    } else if constexpr (Row == 3) {
      return raycast_hit(c.ray, mesh);
    } else if constexpr (Row == 4) {
      return overlaps(mesh, c.sphere);
    } else if constexpr (Row == 5) {
      return Listed<std::uint32_t, 4>([&](auto room) { return overlaps_all(mesh, c.obb, room); });
    } else if constexpr (Row == 6) {
      return intersects(c.segment, mesh);
    } else {
      return nearest_triangle(mesh, c.point);
    }
  }
};

template <Scalar S, int N>
struct FieldCase {
  FieldSamples<S> field;
  Ray<S, N> ray;
  Vec<S, N> point;
  Aabb<S, N> aabb;

  constexpr auto fields(const auto& f) const noexcept { return f(field, ray, point, aabb); }
};

/// The field with these samples; invalid ones make a field without triangles.
template <Scalar S>
[[nodiscard]] constexpr HeightField<S> view_of(const FieldSamples<S>& field) noexcept {
  const auto samples = std::span(field.heights).first(std::size_t{field.columns} * field.rows);
  return height_field<S>(field.corner, field.cell, field.columns, field.rows, samples)
      .value_or(HeightField<S>());
}

struct HeightFields : SurfaceGroup {
  static constexpr std::array<std::string_view, 4> names{
      "height_field/raycast_nearest", "height_field/raycast_all", "height_field/overlaps/aabb",
      "height_field/nearest_triangle"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    SurfaceScene<S> scene(random);
    FieldCase<S, N> c;
    c.field = scene.field();
    scene.aim_at(c.field);
    c.ray = scene.upright_ray();
    c.point = random.coin() ? scene.spot() : scene.sphere().center;
    c.aabb = scene.aabb();
    return c;
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const FieldCase<S, N>& c) noexcept {
    const auto field = view_of(c.field);
    if constexpr (Row == 0) {
      return raycast_nearest(c.ray, field);
    } else if constexpr (Row == 1) {
      return Listed<MeshHit<S>, 3>([&](auto room) { return raycast_all(c.ray, field, room); });
    } else if constexpr (Row == 2) {
      return overlaps(field, c.aabb);
    } else {
      return nearest_triangle(field, c.point);
    }
  }
};

}  // namespace detent::verify
