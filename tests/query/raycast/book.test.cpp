// SPDX-License-Identifier: MIT
#include <cfloat>
#include <cmath>

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

// Queries that textbook formulas in float get wrong, though float represents every input. The
// formulas are only here to show that.

using F3 = std::array<float, 3>;

/// Keeps the compiler from fusing or widening float operations, which would hide their errors.
float stored(float x) {
  volatile float memory = x;
  return memory;
}

F3 minus(const F3& a, const F3& b) {
  return {stored(a[0] - b[0]), stored(a[1] - b[1]), stored(a[2] - b[2])};
}
float dot(const F3& a, const F3& b) {
  const float xy = stored(stored(a[0] * b[0]) + stored(a[1] * b[1]));
  return stored(xy + stored(a[2] * b[2]));
}
F3 cross(const F3& a, const F3& b) {
  return {stored(stored(a[1] * b[2]) - stored(a[2] * b[1])),
          stored(stored(a[2] * b[0]) - stored(a[0] * b[2])),
          stored(stored(a[0] * b[1]) - stored(a[1] * b[0]))};
}

/// Pythagoras: the center's distance from the ray, from its distance from the origin and along the
/// ray.
std::optional<float> float_sphere(const F3& direction, const F3& center, float radius) {
  const float ahead = dot(center, direction);
  const float beside = stored(dot(center, center) - stored(ahead * ahead));
  const float depth = stored(stored(radius * radius) - beside);
  if (depth < 0) return std::nullopt;
  return stored(ahead - std::sqrt(depth));
}

/// Slabs, with a small divisor instead of zero.
std::optional<float> float_box(const F3& origin, const F3& direction, const F3& center,
                               float half_extent) {
  float enter = -FLT_MAX;
  float exit = FLT_MAX;
  for (std::size_t i = 0; i < 3; ++i) {
    const float ahead = stored(center[i] - origin[i]);
    if (direction[i] == 0 && std::fabs(ahead) > half_extent) return std::nullopt;
    const float speed = direction[i] == 0 ? 0.00001f : direction[i];
    const float a = stored(stored(ahead + half_extent) / speed);
    const float b = stored(stored(ahead - half_extent) / speed);
    enter = std::fmax(enter, std::fmin(a, b));
    exit = std::fmin(exit, std::fmax(a, b));
  }
  if (exit < 0 || enter > exit) return std::nullopt;
  return enter;
}

/// Moeller and Trumbore, from the origin.
bool float_triangle(const F3& direction, const F3& a, const F3& b, const F3& c) {
  const F3 edge_b = minus(b, a);
  const F3 edge_c = minus(c, a);
  const F3 p = cross(direction, edge_c);
  const float inverse = stored(1 / dot(edge_b, p));
  const F3 from_a = minus({0, 0, 0}, a);
  const float u = stored(dot(from_a, p) * inverse);
  const F3 q = cross(from_a, edge_b);
  const float v = stored(dot(direction, q) * inverse);
  return u >= 0 && v >= 0 && stored(u + v) <= 1;
}

constexpr auto up = Direction<q16_16, 3>::along(2);
constexpr Ray<q16_16, 3> from_zero{{}, up};

constexpr Sphere<q16_16, 3> sphere(double x, double z, double radius) {
  return {at<q16_16, 3>(x, 0, z), num<q16_16>(radius)};
}
constexpr std::optional<q16_16> raw(std::int32_t distance) { return q16_16::from_raw(distance); }

static_assert(!raycast(from_zero, sphere(0.75, 10000, 0.5)));
static_assert(raycast(from_zero, sphere(2.25, 10000, 2.5)) == raw(655288583));

TEST_CASE("book: distant spheres that float hits or misses wrongly", "[raycast][book]") {
  const auto by_float = [](float x, float z, float radius) {
    return float_sphere({0, 0, 1}, {x, 0, z}, radius);
  };
  // 10000^2 fills a float's 24 bits in steps of 8: 0.75^2 vanishes, 2.25^2 becomes 8.
  CHECK(misses(from_zero, sphere(0.75, 10000, 0.5)));
  CHECK(by_float(0.75f, 10000, 0.5f) == 9999.5f);

  CHECK(distance(from_zero, sphere(2.25, 10000, 2.5)) == raw(655288583));  // 9998.91026...
  CHECK_FALSE(by_float(2.25f, 10000, 2.5f).has_value());

  CHECK(distance(from_zero, sphere(1.875, 10000, 2)) == raw(655314388));  // 9999.30401...
  CHECK(by_float(1.875f, 10000, 2) == 9998.0f);

  // It misses by 21 radii.
  CHECK(misses(from_zero, sphere(5.5, 30000, 0.25)));
  CHECK(by_float(5.5f, 30000, 0.25f).has_value());

  CHECK(distance(from_zero, sphere(6, 30000, 7.5)) == num<q16_16>(29995.5));
  CHECK_FALSE(by_float(6, 30000, 7.5f).has_value());

  CHECK(misses(from_zero, sphere(0.01953125, 100, 0.0078125)));
  CHECK(by_float(0.01953125f, 100, 0.0078125f).has_value());

  // Behind the ray.
  CHECK(misses(from_zero, sphere(0, -5, 1)));
  CHECK(by_float(0, -5, 1) == -6.0f);
}

