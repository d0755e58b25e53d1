// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/draw/sink.hpp"
#include "detent/math/rotation.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/frustum.hpp"
#include "detent/shape/obb.hpp"

namespace detent {

namespace detail {

/// The corners of a box: corner i is at the greater end of axis k if bit k of i is set.
template <Scalar S, int N>
using BoxCorners = std::array<Vec<S, N>, std::size_t{1} << N>;

template <Scalar S, int N>
[[nodiscard]] constexpr BoxCorners<S, N> box_corners(const Aabb<S, N>& box) noexcept {
  BoxCorners<S, N> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = make_vec<N>([&](int k) { return (i >> k & 1) != 0 ? box.max[k] : box.min[k]; });
  }
  return corners;
}
template <Scalar S, int N>
[[nodiscard]] constexpr BoxCorners<S, N> box_corners(const Obb<S, N>& box) noexcept {
  BoxCorners<S, N> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto along = [&](int k, int axis) {
      const auto component = box.rotation.axis(k)[axis];
      return (i >> k & 1) != 0 ? component : narrow_negative(component);
    };
    corners[i] = make_vec<N>([&](int axis) {
      const auto row = make_vec<N>([&](int k) { return along(k, axis); });
      return nearest_to<S>(box.center[axis] + dot(row, box.half_extents));
    });
  }
  return corners;
}

template <class Sink, Scalar S, std::size_t Count, int N>
constexpr void draw_box(Sink& sink, const std::array<Vec<S, N>, Count>& corners,
                        const Colour& colour) {
  for (std::size_t i = 0; i < Count; ++i) {
    for (std::size_t bit = 1; bit < Count; bit *= 2) {
      if ((i & bit) == 0) sink.line(corners[i], corners[i | bit], colour);
    }
  }
}

template <class Sink, Scalar S>
constexpr void draw_solid_box(Sink& sink, const BoxCorners<S, 3>& corners, const Colour& colour) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t front = std::size_t{1} << axis, u = std::size_t{1} << (axis + 1) % 3,
                      v = std::size_t{1} << (axis + 2) % 3;
    sink.triangle(corners[front], corners[front | u], corners[front | u | v], colour);
    sink.triangle(corners[front], corners[front | u | v], corners[front | v], colour);
    sink.triangle(corners[0], corners[u | v], corners[u], colour);
    sink.triangle(corners[0], corners[v], corners[u | v], colour);
  }
}

}  // namespace detail

/// Draws the edges of a box: 12 lines, in 2D 4. Corners of an `Obb` are rounded once. An empty box
/// has no lines.
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const Aabb<S, N>& box, const Colour& colour) {
  if (!is_empty(box)) detail::draw_box(sink, detail::box_corners(box), colour);
}
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const Obb<S, N>& box, const Colour& colour) {
  if (!is_empty(box)) detail::draw_box(sink, detail::box_corners(box), colour);
}

/// Draws the 12 edges of a frustum.
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw(Sink& sink, const Frustum<S>& frustum, const Colour& colour) {
  detail::draw_box(sink, frustum.corners(), colour);
}

/// Draws the sides of a box as 12 triangles, counter-clockwise seen from outside.
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const Aabb<S, 3>& box, const Colour& colour) {
  if (!is_empty(box)) detail::draw_solid_box(sink, detail::box_corners(box), colour);
}
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const Obb<S, 3>& box, const Colour& colour) {
  if (!is_empty(box)) detail::draw_solid_box(sink, detail::box_corners(box), colour);
}

}  // namespace detent
