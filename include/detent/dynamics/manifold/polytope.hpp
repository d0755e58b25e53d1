// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/dynamics/manifold/pose.hpp"

namespace detent::detail {

/// A face of a convex polytope. Its corners and sides are runs of `count` in the polytope's lists;
/// side k passes through corner k. In 3D it is the edge to the next corner, counter-clockwise seen
/// from outside; in 2D the face is an edge with two corners.
template <Scalar S, int N>
struct PolytopeFace {
  Vec<typename Formats<S>::Ratio, N> normal{};  // outward
  typename ContactFormats<S>::Span level{};     // normal . first corner
  std::uint8_t first = 0, count = 0;
};

/// An edge of a polyhedron: two corners, the faces left and right of it seen from outside.
template <Scalar S>
struct PolytopeEdge {
  Vec<typename Formats<S>::Ratio, 3> along{};  // from the first corner to the second
  std::uint8_t from = 0, to = 0, left = 0, right = 0;
};

/// A convex polygon or polyhedron in the frame of its body, stored by its owner. Unit vectors are
/// rounded once; faces use them as stored, whatever the corners are.
template <Scalar S, int N>
struct Polytope {
  using Lever = typename Formats<S>::Lever;
  using Ratio = typename Formats<S>::Ratio;
  using Span = typename ContactFormats<S>::Span;
  using Point = Vec<Lever, N>;

  std::span<const Point> points;
  std::span<const PolytopeFace<S, N>> faces;
  std::span<const std::uint8_t> corners;  // of the faces
  std::span<const Vec<Ratio, N>> sides;   // of the faces: normals in their planes, outward
  std::span<const PolytopeEdge<S>> edges;
  /// The greatest magnitude of a corner's coordinate, if `edges_facing` may leave out edges; else 0.
  Lever reach{};
  /// No corner is farther from the origin; 0 if that is not known.
  Lever radius{};

  /// Corner `k` of a face, from 0 on.
  [[nodiscard]] constexpr const Point& corner(const PolytopeFace<S, N>& face,
                                              std::size_t k) const noexcept {
    return points[corners[face.first + k]];
  }

  /// The height of `p` over the plane of a face: |n| |p - v| is below 2 sqrt(3) 2^61 (1 + 2^-28).
  [[nodiscard]] constexpr Span height(const PolytopeFace<S, N>& face,
                                      const Point& p) const noexcept {
    constexpr int bits = bits_of<Span>;
    return narrow_difference<bits>(narrow_dot<bits>(face.normal, p), face.level);
  }
  /// The distance of `p` beyond side `k` of a face.
  [[nodiscard]] constexpr Span beyond(const PolytopeFace<S, N>& face, std::size_t k,
                                      const Point& p) const noexcept {
    return along(sides[face.first + k], p, corner(face, k));
  }
  /// Whether `p` is above or below the face.
  [[nodiscard]] constexpr bool covers(const PolytopeFace<S, N>& face,
                                      const Point& p) const noexcept {
    for (std::size_t k = 0; k < face.count; ++k) {
      if (beyond(face, k, p) > 0) return false;
    }
    return true;
  }

  /// n . (p - q), exactly.
  [[nodiscard]] static constexpr Span along(const Vec<Ratio, N>& n, const Point& p,
                                            const Point& q) noexcept {
    constexpr int bits = bits_of<Span>;
    return narrow_difference<bits>(narrow_dot<bits>(n, p), narrow_dot<bits>(n, q));
  }
};

/// The storage of a polytope with up to `Points` corners. By Euler's formula a polyhedron has at
/// most 2 n - 4 faces, 3 n - 6 edges and twice as many sides.
template <Scalar S, int N, std::size_t Points>
struct PolytopeParts {
  static constexpr std::size_t face_room = N == 2 ? Points : 2 * Points - 4;
  static constexpr std::size_t edge_room = N == 2 ? 1 : 3 * Points - 6;
  static constexpr std::size_t side_room = N == 2 ? 2 * Points : 2 * edge_room;
  using Ratio = typename Formats<S>::Ratio;

  std::array<Vec<typename Formats<S>::Lever, N>, Points> points{};
  std::array<PolytopeFace<S, N>, face_room> faces{};
  std::array<std::uint8_t, side_room> corners{};
  std::array<Vec<Ratio, N>, side_room> sides{};
  std::array<PolytopeEdge<S>, edge_room> edges{};
  std::size_t point_count = 0, face_count = 0, side_count = 0, edge_count = 0;
  typename Formats<S>::Lever reach{}, radius{};

