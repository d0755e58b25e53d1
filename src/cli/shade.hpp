// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "numbers.hpp"
#include "scene.hpp"
#include "world.hpp"

namespace detent::cli {

/// Colours of hits: a directional light, hard shadows, a checker on planes.
///
/// All geometry is computed in the scalar: the point, the normal, the cosine, the shadow ray. Only
/// the brightness on the screen is a double.
template <Scalar S>
class Shader {
 public:
  /// Shadow rays start `bias` above the surface.
  Shader(const World<S>& world, const std::vector<ShapeModel>& models, const Direction<S, 3>& light,
         S bias)
      : world_(world), models_(models), light_(light), bias_(bias) {}

  [[nodiscard]] Colour sky(const Ray<S, 3>& ray) const {
    const double height = std::clamp(static_cast<double>(ray.direction[1]), 0.0, 1.0);
    return blend({0xc6, 0xd3, 0xdf}, {0x5b, 0x86, 0xb6}, std::sqrt(height));
  }

  [[nodiscard]] Colour surface(const Answer<S>& answer) const {
    const RayHit<S, 3>& hit = answer.hit;
    const double cosine = static_cast<double>(nearest_to<S>(dot(hit.normal, light_)));
    const bool lit = cosine > 0 && !world_.is_blocked(shadow_ray(hit));
    const double skylight = 0.34 + 0.10 * static_cast<double>(hit.normal[1]);
    return scaled(base_colour(answer), skylight + (lit ? 0.62 * cosine : 0));
  }

 private:
  Ray<S, 3> shadow_ray(const RayHit<S, 3>& hit) const {
    return {nearest_to<S>(hit.point + hit.normal.vec() * bias_), light_};
  }

  Colour base_colour(const Answer<S>& answer) const {
    const Colour colour = models_[answer.shape].colour;
    const auto* const plane = std::get_if<Plane<S, 3>>(&world_.shapes()[answer.shape]);
    return plane && !is_light_square(answer.hit.point, plane->normal) ? scaled(colour, 0.8)
                                                                      : colour;
  }

  /// Squares 4 units wide, along the two axes other than the steepest of the plane's normal.
  static bool is_light_square(const Vec<S, 3>& point, const Direction<S, 3>& normal) {
    int steepest = 0;
    for (int i = 1; i < 3; ++i) {
      if (abs(normal[i]) > abs(normal[steepest])) steepest = i;
    }
    bool light = true;
    for (int i = 0; i < 3; ++i) {
      // Exact: every scalar and its quarter are doubles.
      const double square = std::floor(static_cast<double>(point[i]) / 4);
      if (i != steepest && std::fmod(square, 2) != 0) light = !light;
    }
    return light;
  }

  static Colour scaled(Colour colour, double factor) { return blend({}, colour, factor); }

  static Colour blend(Colour from, Colour to, double factor) {
    const double share = factor > 0 ? std::min(factor, 1.0) : 0;  // 0 for a NaN
    const auto mixed = [&](std::uint8_t a, std::uint8_t b) {
      return static_cast<std::uint8_t>(std::lround(a + (b - a) * share));
    };
    return {mixed(from.red, to.red), mixed(from.green, to.green), mixed(from.blue, to.blue)};
  }

  const World<S>& world_;
  const std::vector<ShapeModel>& models_;
  Direction<S, 3> light_;
  S bias_;
};

}  // namespace detent::cli
