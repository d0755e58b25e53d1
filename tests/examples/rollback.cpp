// SPDX-License-Identifier: MIT
// A rollback loop: play on with a prediction of the other player's input. When the real input of an
// earlier frame arrives, go back to that frame and play it again.
#include <array>

#include <detent/scene/sync_test.hpp>
using namespace detent;

using Vec3 = Vec<q16_16, 3>;
using Arena = Scene<q16_16, 3, Sphere>;
using Inputs = std::array<int, 2>;  // how far each player moves
constexpr std::array players{ObjectId{0, 1}, ObjectId{1, 2}};

void simulate(Arena& arena, const Inputs& inputs) {
  for (std::size_t i = 0; i < 2; ++i) arena.move(players[i], Vec3{q16_16(inputs[i]), {}, {}});
  for (const auto& [a, b] : arena.overlaps()) arena.move(b, Vec3{{}, q16_16(1), {}});
}

int main() {
  Arena arena;
  arena.add(Sphere{Vec3{}, q16_16(1)});
  arena.add(Sphere{Vec3{q16_16(20), {}, {}}, q16_16(1)});
  Arena truth = arena;
  std::vector<Arena> saved;  // the arena before each frame
  std::vector<Inputs> inputs;
  constexpr int delay = 3;  // frames until the other player's input arrives
  const auto other = [](int frame) { return frame % 5 == 0 ? -2 : 0; };
  for (int frame = 0; frame < 30; ++frame) {
    if (const int late = frame - delay; late >= 0 && other(late) != 0) {
      arena = saved[static_cast<std::size_t>(late)];
      inputs[static_cast<std::size_t>(late)][1] = other(late);
      for (auto i = static_cast<std::size_t>(late); i < inputs.size(); ++i) {
        saved[i] = arena;
        simulate(arena, inputs[i]);
      }
    }
    saved.push_back(arena);
    inputs.push_back({1, 0});  // guess: he stands still
    simulate(arena, inputs.back());
    simulate(truth, {1, frame < 30 - delay ? other(frame) : 0});
  }
  return digest(arena) == digest(truth) ? 0 : 1;
}
