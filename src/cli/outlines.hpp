// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "scene.hpp"
#include "world_builder.hpp"

namespace detent::cli {

/// What `--debug` draws over a picture.
struct DebugParts {
  bool shapes = false;
  bool tree = false;

  [[nodiscard]] bool any() const { return shapes || tree; }
};

/// A line in the world. Doubles represent the numbers of every scalar.
struct Outline {
  std::array<double, 3> a;
  std::array<double, 3> b;
  Colour colour;
};

/// The edges of the shapes and the boxes of the trees, drawn by the library; planes around the
/// camera's target.
[[nodiscard]] std::vector<Outline> outlines_of(std::string_view scalar, const Scene& scene,
                                               const Move& move, const DebugParts& parts);

}  // namespace detent::cli
