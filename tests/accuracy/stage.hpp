// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "accuracy/ladder.hpp"
#include "accuracy/question.hpp"
#include "support/random.hpp"

namespace detent::accuracy {

inline double dot(const Place& a, const Place& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Place plus(const Place& a, const Place& b, double times) {
  return {a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]};
}
inline Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Place unit(const Place& a) { return plus({}, a, 1 / std::sqrt(dot(a, a))); }

inline CarriedDirection nearest_direction(const Numbers& numbers, const Place& v) {
  std::array<std::int32_t, 3> raw{};
  for (std::size_t i = 0; i < 3; ++i) {
    // Rounding has made some vectors longer than 1.
    raw[i] = static_cast<std::int32_t>(
        std::llround(std::ldexp(std::clamp(v[i], -1.0, 1.0), direction_frac)));
  }
  return numbers.nearest_direction(unchecked(raw));
}

inline Place components(const CarriedDirection& direction) {
  Place result;
  for (int i = 0; i < 3; ++i) {
    result[static_cast<std::size_t>(i)] = std::ldexp(direction[i].raw(), -direction_frac);
  }
  return result;
}

/// Draws shapes of one size around a center, in its own frame.
///
/// On the exact rung all points lie on a lattice of the frame {1, 2, 2} / 3, whose axes every
/// scalar stores exactly up to one common factor. Faces and edges are then exactly parallel, and
/// touching shapes touch exactly.
///
/// A planar stage has z = 0 for all points, its third axis along z, and the lattice {3, 4} / 5.
class Stage {
 public:
  Stage(test::Random& source, const Numbers& given, const Rung& rung, bool keeps_axes,
        bool is_planar)
      : random(source),
        size_(std::ldexp(rung.size, rung.frac)),
        norm_(is_planar && !keeps_axes ? 5 : 3),
        stride_(static_cast<std::int64_t>(std::bit_floor(
            static_cast<std::uint64_t>(size_ / static_cast<double>(3 * norm_)) | 1))),
        on_lattice_(rung.angle == 0),
        is_planar_(is_planar),
        numbers_(given) {
    if (on_lattice_) {
      if (!keeps_axes) lattice_axes_ = any_lattice();
      for (std::size_t i = 0; i < 3; ++i) {
        axes_[i] = lattice_direction(lattice_axes_[i]);
        frame_[i] = components(axes_[i]);
      }
      return;
    }
    turn(keeps_axes ? std::array<Place, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}} : any_frame());
    for (std::size_t i = 0; i < dimension(); ++i) {
      center[i] = std::ldexp(random.coin() ? rung.place : -rung.place, rung.frac) +
                  size_ * uniform(-0.2, 0.2);
    }
  }

  test::Random& random;
  Place center{};

  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] bool on_lattice() const { return on_lattice_; }
  [[nodiscard]] std::size_t dimension() const { return is_planar_ ? 2 : 3; }
  /// A point in the plane of the triangles, spanned by the first and last axis.
  [[nodiscard]] Place level(double x, double y) const {
    return is_planar_ ? Place{x, y, 0} : Place{x, 0, y};
  }
  [[nodiscard]] const CarriedDirection& axis(std::size_t i) const { return axes_[i]; }

  /// Switches to another frame whose axes are unrelated to the old ones.
  void turn() {
    if (!on_lattice_) turn(any_frame());
  }
  /// Rotates the frame by `angle` about a random axis other than its first; in 2D, to either side.
  void tilt(double angle) {
    if (on_lattice_) return;
    const double phase = is_planar_ ? (random.coin() ? 0.5 : 1.5) * std::numbers::pi
                                    : uniform(0, 2 * std::numbers::pi);
    const Place about =
        is_planar_ ? plus({}, frame_[2], std::sin(phase))
                   : plus(plus({}, frame_[1], std::cos(phase)), frame_[2], std::sin(phase));
    auto turned = frame_;
    for (auto& v : turned) {  // Rodrigues
      v = plus(plus(plus({}, v, std::cos(angle)), cross(about, v), std::sin(angle)), about,
               dot(about, v) * (1 - std::cos(angle)));
    }
    turn(turned);
  }

  /// From `low` to `high` sizes; on the lattice, a whole number of steps.
  double reach(double low, double high) {
    if (!on_lattice_) return std::max(1.0, std::round(size_ * uniform(low, high)));
    return static_cast<double>(norm_ * stride_ *
                               random.between(std::llround(3 * low), std::llround(3 * high)));
  }
  double uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(random.next() >> 11), -53);
  }
  /// A vector in the frame, up to `reach` sizes along every axis.
  Place local(const Place& reach) {
    Place result;
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = on_lattice_ ? static_cast<double>(random.between(-std::llround(3 * reach[i]),
                                                                   std::llround(3 * reach[i])))
                              : uniform(-reach[i], reach[i]);
    }
    return result;
  }
  /// center + `local`, which is in the frame.
  [[nodiscard]] Place at(const Place& local) const {
    Place result = center;
    for (std::size_t k = 0; k < dimension(); ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        result[i] += on_lattice_ ? local[k] * static_cast<double>(stride_ * lattice_axes_[k][i])
                                 : local[k] * size_ * frame_[k][i];
      }
    }
    return result;
  }
  static Vec<Carrier, 3> rounded(const Place& place) {
    return make_vec<3>([&](int i) { return number(place[static_cast<std::size_t>(i)]); });
  }
  static Carrier number(double raw) {
    constexpr double most = 2147483647;
    return Carrier::from_raw(static_cast<std::int32_t>(std::llround(std::clamp(raw, -most, most))));
  }
  [[nodiscard]] Vec<Carrier, 3> corner(const Place& local) const { return rounded(at(local)); }

 private:
  using LatticeAxes = std::array<std::array<std::int64_t, 3>, 3>;

  void turn(const std::array<Place, 3>& frame) {
    for (std::size_t i = 0; i < 3; ++i) {
      axes_[i] = nearest_direction(numbers_, frame[i]);
      frame_[i] = components(axes_[i]);
    }
  }
  std::array<Place, 3> any_frame() {
    if (is_planar_) {
      const double phase = uniform(0, 2 * std::numbers::pi);
      const double x = std::cos(phase), y = std::sin(phase);
      return {{{x, y, 0}, {-y, x, 0}, {0, 0, 1}}};
    }
    Place a, b;
    do {
      for (auto& x : a) x = uniform(-1, 1);
      for (auto& x : b) x = uniform(-1, 1);
    } while (dot(a, a) < 0.01 || dot(a, a) > 1 || dot(cross(a, b), cross(a, b)) < 0.01);
    const Place first = unit(a), third = unit(cross(a, b));
    return {first, cross(third, first), third};
  }
  /// {1, 2, 2}, {2, 1, -2}, {2, -2, 1}, permuted and mirrored; {3, 4}, {4, -3} in 2D.
  LatticeAxes any_lattice() {
    if (is_planar_) {
      const std::int64_t x = random.coin() ? 3 : -3, y = random.coin() ? 4 : -4;
      if (random.coin()) return {{{x, y, 0}, {y, -x, 0}, {0, 0, 5}}};
      return {{{y, x, 0}, {x, -y, 0}, {0, 0, 5}}};
    }
    static constexpr LatticeAxes standard{{{1, 2, 2}, {2, 1, -2}, {2, -2, 1}}};
    const auto shift = random.below(3);
    std::array<std::int64_t, 3> signs{};
    for (auto& sign : signs) sign = random.coin() ? 1 : -1;
    LatticeAxes result{};
    const auto first = random.below(3);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        result[k][i] = signs[i] * standard[(k + first) % 3][(i + shift) % 3];
      }
    }
    return result;
  }
  /// The axis divided by its length, 3 or 5; off by at most the last bit of a direction.
  [[nodiscard]] CarriedDirection lattice_direction(const std::array<std::int64_t, 3>& axis) const {
    const std::int64_t part = ((std::int64_t{1} << numbers_.direction_bits) + norm_ / 2) / norm_;
    const bool is_unit =
        std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])}) == norm_;
    std::array<std::int32_t, 3> raw{};
    for (std::size_t i = 0; i < 3; ++i) {
      raw[i] = static_cast<std::int32_t>(
          is_unit ? (axis[i] / norm_) << direction_frac
                  : (axis[i] * part) << (direction_frac - numbers_.direction_bits));
    }
    return unchecked(raw);
  }

  double size_;  // in steps of the grid
  std::int64_t norm_;
  std::int64_t stride_;
  bool on_lattice_;
  bool is_planar_;
  Numbers numbers_;
  LatticeAxes lattice_axes_{{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}};
  std::array<CarriedDirection, 3> axes_;
  std::array<Place, 3> frame_;
};