TEST_CASE("book: entries, exits and normals of the distant spheres", "[raycast][book]") {
  // 10000 -+ sqrt(2.5^2 - 2.25^2), 10000 -+ sqrt(2^2 - 1.875^2), 30000 -+ 4.5.
  CHECK(raycast_interval(from_zero, sphere(2.25, 10000, 2.5)) ==
        Interval<q16_16>{*raw(655288583), *raw(655431416)});
  CHECK(raycast_interval(from_zero, sphere(1.875, 10000, 2)) ==
        Interval<q16_16>{*raw(655314388), *raw(655405611)});
  CHECK(raycast_interval(from_zero, sphere(6, 30000, 7.5)) ==
        Interval<q16_16>{num<q16_16>(29995.5), num<q16_16>(30004.5)});
  const auto hit = raycast_hit(from_zero, sphere(6, 30000, 7.5));
  REQUIRE(hit.has_value());
  CHECK(hit->point == at<q16_16, 3>(0, 0, 29995.5));
  CHECK(hit->normal == toward<q16_16, 3>(-4, 0, -3));
}

TEST_CASE("book: a box in front of a parallel ray", "[raycast][book]") {
  const Obb<q16_16, 3> box{at<q16_16, 3>(0, 0, 10000), at<q16_16, 3>(1, 1, 1), {}};
  const Ray<q16_16, 3> ray{at<q16_16, 3>(0.9375), up};
  CHECK(raycast_interval(ray, box) == Interval<q16_16>{num<q16_16>(9999), num<q16_16>(10001)});
  // With 0.00001 for 0, the ray seems to leave the slab of x after 6250.
  CHECK_FALSE(float_box({0.9375f, 0, 0}, {0, 0, 1}, {0, 0, 10000}, 1).has_value());

  const Aabb<q16_16, 3> same{at<q16_16, 3>(-1, -1, 9999), at<q16_16, 3>(1, 1, 10001)};
  CHECK(distance(ray, same) == num<q16_16>(9999));
}

TEST_CASE("book: rays at an edge shared by two triangles", "[raycast][book]") {
  Random random(0xb00c);
  INFO(random);
  int float_cracks = 0;
  int cracks = 0;
  constexpr int rays = 10'000;
  for (int i = 0; i < rays; ++i) {
    // In 1/16384, seen upwards from 0: a is on the left, b on the right, c above and d below.
    const auto corner = [&](int x0, int x1, int y0, int y1) {
      return std::array<std::int64_t, 3>{random.between(x0, x1), random.between(y0, y1),
                                         random.between(131072, 262144)};
    };
    const auto a = corner(-65536, -16384, -16384, 16384);
    const auto b = corner(16384, 65536, -16384, 16384);
    const auto c = corner(-8192, 8192, 65536, 131072);
    const auto d = corner(-8192, 8192, -131072, -65536);
    const auto part = static_cast<double>(random.between(300, 700)) / 1000;
    std::array<double, 3> target{};
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      target[k] = static_cast<double>(a[k]) + part * static_cast<double>(b[k] - a[k]);
      length += target[k] * target[k];
    }
    F3 float_direction{};
    Vec<q16_16, 3> toward_edge;
    for (std::size_t k = 0; k < 3; ++k) {
      float_direction[k] = static_cast<float>(target[k] / std::sqrt(length));
      toward_edge[static_cast<int>(k)] = q16_16::from_double(target[k] / 16384);
    }
    const auto in_float = [](const std::array<std::int64_t, 3>& p) {
      const auto unit = [](std::int64_t x) { return static_cast<float>(x) / 16384; };
      return F3{unit(p[0]), unit(p[1]), unit(p[2])};
    };
    if (!float_triangle(float_direction, in_float(a), in_float(b), in_float(c)) &&
        !float_triangle(float_direction, in_float(b), in_float(a), in_float(d))) {
      ++float_cracks;
    }
    const auto in_fixed = [](const std::array<std::int64_t, 3>& p) {
      const auto unit = [](std::int64_t x) { return num<q16_16>(static_cast<double>(x) / 16384); };
      return Vec<q16_16, 3>{unit(p[0]), unit(p[1]), unit(p[2])};
    };
    const Ray<q16_16, 3> ray{{}, *normalize(toward_edge)};
    if (!raycast(ray, Triangle<q16_16, 3>{in_fixed(a), in_fixed(b), in_fixed(c)}) &&
        !raycast(ray, Triangle<q16_16, 3>{in_fixed(b), in_fixed(a), in_fixed(d)})) {
      ++cracks;
    }
  }
  CHECK(cracks == 0);
  INFO(float_cracks);
  CHECK(float_cracks > rays / 100);
}

}  // namespace
}  // namespace detent::test
