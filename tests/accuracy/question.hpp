// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <type_traits>

#include "detent/detent.hpp"
#include "detent/shape/hull.hpp"
#include "support/shapes.hpp"

// Every test case is stored in raw numbers of one type, in steps of 2^-frac, with directions in
// Q2.30. Rounding such a number to float gives such a number again: below 2^24 steps it does not
// change, and above that the spacing of floats is a whole number of steps. So the oracles, which
// read the raw numbers of a `Fixed`, can judge the inputs of every scalar.

namespace detent::accuracy {

using Carrier = q16_16;
using CarriedDirection = Direction<Carrier, 3>;
using Place = std::array<double, 3>;

inline constexpr int direction_frac = direction_component<Carrier>::frac;

/// The points of a hull.
template <Scalar S, int N>
struct Points {
  std::array<Vec<S, N>, 6> points;
};

/// The shapes, each in any scalar. Queries divide their number of test cases by a cost where the exact
/// result is slow to compute.
namespace kind {

template <template <Scalar, int> class Shape, int RayCost, int SegmentCost>
struct Kind {
  static constexpr int ray_cost = RayCost, segment_cost = SegmentCost;
  template <Scalar S>
  using In = Shape<S, 3>;
};
struct Sphere : Kind<detent::Sphere, 1, 2> {
  static constexpr const char* name = "sphere";
};
struct Aabb : Kind<detent::Aabb, 1, 8> {
  static constexpr const char* name = "aabb";
};
struct Obb : Kind<detent::Obb, 1, 2> {
  static constexpr const char* name = "obb";
};
struct Plane : Kind<detent::Plane, 1, 2> {
  static constexpr const char* name = "plane";
};
struct Triangle : Kind<detent::Triangle, 1, 8> {
  static constexpr const char* name = "triangle";
};
struct Capsule : Kind<detent::Capsule, 4, 2> {
  static constexpr const char* name = "capsule";
};
struct Hull : Kind<Points, 8, 8> {
  static constexpr const char* name = "hull";
};
struct Segment : Kind<detent::Segment, 0, 8> {
  static constexpr const char* name = "segment";
};

template <class... Shape>
struct List {};
/// In the order of rows.
using Solids = List<Sphere, Aabb, Obb, Plane, Triangle, Capsule>;
using AfterSphere = List<Aabb, Obb, Plane, Triangle, Capsule, Hull>;

template <class A, class B>
constexpr int overlap_cost() {
  const auto is_one = [](auto shape) {
    return std::is_same_v<A, decltype(shape)> || std::is_same_v<B, decltype(shape)>;
  };
  const bool are_alike = std::is_same_v<A, B> && (is_one(Aabb()) || is_one(Capsule()));
  if (is_one(Plane()) || are_alike) return 2;
  return is_one(Sphere()) && !is_one(Hull()) ? 2 : 8;
}

}  // namespace kind

/// The shape that a query takes: a hull is a view of its points.
template <class Shape>
const Shape& as_shape(const Shape& shape) {
  return shape;
}
template <Scalar S, int N>
ConvexHull<S, N> as_shape(const Points<S, N>& hull) {
  return ConvexHull<S, N>{hull.points};
}

/// Components need not form a unit vector of Q2.30: those of a float are off by 2^-24.
inline CarriedDirection unchecked(const std::array<std::int32_t, 3>& raw) {
  return std::bit_cast<CarriedDirection>(raw);
}

/// Converts from the carrier to the nearest number of the scalar `S`.
template <Scalar S>
struct Rounded {
  int frac;

  S operator()(Carrier x) const {
    if constexpr (is_fixed<S>) {
      const double raw = std::nearbyint(std::ldexp(x.raw(), S::frac - frac));
      const auto limit = static_cast<double>(S::max().raw());
      return S::from_raw(static_cast<typename S::raw_type>(std::clamp(raw, -limit - 1, limit)));
    } else {
      return static_cast<S>(std::ldexp(static_cast<double>(x.raw()), -frac));
    }
  }
  Direction<S, 3> operator()(const CarriedDirection& direction) const {
    using Component = direction_component<S>;
    return Direction<S, 3>::assume_unit(make_vec<3>([&](int i) {
      const double component = std::ldexp(direction[i].raw(), -direction_frac);
      if constexpr (is_fixed<S>) {
        return Component::from_double(component);
      } else {
        return static_cast<S>(component);
      }
    }));
  }
};

/// Converts from a scalar back to the carrier; exact.
struct Carried {
  int frac;

