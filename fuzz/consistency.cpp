// SPDX-License-Identifier: MIT
//
// The queries agree about each shape: the closest point and a hit's point are on it within their
// rounding, and a point gives the same result as a sphere, capsule, segment, triangle or box that
// has collapsed to it.
//
// Tolerances, in raw units. Rounding to the grid moves a point by at most sqrt(3)/2 < 1. On top of
// that, a hit's distance is rounded down by less than 1 along a direction of length < 1 + 2^-13, so
// its point is off by less than 2. A box is measured in its frame, where the three coordinates of a
// step of length e along its axes are each at most (1 + 2^-13) e: less than 2 e together.
//
// So a step of 8 raw units along the normal, rounding included, leaves every convex shape. If a
// ball of radius r around c is inside the shape, a step of 8 / r of the way to c enters it, because
// the shape contains balls of radius up to 8 around the points of that segment.

#include <algorithm>

#include "decode.hpp"
#include "detent/query/closest_point.hpp"
#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"
#include "detent/query/intersects.hpp"
#include "detent/query/on.hpp"
#include "detent/query/overlaps.hpp"
#include "detent/query/raycast.hpp"
#include "detent/scene/question.hpp"
#include "reasons.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <Scalar S, int N>
bool is_at_an_end(const Vec<S, N>& p) {
  for (int i = 0; i < N; ++i) {
    if (p[i] == S::lowest() || p[i] == S::max()) return true;
  }
  return false;
}

template <class Shape>
inline constexpr bool is_obb = false;
template <Scalar S, int N>
inline constexpr bool is_obb<Obb<S, N>> = true;

template <Scalar S>
S raw_units(int count) {
  return S::from_raw(static_cast<typename S::raw_type>(count));
}

/// A ball inside a solid.
template <detail::Round Shape>
auto ball_in(const Shape& shape) {
  return Sphere{detail::reference(shape), shape.radius};
}
template <Scalar S, int N>
Sphere<S, N> ball_in(const Obb<S, N>& box) {
  S least = box.half_extents[0];
  for (int i = 1; i < N; ++i) least = std::min(least, box.half_extents[i]);
  return {box.center, least};
}
template <Scalar S, int N>
Sphere<S, N> ball_in(const Aabb<S, N>& box) {
  Obb<S, N> same;
  for (int i = 0; i < N; ++i) {
    const std::int64_t low = box.min[i].raw(), high = box.max[i].raw();
    same.center[i] = oracle::Draw<S, N>::scalar((low + high) / 2);
    same.half_extents[i] = oracle::Draw<S, N>::scalar((high - low) / 2 - 1);
  }
  return ball_in(same);
}

/// Moves a hit's point 8 raw units out of the shape; or into it, towards the ball's center.
template <Scalar S, int N>
Vec<S, N> nudged_out(const RayHit<S, N>& hit) {
  using D = oracle::Draw<S, N>;
  oracle::Raw<N> raw{};
  for (int i = 0; i < N; ++i) raw[static_cast<std::size_t>(i)] = hit.point[i].raw();
  return D::vec(D::moved(raw, hit.normal, 8));
}
template <Scalar S, int N>
Vec<S, N> nudged_in(const RayHit<S, N>& hit, const Sphere<S, N>& ball) {
  oracle::Raw<N> raw{};
  for (int i = 0; i < N; ++i) {
    const std::int64_t from = hit.point[i].raw(), to = ball.center[i].raw();
    raw[static_cast<std::size_t>(i)] = from + (to - from) * 8 / ball.radius.raw();
  }
  return oracle::Draw<S, N>::vec(raw);
}

