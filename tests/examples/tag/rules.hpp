// SPDX-License-Identifier: MIT
// rules.hpp: tag for two players in a walled field, all but main()
#ifndef TAG_RULES_HPP
#define TAG_RULES_HPP

#include <array>

#include <detent/lockstep/lockstep.hpp>
#include <detent/number/literals.hpp>
#include <detent/scene/scene.hpp>

namespace tag {

using namespace detent;
using namespace detent::literals;
using Vec2 = Vec<q16_16, 2>;
using Body = Sphere<q16_16, 2>;
using Field = BoundedScene<Bounded<16>, q16_16, 2, Sphere, Aabb>;

/// What a player presses: x and y in -1, 0 and 1.
struct Pad {
  std::int8_t x = 0, y = 0;
};

struct Game {
  Field field;
  std::array<ObjectId, 2> players;
  std::array<int, 2> points = {};
  int it = 0;    // the player who has to catch the other
  int rest = 0;  // frames until a touch counts again
};
template <class F>
void for_each_field(const Game& game, const F& f) {
  f("field", game.field);
  f("points", game.points);
  f("it", game.it);
  f("rest", game.rest);
}

constexpr std::uint32_t wall = 1, person = 2;  // layers

inline Game new_game() {
  Game game;
  const auto block = [&](q16_16 x, q16_16 y, q16_16 width, q16_16 height) {
    const Vec2 corner{x, y};
    game.field.add(Aabb{corner, nearest_to<q16_16>(corner + Vec2{width, height})},
                   {.layers = wall, .motion = Motion::fixed});
  };
  block(-11_q16_16, -6_q16_16, 22_q16_16, 1_q16_16);
  block(-11_q16_16, 5_q16_16, 22_q16_16, 1_q16_16);
  block(-11_q16_16, -5_q16_16, 1_q16_16, 10_q16_16);
  block(10_q16_16, -5_q16_16, 1_q16_16, 10_q16_16);
  block(-1_q16_16, -2_q16_16, 2_q16_16, 4_q16_16);
  for (int i = 0; i < 2; ++i) {
    const Body body{Vec2{q16_16(12 * i - 6), q16_16(0)}, 0.5_q16_16};
    game.players[static_cast<std::size_t>(i)] =
        game.field.add(body, {.layers = person}).value_or(no_object);
  }
  return game;
}

/// Moves one player by one axis, unless a wall is there.
inline void walk(Game& game, ObjectId player, const Vec2& by) {
  auto body = game.field.shape<Body>(player);
  if (!body) return;
  body->center = nearest_to<q16_16>(body->center + by);
  if (!game.field.any(*body, InLayers{wall})) game.field.replace(player, *body);
}

/// One frame.
template <class Inputs>
void simulate(Game& game, const Inputs& pads) {
  for (std::size_t i = 0; i < 2; ++i) {
    // The hunter is a little faster.
    const q16_16 speed = game.it == static_cast<int>(i) ? 0.15_q16_16 : 0.125_q16_16;
    walk(game, game.players[i], {nearest_to<q16_16>(pads[i].x * speed), {}});
    walk(game, game.players[i], {{}, nearest_to<q16_16>(pads[i].y * speed)});
  }
  if (game.rest > 0) {
    --game.rest;
    return;
  }
  const auto hunter = game.field.shape<Body>(game.players[static_cast<std::size_t>(game.it)]);
  const auto other = game.field.shape<Body>(game.players[static_cast<std::size_t>(1 - game.it)]);
  if (hunter && other && overlaps(*hunter, *other)) {
    ++game.points[static_cast<std::size_t>(game.it)];
    game.it = 1 - game.it;
    game.rest = 60;
  }
}

}  // namespace tag

template <>
struct detent::InputCodec<tag::Pad> : detent::FieldCodec<&tag::Pad::x, &tag::Pad::y> {};

#endif
