// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <detent/dynamics/dynamics.hpp>
#include <detent/lockstep/input_codec.hpp>
#include <detent/number/literals.hpp>
#include <detent/number/trigonometry.hpp>
#include <detent/scene/world.hpp>

// The rules of a slingshot match for two or four. Each side has a king in a castle of blocks, and a
// catapult for each of its players, who can shoot whenever it is ready. A king falls when an
// enemy's ball or the ground touches him, which ends the round and scores a point for the other
// side. Three points win. Players 0 and 2 are the left side, red; 1 and 3 are the right side, blue.
//
// Everything is a function of the seed and the inputs. A `Match` can be copied and has the same
// digest and steps on every machine, so detent::Session can play it over a network.

namespace slingshot {

using namespace detent::literals;
using S = detent::q16_16;
using Point = detent::Vec<S, 2>;
using Box = detent::Obb<S, 2>;
using Ball = detent::Sphere<S, 2>;
inline constexpr std::size_t room = 96;  // bodies
using Bodies = detent::BoundedWorld<detent::Bounded<room>, S, 2, detent::Sphere, detent::Obb>;

/// A player's input: where the catapult points, how far it is drawn, and whether it is released.
struct Pad {
  std::int16_t angle = 8192;  // in 1/65,536 of a turn; 0 is level, towards the enemy
  std::uint8_t power = 160;
  bool fire = false;
};

inline constexpr std::int16_t lowest_angle = -2048, highest_angle = 15'360;
inline constexpr std::uint8_t least_power = 64;
inline constexpr std::uint16_t reload_ticks = 75, ball_ticks = 420, wind_ticks = 600;
inline constexpr std::uint16_t round_pause = 180, match_pause = 420;
inline constexpr std::uint8_t points_to_win = 3;
inline constexpr S speed_per_power = 0.0859375_q16_16;  // at most 22
inline constexpr std::size_t most_players = 4;
inline constexpr S catapult_xs[] = {9.5_q16_16, 6.2_q16_16};  // the second one is in front
inline constexpr S catapult_y = 2.6_q16_16, castle_x = 16_q16_16;
inline constexpr S king_half = 0.45_q16_16, king_height = 0.7_q16_16, ball_radius = 0.45_q16_16;
inline constexpr S field_end = 30_q16_16;

enum class Kind : std::uint8_t { none, rock, wood, stone, king, ball };

/// A body of the match, at the index of its id.
struct Piece {
  detent::BodyId id{};
  Kind kind = Kind::none;
  std::uint8_t owner = 0;
  std::uint16_t age = 0;  // in ticks; balls only
  Point half{};           // a ball has its radius in both
};

template <class F>
constexpr void for_each_field(const Piece& piece, const F& f) {
  f("id", piece.id);
  f("kind", piece.kind);
  f("owner", piece.owner);
  f("age", piece.age);
}

struct Catapult {
  Pad pad{};
  std::uint16_t reload = 0;  // ticks until it is ready
};
template <class F>
constexpr void for_each_field(const Catapult& catapult, const F& f) {
  f("angle", catapult.pad.angle);
  f("power", catapult.pad.power);
  f("fire", catapult.pad.fire);
  f("reload", catapult.reload);
}

struct Side {
  std::uint8_t score = 0;
  bool is_fallen = false;
  detent::BodyId king{};
};
template <class F>
constexpr void for_each_field(const Side& side, const F& f) {
  f("score", side.score);
  f("is_fallen", side.is_fallen);
  f("king", side.king);
}

/// The state that a rollback restores.
struct Match {
  Bodies bodies;
  std::array<Piece, room> pieces{};
  std::array<Catapult, most_players> catapults{};
  std::array<Side, 2> sides{};
  std::size_t players;  // two or four
  std::uint64_t random = 0;
  std::uint32_t tick = 0;
  std::uint16_t round = 0;
  std::uint16_t pause = 0;  // ticks until the next round, after a king has fallen
  std::uint16_t hill = 0;   // one of six
  S wind{};                 // speed gained by balls per tick