template <class Shape, Scalar S, int N>
void check(Source& source) {
  Decoder<S, N> decoder(source);
  const auto shape = decoder.template shape<Shape>();
  const auto ray = decoder.template shape<Ray<S, N>>();
  const auto point = decoder.point();
  const auto because = reasons(shape, ray, point);

  const bool inside = contains(shape, point);
  const S apart = distance(shape, point);
  require(!inside || apart == 0, because("a point inside is at distance 0"));
  require(apart != 0 || on(shape, point, raw_units<S>(1)), because("distance 0 is near"));
  require(inside == on(shape, point, S(0)), because("on without tolerance is inside"));
  if (apart < S::max()) {
    require(on(shape, point, S::from_raw(static_cast<typename S::raw_type>(apart.raw() + 1))),
            because("on within the distance"));
  }
  if (apart > 0) {
    require(!on(shape, point, S::from_raw(static_cast<typename S::raw_type>(apart.raw() - 1))),
            because("not on within less than the distance"));
  }

  // An empty shape gives the point itself. On skewed axes the foot need not be in the box.
  const auto closest = closest_point(shape, point);
  if (inside && !is_at_an_end(point) && closest != point) {
    // Only solids return an inside point itself; for a surface it may be rounded off the shape.
    require(on(shape, closest, raw_units<S>(1)), because("closest to itself"));
  }
  if (!is_obb<Shape> && apart < S::max() && !is_at_an_end(closest)) {
    require(on(shape, closest, raw_units<S>(1)), because("the closest point is on the shape"));
  }

  const bool sphere = overlaps(Sphere<S, N>{point, S(0)}, shape);
  require(sphere == inside, because("a sphere of radius 0"));
  require(overlaps(shape, Capsule<S, N>{point, point, S(0)}) == inside,
          because("a capsule of radius 0"));
  require(intersects(Segment<S, N>{point, point}, shape) == inside,
          because("a segment of a point"));
  if constexpr (!is_obb<Shape>) {
    require(overlaps(Triangle<S, N>{point, point, point}, shape) == inside,
            because("a triangle of a point"));
    require(overlaps(Aabb<S, N>{point, point}, shape) == inside, because("a box of a point"));
    // Round shapes see a box as slabs; one of size 0 is a point only if its axes are independent.
    const auto turn = detail::Round<Shape> ? Rotation<S, N>() : decoder.rotation();
    require(overlaps(Obb<S, N>{point, {}, turn}, shape) == inside,
            because("an oriented box of a point"));
  }
  if (apart < S::max() && apart > 0) {
    const S below = S::from_raw(static_cast<typename S::raw_type>(apart.raw() - 1));
    const S above = S::from_raw(static_cast<typename S::raw_type>(apart.raw() + 1));
    require(!overlaps(Sphere<S, N>{point, below}, shape), because("a sphere short of the shape"));
    require(overlaps(Sphere<S, N>{point, above}, shape), because("a sphere that reaches it"));
  }

  if constexpr (requires { raycast(ray, shape); }) {
    const auto t = raycast(ray, shape);
    const auto hit = raycast_hit(ray, shape);
    const auto interval = raycast_interval(ray, shape);
    require(hit.has_value() == t.has_value(), because("hit and distance"));
    require(interval.has_value() == t.has_value(), because("interval and distance"));
    if (ray.max_distance >= 0 && contains(shape, ray.origin)) {
      require(t == S(0), because("a ray that starts inside"));
    }
    if (!t) return;
    require(*t >= 0 && *t <= ray.max_distance, because("within reach"));
    require(hit->distance == *t && interval->enter == *t, because("one distance"));
    require(interval->exit >= *t && interval->exit <= ray.max_distance, because("exit"));
    require(hit->point == point_at(ray, *t), because("the point is the ray's"));
    if (!is_at_an_end(hit->point)) {
      require(on(shape, hit->point, raw_units<S>(is_obb<Shape> ? 4 : 2)),
              because("the hit is on the shape"));
      const auto out = nudged_out(*hit);
      if (*t > 0 && !is_at_an_end(out)) {
        require(!contains(shape, out), because("nudged out is not contained"));
      }
      if constexpr (requires { ball_in(shape); }) {
        if (const auto ball = ball_in(shape); ball.radius >= raw_units<S>(16)) {
          require(contains(shape, nudged_in(*hit, ball)), because("nudged in is contained"));
        }
      }
    }
  }
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_shape<S, N>(
        source, [&]<class Shape>(std::type_identity<Shape>) { check<Shape, S, N>(source); });
  });
}

}  // namespace detent::fuzz
