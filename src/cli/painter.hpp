// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "image.hpp"
#include "simulation.hpp"
#include "tracer.hpp"
#include "view.hpp"

namespace detent::cli {

/// Draws the bodies of a world, in doubles: pictures are for display, and affect no result.
class Painter {
 public:
  /// Throws InputError when a 3D world has no camera, or one without a direction. A 2D world
  /// without a camera is seen around the bodies that are not fixed.
  Painter(const WorldModel& model, const Simulation& start, Size size);

  [[nodiscard]] Image picture(const std::vector<Facet>& facets) const;

 private:
  Size size_;
  bool is_flat_;
  std::array<double, 3> light_{};
  // The view: as for `View`; in 2D from infinitely far away, along -z.
  View view_{};
};

}  // namespace detent::cli
