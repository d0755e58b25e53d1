// SPDX-License-Identifier: MIT
#pragma once

#include "detent/draw/circle.hpp"
#include "detent/draw/sink.hpp"
#include "detent/shape/capsule.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

namespace detail {

/// Draws the sides of a circle from side `first` up to `last`.
template <class Sink, Scalar S, int N>
constexpr void draw_arc(Sink& sink, const Vec<S, N>& center, const S& radius,
                        const Direction<S, N>& u, const Direction<S, N>& v, int first, int last,
                        const Colour& colour) {
  auto from = circle_point(center, radius, u, v, first);
  for (int i = first + 1; i <= last; ++i) {
    const auto to = circle_point(center, radius, u, v, i);
    sink.line(from, to, colour);
    from = to;
  }
}

/// A row of the surface around an axis `w`: the circle at `latitude` / 32 turn of the sphere about
/// `center`.
template <Scalar S>
struct Ring {
  Vec<S, 3> center;
  int latitude;
};

/// Draws the surface between rings, 16 points each. At a pole, a ring is one point.
template <class Sink, Scalar S>
constexpr void draw_band(Sink& sink, const Ring<S>& low, const Ring<S>& high, const S& radius,
                         const Direction<S, 3>& u, const Direction<S, 3>& v,
                         const Direction<S, 3>& w, const Colour& colour) {
  constexpr int step = 2, pole = circle_sides / 4;
  const auto point = [&](const Ring<S>& ring, int i) {
    using Component = direction_component<S>;
    const auto outward = nearest_to<Component>(u * circle_cosine<S>(i) + v * circle_sine<S>(i));
    const auto unit = outward * circle_cosine<S>(ring.latitude) + w * circle_sine<S>(ring.latitude);
    return nearest_to<S>(ring.center + nearest_to<Component>(unit) * radius);
  };
  for (int i = 0; i < circle_sides; i += step) {
    const auto a = point(low, i), b = point(low, i + step);
    const auto c = point(high, i + step), d = point(high, i);
    if (low.latitude != -pole) sink.triangle(a, b, c, colour);
    if (high.latitude != pole) sink.triangle(a, c, d, colour);
  }
}

}  // namespace detail

/// Draws a sphere as three circles of 32 lines, around the axes; a disc as one.
///
/// exact: the ends of lines are on the sphere, rounded to the grid once and clamped to the range of
///        the scalar; without that, off by 2^-28 of the radius at most, 2^-12 for 16-bit scalars
///        (tests/draw/shapes.test.cpp)
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const Sphere<S, N>& sphere, const Colour& colour) {
  if (sphere.radius < 0) return;
  for (int i = 0; i < (N == 2 ? 1 : 3); ++i) {
    detail::draw_arc(sink, sphere.center, sphere.radius, Direction<S, N>::along(i),
                     Direction<S, N>::along((i + 1) % N), 0, detail::circle_sides, colour);
  }
}

/// Draws a capsule: in 3D two circles, four lines along it and two half circles over each end; in
/// 2D its outline. One with equal ends is a sphere.
///
/// exact: as for a sphere, with a direction along the capsule that is rounded first
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const Capsule<S, N>& capsule, const Colour& colour) {
  const auto& [a, b, radius] = capsule;
  const auto axis = direction_of<S>(b - a);
  if (radius < 0 || !axis) return draw(sink, Sphere<S, N>{a, radius}, colour);
  constexpr int half = detail::circle_sides / 2, whole = detail::circle_sides;
  const auto u = detail::perpendicular(*axis);
  const auto side = [&](const auto& across) {
    // From u around the end at b to -u, and back around a.
    detail::draw_arc(sink, capsule.b, capsule.radius, across, *axis, 0, half, colour);
    detail::draw_arc(sink, capsule.a, capsule.radius, across, *axis, half, whole, colour);
    for (const int i : {0, half}) {
      sink.line(detail::circle_point(capsule.a, capsule.radius, across, *axis, i),
                detail::circle_point(capsule.b, capsule.radius, across, *axis, i), colour);
    }
  };
  side(u);
  if constexpr (N == 3) {
    const auto v = detail::perpendicular(*axis, u);
    side(v);
    detail::draw_arc(sink, a, radius, u, v, 0, whole, colour);
    detail::draw_arc(sink, b, radius, u, v, 0, whole, colour);
  }
}

/// Draws the surface of a capsule as 256 triangles, counter-clockwise seen from outside; that of a
/// sphere, or a capsule with equal ends, as 224.
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const Capsule<S, 3>& capsule, const Colour& colour) {
  if (capsule.radius < 0) return;
  const auto axis = direction_of<S>(capsule.b - capsule.a);
  const auto w = axis.value_or(Direction<S, 3>::along(1));
  const auto u = detail::perpendicular(w);
  const auto v = detail::perpendicular(w, u);
  const auto band = [&](const detail::Ring<S>& low, const detail::Ring<S>& high) {
    detail::draw_band(sink, low, high, capsule.radius, u, v, w, colour);
  };
  constexpr int pole = detail::circle_sides / 4, step = 2;
  for (int i = -pole; i < 0; i += step) band({capsule.a, i}, {capsule.a, i + step});
  if (axis) band({capsule.a, 0}, {capsule.b, 0});
  for (int i = 0; i < pole; i += step) band({capsule.b, i}, {capsule.b, i + step});
}
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const Sphere<S, 3>& sphere, const Colour& colour) {
  draw_solid(sink, Capsule<S, 3>{sphere.center, sphere.center, sphere.radius}, colour);
}

}  // namespace detent
