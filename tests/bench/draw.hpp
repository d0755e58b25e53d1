// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "bench/as_scalar.hpp"
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
  Rotation<double, N> rotation() {
    const auto angle = [this] {
      return Angle<q16_16>::from_raw(static_cast<std::uint32_t>(random_.next()));
    };
    Rotation<q16_16, N> turn;
    if constexpr (N == 2) {
      turn = Rotation<q16_16, 2>::from_angle(angle());
    } else {
      const auto x = angle(), y = angle();
      turn = Rotation<q16_16, 3>::from_euler(x, y, angle());
    }
    std::array<Direction<double, N>, N> axes;
    for (int i = 0; i < N; ++i) {
      axes[static_cast<std::size_t>(i)] =
          Direction<double, N>::assume_unit(as_vec<double>(turn.axis(i).vec()));
    }
    return Rotation<double, N>::from_axes(axes);
  }

  test::Random random_;
  std::int64_t reach_;  // in steps
  Vec<double, N> place_;
};

}  // namespace detent::bench
