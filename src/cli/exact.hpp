// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "detent/shape/capsule.hpp"
#include "detent/shape/ray.hpp"
#include "detent/shape/shape.hpp"
#include "oracle/integer.hpp"

// Rays and shapes of any scalar, exactly, including floats. The oracle of the tests, which shares
// no code with the library, decides them in integers, on a grid fine enough for every number.

namespace detent::cli {

using oracle::Integer;

/// The number mantissa * 2^exponent: the value of any `Fixed`, float or double.
struct Exact {
  Integer mantissa = 0;
  int exponent = 0;

  /// The value of a finite double (and so of every float).
  [[nodiscard]] static Exact of(double value);
  [[nodiscard]] double approximate() const;
  /// In units of 2^-frac, rounded down.
  [[nodiscard]] Integer steps(int frac) const;
};

template <Number T>
[[nodiscard]] Exact exact(const T& value) {
  if constexpr (is_fixed<T>) {
    return {Integer(static_cast<std::int64_t>(value.raw())), -T::frac};
  } else {
    return Exact::of(value);
  }
}

/// A shape as a list of its lengths, coordinates first, and of the components of its directions.
struct ExactShape {
  enum class Form { ray, ball, box, turned_box, wall, face, pill, cloud };

  Form form;
  std::vector<Exact> lengths{}, directions{};

  template <class... Parts>
  ExactShape(Form of, const Parts&... parts) : form(of) {
    (add(parts), ...);
  }

  template <Scalar S>
  void add(const S& length) {
    lengths.push_back(exact(length));
  }
  template <Scalar S>
  void add(const Vec<S, 3>& point) {
    for (int i = 0; i < 3; ++i) add(point[i]);
  }
  template <Scalar S>
  void add(const Direction<S, 3>& direction) {
    for (int i = 0; i < 3; ++i) directions.push_back(exact(direction[i]));
  }
  template <Scalar S>
  void add(const Rotation<S, 3>& rotation) {
    for (int i = 0; i < 3; ++i) add(rotation.axis(i));
  }
};

template <Scalar S>
[[nodiscard]] ExactShape exact(const Ray<S, 3>& ray) {
  return {ExactShape::Form::ray, ray.origin, ray.max_distance, ray.direction};
}
template <Scalar S>
[[nodiscard]] ExactShape exact(const Sphere<S, 3>& sphere) {
  return {ExactShape::Form::ball, sphere.center, sphere.radius};
}
template <Scalar S>
[[nodiscard]] ExactShape exact(const Aabb<S, 3>& box) {
  return {ExactShape::Form::box, box.min, box.max};
}
template <Scalar S>
[[nodiscard]] ExactShape exact(const Obb<S, 3>& box) {
  return {ExactShape::Form::turned_box, box.center, box.half_extents, box.rotation};
}
template <Scalar S>
[[nodiscard]] ExactShape exact(const Plane<S, 3>& plane) {
  return {ExactShape::Form::wall, plane.offset, plane.normal};
}
template <Scalar S>
[[nodiscard]] ExactShape exact(const Triangle<S, 3>& triangle) {
  return {ExactShape::Form::face, triangle.a, triangle.b, triangle.c};
}
template <Scalar S>
[[nodiscard]] ExactShape exact(const Capsule<S, 3>& capsule) {
  return {ExactShape::Form::pill, capsule.a, capsule.b, capsule.radius};
}

/// Distances are whole steps of 2^-48, rounded down.
inline constexpr int distance_frac = 48;

/// The smallest t in [0, max_distance] for which origin + t * direction is in the shape, rounded
/// down; nothing when there is none.
[[nodiscard]] std::optional<Integer> first_hit(const ExactShape& ray, const ExactShape& shape);

}  // namespace detent::cli
