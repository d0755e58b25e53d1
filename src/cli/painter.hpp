// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "camera.hpp"
#include "image.hpp"
#include "simulation.hpp"
#include "tracer.hpp"

namespace detent::cli {

/// Draws the bodies of a world, in doubles: a picture is for the eye, and no number comes from it.
class Painter {
 public:
  /// Throws InputError when a world in three dimensions has no camera, or one without a direction.
  /// Without a camera, one in two dimensions is seen around the bodies that are not fixed.
  Painter(const WorldModel& model, const Simulation& start, Size size);

  [[nodiscard]] Image picture(const std::vector<Facet>& facets) const;

 private:
  Size size_;
  bool is_flat_;
  std::array<double, 3> light_{};
  // What is seen: as for `View`; in two dimensions from infinitely far away, along -z.
  View view_{};
};

}  // namespace detent::cli