  explicit constexpr Match(std::uint64_t seed, std::size_t players = 2);
};

template <class F>
constexpr void for_each_field(const Match& match, const F& f) {
  f("bodies", match.bodies);
  f("left catapult", match.catapults[0]);
  f("left", match.sides[0]);
  f("right catapult", match.catapults[1]);
  f("right", match.sides[1]);
  f("random", match.random);
  f("tick", match.tick);
  f("round", match.round);
  f("pause", match.pause);
  f("hill", match.hill);
  f("wind", match.wind);
  f("pieces", match.pieces);
  if (match.players == 2) return;
  f("left catapult in front", match.catapults[2]);
  f("right catapult in front", match.catapults[3]);
}

/// A random number below `count`, which must be small.
constexpr std::uint32_t draw(Match& match, std::uint32_t count) noexcept {
  match.random = match.random * 6364136223846793005u + 1442695040888963407u;
  return static_cast<std::uint32_t>((match.random >> 33) % count);
}

constexpr void keep(Match& match, std::optional<detent::BodyId> id, Kind kind, std::size_t owner,
                    const Point& half) {
  if (!id) return;  // no room: skip it
  match.pieces[id->index] = {*id, kind, static_cast<std::uint8_t>(owner), 0, half};
}

[[nodiscard]] constexpr detent::BodyOptions<S, 2> box_options(Kind kind) {
  detent::BodyOptions<S, 2> options;
  options.friction = 0.7_q16_16;
  if (kind == Kind::rock) options.motion = detent::BodyMotion::fixed;
  if (kind == Kind::stone) options.density = 2_q16_16;
  return options;
}

constexpr void add_box(Match& match, Kind kind, std::size_t owner, const Point& center,
                       const Point& half) {
  const auto id = match.bodies.add(Box{center, half, {}}, box_options(kind));
  keep(match, id, kind, owner, half);
  if (kind == Kind::king && id) match.sides[owner].king = *id;
}

/// The x axis of a side: 0 in the middle of the field, increasing towards the side's own castle.
[[nodiscard]] constexpr S mirrored(std::size_t side, S x) noexcept {
  return side == 0 ? detent::saturate_to<S>(-x) : x;
}

/// Stacks boxes on a castle's ground; `x` is measured from its middle, backwards.
class Mason {
 public:
  constexpr Mason(Match& match, std::size_t side) noexcept : match_(match), side_(side) {}

  constexpr void put(Kind kind, S x, S bottom, S half_width, S half_height) {
    const Point center{mirrored(side_, detent::saturate_to<S>(castle_x + x)),
                       detent::saturate_to<S>(bottom + half_height)};
    add_box(match_, kind, side_, center, {half_width, half_height});
  }
  constexpr void column(Kind kind, S x, S bottom, int count) {
    for (int i = 0; i < count; ++i) {
      put(kind, x, detent::saturate_to<S>(bottom + i), 0.5_q16_16, 0.5_q16_16);
    }
  }
  /// Two posts 1.8 high and a plank of 0.4 on them.
  constexpr void storey(S bottom, S reach) {
    for (std::size_t post = 0; post < 2; ++post) {
      put(Kind::wood, mirrored(post, reach), bottom, 0.3_q16_16, 0.9_q16_16);
    }
    put(Kind::wood, 0_q16_16, detent::saturate_to<S>(bottom + 1.8_q16_16),
        detent::saturate_to<S>(reach + 0.6_q16_16), 0.2_q16_16);
  }
  constexpr void king(S bottom) { put(Kind::king, 0_q16_16, bottom, king_half, king_height); }

