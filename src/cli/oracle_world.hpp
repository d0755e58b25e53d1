// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "oracle_group.hpp"
#include "world.hpp"

// Converts typed shapes to the oracle's: every scalar has an exact value, so nothing is lost.

namespace detent::cli::oracle {

template <Number T>
[[nodiscard]] Exact exact(const T& value) {
  if constexpr (is_fixed<T>) {
    return {Integer(static_cast<std::int64_t>(value.raw())), -T::frac};
  } else {
    return Exact::of(value);
  }
}

template <Number T>
[[nodiscard]] Vector exact(const Vec<T, 3>& v) {
  return {exact(v.x), exact(v.y), exact(v.z)};
}

template <Scalar S>
[[nodiscard]] Ray exact(const detent::Ray<S, 3>& ray) {
  return {exact(ray.origin), exact(ray.direction.vec()), exact(ray.max_distance)};
}

template <Scalar S>
[[nodiscard]] Shape exact(const detent::Sphere<S, 3>& sphere) {
  return Sphere{exact(sphere.center), exact(sphere.radius)};
}
template <Scalar S>
[[nodiscard]] Shape exact(const detent::Aabb<S, 3>& box) {
  return Aabb{exact(box.min), exact(box.max)};
}
template <Scalar S>
[[nodiscard]] Shape exact(const detent::Obb<S, 3>& box) {
  return Obb{exact(box.center),
             exact(box.half_extents),
             {exact(box.rotation.axis(0).vec()), exact(box.rotation.axis(1).vec()),
              exact(box.rotation.axis(2).vec())}};
}
template <Scalar S>
[[nodiscard]] Shape exact(const detent::Plane<S, 3>& plane) {
  return Plane{exact(plane.normal.vec()), exact(plane.offset)};
}
template <Scalar S>
[[nodiscard]] Shape exact(const detent::Triangle<S, 3>& triangle) {
  return Triangle{exact(triangle.a), exact(triangle.b), exact(triangle.c)};
}

/// The shapes of the scene, in its order.
template <Scalar S>
[[nodiscard]] std::vector<Group> exact(const cli::World<S>& world) {
  std::vector<Group> groups;
  for (const auto& shape : world.shapes()) {
    std::vector<Shape> parts;
    std::visit(
        [&]<class Form>(const Form& form) {
          if constexpr (std::same_as<Form, OwnedMesh<S>>) {
            for (const auto& part : form.view().triangles) parts.push_back(exact(part.triangle));
          } else {
            parts.push_back(exact(form));
          }
        },
        shape);
    groups.emplace_back(std::move(parts));
  }
  return groups;
}

/// A shape that `ray` hits, and its exact distance; in shape order.
struct Meeting {
  std::size_t shape;
  Integer distance;
};

[[nodiscard]] inline std::vector<Meeting> meetings(const std::vector<Group>& scene,
                                                   const Ray& ray) {
  std::vector<Meeting> all;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (const auto distance = scene[i].first_hit(ray)) all.push_back({i, *distance});
  }
  return all;
}

}  // namespace detent::cli::oracle
