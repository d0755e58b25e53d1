// SPDX-License-Identifier: MIT
// A small game: two players walk, slide along walls, jump, climb stairs, ride a lift and a rotating
// disc, throw grenades that no wall is too thin for, and hurt each other if the blast has a free
// line of sight. It plays 20,000 frames with rollbacks. The digest at the end is the same with
// every compiler on every machine.
#include <array>
#include <cstdio>

#include <detent/number/literals.hpp>
#include <detent/scene/mover.hpp>
#include <detent/scene/sync_test.hpp>
using namespace detent;
using namespace detent::literals;

using S = q16_16;
using Vec3 = Vec<S, 3>;
using Box = Aabb<S, 3>;
using Arena = BoundedScene<Bounded<32, 2>, S, 3, Aabb, Obb, Capsule>;

constexpr std::uint32_t level = 1, person = 2;  // layers
constexpr S gravity = 0.01_q16_16, walk_speed = 0.12_q16_16, jump_speed = 0.25_q16_16;
constexpr S grenade_radius = 0.1_q16_16, blast_radius = 4_q16_16;

struct Player {
  Mover<S, 3, Capsule> body;
  Vec3 velocity;  // a frame
  ObjectId object;
  int health = 100;
  int deaths = 0;
  bool sees_other = false;
};
struct Grenade {
  Vec3 position;
  Vec3 velocity;
  int fuse = 0;  // frames left; 0 for none
};
struct Game {
  Arena arena;
  FrameId lift, disc;
  std::array<Player, 2> players;
  std::array<Grenade, 8> grenades;
  std::uint32_t frame = 0;
};
/// A player's input: x and z are -1, 0 or 1.
struct Pad {
  int x = 0, z = 0;
  bool jump = false, fire = false;
};
using Pads = std::array<Pad, 2>;

// The state that a rollback restores.
template <class F>
void for_each_field(const Player& player, const F& f) {
  f("body", player.body);
  f("velocity", player.velocity);
  f("health", player.health);
  f("deaths", player.deaths);
  f("sees_other", player.sees_other);
}
template <class F>
void for_each_field(const Grenade& grenade, const F& f) {
  f("position", grenade.position);
  f("velocity", grenade.velocity);
  f("fuse", grenade.fuse);
}
template <class F>
void for_each_field(const Game& game, const F& f) {
  f("arena", game.arena);
  f("players", game.players);
  f("grenades", game.grenades);
  f("frame", game.frame);
}

Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }
Capsule<S, 3> person_at(const Vec3& feet) {
  const auto up = [&](S height) { return nearest_to<S>(feet + Vec3{{}, height, {}}); };
  return {up(0.4_q16_16), up(1.4_q16_16), 0.4_q16_16};
}

Game new_game() {
  Game game;
  Arena& arena = game.arena;
  const auto wall = [&](const Box& box) { arena.add(box, {level, 0, Motion::fixed}); };
  wall({at(-20, -1, -20), at(20, 0, 20)});
  for (const int side : {-21, 20}) {
    wall({at(side, 0, -21), at(side + 1, 8, 21)});
    wall({at(-21, 0, side), at(21, 8, side + 1)});
  }
  wall({at(-20, 6, -20), at(20, 7, 20)});                       // the ceiling
  wall({at(-6, 0, -6), {next_up(S(-6)), 3_q16_16, 6_q16_16}});  // as thin as the grid
  for (int i = 0; i < 8; ++i) {                                 // stairs to a gallery
    const S top = quotient_nearest<S>(i + 1, 4);
    wall({{S(4 + i), {}, S(-12)}, {12_q16_16, top, S(-8)}});
  }
  wall({at(12, 0, -20), at(20, 2, 0)});
  const auto turn =
      Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(2), Angle<S>::turn(25, 360));
  arena.add(Obb<S, 3>{at(-12, -1, 12), at(6, 1, 4), turn}, {level, 0, Motion::fixed});  // a ramp

  game.lift = arena.add_frame({.translation = at(8, 0, 8)}).value_or(no_frame);
  arena.add(Box{at(-5, -1, -5), {5_q16_16, 0.1_q16_16, 5_q16_16}},
            {.layers = level, .frame = game.lift});
  game.disc = arena.add_frame({.translation = at(0, 0, -3)}).value_or(no_frame);
  arena.add(Obb<S, 3>{{}, {4_q16_16, 0.2_q16_16, 2_q16_16}, {}},
            {.layers = level, .frame = game.disc});

  for (int i = 0; i < 2; ++i) {
    Player& player = game.players[static_cast<std::size_t>(i)];
    player.body.shape = person_at(at(10 * i - 3, 1, 3));
    player.object = arena.add(player.body.shape, {.layers = person}).value_or(no_object);
  }
  return game;
}

/// The lift goes up and down, and the disc rotates.
void move_platforms(Game& game) {
  const auto phase = static_cast<int>(game.frame % 400);
  const S height = quotient_nearest<S>(phase < 200 ? phase : 400 - phase, 50);
  game.arena.move_frame(game.lift, {.translation = {8_q16_16, height, 8_q16_16}});
  const auto turn = Angle<S>::turn(static_cast<int>(game.frame % 600), 600);
  game.arena.move_frame(
      game.disc, {.translation = at(0, 0, -3),
                  .rotation = Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(1), turn)});
}

