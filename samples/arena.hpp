// SPDX-License-Identifier: MIT
#pragma once

// A match for two in 2D, for the samples of rollback and replay: two balls with jets push boxes
// around.

#include <detent/draw/draw.hpp>
#include <detent/dynamics/dynamics.hpp>
#include <detent/lockstep/lockstep.hpp>

#include "sample.hpp"

namespace samples {

/// The state that both players simulate. It never allocates, so a rollback copies plain bytes.
using Arena = BoundedWorld<Bounded<16>, S, 2, Sphere, Obb>;

/// A player's input, as bytes that packets and replays store.
struct Pad {
  std::int8_t x = 0, y = 0;
};
using Pads = FrameInputs<Pad, 8>;

/// Ids go up from 0: floor, two walls, a ceiling, two players and eight boxes.
inline constexpr std::uint32_t first_player = 4, first_box = 6, body_count = 14;

inline Obb<S, 2> arena_box(std::uint32_t index) {
  const auto box = [](S x, S y, S half_width, S half_height) {
    return Obb<S, 2>{{x, y}, {half_width, half_height}, {}};
  };
  switch (index) {
    case 0:
      return box({}, -0.5_q16_16, 6_q16_16, 0.5_q16_16);
    case 1:
      return box(-6.25_q16_16, 4_q16_16, 0.25_q16_16, 5_q16_16);
    case 2:
      return box(6.25_q16_16, 4_q16_16, 0.25_q16_16, 5_q16_16);
    case 3:
      return box({}, 8.75_q16_16, 6_q16_16, 0.25_q16_16);
    default:
      break;
  }
  const auto i = static_cast<int>(index - first_box);
  return box(quotient_nearest<S>(i % 2 * 2 - 1, 2), saturate_to<S>(i / 2 + 0.45_q16_16),
             0.45_q16_16, 0.45_q16_16);
}
inline constexpr S player_radius = 0.6_q16_16;

inline Arena new_arena() {
  Arena arena;
  BodyOptions<S, 2> wall, light;
  wall.motion = BodyMotion::fixed;
  light.density = 0.5_q16_16;
  for (std::uint32_t i = 0; i < first_player; ++i) arena.add(arena_box(i), wall);
  for (const int side : {-1, 1}) {
    arena.add(Sphere<S, 2>{{S(4 * side), 0.6_q16_16}, player_radius});
  }
  for (std::uint32_t i = first_box; i < body_count; ++i) arena.add(arena_box(i), light);
  return arena;
}

inline BodyId body_of(std::uint32_t index) { return {index, index + 1}; }

/// One frame: a function of the world and the inputs only.
inline void simulate(Arena& arena, const Pads& pads) {
  for (std::uint32_t i = 0; i < 2; ++i) {
    const Pad& pad = pads[i];
    arena.apply_force(body_of(first_player + i), {S(16 * pad.x), S(pad.y > 0 ? 22 : 0)});
  }
  arena.step();
}

/// The input of a player without keys.
inline Pad played(int player, int tick) {
  const int phase = tick + 37 * player, side = phase / (40 + 9 * player) % 3 - 1;
  return {static_cast<std::int8_t>(side), static_cast<std::int8_t>(phase / 25 % 3 == 0)};
}
inline Pad pad_of(const Input& input) {
  return {static_cast<std::int8_t>(input.across()), static_cast<std::int8_t>(input.along())};
}

/// Draws a 2D convex shape as a slab one unit thick around `center`.
struct Slab {
  Picture& picture;
  Point2 center;
  S shift{};  // along x, to show two worlds side by side

  void line(const Point2& from, const Point2& to, const Colour& colour) {
    // Counter-clockwise, so that the outside is lit.
    const Point2 u = nearest_to<S>(from - center), v = nearest_to<S>(to - center);
    const bool is_clockwise = u.x * v.y < u.y * v.x;
    const Point2 &a = is_clockwise ? to : from, &b = is_clockwise ? from : to;
    const S front = 0.5_q16_16, back = -0.5_q16_16;
    const auto at = [&](const Point2& p, S z) {
      return Point{saturate_to<S>(p.x + shift), p.y, z};
    };
    picture.triangle(at(center, front), at(a, front), at(b, front), colour);
    picture.triangle(at(a, front), at(a, back), at(b, back), colour);
    picture.triangle(at(a, front), at(b, back), at(b, front), colour);
    picture.line(at(a, front), at(b, front), ink);
  }
};

/// The shape of a 2D body, in its own frame around its center.
template <class World, class Shape>
void draw_slab(Picture& picture, const World& world, const BodyId& id, const Shape& shape, S shift,
               const Colour& colour) {
  Slab slab{picture, world.position(id), shift};
  draw(slab, placed(world.pose(id), shape), colour);
}

/// The arena, with marked bodies in red.
template <class IsMarked>
void draw_arena(Picture& picture, const Arena& arena, S shift, const Colour& walls,
                const IsMarked& is_marked) {
  for (std::uint32_t i = 0; i < body_count; ++i) {
    const auto id = body_of(i);
    if (i == first_player || i == first_player + 1) {
      const Sphere<S, 2> ball{{}, player_radius};
      draw_slab(picture, arena, id, ball, shift,
                is_marked(i)        ? red
                : i == first_player ? blue
                                    : green);
      const auto place = arena.position(id),
                 tip = nearest_to<S>(place +
                                     nearest_to<S>(arena.rotation(id).axis(0) * player_radius));
      const auto at = [&](const Point2& p) {
        return Point{saturate_to<S>(p.x + shift), p.y, 0.51_q16_16};
      };
      picture.line(at(place), at(tip), ink);
    } else {
      const Obb<S, 2> box{{}, arena_box(i).half_extents, {}};
      draw_slab(picture, arena, id, box, shift,
                is_marked(i)       ? red
                : i < first_player ? walls
                                   : yellow);
    }
  }
}

}  // namespace samples
