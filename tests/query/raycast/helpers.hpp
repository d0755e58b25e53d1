// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "detent/number/text.hpp"
#include "detent/query/raycast.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"
#include "support/num.hpp"
#include "support/shapes.hpp"

namespace detent::test {

/// The corners of a frustum along z, from a square of side 2 at 1 to one of side 4 at 2.
template <Scalar S>
std::array<Vec<S, 3>, 8> frustum_corners() {
  std::array<Vec<S, 3>, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double size = i < 4 ? 1 : 2;
    corners[i] = at<S, 3>(i & 1 ? size : -size, i & 2 ? size : -size, size);
  }
  return corners;
}

/// The direction of (x, y, z), or of (x, y) in 2D.
template <Scalar S, int N>
constexpr Direction<S, N> toward(double x, double y = 0, double z = 0) {
  return *normalize(at<S, N>(x, y, z));
}

/// The vector with this value in all components.
template <Scalar S, int N>
constexpr Vec<S, N> filled(S value) {
  Vec<S, N> result;
  for (int i = 0; i < N; ++i) result[i] = value;
  return result;
}

/// The triangle (0, 0), (8, 0), (0, 8).
template <Scalar S, int N>
constexpr Triangle<S, N> right_triangle() {
  return {at<S, N>(0, 0), at<S, N>(8, 0), at<S, N>(0, 8)};
}

/// A triangle, and the same one the other way round.
template <Scalar S, int N>
constexpr std::array<Triangle<S, N>, 2> both_orders(const Triangle<S, N>& triangle) {
  return {triangle, Triangle<S, N>{triangle.a, triangle.c, triangle.b}};
}

/// `value` plus `steps` of a fixed scalar's smallest step, to test exact boundaries.
template <Scalar S>
requires is_fixed<S>
constexpr S moved(S value, int steps) {
  return S::from_raw(static_cast<typename S::raw_type>(value.raw() + steps));
}

/// The point (x, y) in a fixed scalar's smallest steps.
template <Scalar S, int N>
requires is_fixed<S>
constexpr Vec<S, N> in_steps(int x, int y) {
  Vec<S, N> result;
  result.x = moved(S(0), x);
  result.y = moved(S(0), y);
  return result;
}

/// The first corner of the domain, the last one, and between them the corner with the last x: the
/// corners of half the domain in 2D.
template <Scalar S, int N>
constexpr std::array<Vec<S, N>, 3> half_domain() {
  auto side = filled<S, N>(S::lowest());
  side.x = S::max();
  return {filled<S, N>(S::lowest()), side, filled<S, N>(S::max())};
}

/// (3, 4) / 5 with the exact angle: exactly parallel, 2^-30 too long.
template <Scalar S, int N>
constexpr Direction<S, N> three_four_fifths() {
  constexpr auto fifth = ((std::int64_t{1} << direction_component<S>::frac) + 1) / 5;
  static_assert(fifth * 5 == (std::int64_t{1} << direction_component<S>::frac) + 1);
  using Raw = typename direction_component<S>::raw_type;
  std::array<Raw, static_cast<std::size_t>(N)> raw{};
  raw[0] = static_cast<Raw>(3 * fifth);
  raw[1] = static_cast<Raw>(4 * fifth);
  return *Direction<S, N>::from_raw(raw);
}

/// A rotation with these axes x and y and, in 3D, the default z.
template <Scalar S, int N>
Rotation<S, N> frame(const Direction<S, N>& x, const Direction<S, N>& y) {
  if constexpr (N == 2) {
    return Rotation<S, 2>::from_axes({x, y});
  } else {
    return Rotation<S, 3>::from_axes({x, y, Direction<S, 3>::along(2)});
  }
}
/// Local x is along (x, y), local y to the left of it, and local z is unchanged.
template <Scalar S, int N>
Rotation<S, N> heading(double x, double y) {
  return frame(toward<S, N>(x, y), toward<S, N>(-y, x));
}

/// The distance; checks that the three raycasts agree on whether and where the ray enters.
template <Scalar S, int N, class Shape>
std::optional<S> distance(const Ray<S, N>& ray, const Shape& shape) {
  const auto distance = raycast(ray, shape);
  const auto hit = raycast_hit(ray, shape);
  const auto interval = raycast_interval(ray, shape);
  CHECK(hit.has_value() == distance.has_value());
  CHECK(interval.has_value() == distance.has_value());
  if (distance && hit && interval) {
    CHECK(hit->distance == *distance);
    CHECK(interval->enter == *distance);
    CHECK(interval->exit >= *distance);
    CHECK(interval->exit <= ray.max_distance);
    CHECK(hit->point == point_at(ray, *distance));
  }
  return distance;
}

template <Scalar S, int N, class Shape>
bool misses(const Ray<S, N>& ray, const Shape& shape) {
  return !distance(ray, shape).has_value();
}

// The world with its axes renamed cyclically, or mirrored across axis 0. Results must not depend on
// the names or directions of the axes.

