// SPDX-License-Identifier: MIT
// Does the game keep its whole state in its scene? A sync test plays every frame several times, as
// a rollback would, and names the first frame, object and field that differ.
#include <detent/scene/sync_test.hpp>
using namespace detent;

using Vec3 = Vec<q16_16, 3>;
using Arena = Scene<q16_16, 3, Sphere>;

int main() {
  Arena arena;
  const auto ball = arena.add(Sphere{Vec3{}, q16_16(1)}).value_or(no_object);
  q16_16 speed(0);  // a bug: it is neither in the scene nor in the inputs
  const auto simulate = [&](Arena& scene, q16_16 push) {
    speed += push;
    scene.move(ball, Vec3{speed, {}, {}});
  };
  SyncTest<Arena, q16_16> test(8);
  const auto desync = test.step(arena, q16_16(1), simulate);
  return desync && desync->frame == 0 && desync->object == ball &&
                 desync->field.view() == "object 0:1 (sphere) center.x"
             ? 0
             : 1;
}
