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

/// The answer to a ray: which shape, and where.
template <Scalar S>
struct Answer {
  std::size_t shape;
  RayHit<S, 3> hit;
};

/// The shapes of a scene in one scalar, in the order of the file, and trees to find them by.
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

  /// The nearest shape along `ray`; of equally near ones the first in the file.
  [[nodiscard]] std::optional<Answer<S>> nearest(const Ray<S, 3>& ray) const {
    std::optional<Candidate> best;
    Ray<S, 3> rest = ray;
    const auto offer = [&](const Candidate& candidate) {
      const bool is_nearer =
          !best || candidate.distance < best->distance ||
          (candidate.distance == best->distance && candidate.shape < best->shape);
      if (!is_nearer) return;
      best = candidate;
      // What lies farther need not be found, but for what rounds down to the same distance.
      rest.max_distance = std::min(ray.max_distance, next_up(candidate.distance));
    };
    for (const std::size_t shape : list_) {
      if (const auto candidate = ask(rest, shape)) offer(*candidate);
    }
    if (tree_.size() > 0) {
      if (const auto found = tree_.nearest(rest)) offer({found->id.index, found->distance, {}});
    }
    if (!best) return std::nullopt;

    const auto hit = best->hit ? best->hit : hit_of(ray, shapes_[best->shape]);
    if (!hit) return std::nullopt;  // cannot be for a Fixed: the same ray just hit
    return Answer<S>{best->shape, *hit};
  }

  /// Whether anything lies on `ray`.
  [[nodiscard]] bool is_blocked(const Ray<S, 3>& ray) const {
    return (tree_.size() > 0 && tree_.any(ray)) ||
           std::any_of(list_.begin(), list_.end(), [&](std::size_t shape) {
             return std::visit([&](const auto& form) { return is_hit(ray, form); }, shapes_[shape]);
           });
  }

 private:
  /// Up to here asking each shape takes no longer than a tree.
  static constexpr std::size_t longest_list = 16;

  struct Candidate {
    std::size_t shape;
    S distance;
    std::optional<RayHit<S, 3>> hit;  // of a mesh, whose triangle is at hand only now
  };

  /// Each under its place in the file, by which the tree decides between equally near ones.
  template <class Form>
  bool add_to_tree(const Form& form, std::size_t place) {
    if constexpr (requires { tree_.add(form); }) {
      return tree_.add_as({static_cast<std::uint32_t>(place), 1}, form);
    } else {
      return false;
    }
  }

  [[nodiscard]] std::optional<Candidate> ask(const Ray<S, 3>& ray, std::size_t shape) const {
    if (std::holds_alternative<OwnedMesh<S>>(shapes_[shape])) {
      const auto hit = hit_of(ray, shapes_[shape]);
      return hit ? std::optional(Candidate{shape, hit->distance, hit}) : std::nullopt;
    }
    const auto distance =
        std::visit([&](const auto& form) { return raycast(ray, asked(form)); }, shapes_[shape]);
    return distance ? std::optional(Candidate{shape, *distance, {}}) : std::nullopt;
  }

  [[nodiscard]] static std::optional<RayHit<S, 3>> hit_of(const Ray<S, 3>& ray,
                                                          const Shape& shape) {
    return std::visit([&](const auto& form) { return raycast_hit(ray, asked(form)); }, shape);
  }

  /// What the queries take of a shape.
  template <class Form>
  [[nodiscard]] static const Form& asked(const Form& form) {
    return form;
  }
  [[nodiscard]] static Mesh<S> asked(const OwnedMesh<S>& mesh) { return mesh.view(); }

  template <class Form>
  [[nodiscard]] static bool is_hit(const Ray<S, 3>& ray, const Form& form) {
    return raycast(ray, form).has_value();
  }
  [[nodiscard]] static bool is_hit(const Ray<S, 3>& ray, const OwnedMesh<S>& mesh) {
    return raycast_any(ray, mesh.view());
  }

  std::vector<Shape> shapes_;
  detent::Scene<S, 3, Sphere, Aabb, Obb, Triangle> tree_;
  std::vector<std::size_t> list_;  // what is not in the tree: planes, meshes, a few shapes
};

}  // namespace detent::cli
