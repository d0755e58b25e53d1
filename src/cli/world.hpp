// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "detent/detent.hpp"
#include "mesh.hpp"

namespace detent::cli {

/// The shapes of a scene in one scalar, in the order of the file.
template <Scalar S>
struct World {
  using Shape =
      std::variant<Sphere<S, 3>, Aabb<S, 3>, Obb<S, 3>, Plane<S, 3>, Triangle<S, 3>, Mesh<S>>;
  std::vector<Shape> shapes;
};

/// The answer to a ray: which shape, and where.
template <Scalar S>
struct Answer {
  std::size_t shape;
  RayHit<S, 3> hit;
};

/// The nearest shape along `ray`; of equally near ones the first in the file.
template <Scalar S>
[[nodiscard]] std::optional<Answer<S>> nearest(const World<S>& world, const Ray<S, 3>& ray) {
  using Shape = typename World<S>::Shape;
  const Shape* best = nullptr;
  const Triangle<S, 3>* best_triangle = nullptr;
  S best_distance{};
  // What lies farther than the best so far need not be found, so the ray gets shorter.
  Ray<S, 3> rest = ray;
  const auto keep = [&](const Shape& shape, S distance, const Triangle<S, 3>* triangle) {
    if (best && !(distance < best_distance)) return;
    best = &shape;
    best_triangle = triangle;
    best_distance = rest.max_distance = distance;
  };
  for (const Shape& shape : world.shapes) {
    std::visit(
        [&]<class Form>(const Form& form) {
          if constexpr (std::same_as<Form, Mesh<S>>) {
            if (const auto hit = form.nearest(rest)) {
              keep(shape, hit->distance, &form.triangles()[hit->triangle]);
            }
          } else if (const auto distance = raycast(rest, form)) {
            keep(shape, *distance, nullptr);
          }
        },
        shape);
  }
  if (!best) return std::nullopt;

  const auto hit = std::visit(
      [&]<class Form>(const Form& form) {
        if constexpr (std::same_as<Form, Mesh<S>>) {
          return raycast_hit(ray, *best_triangle);
        } else {
          return raycast_hit(ray, form);
        }
      },
      *best);
  if (!hit) return std::nullopt;  // cannot be for a Fixed: the same ray just hit
  return Answer<S>{static_cast<std::size_t>(best - world.shapes.data()), *hit};
}

/// Whether anything lies on the ray.
template <Scalar S>
[[nodiscard]] bool is_blocked(const World<S>& world, const Ray<S, 3>& ray) {
  for (const auto& shape : world.shapes) {
    const bool hit = std::visit(
        [&]<class Form>(const Form& form) {
          if constexpr (std::same_as<Form, Mesh<S>>) {
            return form.is_hit(ray);
          } else {
            return raycast(ray, form).has_value();
          }
        },
        shape);
    if (hit) return true;
  }
  return false;
}

}  // namespace detent::cli