// The shapes of a stage.

inline void draw(Stage& stage, Sphere<Carrier, 3>& sphere) {
  sphere = {Stage::rounded(stage.center), Stage::number(stage.reach(0.67, 1))};
}
inline void draw(Stage& stage, Aabb<Carrier, 3>& box) {
  Place low = stage.center, high = low;
  for (std::size_t i = 0; i < 3; ++i) {
    const double half = stage.reach(0.34, 1);
    low[i] -= half;
    high[i] += half;
  }
  box = {Stage::rounded(low), Stage::rounded(high)};
}
inline void draw(Stage& stage, Obb<Carrier, 3>& box) {
  box.center = Stage::rounded(stage.center);
  for (int i = 0; i < 3; ++i) box.half_extents[i] = Stage::number(stage.reach(0.34, 1));
  box.rotation = Rotation<Carrier, 3>::from_axes({stage.axis(0), stage.axis(1), stage.axis(2)});
}
/// Through the center, along the first and the third axis.
inline void draw(Stage& stage, Plane<Carrier, 3>& plane) {
  plane = {stage.axis(1),
           Stage::number(static_cast<double>(dot(components(stage.axis(1)), stage.center)))};
}
/// Along the first and the third axis; in a plane the second.
inline void draw(Stage& stage, Triangle<Carrier, 3>& triangle) {
  if (stage.on_lattice()) {
    const Place flat = stage.level(1, 1);
    triangle.a = stage.corner(stage.local(flat));
    triangle.b = stage.corner(stage.local(flat));
    triangle.c = stage.corner(stage.local(flat));
    return;
  }
  double phase = stage.uniform(0, 2 * std::numbers::pi);
  for (auto* const corner : {&triangle.a, &triangle.b, &triangle.c}) {
    const double radius = stage.uniform(0.6, 1);
    *corner = stage.corner(stage.level(radius * std::cos(phase), radius * std::sin(phase)));
    phase += stage.uniform(0.5, 0.8) * std::numbers::pi;
  }
}
inline void draw(Stage& stage, Segment<Carrier, 3>& segment) {
  const auto end = [&] {
    return stage.on_lattice() ? std::abs(stage.local({1, 0, 0})[0]) : stage.uniform(0.5, 1);
  };
  segment = {stage.corner({-end(), 0, 0}), stage.corner({end(), 0, 0})};
}
inline void draw(Stage& stage, Capsule<Carrier, 3>& capsule) {
  Segment<Carrier, 3> segment;
  draw(stage, segment);
  capsule = {segment.start, segment.end, Stage::number(stage.reach(0.51, 1))};
}
inline void draw(Stage& stage, Points<Carrier, 3>& hull) {
  for (auto& point : hull.points) point = stage.corner(stage.local({1, 1, 1}));
}

