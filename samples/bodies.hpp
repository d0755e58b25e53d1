// SPDX-License-Identifier: MIT
#pragma once

// Shared by the 3D samples: their scene, their world and the drawing of bodies.

#include <type_traits>

#include <detent/draw/draw.hpp>
#include <detent/dynamics/dynamics.hpp>
#include <detent/scene/scene.hpp>

#include "sample.hpp"

namespace samples {

using Ball = Sphere<S, 3>;
using Box = Obb<S, 3>;

/// The 3D worlds name the same shapes, so that the compiler instantiates only one.
using Bodies = World<S, 3, Sphere, Capsule, Obb, BodyHeightField, BallJoint, WheelJoint>;

inline BodyOptions<S, 3> fixed_body() {
  BodyOptions<S, 3> options;
  options.motion = BodyMotion::fixed;
  return options;
}

/// A body and the colour to draw it in.
struct Drawn {
  BodyId id;
  Colour colour;

  void draw(const Bodies& world, Picture& picture) const {
    world.visit(id, [&]<class Shape>(const BodyInfo&, const Shape& shape) {
      draw_solid(picture, shape, colour);
      if constexpr (std::is_same_v<Shape, Box>) detent::draw(picture, shape, ink);
    });
  }
};

}  // namespace samples
