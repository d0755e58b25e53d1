// SPDX-License-Identifier: MIT
// A small game. `./dev size compile` measures its compile time and its frame time. Players walk
// over hills, look around and push crates, balls bounce, and every eight frames the world goes back
// by three. Prints a digest of all frames, the same from every compiler at every optimization
// level; with --time, the microseconds per frame, the least of many batches.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "detent/number/literals.hpp"
#include "detent/scene/snapshot.hpp"

using namespace detent;
using namespace detent::literals;

namespace {

using S = q16_16;
using Vec3 = Vec<S, 3>;
using Arena = Scene<S, 3, Sphere, Aabb, Capsule, Triangle>;

constexpr auto down = -Direction<S, 3>::along(1);

enum Layer : std::uint32_t { ground = 1, crate = 2, ball = 4, player = 8 };

constexpr Vec3 sum(const Vec3& a, const Vec3& b) noexcept { return nearest_to<S>(a + b); }

/// Draws the same random numbers on every machine.
class Dice {
 public:
  /// A number from -n to n, in sixteenths.
  S operator()(int n) noexcept {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    const auto drawn = (state_ >> 33) % static_cast<std::uint64_t>(32 * n + 1);
    return quotient_floor<S>(S(static_cast<int>(drawn) - 16 * n), 16);
  }
  Vec3 around(const Vec3& center, int n) noexcept {
    const S x = (*this)(n), y = (*this)(n);
    return sum(center, {x, y, (*this)(n)});
  }

 private:
  std::uint64_t state_ = 1;
};

class Game {
 public:
  Game() {
    Dice dice;
    add_hills(dice);
    for (int i = 0; i < 16; ++i) {
      const Vec3 min = dice.around({{}, S(2), {}}, 16);
      add(Aabb{min, sum(min, {S(2), S(2), S(2)})}, crate);
    }
    for (auto& speed : speeds_) {
      add(Sphere{dice.around({{}, S(12), {}}, 12), S(1)}, ball);
      speed = dice.around({}, 1);
    }
    for (int i = 0; i < 4; ++i) {
      const Vec3 foot = dice.around({}, 12);
      add(Capsule{foot, sum(foot, {{}, S(1), {}}), 0.5_q16_16}, player);
    }
    arena_.optimize();
  }

  void step(int frame) {
    for (const ObjectId& id : ids_) {
      if (const auto walker = arena_.shape<Capsule<S, 3>>(id)) walk(id, *walker, frame);
    }
    std::size_t i = 0;
    for (const ObjectId& id : ids_) {
      if (const auto sphere = arena_.shape<Sphere<S, 3>>(id)) bounce(id, *sphere, speeds_[i++]);
    }
    for (const auto& [first, second] : arena_.overlaps()) {
      arena_.move(second, {{}, 0.125_q16_16, {}});
      arena_.set_user(first, arena_.info(first)->user + 1);
    }
    if (frame % 8 == 0) {
      saved_ = snapshot(arena_);
      saved_speeds_ = speeds_;
    }
    if (frame % 8 == 3 && restore(arena_, saved_) == Restored::yes) speeds_ = saved_speeds_;
    digest_.add(digest(arena_), seen_);
  }

  [[nodiscard]] std::uint64_t digest_of_frames() const { return digest_.value(); }

 private:
  template <class Shape>
  void add(const Shape& shape, Layer layer) {
    const Motion motion = layer == ground ? Motion::fixed : Motion::moving;
    ids_.push_back(arena_.add(shape, {.layers = layer, .motion = motion}).value_or(no_object));
  }

  /// Squares of 8 by 8 units at different heights.
  void add_hills(Dice& dice) {
    std::array<Vec3, 49> points;
    for (int i = 0; i < 49; ++i) {
      points[static_cast<std::size_t>(i)] =
          sum({S(8 * (i % 7) - 24), S(-8), S(8 * (i / 7) - 24)}, {{}, dice(2), {}});
    }
    for (std::size_t i = 0; i < 42; ++i) {
      if (i % 7 == 6) continue;
      add(Triangle{points[i], points[i + 1], points[i + 7]}, ground);
      add(Triangle{points[i + 1], points[i + 8], points[i + 7]}, ground);
    }
  }

  /// Takes a step and drops to the ground if nothing is in the way; otherwise pushes the obstacle.
  void walk(const ObjectId& id, const Capsule<S, 3>& walker, int frame) {
    const auto heading = Direction<S, 3>::along(frame / 16 % 2 == 0 ? 0 : 2);
    const auto sight = arena_.nearest_hit(Ray{walker.b, heading, S(24)}, InLayers{crate | ball});
    if (sight && sight->distance < 1) arena_.move(sight->id, nearest_to<S>(heading * S(1)));
    seen_ += sight ? sight->id.index : 0u;

    const Vec3 step = nearest_to<S>(heading * 0.125_q16_16);
    const auto next = translated(walker, step);
    if (arena_.any(next, InLayers{crate})) return;
    const auto fall = arena_.nearest(Ray{next.b, down, S(64)}, InLayers{ground});
    if (fall) arena_.move(id, {step.x, nearest_to<S>(S(2) - fall->distance), step.z});
  }

  /// Falls, and turns back at obstacles.
  void bounce(const ObjectId& id, const Sphere<S, 3>& sphere, Vec3& speed) {
    speed.y -= 0.015625_q16_16;
    std::array<Found<S>, 4> met;
    const auto others = [&](const ObjectInfo& object) { return object.id != id; };
    if (arena_.all(translated(sphere, speed), met, others) > 0) {
      speed = narrow_negative(speed);
      return;
    }
    arena_.move(id, speed);
    if (sphere.center.y < -16) arena_.replace(id, Sphere{Vec3{{}, S(16), {}}, sphere.radius});
  }

  Arena arena_;
  std::vector<ObjectId> ids_;
  std::array<Vec3, 16> speeds_, saved_speeds_;
  std::vector<std::byte> saved_;
  std::uint64_t seen_ = 0;
  Digest digest_;
};

}  // namespace

int main(int argc, char**) {
  Game game;
  if (argc < 2) {
    for (int frame = 0; frame < 1000; ++frame) game.step(frame);
    std::printf("%016llx\n", static_cast<unsigned long long>(game.digest_of_frames()));
    return 0;
  }
  constexpr int frames = 64;
  double least = 1e9;
  for (int batch = 0; batch < 20; ++batch) {
    const auto start = std::chrono::steady_clock::now();
    for (int frame = 0; frame < frames; ++frame) game.step(frame);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
    least = std::min(least, time.count() / frames);
  }
  std::printf("%.1f\n", least);
}