  template <Scalar S>
  Carrier operator()(const S& x) const {
    return Carrier::from_raw(steps(static_cast<double>(x), frac));
  }
  template <Scalar S>
  CarriedDirection operator()(const Direction<S, 3>& direction) const {
    std::array<std::int32_t, 3> raw{};
    for (int i = 0; i < 3; ++i) {
      raw[static_cast<std::size_t>(i)] = steps(static_cast<double>(direction[i]), direction_frac);
    }
    return unchecked(raw);
  }

 private:
  static std::int32_t steps(double x, int frac) {
    const double raw = std::ldexp(x, frac);
    if (raw != std::floor(raw) || std::abs(raw) >= 2147483648.0) {
      throw std::logic_error("a number of the accuracy ladder does not fit its grid");
    }
    return static_cast<std::int32_t>(raw);
  }
};

/// Records the largest coordinate or length it is applied to.
struct Extent {
  std::int64_t& most;

  Carrier operator()(Carrier x) const {
    most = std::max<std::int64_t>(most, std::abs(static_cast<std::int64_t>(x.raw())));
    return x;
  }
  CarriedDirection operator()(const CarriedDirection& direction) const { return direction; }
};

// Applies `f` to every number and direction of a shape.

template <class F, Scalar S>
auto changed(const F& f, const Vec<S, 3>& v) {
  return Vec{f(v.x), f(v.y), f(v.z)};
}
template <class F, Scalar S>
auto changed(const F& f, const Rotation<S, 3>& rotation) {
  return support::mapped_axes<decltype(f(S()))>(rotation, f);
}
template <class F, support::Mappable Shape>
auto changed(const F& f, const Shape& shape) {
  return support::mapped(shape, [&]<class Field>(const Field& field) {
    if constexpr (requires { f(field); }) {
      return f(field);
    } else {
      return changed(f, field);
    }
  });
}
template <class F, Scalar S>
auto changed(const F& f, const Points<S, 3>& hull) {
  Points<decltype(f(S())), 3> result;
  std::transform(hull.points.begin(), hull.points.end(), result.points.begin(),
                 [&](const auto& point) { return changed(f, point); });
  return result;
}

/// The largest whole coordinate of a scalar; for a float, of its test cases.
template <Scalar S>
double world_of(int frac) {
  if constexpr (is_fixed<S>) {
    return static_cast<double>(S::max());
  } else {
    return std::ldexp(1, 31 - frac);
  }
}

/// The properties of a scalar's numbers, for code that is not compiled for each scalar.
struct Numbers {
  int direction_bits;  // fractional bits; for a float those of components below 1
  double (*world)(int frac);
  Carrier (*nearest)(Carrier, int frac);
  CarriedDirection (*nearest_direction)(const CarriedDirection&);
};

template <Scalar S>
inline constexpr Numbers numbers{
    []() -> int {
      if constexpr (is_fixed<S>) {
        return direction_component<S>::frac;
      } else {
        return std::is_same_v<S, float> ? 24 : direction_frac;
      }
    }(),
    &world_of<S>, [](Carrier x, int frac) { return Carried{frac}(Rounded<S>{frac}(x)); },
    [](const CarriedDirection& d) { return Carried{0}(Rounded<S>{0}(d)); }};

/// The scalar's nearest number or direction, in the carrier.
struct Snapped {
  const Numbers& numbers;
  int frac;

  Carrier operator()(Carrier x) const { return numbers.nearest(x, frac); }
  CarriedDirection operator()(const CarriedDirection& d) const {
    return numbers.nearest_direction(d);
  }
};

}  // namespace detent::accuracy
