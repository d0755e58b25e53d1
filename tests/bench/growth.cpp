// SPDX-License-Identifier: MIT
//
// usage: detent-bench-growth NAME [--peers] [--most OBJECTS] [--threads]
// Times scenes of 100 to OBJECTS (100,000) random spheres and boxes: rays, regions, pairs, changes,
// loading and snapshots, in q16_16. --peers adds float and Bullet; --threads adds rays on one and
// two threads, and shadow rays singly and in one call. Prints rows "question,size,NAME,time" in
// nanoseconds, each the median of a few rounds. Fails if a q16_16 result is not golden.
// tests/bench/engines makes a table of the rows.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

#include "bench/drawn_scene.hpp"
#include "bench/snapshots.hpp"
#if DETENT_BENCH_BULLET
#include "bench/bullet_scene.hpp"
#endif

namespace detent::bench {
namespace {

/// The median CPU time of a few runs, in nanoseconds.
class Median {
 public:
  template <class F>
  void time(const F& f) {
    const double start = now();
    f();
    times_.push_back(now() - start);
  }
  [[nodiscard]] double value() {
    const auto middle = times_.begin() + static_cast<std::ptrdiff_t>(times_.size() / 2);
    std::nth_element(times_.begin(), middle, times_.end());
    return *middle;
  }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
  }

