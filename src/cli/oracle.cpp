// SPDX-License-Identifier: MIT
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace detent::cli::oracle {
namespace {

bool operator<(const Exact& a, const Exact& b) { return (a - b).sign() < 0; }
bool operator<=(const Exact& a, const Exact& b) { return (a - b).sign() <= 0; }

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Exact dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_zero(const Vector& v) { return v[0].sign() == 0 && v[1].sign() == 0 && v[2].sign() == 0; }

Integer divide_floor(const Integer& n, const Integer& d) {  // d > 0
  Integer quotient = n / d;
  if (n.sign() < 0 && quotient * d != n) --quotient;
  return quotient;
}

/// A time along the ray: numerator / denominator, where denominator > 0.
struct Time {
  Exact numerator;
  Exact denominator = 1;

  Time(Exact n, Exact d) : numerator(std::move(n)), denominator(std::move(d)) {
    if (denominator.sign() < 0) {
      numerator = -numerator;
      denominator = -denominator;
    }
  }

  friend bool operator<(const Time& a, const Time& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }

  Integer floor() const {
    const int shift = numerator.exponent() - denominator.exponent() + distance_frac;
    const Integer n = shift > 0 ? Integer(numerator.mantissa() << static_cast<unsigned>(shift))
                                : numerator.mantissa();
    const Integer d = shift < 0 ? Integer(denominator.mantissa() << static_cast<unsigned>(-shift))
                                : denominator.mantissa();
    return divide_floor(n, d);
  }
};

using MaybeTime = std::optional<Time>;

bool within(const Ray& ray, const Time& t) {
  return t.numerator.sign() >= 0 && t.numerator <= ray.max_distance * t.denominator;
}

/// Clips [enter, exit] to the times for which `low <= t * slope <= high`.
bool clip(Time& enter, Time& exit, Exact low, Exact high, Exact slope) {
  if (slope.sign() == 0) return low.sign() <= 0 && high.sign() >= 0;
  if (slope.sign() < 0) {
    std::swap(low, high);
    low = -low;
    high = -high;
    slope = -slope;
  }
  enter = std::max(enter, Time(low, slope));
  exit = std::min(exit, Time(high, slope));
  return !(exit < enter);
}

MaybeTime first_time(const Ray& ray, const Aabb& box) {
  Time enter(0, 1);
  Time exit(ray.max_distance, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    if (!clip(enter, exit, box.min[i] - ray.origin[i], box.max[i] - ray.origin[i],
              ray.direction[i])) {
      return std::nullopt;
    }
  }
  return enter;
}

MaybeTime first_time(const Ray& ray, const Obb& box) {
  Time enter(0, 1);
  Time exit(ray.max_distance, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    const Exact middle = dot(box.axes[i], box.center - ray.origin);
    if (!clip(enter, exit, middle - box.half_extents[i], middle + box.half_extents[i],
              dot(box.axes[i], ray.direction))) {
      return std::nullopt;
    }
  }
  return enter;
}

MaybeTime first_time(const Ray& ray, const Plane& plane) {
  const Exact height = plane.offset - dot(plane.normal, ray.origin);
  if (height.sign() == 0) return Time(0, 1);
  const Exact slope = dot(plane.normal, ray.direction);
  if (slope.sign() == 0) return std::nullopt;
  const Time t(height, slope);
  return within(ray, t) ? MaybeTime(t) : std::nullopt;
}

/// Where the ray hits the segment from p to q, which may be a point.
MaybeTime meet_segment(const Ray& ray, const Vector& p, const Vector& q) {
  const Vector to_p = p - ray.origin;
  const Vector edge = q - p;
  const Vector c = cross(ray.direction, edge);
  if (!is_zero(c)) {
    if (dot(to_p, c).sign() != 0) return std::nullopt;  // skew lines
    const Exact cc = dot(c, c);
    const Exact along = dot(cross(to_p, ray.direction), c);
    if (along.sign() < 0 || cc < along) return std::nullopt;
    const Time t(dot(cross(to_p, edge), c), cc);
    return within(ray, t) ? MaybeTime(t) : std::nullopt;
  }
  if (!is_zero(cross(to_p, ray.direction))) return std::nullopt;  // parallel, apart
  const Exact dd = dot(ray.direction, ray.direction);
  const Time first(dot(to_p, ray.direction), dd);
  const Time second(dot(q - ray.origin, ray.direction), dd);
  const Time enter = std::max(Time(0, 1), std::min(first, second));
  return std::max(first, second) < enter || !within(ray, enter) ? std::nullopt : MaybeTime(enter);
}

/// Whether a point of the triangle's plane is inside the triangle, which has this non-zero normal.
bool inside(const Triangle& triangle, const Vector& normal, const Vector& point) {
  const auto left_of = [&](const Vector& from, const Vector& to) {
    return dot(cross(to - from, point - from), normal).sign() >= 0;
  };
  return left_of(triangle.a, triangle.b) && left_of(triangle.b, triangle.c) &&
         left_of(triangle.c, triangle.a);
}

MaybeTime first_time(const Ray& ray, const Triangle& triangle) {
  const Vector normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  const Exact slope = dot(normal, ray.direction);
  const Exact height = dot(normal, triangle.a - ray.origin);
  if (slope.sign() != 0) {
    const Time t(height, slope);
    if (!within(ray, t)) return std::nullopt;
    // Scales the triangle and the hit point by the denominator, which avoids the division.
    const auto grown = [&](const Vector& v) {
      return Vector{v[0] * t.denominator, v[1] * t.denominator, v[2] * t.denominator};
    };
    const Vector along{ray.direction[0] * t.numerator, ray.direction[1] * t.numerator,
                       ray.direction[2] * t.numerator};
    const Triangle scaled{grown(triangle.a), grown(triangle.b), grown(triangle.c)};
    return inside(scaled, normal, grown(ray.origin) + along) ? MaybeTime(t) : std::nullopt;
  }
  // The ray is parallel to the plane, or the triangle is a segment or a point.
  if (height.sign() != 0) return std::nullopt;
  if (!is_zero(normal) && inside(triangle, normal, ray.origin)) return Time(0, 1);
  MaybeTime first;
  for (const auto& [p, q] :
       {std::pair(&triangle.a, &triangle.b), std::pair(&triangle.b, &triangle.c),
        std::pair(&triangle.c, &triangle.a)}) {
    const MaybeTime t = meet_segment(ray, *p, *q);
    if (t && (!first || *t < *first)) first = t;
  }
  return first;
}

/// Whether the smaller root of a t^2 + 2 b t + c = 0 is at least `steps` * 2^-distance_frac.
bool root_at_least(const Exact& a, const Exact& b, const Exact& discriminant,
                   const Integer& steps) {
  const Exact margin = -b - a * Exact(steps, -distance_frac);
  return margin.sign() >= 0 && discriminant <= margin * margin;
}

std::optional<Integer> hit_sphere(const Ray& ray, const Sphere& sphere) {
  if (sphere.radius.sign() < 0 || ray.max_distance.sign() < 0) return std::nullopt;
  const Vector m = ray.origin - sphere.center;
  const Exact c = dot(m, m) - sphere.radius * sphere.radius;
  if (c.sign() <= 0) return Integer(0);
  const Exact a = dot(ray.direction, ray.direction);
  const Exact b = dot(m, ray.direction);
  if (b.sign() >= 0) return std::nullopt;
  const Exact discriminant = b * b - a * c;
  if (discriminant.sign() < 0) return std::nullopt;
  // (-b - sqrt(discriminant)) / a <= max_distance
  const Exact excess = -b - a * ray.max_distance;
  if (excess.sign() > 0 && discriminant < excess * excess) return std::nullopt;

  // An estimate from an integer root with 64 spare bits, corrected by the exact test.
  const int exponent = discriminant.exponent() - (discriminant.exponent() & 1);
  const Integer radicand = discriminant.mantissa()
                           << static_cast<unsigned>(128 + discriminant.exponent() - exponent);
  const Exact root(Integer(boost::multiprecision::sqrt(radicand)), exponent / 2 - 64);
  Integer steps = Time(-b - root, a).floor();
  while (!root_at_least(a, b, discriminant, steps)) --steps;
  while (root_at_least(a, b, discriminant, steps + 1)) ++steps;
  return steps;
}

}  // namespace

Exact Exact::of(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {Integer(static_cast<std::int64_t>(std::ldexp(fraction, 53))), exponent - 53};
}

double Exact::approximate() const { return std::ldexp(mantissa_.convert_to<double>(), exponent_); }

Exact operator+(const Exact& a, const Exact& b) {
  if (a.exponent_ < b.exponent_) return b + a;
  const auto shift = static_cast<unsigned>(a.exponent_ - b.exponent_);
  return {Integer((a.mantissa_ << shift) + b.mantissa_), b.exponent_};
}
Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
Exact operator*(const Exact& a, const Exact& b) {
  return {Integer(a.mantissa_ * b.mantissa_), a.exponent_ + b.exponent_};
}
Exact operator-(const Exact& a) { return {Integer(-a.mantissa_), a.exponent_}; }

Integer steps_of(const Exact& distance) { return Time(distance, 1).floor(); }

std::optional<Integer> first_hit(const Ray& ray, const Shape& shape) {
  if (ray.max_distance.sign() < 0) return std::nullopt;
  if (const auto* const sphere = std::get_if<Sphere>(&shape)) return hit_sphere(ray, *sphere);
  return std::visit(
      [&](const auto& form) -> std::optional<Integer> {
        if constexpr (!std::is_same_v<decltype(form), const Sphere&>) {
          if (const MaybeTime t = first_time(ray, form)) return t->floor();
        }
        return std::nullopt;
      },
      shape);
}

}  // namespace detent::cli::oracle