void move_player(Game& game, Player& player, const Pad& pad) {
  const bool grounded = player.body.ground.is_grounded;
  if (grounded) {
    player.velocity = {nearest_to<S>(walk_speed * pad.x), {}, nearest_to<S>(walk_speed * pad.z)};
    if (pad.jump) player.velocity.y = jump_speed;
  }
  player.velocity.y -= gravity;
  const auto not_itself = [&](const ObjectInfo& object) { return object.id != player.object; };
  const auto result = player.body.move(game.arena, player.velocity, {}, not_itself);
  player.velocity = clip_velocity(player.velocity, result);
  if (grounded && !player.body.ground.is_grounded) player.velocity += result.carried;
  game.arena.replace(player.object, player.body.shape);
}

void throw_grenade(Game& game, const Player& player, const Pad& pad) {
  for (Grenade& grenade : game.grenades) {
    if (grenade.fuse > 0) continue;
    const Vec3 forward{S(pad.x), {}, S(pad.z)};
    grenade.position = player.body.shape.b;
    grenade.velocity = nearest_to<S>(forward * 0.5_q16_16 + Vec3{{}, 0.2_q16_16, {}});
    grenade.fuse = 90;
    return;
  }
}

/// Hurts and throws back every player within reach of the blast who is not behind a wall.
void explode(Game& game, const Vec3& center) {
  for (Player& player : game.players) {
    const auto& body = player.body.shape;
    const S gap = distance(body, center);
    if (gap >= blast_radius) continue;
    if (game.arena.any(Segment{center, body.b}, InLayers{level})) continue;
    player.health -= floor_to<int>((blast_radius - gap) * 20);
    const auto away = normalize(body.b - center).value_or(Direction<S, 3>::along(1));
    player.velocity += nearest_to<S>(away * 0.3_q16_16 + Vec3{{}, 0.1_q16_16, {}});
    player.body.ground = {};
  }
}

/// A grenade flies to the first obstacle at any speed, and bounces.
void move_grenade(Game& game, Grenade& grenade) {
  if (grenade.fuse == 0) return;
  if (--grenade.fuse == 0) return explode(game, grenade.position);
  grenade.velocity.y -= gravity;
  const auto direction = normalize(grenade.velocity);
  if (!direction) return;
  const S way = length(grenade.velocity);
  const Sphere<S, 3> ball{grenade.position, grenade_radius};
  const auto hit = game.arena.nearest_hit(Cast{ball, *direction, way}, InLayers{level});
  if (!hit) {
    grenade.position += grenade.velocity;
    return;
  }
  const S before = nearest_to<S>(hit->distance - 0.01_q16_16);
  if (before > 0) grenade.position += nearest_to<S>(*direction * before);
  grenade.velocity = nearest_to<S>(half(reflect(grenade.velocity, hit->normal)));
}

void simulate(Game& game, const Pads& pads) {
  ++game.frame;
  move_platforms(game);
  for (std::size_t i = 0; i < 2; ++i) {
    Player& player = game.players[i];
    move_player(game, player, pads[i]);
    if (pads[i].fire) throw_grenade(game, player, pads[i]);
    if (player.health > 0) continue;
    player.health = 100;
    ++player.deaths;
    player.body = {person_at(at(0, 3, 14))};
    game.arena.replace(player.object, player.body.shape);
  }
  for (Grenade& grenade : game.grenades) move_grenade(game, grenade);
  const Segment sight{game.players[0].body.shape.b, game.players[1].body.shape.b};
  for (Player& player : game.players) {
    player.sees_other = !game.arena.any(sight, InLayers{level});
  }
}

/// The players change keys from time to time, always in the same way.
Pads pressed(std::uint64_t& random, Pads pads) {
  for (Pad& pad : pads) {
    random = random * 6364136223846793005u + 1442695040888963407u;
    const auto bits = static_cast<unsigned>(random >> 40);
    if (bits % 32 == 0)
      pad = {static_cast<int>(bits / 32 % 3) - 1, static_cast<int>(bits / 128 % 3) - 1};
    pad.jump = bits % 61 == 0;
    pad.fire = bits % 97 == 0;
  }
  return pads;
}

int main() {
  Game game = new_game();
  SyncTest<Game, Pads, 2> rollback;  // every frame is played three times
  std::uint64_t random = 1;
  Pads pads{};
  std::array<int, 5> seen{};  // checks that everything in the game happens
  for (int frame = 0; frame < 20000; ++frame) {
    pads = pressed(random, pads);
    if (const auto desync = rollback.step(game, pads, simulate)) {
      const auto name = desync->field.view();
      std::printf("frame %d: %.*s\n", frame, static_cast<int>(name.size()), name.data());
      return 1;
    }
    for (const Player& player : game.players) {
      const auto& ground = player.body.ground;
      seen[0] += ground.is_grounded && ground.frame == game.lift;
      seen[1] += ground.is_grounded && ground.frame == game.disc;
      seen[2] += player.sees_other;
      seen[3] += !ground.is_grounded;
    }
  }
  seen[4] = game.players[0].deaths + game.players[1].deaths;
  const auto result = world_digest(game);
  std::printf("lift %d, disc %d, sight %d, air %d, deaths %d, digest %016llx\n", seen[0], seen[1],
              seen[2], seen[3], seen[4], static_cast<unsigned long long>(result));
  for (const int count : seen) {
    if (count == 0) return 2;
  }
  return result == 0x22533ef29387d48du ? 0 : 3;
}
