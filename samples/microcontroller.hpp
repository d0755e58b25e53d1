// SPDX-License-Identifier: MIT
#pragma once

// A world in static memory: no heap, no floating point, no other library. microcontroller.cpp shows
// it; microcontroller_bare.cpp runs it on a Cortex-M3.

#include <detent/dynamics/dynamics.hpp>
#include <detent/number/literals.hpp>

namespace microcontroller {

using namespace detent::literals;
using S = detent::q16_16;

/// Room for sixteen bodies and their contacts.
using Toy = detent::BoundedWorld<detent::Bounded<16>, S, 2, detent::Sphere, detent::Obb>;

constexpr std::uint32_t fixed_count = 3, box_count = 7, ball_count = 6;
constexpr S radius = 0.4_q16_16;

/// A floor, two ramps and a wall of boxes. Body `i`, in its own frame on request.
constexpr detent::Obb<S, 2> box(std::uint32_t i) {
  const auto turned = [](int degrees) {
    return detent::Rotation<S, 2>::from_angle(detent::Angle<S>::from_degrees(S(degrees)));
  };
  if (i == 0) return {{0_q16_16, -0.5_q16_16}, {7_q16_16, 0.5_q16_16}, {}};
  if (i == 1) return {{-3_q16_16, 5_q16_16}, {2.6_q16_16, 0.15_q16_16}, turned(-15)};
  if (i == 2) return {{2.6_q16_16, 3.2_q16_16}, {2.6_q16_16, 0.15_q16_16}, turned(15)};
  const auto k = static_cast<int>(i - fixed_count);
  return {
      {S(k % 3 - 4), detent::saturate_to<S>(k / 3 + 0.45_q16_16)}, {0.45_q16_16, 0.45_q16_16}, {}};
}

constexpr void build(Toy& toy) {
  detent::BodyOptions<S, 2> fixed;
  fixed.motion = detent::BodyMotion::fixed;
  for (std::uint32_t i = 0; i < fixed_count + box_count; ++i) {
    toy.add(box(i), i < fixed_count ? fixed : detent::BodyOptions<S, 2>());
  }
}

/// One tick. A ball is added every 30 ticks, up to six.
constexpr void step(Toy& toy, std::uint32_t tick) {
  if (tick % 30 == 0 && tick / 30 < ball_count) {
    detent::BodyOptions<S, 2> rubber;
    rubber.restitution = 0.3_q16_16;
    rubber.density = 2_q16_16;
    toy.add(detent::Sphere<S, 2>{{-5_q16_16, 7_q16_16}, radius}, rubber);
  }
  toy.step();
}

}  // namespace microcontroller
