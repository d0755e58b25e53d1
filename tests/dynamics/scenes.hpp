// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "detent/dynamics/snapshot.hpp"
#include "dynamics/stage.hpp"

namespace detent::test {

/// A box as in `box_of`, rotated by an angle in 2D.
template <Scalar S, int N>
Obb<S, N> box_at(double x, double y, double half_width, double half_height, double angle = 0) {
  auto box = box_of<S, N>(x, y, half_width, half_height);
  if constexpr (N == 2) {
    box.rotation = Rotation<S, 2>::from_angle(Angle<S>::from_radians(num<S>(angle)));
  }
  return box;
}

/// Boxes on a floor whose top is at y = 0. The tests watch `top`.
template <Scalar S, int N>
struct Scene {
  World<S, N, Obb> world;
  BodyId top{};
  BodyOptions<S, N> options{};

  Scene(int substeps, double sleep_speed = 0, double hold_distance = 0.1) {
    WorldSettings<S, N> settings;
    settings.substeps = substeps;
    settings.sleep_speed = num<S>(sleep_speed);
    settings.hold_distance = num<S>(hold_distance);
    world = World<S, N, Obb>(settings);
    BodyOptions<S, N> fixed;
    fixed.motion = BodyMotion::fixed;
    (void)world.add(box_at<S, N>(0, -1, 50, 1), fixed);
  }
  void add(const Obb<S, N>& box, double density = 1) {
    options.density = num<S>(density);
    top = world.add(box, options).value_or(no_object);
  }
  void step(int ticks) {
    for (int i = 0; i < ticks; ++i) world.step();
  }
  /// The largest component of any velocity or spin, in units or radians per second.
  double fastest() const {
    double most = 0;
    const auto& bodies = detail::WorldAccess::bodies(world);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      for (int k = 0; k < N; ++k) {
        most = (std::max)(most, std::fabs(static_cast<double>(bodies[i].state.velocity[k])));
      }
      for (const auto& w : bodies[i].state.spin) {
        most = (std::max)(most, std::fabs(static_cast<double>(w)));
      }
    }
    return most * detail::WorldAccess::rate(world);
  }
};

template <Scalar S, int N>
Scene<S, N> stack(int boxes, int substeps, double sleep_speed = 0, double hold_distance = 0.1) {
  Scene<S, N> scene(substeps, sleep_speed, hold_distance);
  for (int i = 0; i < boxes; ++i) scene.add(box_at<S, N>(0, 0.5 + i, 0.5, 0.5));
  return scene;
}

/// Three boxes; the last one weighs 100 times as much as each of the others.
template <Scalar S, int N>
Scene<S, N> heavy_top(double weight, int substeps, double sleep_speed = 0,
                      double hold_distance = 0.1) {
  Scene<S, N> scene(substeps, sleep_speed, hold_distance);
  scene.add(box_at<S, N>(0, 0.5, 0.5, 0.5));
  scene.add(box_at<S, N>(0, 1.5, 0.5, 0.5));
  scene.add(box_at<S, N>(0, 2.5, 0.5, 0.5), weight);
  return scene;
}

template <Scalar S>
Scene<S, 2> pyramid(int base, int substeps, double sleep_speed = 0) {
  Scene<S, 2> scene(substeps, sleep_speed);
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      scene.add(box_at<S, 2>(-0.5 * base + 0.55 * row + 1.1 * i, 0.5 + row, 0.5, 0.5));
    }
  }
  return scene;
}

/// A house of cards: cards of 1.2 by 0.1 lean against each other, with level cards between the
/// storeys.
template <Scalar S>
Scene<S, 2> house_of_cards(int levels, int substeps, double sleep_speed = 0,
                           double hold_distance = 0.1) {
  Scene<S, 2> scene(substeps, sleep_speed, hold_distance);
  scene.options.friction = num<S>(0.7);
  const double thin = 0.05, tall = 0.6, lean = 0.42;
  const double height = 2 * (tall * std::cos(lean) + thin * std::sin(lean));
  const double span = 2 * (tall * std::sin(lean) + thin * std::cos(lean));
  double floor = 0;
  for (int storey = 0; storey < levels; ++storey) {
    const int tents = levels - storey;
    const double first = -(tents - 1) * span;
    for (int i = 0; i < tents; ++i) {
      const double x = first + 2 * span * i;
      scene.add(box_at<S, 2>(x - span / 2, floor + height / 2, thin, tall, -lean));
      scene.add(box_at<S, 2>(x + span / 2, floor + height / 2, thin, tall, lean));
    }
    floor += height;
    for (int i = 0; i + 1 < tents; ++i) {
      scene.add(box_at<S, 2>(first + 2 * span * i + span, floor + thin, span, thin));
    }
    floor += 2 * thin;
  }
  return scene;
}

/// 40 boxes of different sizes that fall onto each other.
template <Scalar S>
Scene<S, 3> heap(int substeps) {
  Scene<S, 3> scene(substeps);
  for (int i = 0; i < 40; ++i) {
    auto box =
        box_at<S, 3>(0.3 * (i % 3) - 0.3, 1 + 0.9 * i, 0.3 + 0.02 * (i % 7), 0.25 + 0.03 * (i % 5));
    box.center.z = num<S>(0.35 * (i % 4) - 0.5);
    box.half_extents.z = num<S>(0.4);
    box.rotation = Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(1),
                                                   Angle<S>::from_radians(num<S>(0.7 * i)));
    scene.add(box);
  }
  return scene;
}

/// How a scene settles: the tick from which nothing is faster than 0.03 units a second, and how far
/// its top has moved at the end.
struct Settled {
  int rest = -1;
  double dx = 0, dy = 0;
  double fastest = 0;
  std::uint64_t digest = 0;
};

template <Scalar S, int N>
Settled settle(Scene<S, N> scene, int ticks) {
  const auto start = scene.world.position(scene.top);
  Settled settled;
  for (int t = 0; t < ticks; ++t) {
    scene.step(1);
    settled.fastest = scene.fastest();
    if (settled.fastest > 0.03) {
      settled.rest = -1;
    } else if (settled.rest < 0) {
      settled.rest = t;
    }
  }
  const auto end = scene.world.position(scene.top);
  settled.dx = static_cast<double>(end.x) - static_cast<double>(start.x);
  settled.dy = static_cast<double>(end.y) - static_cast<double>(start.y);
  settled.digest = digest(scene.world);
  return settled;
}

}  // namespace detent::test
