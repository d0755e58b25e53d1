// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "detent/scene/snapshot.hpp"
#include "support/random.hpp"

namespace detent::bench {

template <class Clock>
struct SnapshotTimes {
  Clock save, load, copy;
  std::size_t bytes = 0;
  bool is_right = true;  // every snapshot was restored
};

/// Saves 1,000 moving spheres, restores them eight frames later, and copies them.
template <class Clock>
SnapshotTimes<Clock> measure_snapshots() {
  using V = Vec<q16_16, 3>;
  Scene<q16_16, 3, Sphere> scene;
  test::Random random(1);
  const auto draw = [&] { return q16_16(random.between(-500, 500)); };
  for (int i = 0; i < 1000; ++i) {
    const auto x = draw(), y = draw();
    scene.add(Sphere<q16_16, 3>{{x, y, draw()}, q16_16(3)});
  }
  const auto before = scene;
  const auto early = snapshot(scene);
  for (std::uint32_t i = 0; i < 8000; ++i) {
    const auto step = static_cast<int>(i % 1000);
    scene.move({i % 1000, i % 1000 + 1},
               V{q16_16(step % 3 - 1), q16_16(step % 5 - 2), q16_16(1 - step % 2 * 2)});
  }
  const auto late = snapshot(scene);
  std::vector<std::byte> room(early.size());
  SnapshotTimes<Clock> times;
  times.bytes = early.size();
  for (int i = 0; i < 2000; ++i) {
    times.save.time([&] { snapshot(scene, room); });
    times.load.time(
        [&] { times.is_right &= restore(scene, i % 2 == 0 ? early : late) == Restored::yes; });
    auto other = scene;
    times.copy.time([&] { other = before; });
  }
  return times;
}

}  // namespace detent::bench
