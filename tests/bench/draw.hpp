// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "bench/as_scalar.hpp"
#include "bench/terrain.hpp"
#include "support/random.hpp"

namespace detent::bench {

/// The size of a scene: coordinates under `reach` units, sizes under a sixteenth of that.
struct Scale {
  int reach;
};
inline constexpr Scale ordinary{4096};
/// Coordinates that fit in 8 bits before the point.
inline constexpr Scale small{64};

/// The step of all lengths, exact in every scalar.
inline constexpr double grid_step = 1.0 / 256;

/// Draws shapes in double whose lengths are multiples of 1/256, which every scalar represents,
/// including float; directions are unit vectors of Q2.30.
template <int N = 3>
class Artist {
 public:
  Artist(std::uint64_t seed, Scale scale) : random_(seed), reach_(scale.reach * 256) {}

  [[nodiscard]] bool coin() { return random_.coin(); }

  /// Starts a scene: the following shapes lie around a common point.
  void next_scene() { place_ = vec(reach_ / 2); }

  void draw(Vec<double, N>& v) { v = nearby(); }
  void draw(Ray<double, N>& ray) {
    const auto aim = nearby();
    do {
      ray.origin = place_ + vec(reach_ * 2 / 5);
    } while (ray.origin == aim);
    ray.direction = toward(random_.one_in(8) ? ray.origin - aim : aim - ray.origin);
    ray.max_distance = length(reach_ / 2, reach_ - 1);
  }
  template <support::OfPoints Shape>
  void draw(Shape& shape) {
    const auto middle = nearby();
    shape = support::made_of<Shape>([&] { return middle + vec(size()); },
                                    [&] { return length(size() / 16, size() / 2); });
  }
  void draw(Sphere<double, N>& sphere) { sphere = {nearby(), length(size() / 8, size())}; }
  void draw(Aabb<double, N>& box) {
    const auto middle = nearby();
    const auto half = extents();
    box = {middle - half, middle + half};
  }
  void draw(Obb<double, N>& box) { box = {nearby(), extents(), rotation()}; }
  void draw(Plane<double, N>& plane) {
    const auto point = nearby();
    plane.normal = direction();
    plane.offset = std::round(dot(plane.normal, point) / grid_step) * grid_step;
  }
  void draw(Rock<double, N>& rock) {
    const auto middle = nearby();
    for (auto& point : rock.points) point = middle + vec(size());
  }
  /// Seven in eight move towards the scene.
  template <template <class, int> class Shape>
  void draw(Moving<double, N, Shape>& moving) {
    draw(moving.shape);
    const auto aim = vec(size());
    Vec<double, N> start;
    do {
      start = vec(reach_ * 2 / 5);
    } while (start == aim);
    move(moving.shape, start);
    moving.direction = toward(random_.one_in(8) ? start - aim : aim - start);
    moving.max_distance = length(reach_ / 2, reach_ - 1);
  }
  /// Moves by a few of its sizes and turns by up to an eighth of a turn about each axis.
  template <template <class, int> class Shape>
  void draw(Swept<double, N, Shape>& body) {
    const auto place = std::exchange(place_, {});
    draw(body.shape);
    place_ = place;
    const auto start = place_ + vec(size() * 4), end = place_ + vec(size() * 4);
    const auto before = angles();
    auto after = before;
    for (auto& angle : after) {
      const auto eighth = std::int64_t{1} << 29;
      const auto turn = static_cast<std::uint32_t>(random_.between(-eighth, eighth));
      angle += Angle<q16_16>::from_raw(turn);
    }
    body.sweep = {start, end, rotation_by(before), rotation_by(after)};
  }
  /// Seven in eight look towards the scene.
  void draw(View<double, N>& view) {
    const auto aim = nearby();
    Vec<double, N> eye, offset;
    do {
      eye = place_ + vec(reach_ * 2 / 5);
      offset = eye - aim;
    } while (squared_length(offset) < square(length(size() * 8, size() * 8)));
    if (random_.one_in(8)) offset = -offset;
    const Vec<q16_16, N> up{q16_16(0), q16_16(1), q16_16(0)};
    const auto pose = look_at(as<q16_16>(offset), {}, up);
    view.camera.pose = {eye, as_double(pose ? pose->rotation : Rotation<q16_16, N>())};
  }
  void draw(Pixel<double, N>& pixel) {
    const auto below = [&](std::int32_t count) {
      return static_cast<std::int32_t>(random_.between(0, count - 1));
    };
    pixel = {below(View<double, N>::screen.width), below(View<double, N>::screen.height)};
  }
  void draw(Spot<double, N>& spot) { spot = {length(-256, 256), length(-256, 256)}; }
  /// The shapes of the scene are near its ground.
  void draw(Terrain<double, N>& terrain) {
    terrain = as<double>(Terrain<double, N>{static_cast<int>(size() / 256)});
    place_.y = 0;
  }

 private:
  [[nodiscard]] std::int64_t size() const { return reach_ / 32; }

  double length(std::int64_t low, std::int64_t high) {
    return static_cast<double>(random_.between(low, high)) * grid_step;
  }
  Vec<double, N> vec(std::int64_t limit) {
    return make_vec<N>([&](int) { return length(-limit, limit); });
  }
  Vec<double, N> nearby() { return place_ + vec(size() >> random_.below(3)); }
  Vec<double, N> extents() {
    return make_vec<N>([&](int) { return length(size() / 8, size()); });
  }

  static Direction<double, N> toward(const Vec<double, N>& v) {
    const auto unit = *normalize(as<q16_16>(v));
    return Direction<double, N>::assume_unit(as_vec<double>(unit.vec()));
  }
  Direction<double, N> direction() {
    auto v = vec(reach_ / 2);
    while (v == Vec<double, N>{}) v = vec(reach_ / 2);
    return toward(v);
  }
  static constexpr std::size_t angle_count = N == 2 ? 1 : 3;
  using Angles = std::array<Angle<q16_16>, angle_count>;
  Angles angles() {
    Angles result;
    for (auto& angle : result) {
      angle = Angle<q16_16>::from_raw(static_cast<std::uint32_t>(random_.next()));
    }
    return result;
  }
  Rotation<double, N> rotation() { return rotation_by(angles()); }
  static Rotation<double, N> rotation_by(const Angles& angles) {
    if constexpr (N == 2) {
      return as_double(Rotation<q16_16, 2>::from_angle(angles[0]));
    } else {
      return as_double(Rotation<q16_16, 3>::from_euler(angles[0], angles[1], angles[2]));
    }
  }
  static Rotation<double, N> as_double(const Rotation<q16_16, N>& rotation) {
    return support::mapped_axes<double>(rotation, [](const auto& axis) {
      return Direction<double, N>::assume_unit(as_vec<double>(axis.vec()));
    });
  }

  test::Random random_;
  std::int64_t reach_;  // in steps
  Vec<double, N> place_;
};

}  // namespace detent::bench
