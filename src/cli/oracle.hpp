// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <optional>
#include <variant>

// A second opinion on every ray: the same definitions of shapes, evaluated in unbounded integers
// by formulas of its own. It shares no code with the library, so the two can check each other.
// It takes its time: this is for judging answers, not for giving them.

namespace detent::cli::oracle {

/// Small values stay on the stack; larger ones grow onto the heap.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked,
                                           std::allocator<boost::multiprecision::limb_type>>,
    boost::multiprecision::et_off>;

/// The number mantissa * 2^exponent. Every scalar has such a value, a float included, and sums and
/// products of such numbers are such numbers again: nothing is ever rounded.
class Exact {
 public:
  Exact() = default;
  Exact(int value) : mantissa_(value) {}
  Exact(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  /// The value of a finite double (and so of every float).
  [[nodiscard]] static Exact of(double value);

  [[nodiscard]] const Integer& mantissa() const { return mantissa_; }
  [[nodiscard]] int exponent() const { return exponent_; }
  [[nodiscard]] int sign() const { return mantissa_.sign(); }
  [[nodiscard]] double approximate() const;

  friend Exact operator+(const Exact& a, const Exact& b);
  friend Exact operator-(const Exact& a, const Exact& b);
  friend Exact operator*(const Exact& a, const Exact& b);
  friend Exact operator-(const Exact& a);

 private:
  Integer mantissa_;
  int exponent_ = 0;
};

using Vector = std::array<Exact, 3>;

struct Sphere {
  Vector center;
  Exact radius;
};
struct Aabb {
  Vector min;
  Vector max;
};
/// {x : |dot(axes[i], x - center)| <= half_extents[i]}, axes as they are.
struct Obb {
  Vector center;
  Vector half_extents;
  std::array<Vector, 3> axes;
};
struct Plane {
  Vector normal;
  Exact offset;
};
struct Triangle {
  Vector a;
  Vector b;
  Vector c;
};
using Shape = std::variant<Sphere, Aabb, Obb, Plane, Triangle>;

struct Ray {
  Vector origin;
  Vector direction;
  Exact max_distance;
};

/// Distances are given in whole steps of 2^-48, rounded down.
inline constexpr int distance_frac = 48;

/// A distance in those steps.
[[nodiscard]] Integer steps_of(const Exact& distance);

/// The smallest t in [0, max_distance] at which origin + t * direction lies in the shape, rounded
/// down; nothing when there is none.
[[nodiscard]] std::optional<Integer> first_hit(const Ray& ray, const Shape& shape);

}  // namespace detent::cli::oracle