  std::vector<double> times_;
};

void print(const char* question, std::size_t size, const char* who, double time) {
  std::printf("%s,%zu,%s,%.1f\n", question, size, who, time);
  std::fflush(stdout);
}

constexpr std::size_t changes = 512;
constexpr double region_radius = 100;

/// The results, to be compared with golden counts.
struct Counts {
  std::size_t hits = 0, in_regions = 0, pairs = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

/// Fewer rounds for large scenes.
int rounds_of(std::size_t size) { return size > 200'000 ? 3 : size > 20'000 ? 5 : 9; }

std::vector<std::uint32_t> draw_changes(std::size_t size) {
  test::Random random(3);
  std::vector<std::uint32_t> list(changes);
  for (auto& i : list) i = static_cast<std::uint32_t>(random.below(size));
  return list;
}

template <Scalar S>
Counts measure(const Drawn& drawn, const char* who) {
  const std::size_t size = drawn.items.size();
  const int count = rounds_of(size);
  Counts counts;
  Scene<S, 3, Sphere, Obb> scene;
  Median load, optimize, nearest, any, region, pairs, change, move;
  for (int i = 0; i < (count + 1) / 2; ++i) {
    scene = {};
    load.time([&] { add(scene, drawn); });
    optimize.time([&] { scene.optimize(); });
  }
  std::vector<Ray<S, 3>> rays;
  for (const auto& ray : drawn.rays) rays.push_back(as<S>(ray));
  std::array<Found<S>, 64> room;
  for (int i = 0; i < count; ++i) {
    nearest.time([&] {
      counts.hits = 0;
      for (const auto& ray : rays) counts.hits += scene.nearest(ray) ? 1u : 0u;
    });
    any.time([&] {
      for (const auto& ray : rays) counts.hits -= scene.any(ray) ? 1u : 0u;
    });
    if (counts.hits != 0) std::puts("any and nearest disagree"), std::exit(1);
    for (const auto& ray : rays) counts.hits += scene.any(ray) ? 1u : 0u;
    region.time([&] {
      counts.in_regions = 0;
      for (const auto& ray : rays) {
        const Sphere<S, 3> sphere{ray.origin, as_number<S>(region_radius)};
        counts.in_regions += scene.all(sphere, std::span(room));
      }
    });
    pairs.time([&] { counts.pairs = scene.overlaps().size(); });
  }
  // Objects come and go at the positions of others, so the density of the scene is constant.
  for (int i = 0; i < count; ++i) {
    move.time([&] {
      for (const auto k : draw_changes(size)) {
        scene.move({k, k + 1}, as<S>(drawn.moves[0][k % drawn.moves[0].size()].second));
      }
    });
  }
  const auto places = draw_changes(size);
  std::vector<ObjectId> ids(size);
  scene.for_each([&](const ObjectInfo& info, const auto&) { ids[info.id.index] = info.id; });
  for (int i = 0; i < count; ++i) {
    change.time([&] {
      for (const auto k : places) {
        const auto& box = drawn.items[k].box;
        scene.remove(ids[k]);
        ids[k] = scene.add(Sphere<S, 3>{as<S>(box.center), as_number<S>(box.half_extents.x)})
                     .value_or(no_object);
      }
    });
  }
  const auto print_time = [&](const char* question, Median& median, double calls) {
    print(question, size, who, median.value() / calls);
  };
  print_time("nearest", nearest, ray_count);
  print_time("any", any, ray_count);
  print_time("region", region, ray_count);
  print_time("pairs", pairs, 1);
  print_time("move", move, changes);
  print_time("remove and add", change, changes);
  print_time("load", load, 1);
  print_time("optimize", optimize, 1);
  return counts;
}

#if DETENT_BENCH_BULLET

/// Bullet's regions and pairs use bounding boxes; only its rays test the shapes.
void measure_bullet(const Drawn& drawn) {
  const std::size_t size = drawn.items.size();
  const int count = size > 200'000 ? 1 : rounds_of(size);
  BulletWorld bullet;
  Median load, optimize, nearest, region;
  load.time([&] { bullet.add(drawn); });
  optimize.time([&] { bullet.broad_phase.optimize(); });
  struct Counting : btBroadphaseAabbCallback {
    std::size_t count = 0;
    bool process(const btBroadphaseProxy*) override { return ++count > 0; }
  } counting;
  for (int i = 0; i < count; ++i) {
    nearest.time([&] {
      for (const auto& ray : drawn.rays) {
        const auto from = as_bullet(ray.origin);
        const auto to = as_bullet(ray.origin + ray.max_distance * ray.direction.vec());
        btCollisionWorld::ClosestRayResultCallback closest(from, to);
        bullet.world.rayTest(from, to, closest);
      }
    });
    region.time([&] {
      for (const auto& ray : drawn.rays) {
        const auto center = as_bullet(ray.origin);
        const btVector3 radius(region_radius, region_radius, region_radius);
        bullet.broad_phase.aabbTest(center - radius, center + radius, counting);
      }
    });
  }
  print("nearest", size, "Bullet", nearest.value() / ray_count);
  print("region", size, "Bullet", region.value() / ray_count);
  print("load", size, "Bullet", load.value());
  print("optimize", size, "Bullet", optimize.value());
}

#endif

void print_snapshots(const char* who) {
  auto times = measure_snapshots<Median>();
  if (!times.is_right) std::puts("a snapshot is refused"), std::exit(1);
  print("save", 1000, who, times.save.value());
  print("restore", 1000, who, times.load.value());
  print("copy", 1000, who, times.copy.value());
}

/// Wall-clock nanoseconds per ray with this many threads that share one scene.
void measure_threads(const Drawn& drawn, const char* who) {
  Scene<q16_16, 3, Sphere, Obb> scene;
  add(scene, drawn);
  scene.optimize();
  std::vector<Ray<q16_16, 3>> rays;
  for (const auto& ray : drawn.rays) rays.push_back(as<q16_16>(ray));
  constexpr int passes = 100;
  std::array<std::vector<double>, 2> times;
  for (int round = 0; round < 7; ++round) {
    for (std::size_t count = 1; count <= 2; ++count) {
      const auto cast = [&] {
        std::size_t hits = 0;
        for (int i = 0; i < passes; ++i) {
          for (const auto& ray : rays) hits += scene.nearest(ray) ? 1u : 0u;
        }
        if (hits == 0) std::exit(1);
      };
      const auto start = std::chrono::steady_clock::now();
      std::vector<std::thread> threads;
      for (std::size_t i = 0; i < count; ++i) threads.emplace_back(cast);
      for (auto& thread : threads) thread.join();
      const std::chrono::duration<double, std::nano> time =
          std::chrono::steady_clock::now() - start;
      times[count - 1].push_back(time.count() / (static_cast<double>(count) * passes * ray_count));
    }
  }
  for (std::size_t count = 1; count <= 2; ++count) {
    auto& list = times[count - 1];
    std::sort(list.begin(), list.end());
    print(count == 1 ? "ray by 1 thread" : "ray by 2 threads", drawn.items.size(), who,
          list[list.size() / 2]);
  }
}

/// Shadow rays in the order of a picture's pixels, one by one and in one call, alternating.
template <class Scene>
void measure_shadows(Scene& scene, const Drawn& drawn, const char* who) {
  using S = q16_16;
  using V = Vec<S, 3>;
  add(scene, drawn);
  scene.optimize();
  std::vector<Ray<S, 3>> shadows;
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 240; ++x) {
      const Ray<S, 3> ray{V{S(0), S(0), S(1500)},
                          *normalize(V{S((x - 120) * 8), S((80 - y) * 8), S(-1600)}), S(4000)};
      const auto hit = scene.nearest(ray);
      if (!hit) continue;
      const auto from = point_at(ray, nearest_to<S>(hit->distance - S::from_double(0.125)));
      shadows.push_back(
          {from, *normalize(nearest_to<S>(V{S(1200), S(1900), S(900)} - from)), S(2500)});
    }
  }
  const std::span<const Ray<S, 3>> rays(shadows);
  const auto answers = std::make_unique<bool[]>(rays.size());
  if constexpr (requires { scene.any_each(rays, std::span(answers.get(), 0)); }) {
    Median alone, together;
    for (int i = 0; i < 9; ++i) {
      std::ptrdiff_t hits = 0;
      alone.time([&] {
        for (const auto& ray : rays) hits += scene.any(ray) ? 1 : 0;
      });
      together.time([&] { scene.any_each(rays, std::span(answers.get(), rays.size())); });
      if (std::count(answers.get(), answers.get() + rays.size(), true) != hits) {
        std::puts("shadows alone and together disagree"), std::exit(1);
      }
    }
    const auto calls = static_cast<double>(rays.size());
    print("shadow alone", drawn.items.size(), who, alone.value() / calls);
    print("shadow together", drawn.items.size(), who, together.value() / calls);
  }
}