/// The data about a shape that a ray needs.
enum class Form { solid, surface, endless };

template <class Shape>
inline constexpr Form form = Form::solid;
template <Scalar S>
inline constexpr Form form<Triangle<S, 3>> = Form::surface;
template <Scalar S>
inline constexpr Form form<Plane<S, 3>> = Form::endless;

/// A ray that may or may not hit the stage's shapes.
///
/// With an angle, it runs within that angle of the first axis of the stage. If the ray must start
/// at the world's origin, the stage moves instead. For a shape that moves along the ray, `spread`
/// is above 1, because it touches more of what it passes.
inline Ray<Carrier, 3> draw_ray(Stage& stage, const Rung& rung, Form form, double spread = 1) {
  Stage way = stage;
  rung.angle < 0 ? way.turn() : way.tilt(rung.angle);
  const auto direction = way.axis(0);
  const double enough = std::ceil(1.5 * rung.length + 2 * rung.size + 8);
  const double longest = std::ldexp(32000, 16 - rung.frac);
  const auto limit = [&](double reach) {
    return Stage::number(std::ldexp(std::min(reach, longest), rung.frac));
  };
  if (stage.on_lattice()) {
    auto start = stage.local({2, 1.34 * spread, 1.34 * spread});
    start[0] -= 4 * spread;
    return {stage.corner(start), direction, limit(enough)};
  }
  const Place d = components(direction);
  const double length = std::ldexp(rung.length, rung.frac);
  if (rung.ladder == Ladder::distance) stage.center = plus(stage.center, d, length);
  if (rung.angle < 0 || form == Form::solid) {
    // Rays cannot pass beside a plane, so they end near it instead.
    const double reach = form == Form::endless ? std::max(rung.length, rung.size) : enough;
    const double aside = 1.4 * spread;
    const auto target = stage.at(stage.local({aside, aside, aside}));
    return {Stage::rounded(plus(target, d, -length)), direction, limit(reach)};
  }
  // From either side of the surface, towards a point close enough for the angle.
  const auto target = stage.at(stage.local({1.4, 1.4 * rung.angle, 1.4}));
  return {Stage::rounded(plus(target, d, -length * stage.uniform(0, 2))), direction,
          limit(rung.length)};
}

}  // namespace detent::accuracy
