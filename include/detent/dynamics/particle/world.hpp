// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "detent/dynamics/compound.hpp"
#include "detent/dynamics/particle/obstacles.hpp"
#include "detent/dynamics/particle/terrain.hpp"
#include "detent/dynamics/world.hpp"
#include "detent/scene/scene.hpp"

namespace detent {

namespace detail {

/// The corners of a solid hull in its body's pose, each coordinate rounded to nearest once.
template <Scalar S, int N>
class SolidPoints {
 public:
  constexpr SolidPoints(const SolidHull<S, N>* solid, const Standing<S, N>& body) noexcept {
    if (solid == nullptr) return;
    for (const auto& point : solid->hull().points) {
      const auto local = point - solid->center();
      points_[count_++] = make_vec<N>([&](int k) {
        const auto along =
            make_vec<N>([&](int i) { return body.axes[static_cast<std::size_t>(i)][k]; });
        return saturate_to<S>(body.place[k] + dot(along, local));
      });
    }
  }
  [[nodiscard]] constexpr ConvexHull<S, N> hull() const noexcept {
    return {std::span<const Vec<S, N>>(points_).first(count_)};
  }

 private:
  std::array<Vec<S, N>, SolidHull<S, N>::capacity> points_{};
  std::size_t count_ = 0;
};

/// Position and axes as a transform, each number rounded to nearest once.
template <Scalar S, int N>
[[nodiscard]] constexpr Transform<S, N> transform_of(const Standing<S, N>& at) noexcept {
  std::array<Direction<S, N>, std::size_t{N}> directions;
  for (std::size_t i = 0; i < std::size_t{N}; ++i) {
    directions[i] = Direction<S, N>::assume_unit(nearest_to<direction_component<S>>(at.axes[i]));
  }
  return {make_vec<N>([&](int i) { return saturate_to<S>(at.place[i]); }),
          Rotation<S, N>::from_axes(directions), S(1)};
}

/// Calls f(shape) with the shape of a body at this pose, with each part that is not a sensor, or with
/// the triangles of a surface.
template <Scalar S, int N, class Shape, class F>
constexpr void visit_placed(const Standing<S, N>& at, const Aabb<S, N>& box, const Shape& shape,
                            const F& f) {
  if constexpr (std::is_same_v<Shape, BodyHull<S, N>>) {
    const SolidPoints<S, N> points(shape.asset, at);
    visit_parts_in(box, points.hull(), f);
  } else if constexpr (is_compound_body<Shape>) {
    if (shape.asset == nullptr) return;
    for (const auto& part : shape.asset->parts()) {
      if (part.options().is_sensor) continue;
      const auto there = part_at(at, pose_in(*shape.asset, part));
      part.shape().visit([&](const auto& solid) { visit_placed(there, box, solid, f); });
    }
  } else if constexpr (is_surface_body<Shape>) {
    visit_placed_surface(at, box, shape, f);
  } else {
    visit_parts_in(box, placed(transform_of(at), shape), f);
  }
}

}  // namespace detail

/// The bodies of a world at their current poses, in the order of their indices: compounds part by
/// part, meshes and height fields triangle by triangle, from both sides. Sensors are left out.
template <class World>
class WorldObstacles;

template <class Storage, Scalar S, int N, class... Parts>
class WorldObstacles<BasicWorld<Storage, S, N, Parts...>> {
  using World = BasicWorld<Storage, S, N, Parts...>;

 public:
  /// See `obstacles_of`. It refers to the world.
  constexpr WorldObstacles(const World& world, std::uint32_t layers) : world_(world) {
    const auto& bodies = detail::WorldAccess::bodies(world);
    boxes_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      boxes_[i] = detail::no_box<Aabb<S, N>>;
      if (bodies[i].generation == 0 || bodies[i].is_sensor || (bodies[i].layers & layers) == 0) {
        continue;
      }
      const bool is_surface = bodies[i].shape.visit([&]<class Shape>(const Shape& shape) {
        if constexpr (detail::is_surface_body<Shape>) {
          if (shape.asset == nullptr) return true;
          boxes_[i] = detail::placed_box(standing(i), bounding_box(detail::surface_of(shape)));
        }
        return detail::is_surface_body<Shape>;
      });
      if (is_surface) continue;
      visit(
          i,
          {make_vec<N>([](int) { return lowest<S>; }), make_vec<N>([](int) { return largest<S>; })},
          [&](const auto& shape) { boxes_[i] = bounding_box(boxes_[i], bounding_box(shape)); });
    }
  }

  template <class F>
  constexpr void operator()(const Aabb<S, N>& box, const F& f) const {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (overlaps(box, boxes_[i])) visit(i, box, f);
    }
  }

 private:
  [[nodiscard]] constexpr detail::Standing<S, N> standing(std::size_t i) const {
    const auto& state = detail::WorldAccess::bodies(world_)[i].state;
    return {state.place, detail::axes_of<S, N>(state.orientation)};
  }
  template <class F>
  constexpr void visit(std::size_t i, const Aabb<S, N>& box, const F& f) const {
    const auto at = standing(i);
    const auto& body = detail::WorldAccess::bodies(world_)[i];
    body.shape.visit([&](const auto& shape) { detail::visit_placed(at, box, shape, f); });
  }

  const World& world_;
  typename Storage::template List<Aabb<S, N>, Storage::capacity> boxes_;
};

/// The bodies of a world in any of these layers, as obstacles of particles. Valid for one tick:
/// make a new one after bodies have moved.
template <class Storage, Scalar S, int N, class... Parts>
[[nodiscard]] constexpr auto obstacles_of(const BasicWorld<Storage, S, N, Parts...>& world,
                                          std::uint32_t layers = 0xffffffffu) {
  return WorldObstacles<BasicWorld<Storage, S, N, Parts...>>(world, layers);
}

/// The objects of a scene, at their current positions, in the order of their indices.
template <class Storage, Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr auto obstacles_of(const BasicScene<Storage, S, N, Shapes...>& scene,
                                          std::uint32_t layers = 0xffffffffu) {
  return [&scene, layers](const Aabb<S, N>& box, const auto& f) {
    const auto& store = detail::SceneAccess::store(scene);
    for (std::size_t i = 0; i < store.end(); ++i) {
      if (!store.is_object(i) || (store[i].layers & layers) == 0) continue;
      store[i].shape.visit([&](const auto& shape) { detail::visit_parts_in(box, shape, f); });
    }
  };
}

}  // namespace detent