 private:
  Match& match_;
  std::size_t side_;
};

/// Three castles with ground 0.8 high. Both sides get the same one.
constexpr void build_castle(Mason mason, std::uint32_t plan) {
  if (plan == 0) {  // a keep of three storeys
    mason.storey(0.8_q16_16, 1.4_q16_16);
    mason.king(3_q16_16);
    mason.storey(3_q16_16, 1.3_q16_16);
    mason.storey(5.2_q16_16, 1.1_q16_16);
    mason.column(Kind::stone, -2.9_q16_16, 0.8_q16_16, 4);
    mason.column(Kind::wood, 2.9_q16_16, 0.8_q16_16, 2);
  } else if (plan == 1) {  // a bridge between two towers
    mason.column(Kind::stone, -1.7_q16_16, 0.8_q16_16, 3);
    mason.column(Kind::stone, 1.7_q16_16, 0.8_q16_16, 3);
    mason.put(Kind::wood, 0_q16_16, 3.8_q16_16, 2.5_q16_16, 0.2_q16_16);
    mason.king(4.2_q16_16);
    mason.storey(4.2_q16_16, 1.5_q16_16);
    mason.column(Kind::wood, -0.7_q16_16, 6.4_q16_16, 2);
    mason.column(Kind::wood, 0.7_q16_16, 6.4_q16_16, 1);
    mason.column(Kind::wood, -3.3_q16_16, 0.8_q16_16, 4);
  } else {  // a pyramid of crates with the king on top, behind battlements
    for (int row = 0; row < 4; ++row) {
      for (int i = 0; i < 5 - row; ++i) {
        const auto x = detent::saturate_to<S>(i * 1.05_q16_16 - (4 - row) * 0.525_q16_16);
        mason.column(row == 0 ? Kind::stone : Kind::wood, x,
                     detent::saturate_to<S>(row + 0.8_q16_16), 1);
      }
    }
    mason.king(4.8_q16_16);
    mason.put(Kind::stone, -0.75_q16_16, 4.8_q16_16, 0.25_q16_16, 0.6_q16_16);
  }
}

[[nodiscard]] constexpr S catapult_x(std::size_t player) noexcept {
  return mirrored(player % 2, catapult_xs[player / 2]);
}

/// Clears the field and sets it up again.
constexpr void begin_round(Match& match) {
  for (Piece& piece : match.pieces) {
    if (piece.kind != Kind::none) match.bodies.remove(piece.id);
    piece = {};
  }
  add_box(match, Kind::rock, 0, {0_q16_16, -2_q16_16}, {field_end, 2_q16_16});
  match.hill = static_cast<std::uint16_t>(draw(match, 6));
  for (int step = 0; step <= match.hill; ++step) {
    const auto half = detent::saturate_to<S>(3.2_q16_16 - step * 0.45_q16_16);
    add_box(match, Kind::rock, 0, {0_q16_16, detent::saturate_to<S>(step + 0.5_q16_16)},
            {half, 0.5_q16_16});
  }
  const auto plan = draw(match, 3);
  for (std::size_t side = 0; side < 2; ++side) {
    add_box(match, Kind::rock, side, {mirrored(side, castle_x), 0.4_q16_16},
            {4.2_q16_16, 0.4_q16_16});
    for (std::size_t player = side; player < match.players; player += 2) {
      add_box(match, Kind::rock, side, {catapult_x(player), 0.6_q16_16}, {0.9_q16_16, 0.6_q16_16});
      match.catapults[player].reload = reload_ticks;
    }
    build_castle(Mason(match, side), plan);
    match.sides[side].is_fallen = false;
  }
  ++match.round;
}

constexpr void shoot(Match& match, std::size_t player) {
  using detent::nearest_to;
  const std::size_t side = player % 2;
  const Pad& pad = match.catapults[player].pad;
  const auto turn = static_cast<std::uint32_t>(static_cast<std::int32_t>(pad.angle)) << 16;
  const auto angle = detent::Angle<S>::from_raw(turn);
  const auto speed = nearest_to<S>(speed_per_power * int{pad.power});
  const Point velocity{mirrored(side, nearest_to<S>(-(speed * detent::cos(angle)))),
                       nearest_to<S>(speed * detent::sin(angle))};
  detent::BodyOptions<S, 2> options;
  options.density = 5_q16_16;
  options.restitution = 0.2_q16_16;
  options.angular_damping = 2_q16_16;
  options.velocity = velocity;
  const Ball ball{{catapult_x(player), catapult_y}, ball_radius};
  keep(match, match.bodies.add(ball, options), Kind::ball, side, {ball_radius, ball_radius});
  match.catapults[player].reload = reload_ticks;
}

/// A catapult shoots if it is released and ready.
constexpr void aim_and_shoot(Match& match, std::size_t player, Pad pad) {
  pad.angle = std::clamp(pad.angle, lowest_angle, highest_angle);
  pad.power = std::max(pad.power, least_power);
  Catapult& own = match.catapults[player];
  own.pad = pad;
  if (own.reload > 0) {
    --own.reload;
  } else if (pad.fire && match.pause == 0) {
    shoot(match, player);
  }
}

/// Wind pushes young balls; old balls are removed.
constexpr void tend_balls(Match& match) {
  for (Piece& piece : match.pieces) {
    if (piece.kind != Kind::ball) continue;
    const auto place = match.bodies.position(piece.id);
    if (++piece.age > ball_ticks || place.x > field_end || place.x < -field_end) {
      match.bodies.remove(piece.id);
      piece = {};
    } else if (piece.age < 180) {
      auto velocity = match.bodies.velocity(piece.id);
      velocity.x = detent::nearest_to<S>(velocity.x + match.wind);
      match.bodies.set_velocity(piece.id, velocity);
    }
  }
}

/// Kings touched by an enemy's ball or the ground in this step fall.
constexpr void judge(Match& match) {
  for (std::size_t i = 0; i < match.bodies.event_count(); ++i) {
    const auto event = match.bodies.event(i);
    if (!event.begins) continue;
    for (std::size_t side = 0; side < 2; ++side) {
      const auto king = match.sides[side].king;
      if (event.a != king && event.b != king) continue;
      const Piece& other = match.pieces[(event.a == king ? event.b : event.a).index];
      const bool is_hit = other.kind == Kind::ball && other.owner != side;
      match.sides[side].is_fallen |= is_hit || other.kind == Kind::rock;
    }
  }
  if (!match.sides[0].is_fallen && !match.sides[1].is_fallen) return;
  match.pause = round_pause;
  for (std::size_t side = 0; side < 2; ++side) {
    if (!match.sides[1 - side].is_fallen) continue;
    if (++match.sides[side].score == points_to_win) match.pause = match_pause;
  }
}

/// Steps one sixtieth of a second; `pads[player]` are the players' inputs.
template <class Pads>
constexpr void step(Match& match, const Pads& pads) {
  if (match.tick++ % wind_ticks == 0) {
    match.wind = detent::nearest_to<S>((static_cast<int>(draw(match, 13)) - 6) * 0.01_q16_16);
  }
  for (std::size_t i = 0; i < match.players; ++i) aim_and_shoot(match, i, pads[i]);
  tend_balls(match);
  match.bodies.step();
  if (match.pause == 0) {
    judge(match);
  } else if (--match.pause == 0) {
    for (const Side& side : match.sides) {
      if (side.score < points_to_win) continue;
      for (Side& each : match.sides) each.score = 0;
      break;
    }
    begin_round(match);
  }
}

constexpr Match::Match(std::uint64_t seed, std::size_t count)
    : players(count == most_players ? count : 2), random(seed) {
  draw(*this, 1);
  begin_round(*this);
}

}  // namespace slingshot

template <>
struct detent::InputCodec<slingshot::Pad>
    : detent::FieldCodec<&slingshot::Pad::angle, &slingshot::Pad::power, &slingshot::Pad::fire> {};
