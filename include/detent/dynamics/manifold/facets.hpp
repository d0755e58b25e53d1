// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/manifold/polytope.hpp"
#include "detent/dynamics/mass/hull.hpp"

namespace detent::detail {

/// The `reach` of a polyhedron whose corners are rounded to the grid of `Lever`; 0 unless no corner
/// was clamped and the normals u, v of the faces of each edge have -1 + 2^-6 <= u . v <= 1 - 2^-20.
template <Scalar S, std::size_t Points, class Lever = typename Formats<S>::Lever>
[[nodiscard]] constexpr Lever regular_reach(const PolytopeParts<S, 3, Points>& parts) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  constexpr auto flattest = Ratio(1) - one_over<Ratio>(1 << 20);
  constexpr auto sharpest = one_over<Ratio>(64) - Ratio(1);
  for (std::size_t i = 0; i < parts.edge_count; ++i) {
    const auto& edge = parts.edges[i];
    const auto cosine =
        narrow_dot<62>(parts.faces[edge.left].normal, parts.faces[edge.right].normal);
    if (cosine < sharpest || cosine > flattest) return {};
  }
  Lever reach{};
  for (std::size_t i = 0; i < parts.point_count; ++i) {
    for (int c = 0; c < 3; ++c) reach = (max)(reach, nearest_to<Lever>(abs(parts.points[i][c])));
  }
  if constexpr (is_fixed<S>) {
    if (reach.raw() >> 29 != 0) return {};
  }
  return reach;
}

/// The `radius` of a polytope about its center; 0, which means unknown, for scalars that round and
/// if it may be 2^29 steps.
template <Scalar S, int N, std::size_t Points, class Lever = typename Formats<S>::Lever>
[[nodiscard]] constexpr Lever radius_of(const PolytopeParts<S, N, Points>& parts) noexcept {
  if constexpr (is_fixed<S>) {
    auto most = squared_length(parts.points[0]);
    for (std::size_t i = 1; i < parts.point_count; ++i) {
      most = (max)(most, squared_length(parts.points[i]));
    }
    const auto radius = sqrt_floor<Lever>(most);
    if (radius.raw() >> 29 == 0) return nearest_to<Lever>(radius + positive<Lever>());
  }
  return {};
}

/// The faces of a hull: its corners in the order of its points, its faces in that of their first
/// directed edge, by corners. Points that are not corners have no effect. No faces for a hull
/// without volume.
///
/// `center` is subtracted from the points, each coordinate clamped.
template <std::size_t Points, Scalar S, int N>
[[nodiscard]] constexpr PolytopeParts<S, N, Points> facets_of(
    std::span<const Vec<S, N>> points,
    const Vec<typename MassFormats<S>::Center, N>& center) noexcept {
  using Lever = typename Formats<S>::Lever;
  using Ratio = typename Formats<S>::Ratio;
  constexpr std::size_t none = Points;
  PolytopeParts<S, N, Points> parts;
  const HullGrid<S, N> grid(points);
  // next[j][k] is the corner after k in the face left of the edge from j to k.
  std::array<std::array<std::uint8_t, Points>, Points> next{};
  std::array<std::size_t, Points> number{};
  for (auto& row : next) row.fill(static_cast<std::uint8_t>(none));
  const auto is_edge = [&](std::size_t j, std::size_t k) { return next[j][k] != none; };
  visit_edges(grid, [&](std::size_t j, std::size_t k) { next[j][k] = 0; });
  for (std::size_t i = 0; i < points.size(); ++i) {
    number[i] = none;
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (is_edge(i, j)) number[i] = parts.point_count;
    }
    if (number[i] == none) continue;
    parts.points[parts.point_count++] =
        make_vec<N>([&](int c) { return nearest_to<Lever>(points[i][c] - center[c]); });
  }
  for (std::size_t j = 0; j < points.size(); ++j) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!is_edge(j, k)) continue;
      if constexpr (N == 2) {
        const auto along = unit_or_x<Ratio>(points[k] - points[j]);
        parts.add_face({along.y, narrow_negative(along.x)});
        parts.add_corner(number[j], narrow_negative(along));
        parts.add_corner(number[k], along);
      } else {
        const auto edge = grid[k] - grid[j];
        // The corner next to k such that all others are below the plane through it.
        auto normal = decltype(cross(edge, edge)){};
        for (std::size_t l = 0; l < points.size(); ++l) {
          if (l == j || !is_edge(k, l)) continue;
          const auto q = grid[l] - grid[j];
          if (normal == decltype(normal){} || dot(normal, q) > 0) {
            normal = cross(edge, q);
            next[j][k] = static_cast<std::uint8_t>(l);
          }
        }
      }
    }
  }
  if constexpr (N == 3) {
    std::array<std::array<std::uint8_t, Points>, Points> face{};  // 1 more than its number
    for (std::size_t j = 0; j < points.size(); ++j) {
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (!is_edge(j, k) || face[j][k] != 0) continue;
        const auto normal =
            unit_or_x<Ratio>(cross(points[k] - points[j], points[next[j][k]] - points[j]));
        parts.add_face(normal);
        for (std::size_t from = j, to = k; face[from][to] == 0;) {
          face[from][to] = static_cast<std::uint8_t>(parts.face_count);
          parts.add_corner(number[from],
                           unit_or_x<Ratio>(cross(points[to] - points[from], normal)));
          const std::size_t after = next[from][to];
          from = to;
          to = after;
        }
      }
    }
    for (std::size_t j = 0; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        if (!is_edge(j, k)) continue;
        parts.add_edge(number[j], number[k], unit_or_x<Ratio>(points[k] - points[j]),
                       face[j][k] - std::size_t{1}, face[k][j] - std::size_t{1});
      }
    }
    if constexpr (has_filters) parts.reach = regular_reach(parts);
  }
  if constexpr (has_filters) parts.radius = radius_of(parts);
  return parts;
}

}  // namespace detent::detail
