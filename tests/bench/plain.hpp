// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

// A baseline, not a part of detent: Q16.16 as it is usually written. Numbers have 32 bits, products
// have 64 bits and are shifted back, and the formulas are those for float. Overflow wraps.

namespace detent::bench::plain {

struct Number {
  std::int32_t raw = 0;

  static constexpr Number from_wide(std::int64_t wide) { return {static_cast<std::int32_t>(wide)}; }
  static constexpr Number from_int(int x) { return from_wide(std::int64_t{x} * 65536); }

  friend constexpr Number operator+(Number a, Number b) {
    return from_wide(std::int64_t{a.raw} + b.raw);
  }
  friend constexpr Number operator-(Number a, Number b) {
    return from_wide(std::int64_t{a.raw} - b.raw);
  }
  friend constexpr Number operator-(Number a) { return from_wide(-std::int64_t{a.raw}); }
  friend constexpr Number operator*(Number a, Number b) {
    return from_wide((std::int64_t{a.raw} * b.raw) >> 16);
  }
  friend constexpr Number operator/(Number a, Number b) {
    if (b.raw == 0) return {a.raw < 0 ? INT32_MIN : INT32_MAX};
    return from_wide(std::int64_t{a.raw} * 65536 / b.raw);
  }
  friend constexpr auto operator<=>(Number a, Number b) = default;
};

/// Digit by digit, as in other fixed-point libraries.
inline Number sqrt(Number x) {
  if (x.raw <= 0) return {};
  std::uint64_t rest = static_cast<std::uint64_t>(x.raw) << 16, root = 0;
  std::uint64_t bit = std::uint64_t{1} << 46;
  while (bit > rest) bit >>= 2;
  for (; bit != 0; bit >>= 2) {
    if (rest >= root + bit) {
      rest -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
  }
  return {static_cast<std::int32_t>(root)};
}

struct Vector {
  Number x, y, z;
};
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Number dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Ray {
  Vector origin, direction;
  Number max_distance;
};
struct Sphere {
  Vector center;
  Number radius;
};
struct Box {
  Vector min, max;
};
struct Triangle {
  Vector a, b, c;
};

inline std::optional<Number> raycast(const Ray& ray, const Sphere& sphere) {
  const auto m = ray.origin - sphere.center;
  const auto b = dot(m, ray.direction);
  const auto c = dot(m, m) - sphere.radius * sphere.radius;
  if (c.raw <= 0) return Number{};
  if (b.raw > 0) return std::nullopt;
  const auto discriminant = b * b - c;
  if (discriminant.raw < 0) return std::nullopt;
  const auto t = -b - sqrt(discriminant);
  if (t > ray.max_distance) return std::nullopt;
  return t < Number{} ? Number{} : t;
}

inline std::optional<Number> raycast(const Ray& ray, const Box& box) {
  Number enter{}, exit = ray.max_distance;
  const auto clip = [&](Number low, Number high, Number origin, Number direction) {
    if (direction.raw == 0) return low <= origin && origin <= high;
    auto first = (low - origin) / direction, second = (high - origin) / direction;
    if (second < first) std::swap(first, second);
    if (enter < first) enter = first;
    if (second < exit) exit = second;
    return enter <= exit;
  };
  if (!clip(box.min.x, box.max.x, ray.origin.x, ray.direction.x)) return std::nullopt;
  if (!clip(box.min.y, box.max.y, ray.origin.y, ray.direction.y)) return std::nullopt;
  if (!clip(box.min.z, box.max.z, ray.origin.z, ray.direction.z)) return std::nullopt;
  return enter;
}

inline std::optional<Number> raycast(const Ray& ray, const Triangle& triangle) {
  const auto edge_b = triangle.b - triangle.a, edge_c = triangle.c - triangle.a;
  const auto p = cross(ray.direction, edge_c);
  const auto det = dot(edge_b, p);
  if (det.raw == 0) return std::nullopt;
  const auto from_a = ray.origin - triangle.a;
  const auto one = Number::from_int(1);
  const auto u = dot(from_a, p) / det;
  if (u < Number{} || u > one) return std::nullopt;
  const auto q = cross(from_a, edge_b);
  const auto v = dot(ray.direction, q) / det;
  if (v < Number{} || u + v > one) return std::nullopt;
  const auto t = dot(edge_c, q) / det;
  if (t < Number{} || t > ray.max_distance) return std::nullopt;
  return t;
}

}  // namespace detent::bench::plain
