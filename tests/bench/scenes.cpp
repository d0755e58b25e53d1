// SPDX-License-Identifier: MIT
//
// usage: detent-bench-scenes
// Times scenes of random spheres and boxes: rays, pairs after a tenth of them moved, snapshots.
// Compares them with Bullet on the same shapes and rays, and with float from the same source.
// Prints tables in Markdown. Fails if a q16_16 result is not golden.

#include <algorithm>
#include <cstdio>
#include <vector>

#include "bench/drawn_scene.hpp"
#include "bench/snapshots.hpp"
#if DETENT_BENCH_BULLET
#include "bench/bullet_scene.hpp"
#endif

namespace detent::bench {
namespace {

struct Measured {
  double build = 0, ray = 0, move = 0, pairs = 0;
  std::size_t hits = 0, overlaps = 0;
};

template <Scalar S>
Measured measure(const Drawn& drawn) {
  Measured result;
  Scene<S, 3, Sphere, Obb> scene;
  Timer build, cast, move, pairs;
  build.time([&] {
    add(scene, drawn);
    scene.optimize();
  });
  std::vector<Ray<S, 3>> rays;
  for (const auto& ray : drawn.rays) rays.push_back(as<S>(ray));
  for (const auto& moves : drawn.moves) {
    cast.time([&] {
      result.hits = 0;
      for (const auto& ray : rays) result.hits += scene.nearest(ray) ? 1u : 0u;
    });
    std::vector<std::pair<ObjectId, Vec<S, 3>>> steps;
    for (const auto& [i, by] : moves) steps.emplace_back(ObjectId{i, i + 1}, as<S>(by));
    move.time([&] {
      for (const auto& [id, by] : steps) scene.move(id, by);
    });
    pairs.time([&] { result.overlaps = scene.overlaps().size(); });
  }
  result.build = build.least();
  result.ray = cast.least() * 1000 / ray_count;
  result.move = move.least();
  result.pairs = pairs.least();
  return result;
}

#if DETENT_BENCH_BULLET

Measured measure_bullet(const Drawn& drawn) {
  Measured result;
  BulletWorld bullet;
  Timer build, cast, move, pairs;
  build.time([&] {
    bullet.add(drawn);
    bullet.broad_phase.optimize();
  });
  for (const auto& moves : drawn.moves) {
    cast.time([&] {
      result.hits = 0;
      for (const auto& ray : drawn.rays) {
        const auto from = as_bullet(ray.origin);
        const auto to = as_bullet(ray.origin + ray.max_distance * ray.direction.vec());
        btCollisionWorld::ClosestRayResultCallback closest(from, to);
        bullet.world.rayTest(from, to, closest);
        result.hits += closest.hasHit() ? 1u : 0u;
      }
    });
    move.time([&] {
      for (const auto& [i, by] : moves) {
        auto& place = bullet.objects.objects[i]->getWorldTransform();
        place.setOrigin(place.getOrigin() + as_bullet(by));
        bullet.world.updateSingleAabb(bullet.objects.objects[i].get());
      }
    });
    pairs.time([&] { bullet.broad_phase.calculateOverlappingPairs(&bullet.dispatcher); });
  }
  result.overlaps = static_cast<std::size_t>(
      bullet.broad_phase.getOverlappingPairCache()->getNumOverlappingPairs());
  result.build = build.least();
  result.ray = cast.least() * 1000 / ray_count;
  result.move = move.least();
  result.pairs = pairs.least();
  return result;
}

#endif

void print(int count, const char* who, const Measured& m) {
  std::printf("%d,%s,%zu,%.0f,%.1f,%.0f,%.0f,%zu\n", count, who, m.hits, m.ray, m.build / 1000,
              m.move, m.pairs, m.overlaps);
}

void print_snapshots() {
  const auto times = measure_snapshots<Timer>();
  std::printf("# 1,000 moving spheres: save %.1f us, restore %.1f us; copy %.1f us; %zu bytes%s\n",
              times.save.least(), times.load.least(), times.copy.least(), times.bytes,
              times.is_right ? "" : "; WRONG");
}

/// The hits and overlaps of q16_16.
struct Golden {
  int count;
  std::size_t hits, overlaps;
};
constexpr Golden golden[] = {
    {100, 1124, 24}, {1000, 1678, 287}, {10000, 1956, 3177}, {100000, 1997, 31706}};

}  // namespace
}  // namespace detent::bench

int main() {
  using namespace detent::bench;
  bool is_right = true;
  std::printf("objects,engine,hits of 2000,ns per ray,build ms,move a tenth us,pairs us,pairs\n");
  for (const auto& [count, hits, overlaps] : golden) {
    const Drawn drawn(count, 42);
    const auto fixed = print_scalars(count, [&]<class S>(S) { return measure<S>(drawn); });
#if DETENT_BENCH_BULLET
    print(count, "Bullet", measure_bullet(drawn));
#endif
    if (fixed.hits != hits || fixed.overlaps != overlaps) {
      is_right = false;
      std::printf("golden: {%d, %zu, %zu}\n", count, fixed.hits, fixed.overlaps);
    }
  }
  print_snapshots();
  return is_right ? 0 : 1;
}
