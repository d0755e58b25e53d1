// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "accuracy/question.hpp"
#include "oracle.hpp"
#include "oracle/hull.hpp"

// Where a ray first hits a shape, exactly: from the tool's oracle, or composed from its results for
// simpler shapes. Distances are in steps of 2^-48.

namespace detent::accuracy {

namespace oracle = cli::oracle;
using oracle::Exact;
using Steps = oracle::Integer;

/// The exact distance in steps of 2^-48, rounded down; nothing for a miss.
using Distance = std::optional<Steps>;

struct Reader {
  int frac;

  Exact operator()(Carrier x) const { return {oracle::Integer(x.raw()), -frac}; }
  template <class T>
  oracle::Vector operator()(const Vec<T, 3>& v) const {
    return {(*this)(v.x), (*this)(v.y), (*this)(v.z)};
  }
  oracle::Vector operator()(const CarriedDirection& d) const {
    const auto component = [&](int i) {
      return Exact(oracle::Integer(d[i].raw()), -direction_frac);
    };
    return {component(0), component(1), component(2)};
  }
  oracle::Ray operator()(const Ray<Carrier, 3>& ray) const {
    return {(*this)(ray.origin), (*this)(ray.direction), (*this)(ray.max_distance)};
  }
  oracle::Sphere operator()(const Sphere<Carrier, 3>& s) const {
    return {(*this)(s.center), (*this)(s.radius)};
  }
  oracle::Aabb operator()(const Aabb<Carrier, 3>& box) const {
    return {(*this)(box.min), (*this)(box.max)};
  }
  oracle::Obb operator()(const Obb<Carrier, 3>& box) const {
    return {(*this)(box.center),
            (*this)(box.half_extents),
            {(*this)(box.rotation.axis(0)), (*this)(box.rotation.axis(1)),
             (*this)(box.rotation.axis(2))}};
  }
  oracle::Plane operator()(const Plane<Carrier, 3>& plane) const {
    return {(*this)(plane.normal), (*this)(plane.offset)};
  }
  oracle::Triangle operator()(const Triangle<Carrier, 3>& t) const {
    return {(*this)(t.a), (*this)(t.b), (*this)(t.c)};
  }
};

template <class Shape>
Distance first_hit(const Ray<Carrier, 3>& ray, const Shape& shape, int frac) {
  const Reader read{frac};
  return oracle::first_hit(read(ray), read(shape));
}

/// Lowers `first` to `other` where that is nearer.
inline void lower(Distance& first, const Distance& other) {
  if (other && (!first || *other < *first)) first = other;
}

/// The sign of x - k sqrt(d), where d is not negative.
inline int sign_beside_root(const Exact& x, const Exact& k, const Exact& d) {
  const int root = d.sign() == 0 ? 0 : k.sign();
  if (x.sign() != root) return x.sign() > root ? 1 : -1;
  return x.sign() * (x * x - k * k * d).sign();
}

/// The least t with a t^2 + 2 b t + c = 0, where a > 0, b < 0 < c, and d = b^2 - a c >= 0. By
/// bisection: -b - a t >= sqrt(d) holds up to that t.
inline Distance first_root(const Exact& a, const Exact& b, const Exact& d, const Exact& limit) {
  const auto is_reached = [&](const Exact& t) {
    const Exact margin = -b - a * t;
    return margin.sign() < 0 || (margin * margin - d).sign() <= 0;
  };
  if (!is_reached(limit)) return std::nullopt;
  Steps low = 0, beyond = oracle::steps_of(limit) + 1;
  while (beyond - low > 1) {
    const Steps middle = (low + beyond) / 2;
    const Exact t(middle, -oracle::distance_frac);
    const Exact margin = -b - a * t;
    const bool is_before = margin.sign() >= 0 && (margin * margin - d).sign() >= 0;
    (is_before ? low : beyond) = middle;
  }
  return low;
}

/// The nearest of the spheres around the ends and the tube between them. A ray that enters the tube
/// through an end also hits that end's sphere.
inline Distance first_hit(const Ray<Carrier, 3>& ray, const Capsule<Carrier, 3>& capsule,
                          int frac) {
  Distance first = first_hit(ray, Sphere{capsule.a, capsule.radius}, frac);
  lower(first, first_hit(ray, Sphere{capsule.b, capsule.radius}, frac));
  const Reader read{frac};
  const auto exact_dot = [](const oracle::Vector& u, const oracle::Vector& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  };
  const auto minus = [](const oracle::Vector& u, const oracle::Vector& v) {
    return oracle::Vector{u[0] - v[0], u[1] - v[1], u[2] - v[2]};
  };
  const auto start = read(capsule.a), d = read(ray.direction);
  const auto e = minus(read(capsule.b), start), m = minus(read(ray.origin), start);
  const Exact radius = read(capsule.radius), ee = exact_dot(e, e), de = exact_dot(d, e),
              me = exact_dot(m, e);
  // ee times (squared distance of the point at t from the axis - radius^2): a t^2 + 2 b t + c.
  const Exact a = exact_dot(d, d) * ee - de * de, b = exact_dot(m, d) * ee - me * de,
              c = (exact_dot(m, m) - radius * radius) * ee - me * me;
  if (radius.sign() < 0 || ee.sign() == 0) return first;
  if (c.sign() <= 0 && me.sign() >= 0 && (me - ee).sign() <= 0) return Steps(0);
  const Exact discriminant = b * b - a * c;
  if (a.sign() == 0 || b.sign() >= 0 || c.sign() <= 0 || discriminant.sign() < 0) return first;
  // a times the hit's position along the axis is a me - b de - de sqrt(discriminant).
  const Exact place = a * me - b * de;
  if (sign_beside_root(place, de, discriminant) < 0) return first;
  if (sign_beside_root(place - a * ee, de, discriminant) > 0) return first;
  lower(first, first_root(a, b, discriminant, read(ray.max_distance)));
  return first;
}

/// 0 inside, otherwise the first hit among the triangles of its points: they contain its surface.
inline Distance first_hit(const Ray<Carrier, 3>& ray, const Points<Carrier, 3>& hull, int frac) {
  namespace exact = detent::oracle;
  if (exact::meet(exact::hull_of(as_shape(hull)), exact::hull_of(ray.origin))) return Steps(0);
  const auto& p = hull.points;
  Distance first;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        lower(first, first_hit(ray, Triangle<Carrier, 3>{p[i], p[j], p[k]}, frac));
      }
    }
  }
  return first;
}

}  // namespace detent::accuracy
