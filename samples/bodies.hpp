// SPDX-License-Identifier: MIT
#pragma once

// What samples with bodies share: their world, and how they are drawn.

#include <detent/draw/draw.hpp>
#include <detent/dynamics/dynamics.hpp>

#include "sample.hpp"

namespace samples {

using Ball = Sphere<S, 3>;
using Box = Obb<S, 3>;

/// Worlds of the samples in 3D name the same shapes, so that the compiler makes one of them.
using Bodies = World<S, 3, Sphere, Capsule, Obb, BodyHeightField, BallJoint, WheelJoint>;

inline BodyOptions<S, 3> fixed_body() {
  BodyOptions<S, 3> options;
  options.motion = BodyMotion::fixed;
  return options;
}

/// A body and what to draw for it: its shape, in its own frame.
template <class Shape>
struct Drawn {
  BodyId id;
  Shape shape;
  Colour colour;

  void draw(const Bodies& world, Picture& picture) const {
    const auto there = placed(world.pose(id), shape);
    draw_solid(picture, there, colour);
    if constexpr (std::is_same_v<Shape, Box>) detent::draw(picture, there, ink);
  }
};

/// Draws a convex shape of the plane as a slab, one unit thick, around `centre`.
struct Slab {
  Picture& picture;
  Point2 centre;
  S shift{};  // along x, to show two worlds next to each other

  void line(const Point2& a, const Point2& b, const Colour& colour) {
    const S front = 0.5_q16_16, back = -0.5_q16_16;
    const auto at = [&](const Point2& p, S z) {
      return Point{saturate_to<S>(p.x + shift), p.y, z};
    };
    picture.triangle(at(centre, front), at(a, front), at(b, front), colour);
    picture.triangle(at(a, front), at(a, back), at(b, back), colour);
    picture.triangle(at(a, front), at(b, back), at(b, front), colour);
    picture.line(at(a, front), at(b, front), ink);
  }
};

}  // namespace samples
