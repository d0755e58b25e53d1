// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "detent/draw/sink.hpp"
#include "detent/shape/frustum.hpp"
#include "detent/shape/hull.hpp"

namespace detent {

namespace detail {

/// The edges of a hull without a list of its faces, by exact signs: points i and j span an edge if
/// all other points are on one side of a plane through both, and those on their line are between
/// them. Time grows with the cube of the number of points.
template <Scalar S, int N>
class HullEdges {
 public:
  explicit constexpr HullEdges(const ConvexHull<S, N>& hull) noexcept : hull_(hull) {}

  [[nodiscard]] constexpr std::size_t count() const noexcept { return hull_.points.size(); }
  [[nodiscard]] constexpr const Vec<S, N>& operator[](std::size_t i) const noexcept {
    return hull_.points[i];
  }

  /// Whether point i is the first of its equals; only that one spans edges.
  [[nodiscard]] constexpr bool is_first(std::size_t i) const noexcept {
    std::size_t first = 0;
    while (hull_.points[first] != hull_.points[i]) ++first;
    return first == i;
  }

  [[nodiscard]] constexpr bool is_edge(std::size_t i, std::size_t j) const noexcept {
    return is_longest(i, j) && is_outside(i, j);
  }

  /// The point farthest to the left of the line from i to j, seen against it, so that all other
  /// points are behind the facet through i, j and that point; nothing if all points are on the
  /// line.
  [[nodiscard]] constexpr std::optional<std::size_t> leftmost(std::size_t i,
                                                              std::size_t j) const noexcept
      requires(N == 3) {
    std::optional<std::size_t> left;
    for (std::size_t k = 0; k < count(); ++k) {
      if (!is_on_line(i, j, k) && (!left || turn(i, j, *left, k) > 0)) left = k;
    }
    return left;
  }

  /// Positive if k -> l turns left about the line from i to j; 0 if a plane holds all four.
  [[nodiscard]] constexpr auto turn(std::size_t i, std::size_t j, std::size_t k,
                                    std::size_t l) const noexcept requires(N == 3) {
    return dot(from(i, j), cross(from(i, k), from(i, l)));
  }

  [[nodiscard]] constexpr bool is_on_line(std::size_t i, std::size_t j,
                                          std::size_t k) const noexcept {
    const auto normal = cross(from(i, j), from(i, k));
    if constexpr (N == 2) {
      return normal == 0;
    } else {
      return normal.x == 0 && normal.y == 0 && normal.z == 0;
    }
  }

 private:
  [[nodiscard]] constexpr auto from(std::size_t i, std::size_t j) const noexcept {
    return hull_.points[j] - hull_.points[i];
  }

  /// Whether the points on the line through i and j lie between them.
  [[nodiscard]] constexpr bool is_longest(std::size_t i, std::size_t j) const noexcept {
    const auto way = from(i, j);
    for (std::size_t k = 0; k < count(); ++k) {
      if (!is_on_line(i, j, k)) continue;
      const auto along = dot(way, from(i, k));
      if (along < 0 || along > dot(way, way)) return false;
    }
    return true;
  }

  [[nodiscard]] constexpr bool is_outside(std::size_t i, std::size_t j) const noexcept {
    if constexpr (N == 2) {
      bool has_left = false, has_right = false;
      for (std::size_t k = 0; k < count(); ++k) {
        const auto side = cross(from(i, j), from(i, k));
        has_left = has_left || side > 0;
        has_right = has_right || side < 0;
      }
      return !(has_left && has_right);
    } else {
      // All points must be behind the facet on the left; those in its plane must not be across the
      // line.
      const auto left = leftmost(i, j);
      if (!left) return true;
      const auto normal = cross(from(i, j), from(i, *left));
      for (std::size_t k = 0; k < count(); ++k) {
        const auto height = dot(normal, from(i, k));
        if (height > 0) return false;
        if (height == 0 && dot(normal, cross(from(i, j), from(i, k))) < 0) return false;
      }
      return true;
    }
  }

  const ConvexHull<S, N>& hull_;
};

}  // namespace detail

/// Draws every edge of a hull once, also those between nearly coplanar sides: 12 lines for a box,
/// none for a single point.
///
/// domain: every hull; meant for up to 100 points, since time grows with the cube of their number
/// exact:  the edges of the hull of the points as given          (tests/draw/hull.test.cpp)
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const ConvexHull<S, N>& hull, const Colour& colour) {
  const detail::HullEdges edges(hull);
  for (std::size_t i = 0; i < edges.count(); ++i) {
    if (!edges.is_first(i)) continue;
    for (std::size_t j = i + 1; j < edges.count(); ++j) {
      if (edges.is_first(j) && edges.is_edge(i, j)) sink.line(edges[i], edges[j], colour);
    }
  }
}

/// Draws the sides of a hull as triangles, counter-clockwise seen from outside; a flat one from both
/// sides.
///
/// exact: the triangles cover the surface of the hull once       (tests/draw/hull.test.cpp)
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const ConvexHull<S, 3>& hull, const Colour& colour) {
  const detail::HullEdges edges(hull);
  for (std::size_t i = 0; i < edges.count(); ++i) {
    if (!edges.is_first(i)) continue;
    for (std::size_t j = 0; j < edges.count(); ++j) {
      if (j == i || !edges.is_first(j) || !edges.is_edge(i, j)) continue;
      const auto left = edges.leftmost(i, j);
      if (!left) continue;
      // Each edge of a facet makes a triangle with the first point of the facet.
      std::size_t first = 0;
      while (edges.turn(i, j, *left, first) != 0) ++first;
      if (!edges.is_on_line(i, j, first)) {
        sink.triangle(edges[first], edges[i], edges[j], colour);
      }
    }
  }
}
/// Draws the sides of the hull of a frustum's corners.
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const Frustum<S>& frustum, const Colour& colour) {
  draw_solid(sink, frustum.hull(), colour);
}

}  // namespace detent