/// The hits, objects in regions and pairs of q16_16.
struct Golden {
  std::size_t size;
  Counts counts;
};
constexpr Golden golden[] = {{100, {1109, 868, 26}},
                             {1000, {1691, 3483, 293}},
                             {10000, {1952, 19123, 3157}},
                             {100000, {1996, 137579, 31678}},
                             {1000000, {2000, 1160537, 318312}}};

int run(const char* who, bool has_peers, std::size_t most, bool has_threads) {
  bool is_right = true;
  for (const auto& [size, expected] : golden) {
    if (size > most) continue;
    const Drawn drawn(static_cast<int>(size), 42);
    const auto found = measure<q16_16>(drawn, who);
    if (found != expected) {
      is_right = false;
      std::printf("golden: {%zu, {%zu, %zu, %zu}}\n", size, found.hits, found.in_regions,
                  found.pairs);
    }
    if (has_peers) {
      measure<float>(drawn, "float");
#if DETENT_BENCH_BULLET
      measure_bullet(drawn);
#endif
    }
    if (has_threads && (size == 1000 || size == 10000)) {
      Scene<q16_16, 3, Sphere, Obb> scene;
      measure_shadows(scene, drawn, who);
    }
    if (has_threads && size == 10000) measure_threads(drawn, who);
  }
  print_snapshots(who);
  return is_right ? 0 : 1;
}

}  // namespace
}  // namespace detent::bench

int main(int count, char** arguments) {
  if (count < 2 || arguments[1][0] == '-') {
    std::puts("usage: detent-bench-growth NAME [--peers] [--most OBJECTS] [--threads]");
    return 2;
  }
  bool has_peers = false, has_threads = false;
  std::size_t most = 100'000;
  for (int i = 2; i < count; ++i) {
    if (std::strcmp(arguments[i], "--peers") == 0) has_peers = true;
    if (std::strcmp(arguments[i], "--threads") == 0) has_threads = true;
    if (std::strcmp(arguments[i], "--most") == 0 && i + 1 < count) {
      most = std::strtoull(arguments[i + 1], nullptr, 10);
    }
  }
  return detent::bench::run(arguments[1], has_peers, most, has_threads);
}
