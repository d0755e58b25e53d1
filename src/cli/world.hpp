// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "detent/detent.hpp"
#include "detent/scene/mesh/owned.hpp"

namespace detent::cli {

/// The result of a ray: the shape, and the point.
template <Scalar S>
struct Answer {
  std::size_t shape;
  RayHit<S, 3> hit;
};

/// The shapes of a scene in one scalar, in file order, and trees to find them.
template <Scalar S>
class World {
 public:
  using Shape =
      std::variant<Sphere<S, 3>, Aabb<S, 3>, Obb<S, 3>, Plane<S, 3>, Triangle<S, 3>, OwnedMesh<S>>;

  explicit World(std::vector<Shape> shapes) : shapes_(std::move(shapes)) {
    const bool has_tree = shapes_.size() > longest_list;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const auto add = [&](const auto& form) { return add_to_tree(form, i); };
      if (!has_tree || !std::visit(add, shapes_[i])) list_.push_back(i);
    }
    tree_.optimize();
  }

  [[nodiscard]] const std::vector<Shape>& shapes() const { return shapes_; }

  /// The tree over all shapes except planes and meshes, if the scene has many.
  [[nodiscard]] const auto& tree() const { return tree_; }

  /// The nearest shape along `ray`; of equally near ones the first in the file.
  [[nodiscard]] std::optional<Answer<S>> nearest(const Ray<S, 3>& ray) const {
    constexpr auto none = static_cast<std::size_t>(-1);
    std::size_t best = none;
    S distance{};
    std::optional<RayHit<S, 3>> mesh_hit;  // comes with the distance; others' come later
    Ray<S, 3> rest = ray;
    const auto is_nearest = [&](std::size_t shape, const S& to_shape) {
      if (best != none && (distance < to_shape || (distance == to_shape && best < shape))) {
        return false;
      }
      best = shape;
      distance = to_shape;
      // Culls farther shapes, but keeps those that round down to the same distance.
      rest.max_distance = std::min(ray.max_distance, next_up(to_shape));
      return true;
    };
    for (const std::size_t shape : list_) {
      std::visit(
          [&]<class Form>(const Form& form) {
            if constexpr (std::same_as<Form, OwnedMesh<S>>) {
              const auto hit = raycast_hit(rest, form.view());
              if (hit && is_nearest(shape, hit->distance)) mesh_hit = hit;
            } else if (const auto to_shape = raycast(rest, form)) {
              (void)is_nearest(shape, *to_shape);
            }
          },
          shapes_[shape]);
    }
    if (tree_.size() > 0) {
      if (const auto found = tree_.nearest(rest))
        (void)is_nearest(found->id.index, found->distance);
    }
    if (best == none) return std::nullopt;

    const auto hit = std::visit(
        [&]<class Form>(const Form& form) {
          if constexpr (std::same_as<Form, OwnedMesh<S>>) {
            return mesh_hit;
          } else {
            return raycast_hit(ray, form);
          }
        },
        shapes_[best]);
    if (!hit) return std::nullopt;  // not for a Fixed: the same ray just hit
    return Answer<S>{best, *hit};
  }

  /// Whether `ray` hits anything.
  [[nodiscard]] bool is_blocked(const Ray<S, 3>& ray) const {
    return (tree_.size() > 0 && tree_.any(ray)) ||
           std::any_of(list_.begin(), list_.end(), [&](std::size_t shape) {
             return std::visit([&](const auto& form) { return is_hit(ray, form); }, shapes_[shape]);
           });
  }

 private:
  /// Up to this many shapes, a list is as fast as a tree.
  static constexpr std::size_t longest_list = 16;

  /// Each is added under its index in the file, which decides between equally near shapes.
  template <class Form>
  bool add_to_tree(const Form& form, std::size_t place) {
    if constexpr (requires { tree_.add(form); }) {
      return tree_.add_as({static_cast<std::uint32_t>(place), 1}, form);
    } else {
      return false;
    }
  }

  template <class Form>
  [[nodiscard]] static bool is_hit(const Ray<S, 3>& ray, const Form& form) {
    return raycast(ray, form).has_value();
  }
  [[nodiscard]] static bool is_hit(const Ray<S, 3>& ray, const OwnedMesh<S>& mesh) {
    return raycast_any(ray, mesh.view());
  }

  std::vector<Shape> shapes_;
  detent::Scene<S, 3, Sphere, Aabb, Obb, Triangle> tree_;
  std::vector<std::size_t> list_;  // shapes outside the tree: planes, meshes, a few others
};

}  // namespace detent::cli
