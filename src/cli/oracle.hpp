// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <optional>
#include <variant>

// An independent check of every ray: the same definitions of shapes, evaluated in unbounded
// integers with other formulas. It shares no code with the library, so each can check the other. It
// is slow.

namespace detent::cli::oracle {

/// Small values stay on the stack; larger ones use the heap.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked,
                                           std::allocator<boost::multiprecision::limb_type>>,
    boost::multiprecision::et_off>;

/// The number mantissa * 2^exponent. Every scalar's value has this form, including floats, and so
/// have sums and products: nothing is ever rounded.
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
/// {x : |dot(axes[i], x - center)| <= half_extents[i]}; the axes are not normalized.
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

/// Distances are whole steps of 2^-48, rounded down.
inline constexpr int distance_frac = 48;

/// A distance in those steps.
[[nodiscard]] Integer steps_of(const Exact& distance);

/// The smallest t in [0, max_distance] for which origin + t * direction is in the shape, rounded
/// down; nothing when there is none.
[[nodiscard]] std::optional<Integer> first_hit(const Ray& ray, const Shape& shape);

}  // namespace detent::cli::oracle
