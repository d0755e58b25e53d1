// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "bench/as_scalar.hpp"
#include "support/random.hpp"

namespace detent::bench {

/// How large a scene is: coordinates under `reach` units, sizes under a sixteenth of that.
struct Scale {
  int reach;
};
inline constexpr Scale ordinary{4096};
/// What fits 8 bits before the point.
inline constexpr Scale small{64};

/// Draws shapes in double whose lengths are multiples of 1/256, which every scalar holds, float
/// too; directions are unit vectors of Q2.30.
class Artist {
 public:
  static constexpr double step = 1.0 / 256;

  Artist(std::uint64_t seed, Scale scale) : random_(seed), reach_(scale.reach * 256) {}

  [[nodiscard]] bool coin() { return random_.coin(); }
  [[nodiscard]] int axis() { return static_cast<int>(random_.below(3)); }

  /// Starts a scene: the next shapes lie about a common place.
  void next_scene() { place_ = vec(reach_ / 2); }

  void draw(Vec<double, 3>& v) { v = nearby(); }
  void draw(Ray<double, 3>& ray) {
    const auto aim = nearby();
    do {
      ray.origin = place_ + vec(reach_ * 2 / 5);
    } while (ray.origin == aim);
    ray.direction = toward(random_.one_in(8) ? ray.origin - aim : aim - ray.origin);
    ray.max_distance = length(reach_ / 2, reach_ - 1);
  }
  void draw(Segment<double, 3>& segment) {
    const auto middle = nearby();
    segment = {middle + vec(size()), middle + vec(size())};
  }
  void draw(Sphere<double, 3>& sphere) { sphere = {nearby(), length(size() / 8, size())}; }
  void draw(Aabb<double, 3>& box) {
    const auto middle = nearby();
    const auto half = extents();
    box = {middle - half, middle + half};
  }
  void draw(Obb<double, 3>& box) { box = {nearby(), extents(), rotation()}; }
  void draw(Plane<double, 3>& plane) {
    const auto point = nearby();
    plane.normal = direction();
    plane.offset = std::round(dot(plane.normal, point) / step) * step;
  }
  void draw(Triangle<double, 3>& triangle) {
    const auto middle = nearby();
    triangle = {middle + vec(size()), middle + vec(size()), middle + vec(size())};
  }
  void draw(Capsule<double, 3>& capsule) {
    const auto middle = nearby();
    capsule = {middle + vec(size()), middle + vec(size()), length(size() / 16, size() / 2)};
  }

 private:
  [[nodiscard]] std::int64_t size() const { return reach_ / 32; }

  double length(std::int64_t low, std::int64_t high) {
    return static_cast<double>(random_.between(low, high)) * step;
  }
  Vec<double, 3> vec(std::int64_t limit) {
    const auto x = length(-limit, limit), y = length(-limit, limit);
    return {x, y, length(-limit, limit)};
  }
  Vec<double, 3> nearby() { return place_ + vec(size() >> random_.below(3)); }
  Vec<double, 3> extents() {
    const auto x = length(size() / 8, size()), y = length(size() / 8, size());
    return {x, y, length(size() / 8, size())};
  }

  static Direction<double, 3> toward(const Vec<double, 3>& v) {
    const auto unit = *normalize(as<q16_16>(v));
    return Direction<double, 3>::assume_unit(as_vec<double>(unit.vec()));
  }
  Direction<double, 3> direction() {
    auto v = vec(reach_ / 2);
    while (v == Vec<double, 3>{}) v = vec(reach_ / 2);
    return toward(v);
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
  std::int64_t reach_;  // in steps
  Vec<double, 3> place_;
};

}  // namespace detent::bench