template <Number T, int N>
constexpr Vec<T, N> turned(const Vec<T, N>& v) {
  return make_vec<N>([&](int i) { return v[(i + 1) % N]; });
}
template <Number T, int N>
constexpr Vec<T, N> mirrored(Vec<T, N> v) {
  v.x = narrow<bits_of<T>>(-v.x);
  return v;
}

template <Scalar S, int N>
constexpr Direction<S, N> turned(const Direction<S, N>& d) {
  return Direction<S, N>::assume_unit(turned(d.vec()));
}
template <Scalar S, int N>
constexpr Direction<S, N> mirrored(const Direction<S, N>& d) {
  return Direction<S, N>::assume_unit(mirrored(d.vec()));
}

/// Applies f to every point and direction of a ray or shape.
template <Scalar S, int N, class F>
constexpr Ray<S, N> changed(const Ray<S, N>& ray, const F& f) {
  return {f(ray.origin), f(ray.direction), ray.max_distance};
}
template <support::OfPoints Shape, class F>
constexpr Shape changed(const Shape& shape, const F& f) {
  return support::with_points(shape, f);
}
template <Scalar S, int N, class F>
constexpr Aabb<S, N> changed(const Aabb<S, N>& box, const F& f) {
  auto low = f(box.min);
  auto high = f(box.max);
  for (int i = 0; i < N; ++i) {
    if (low[i] > high[i]) std::swap(low[i], high[i]);
  }
  return {low, high};
}
template <Scalar S, int N, class F>
constexpr Obb<S, N> changed(const Obb<S, N>& box, const F& f) {
  std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
  for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = f(box.rotation.axis(i));
  return {f(box.center), box.half_extents, Rotation<S, N>::from_axes(axes)};
}
template <Scalar S, int N, class F>
constexpr Plane<S, N> changed(const Plane<S, N>& plane, const F& f) {
  return {f(plane.normal), plane.offset};
}

/// `value` in [-reach, reach] on every axis around `center`, for halves of the domain.
template <Scalar S, int N>
Vec<S, N> random_near(Random& random, const Vec<S, N>& center, std::int64_t reach) {
  return make_vec<N>([&](int i) {
    const auto raw = std::int64_t{center[i].raw()} + random.between(-reach, reach);
    const auto limit = std::int64_t{S::max().raw()};
    return S::from_raw(static_cast<typename S::raw_type>(std::clamp(raw, -limit, limit)));
  });
}
/// A point in half the domain, so that it can be mirrored, at a random scale.
template <Scalar S, int N>
Vec<S, N> random_point(Random& random) {
  const auto reach = std::int64_t{1} << random.between(4, S::bits - 1);
  return random_near(random, Vec<S, N>(), reach);
}
/// From one point to another; x if they are equal.
template <Scalar S, int N>
Direction<S, N> aimed(const Vec<S, N>& from, const Vec<S, N>& to) {
  return direction_of<S>(to - from).value_or(Direction<S, N>());
}

/// Checks that distances, intervals and, with `exact_normals`, normals do not depend on the frame.
template <Scalar S, int N, class Shape>
void check_symmetry(const Ray<S, N>& ray, const Shape& shape, bool exact_normals) {
  const auto turn = [](const auto& x) { return turned(x); };
  const auto mirror = [](const auto& x) { return mirrored(x); };
  const auto check = [&](const auto& change) {
    const auto other_ray = changed(ray, change);
    const auto other_shape = changed(shape, change);
    CHECK(raycast(other_ray, other_shape) == raycast(ray, shape));
    CHECK(raycast_interval(other_ray, other_shape) == raycast_interval(ray, shape));
    const auto hit = raycast_hit(ray, shape);
    const auto other_hit = raycast_hit(other_ray, other_shape);
    REQUIRE(other_hit.has_value() == hit.has_value());
    if (hit && exact_normals) CHECK(other_hit->normal == change(hit->normal));
  };
  check(turn);
  check(mirror);
}

/// `check_symmetry` of rays aimed within `spread` times the reach of boxes of all sizes up to
/// 2^`bits` steps. `box_of(random, center, half)` makes a box.
template <Scalar S, int N, class BoxOf>
void check_symmetry_of_boxes(std::uint64_t seed, int bits, double spread, bool exact_normals,
                             const BoxOf& box_of) {
  Random random(seed);
  INFO(random);
  HitRate rate;
  for (int i = 0; i < 2000; ++i) {
    const auto center = random_point<S, N>(random);
    const auto reach = std::int64_t{1} << random.between(2, bits);
    const auto half = make_vec<N>([&](int) { return random.number<S>(reach / 2, reach); });
    const auto box = box_of(random, center, half);
    const auto origin = random_point<S, N>(random);
    const auto around = static_cast<std::int64_t>(spread * static_cast<double>(reach));
    const Ray<S, N> ray{origin, aimed(origin, random_near(random, center, around))};
    rate.count(raycast(ray, box).has_value());
    check_symmetry(ray, box, exact_normals);
  }
  INFO(rate);
  CHECK(rate.is_balanced());
}

}  // namespace detent::test
