// SPDX-License-Identifier: MIT
#pragma once

#include "detent/draw/sink.hpp"
#include "detent/shape/compound.hpp"

namespace detent {

/// Draws every part of a compound.
template <class Sink, class... Shapes>
constexpr void draw(Sink& sink, const Compound<Shapes...>& compound, const Colour& colour) {
  for_each_part(compound, [&](const auto& part) { draw(sink, part, colour); });
}
template <class Sink, class... Shapes>
constexpr void draw_solid(Sink& sink, const Compound<Shapes...>& compound, const Colour& colour) {
  for_each_part(compound, [&](const auto& part) { draw_solid(sink, part, colour); });
}

}  // namespace detent
