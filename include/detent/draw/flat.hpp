// SPDX-License-Identifier: MIT
#pragma once

#include "detent/draw/circle.hpp"
#include "detent/draw/sink.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/point_plane.hpp"
#include "detent/query/raycast/aabb.hpp"
#include "detent/shape/plane.hpp"
#include "detent/shape/ray.hpp"
#include "detent/shape/segment.hpp"
#include "detent/shape/triangle.hpp"

namespace detent {

namespace detail {

/// The point of a plane closest to another point, off the plane by at most half a step. It may be
/// outside the range.
template <Scalar S, int N>
[[nodiscard]] constexpr auto foot_on(const Plane<S, N>& plane, const Vec<S, N>& point) noexcept {
  const auto height =
      quotient_nearest<Length<S>>(height_above(plane, point), squared_length(plane.normal));
  return point - plane.normal * height;
}

/// Points of the drawn part of a plane, by coordinates in quarters of its reach.
template <Scalar S>
class PlaneSquare {
 public:
  constexpr PlaneSquare(const Plane<S, 3>& plane, const DrawRegion<S, 3>& region) noexcept
      : middle_(foot_on(plane, region.center)),
        u_(perpendicular(plane.normal)),
        v_(perpendicular(plane.normal, u_)),
        reach_(region.reach) {}

  [[nodiscard]] constexpr Vec<S, 3> operator()(int x, int y) const noexcept {
    return nearest_to<S>(middle_ + half(half((u_ * x + v_ * y) * reach_)));
  }

 private:
  decltype(foot_on(Plane<S, 3>(), Vec<S, 3>())) middle_;
  Direction<S, 3> u_, v_;
  S reach_;
};

}  // namespace detail

/// Draws a segment as one line.
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const Segment<S, N>& segment, const Colour& colour) {
  sink.line(segment.start, segment.end, colour);
}

/// Draws a ray as one line, to its end or to the end of the scalar's range. An empty ray has no
/// line.
///
/// exact: the far end is `point_at` of a distance rounded down   (tests/draw/shapes.test.cpp)
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const Ray<S, N>& ray, const Colour& colour) {
  const Aabb<S, N> range{make_vec<N>([](int) { return lowest<S>; }),
                         make_vec<N>([](int) { return largest<S>; })};
  if (const auto inside = raycast_interval(ray, range)) {
    sink.line(ray.origin, point_at(ray, inside->exit), colour);
  }
}

/// Draws the three sides of a triangle.
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const Triangle<S, N>& triangle, const Colour& colour) {
  sink.line(triangle.a, triangle.b, colour);
  sink.line(triangle.b, triangle.c, colour);
  sink.line(triangle.c, triangle.a, colour);
}
/// Draws the triangle itself.
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const Triangle<S, 3>& triangle, const Colour& colour) {
  sink.triangle(triangle.a, triangle.b, triangle.c, colour);
}

/// Draws the part of a plane in a region: a grid of 9 by 9 lines, in 2D one line.
///
/// exact: points are off the plane by at most the rounding of two points plus 2^-29 of the reach
///        (2^-13 for 16-bit scalars)                              (tests/draw/shapes.test.cpp)
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw(Sink& sink, const Plane<S, 3>& plane, const Colour& colour,
                    const DrawRegion<S, 3>& region = {}) {
  const detail::PlaneSquare point(plane, region);
  for (int i = -4; i <= 4; ++i) {
    sink.line(point(i, -4), point(i, 4), colour);
    sink.line(point(-4, i), point(4, i), colour);
  }
}
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 2>
constexpr void draw(Sink& sink, const Plane<S, 2>& plane, const Colour& colour,
                    const DrawRegion<S, 2>& region = {}) {
  const auto middle = detail::foot_on(plane, region.center);
  const auto reach = detail::perpendicular(plane.normal) * region.reach;
  sink.line(nearest_to<S>(middle - reach), nearest_to<S>(middle + reach), colour);
}

/// Draws the part of a plane in a region as two triangles, counter-clockwise seen from the side of
/// the normal.
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const Plane<S, 3>& plane, const Colour& colour,
                          const DrawRegion<S, 3>& region = {}) {
  const detail::PlaneSquare point(plane, region);
  sink.triangle(point(-4, -4), point(4, -4), point(4, 4), colour);
  sink.triangle(point(-4, -4), point(4, 4), point(-4, 4), colour);
}

}  // namespace detent
