// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "exact_group.hpp"
#include "world.hpp"

namespace detent::cli {

/// The shapes of the scene, in its order.
template <Scalar S>
[[nodiscard]] std::vector<ExactGroup> exact(const World<S>& world) {
  std::vector<ExactGroup> groups;
  for (const auto& shape : world.shapes()) {
    std::vector<ExactShape> parts;
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

[[nodiscard]] inline std::vector<Meeting> meetings(const std::vector<ExactGroup>& scene,
                                                   const ExactShape& ray) {
  std::vector<Meeting> all;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (const auto distance = scene[i].first_hit(ray)) all.push_back({i, *distance});
  }
  return all;
}

}  // namespace detent::cli
