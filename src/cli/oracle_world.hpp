// SPDX-License-Identifier: MIT
#pragma once

#include "oracle.hpp"
#include "world.hpp"

// The way from typed shapes to the oracle's: every scalar has an exact value, so nothing is lost.

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

/// The oracle's shapes, and for each of them the shape of the scene that it belongs to.
struct Scene {
  World world;
  std::vector<std::size_t> owners;
};

template <Scalar S>
[[nodiscard]] Scene exact(const cli::World<S>& world) {
  Scene scene;
  const auto add = [&](const auto& form, std::size_t owner) {
    scene.world.add(exact(form));
    scene.owners.push_back(owner);
  };
  for (std::size_t i = 0; i < world.shapes.size(); ++i) {
    const auto add_all = [&](const auto& form) {
      if constexpr (std::same_as<std::remove_cvref_t<decltype(form)>, Mesh<S>>) {
        for (const auto& triangle : form.triangles()) add(triangle, i);
      } else {
        add(form, i);
      }
    };
    std::visit(add_all, world.shapes[i]);
  }
  return scene;
}

/// The first distance at which `ray` meets each shape of the scene that it meets, in shape order.
struct Meeting {
  std::size_t shape;
  Integer distance;
};

[[nodiscard]] inline std::vector<Meeting> meetings(const Scene& scene, const Ray& ray) {
  std::vector<Meeting> all;
  for (std::size_t i = 0; i < scene.world.size(); ++i) {
    const auto distance = scene.world.hit(ray, i);
    if (!distance) continue;
    if (all.empty() || all.back().shape != scene.owners[i]) {
      all.push_back({scene.owners[i], *distance});
    } else if (*distance < all.back().distance) {
      all.back().distance = *distance;
    }
  }
  return all;
}

}  // namespace detent::cli::oracle
