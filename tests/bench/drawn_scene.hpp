// SPDX-License-Identifier: MIT
#pragma once

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "bench/as_scalar.hpp"
#include "detent/scene/scene.hpp"
#include "support/random.hpp"

// Random scenes, and timing them.

namespace detent::bench {

inline constexpr int ray_count = 2000, rounds = 15;
inline constexpr double reach = 1000;  // coordinates of centers

/// The minimum CPU time of a few runs, in microseconds.
class Timer {
 public:
  template <class F>
  void time(const F& f) {
    const double start = now();
    f();
    least_ = std::min(least_, now() - start);
  }
  [[nodiscard]] double least() const { return least_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e6 + static_cast<double>(time.tv_nsec) / 1e3;
  }

  double least_ = 1e12;
};

/// The drawn scene, on a grid that every scalar has.
struct Drawn {
  struct Item {
    Obb<double, 3> box;  // its first half extent is the radius of a ball
    bool is_ball;
  };
  std::vector<Item> items;
  std::vector<Ray<double, 3>> rays;
  std::vector<std::vector<std::pair<std::uint32_t, Vec<double, 3>>>> moves;  // per round

  /// Objects fill the same fraction of the world, whatever their number.
  Drawn(int count, std::uint64_t seed) : random_(seed) {
    const double size = 0.7 * reach / std::cbrt(count);
    for (int i = 0; i < count; ++i) {
      items.push_back({{point(reach), extents(size), rotation()}, random_.coin()});
    }
    for (int i = 0; i < ray_count; ++i) {
      const auto from = point(reach), to = point(reach);
      const auto unit = *normalize(as<q16_16>(to - from));
      rays.push_back({from, Direction<double, 3>::assume_unit(as_vec<double>(unit.vec())), 4000});
    }
    moves.resize(rounds);
    for (auto& round : moves) {
      for (int i = 0; i < count / 10; ++i) {
        const auto which = random_.below(static_cast<std::uint64_t>(count));
        round.emplace_back(static_cast<std::uint32_t>(which), point(size / 10));
      }
    }
  }

 private:
  double length(double low, double high) {
    return static_cast<double>(random_.between(std::lround(low * 256), std::lround(high * 256))) /
           256;
  }
  Vec<double, 3> point(double limit) {
    const double x = length(-limit, limit), y = length(-limit, limit);
    return {x, y, length(-limit, limit)};
  }
  Vec<double, 3> extents(double size) {
    const double x = length(size / 4, size), y = length(size / 4, size);
    return {x, y, length(size / 4, size)};
  }
  Rotation<double, 3> rotation() {
    const auto angle = [this] {
      return Angle<q16_16>::from_raw(static_cast<std::uint32_t>(random_.next()));
    };
    const auto x = angle(), y = angle();
    const auto turn = Rotation<q16_16, 3>::from_euler(x, y, angle());
    std::array<Direction<double, 3>, 3> axes;
    for (int i = 0; i < 3; ++i) {
      axes[static_cast<std::size_t>(i)] =
          Direction<double, 3>::assume_unit(as_vec<double>(turn.axis(i).vec()));
    }
    return Rotation<double, 3>::from_axes(axes);
  }

  test::Random random_;
};

/// Prints what measure(S()) returns for q16_16, which is the result, and for `float`.
template <class Measure>
auto print_scalars(int count, const Measure& measure) {
  const auto fixed = measure(q16_16());
  print(count, "q16_16", fixed);
  print(count, "float", measure(0.0F));
  return fixed;
}

template <Scalar S>
void add(Scene<S, 3, Sphere, Obb>& scene, const Drawn& drawn) {
  for (const auto& [box, is_ball] : drawn.items) {
    const Obb<S, 3> shape{as<S>(box.center), as<S>(box.half_extents), as<S>(box.rotation)};
    if (is_ball) {
      scene.add(Sphere<S, 3>{shape.center, shape.half_extents.x});
    } else {
      scene.add(shape);
    }
  }
}

}  // namespace detent::bench