  [[nodiscard]] constexpr Polytope<S, N> view() const noexcept {
    return {std::span(points).first(point_count),
            std::span(faces).first(face_count),
            std::span(corners).first(side_count),
            std::span(sides).first(side_count),
            std::span(edges).first(edge_count),
            reach,
            radius};
  }

  constexpr void add_face(const Vec<Ratio, N>& normal) noexcept {
    faces[face_count].normal = normal;
    faces[face_count++].first = static_cast<std::uint8_t>(side_count);
  }
  /// A corner of the last added face; the points are known.
  constexpr void add_corner(std::size_t point, const Vec<Ratio, N>& side) noexcept {
    auto& face = faces[face_count - 1];
    if (face.count++ == 0) {
      face.level = narrow_dot<bits_of<decltype(face.level)>>(face.normal, points[point]);
    }
    corners[side_count] = static_cast<std::uint8_t>(point);
    sides[side_count++] = side;
  }
  constexpr void add_edge(std::size_t from, std::size_t to, const Vec<Ratio, 3>& along,
                          std::size_t left, std::size_t right) noexcept {
    edges[edge_count++] = {along, static_cast<std::uint8_t>(from), static_cast<std::uint8_t>(to),
                           static_cast<std::uint8_t>(left), static_cast<std::uint8_t>(right)};
  }
};

/// A box as a polytope: corner c is on the negative side of each axis whose bit is set in c; face 2
/// i looks along axis i, and 2 i + 1 against it.
template <Scalar S, int N>
[[nodiscard]] constexpr PolytopeParts<S, N, 8> polytope_of(const BoxCore<S, N>& box) noexcept {
  using Lever = typename Formats<S>::Lever;
  PolytopeParts<S, N, 8> parts;
  RelativePose<S, N> frame;
  frame.axes = box.axes;
  frame.translation = box.center;
  for (std::size_t c = 0; c < (std::size_t{1} << N); ++c) {
    parts.points[parts.point_count++] =
        placed_point<Lever>(frame, make_vec<N>([&](int i) {
                              return (c >> i & 1) != 0 ? narrow_negative(box.half[i]) : box.half[i];
                            }));
  }
  const auto axis = [&](int i, bool negative) {
    const auto& u = box.axes[static_cast<std::size_t>(i)];
    return negative ? narrow_negative(u) : u;
  };
  const auto on_side = [](int i, bool negative) {
    return negative ? std::size_t{1} << i : std::size_t{0};
  };
  for (int i = 0; i < N; ++i) {
    const int j = (i + 1) % N, k = (i + 2) % N;
    for (const bool negative : {false, true}) {
      parts.add_face(axis(i, negative));
      const auto face = on_side(i, negative);
      if constexpr (N == 2) {
        for (const bool end : {false, true}) parts.add_corner(face | on_side(j, end), axis(j, end));
      } else {
        // Around axis i, or the other way round.
        const int first = negative ? k : j, second = negative ? j : k;
        parts.add_corner(face, axis(second, false));
        parts.add_corner(face | on_side(first, true), axis(first, true));
        parts.add_corner(face | on_side(first, true) | on_side(second, true), axis(second, true));
        parts.add_corner(face | on_side(second, true), axis(first, false));
      }
    }
    if constexpr (N == 3) {
      for (const bool at_j : {false, true}) {
        for (const bool at_k : {false, true}) {
          const auto corner = on_side(j, at_j) | on_side(k, at_k);
          const auto face_j = 2 * static_cast<std::size_t>(j) + std::size_t{at_j};
          const auto face_k = 2 * static_cast<std::size_t>(k) + std::size_t{at_k};
          const bool j_is_left = at_j == at_k;
          parts.add_edge(corner | on_side(i, true), corner, axis(i, false),
                         j_is_left ? face_j : face_k, j_is_left ? face_k : face_j);
        }
      }
    }
  }
  if constexpr (has_filters && N == 3) {
    if (box.is_aligned) {  // so the axes are exactly perpendicular
      for (const auto& p : parts.points) {
        for (int c = 0; c < 3; ++c) {
          parts.reach = (max)(parts.reach, nearest_to<Lever>(abs(p[c])));
        }
      }
      if constexpr (is_fixed<S>) {
        if (parts.reach.raw() >> 29 != 0) parts.reach = {};
      }
    }
  }
  return parts;
}

}  // namespace detent::detail
