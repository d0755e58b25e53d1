// SPDX-License-Identifier: MIT
#pragma once

#include "detent/draw/box.hpp"
#include "detent/draw/flat.hpp"
#include "detent/draw/round.hpp"
#include "detent/draw/surface.hpp"
#include "detent/dynamics/world.hpp"

namespace detent {

/// Colours of bodies: by how they move, and whether they sleep.
struct ColourByState {
  Colour awake = palette_colour(0);
  Colour asleep = palette_colour(7);
  Colour kinematic = palette_colour(2);
  Colour fixed = palette_colour(1);
  Colour sensor = palette_colour(3);

  template <class Shape>
  [[nodiscard]] constexpr Colour operator()(const BodyInfo& body, const Shape&) const noexcept {
    if (body.is_sensor) return sensor;
    if (body.motion == BodyMotion::fixed) return fixed;
    if (body.motion == BodyMotion::kinematic) return kinematic;
    return body.is_asleep ? asleep : awake;
  }
};

/// Draws every body of a world, in order of index, and every part of a compound, in the colour
/// `colours(info, shape)`; the colour functions of scenes work, too. The world does not change.
template <class Sink, class Storage, Scalar S, int N, class... Parts, class Colours = ColourByState>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const BasicWorld<Storage, S, N, Parts...>& world,
                    const Colours& colours = {}) {
  world.for_each(
      [&](const BodyInfo& body, const auto& shape) { draw(sink, shape, colours(body, shape)); });
}
/// Draws their surfaces, in 3D.
template <class Sink, class Storage, Scalar S, class... Parts, class Colours = ColourByState>
requires DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const BasicWorld<Storage, S, 3, Parts...>& world,
                          const Colours& colours = {}) {
  world.for_each([&](const BodyInfo& body, const auto& shape) {
    draw_solid(sink, shape, colours(body, shape));
  });
}

}  // namespace detent
