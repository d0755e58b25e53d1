// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/dynamics/manifold/polygon.hpp"
#include "detent/dynamics/manifold/round.hpp"

namespace detent::detail {

/// The most corners of a polytope: `SolidHull::capacity`.
inline constexpr std::size_t polytope_room = 32;

/// The corners of one polytope in the frame of the other.
template <Scalar S, int N>
struct MovedPoints {
  using Lever = typename Formats<S>::Lever;

  std::array<Vec<Lever, N>, polytope_room> at;
  std::size_t count = 0;

  template <class Move>
  constexpr MovedPoints(const Polytope<S, N>& shape, const Move& move) noexcept {
    for (const auto& p : shape.points) at[count++] = nearest_to<Lever>(move(p));
  }
  [[nodiscard]] constexpr std::span<const Vec<Lever, N>> view() const noexcept {
    return std::span(at).first(count);
  }
};

/// The face of a polytope with the greatest separation from these points; the first of equals.
template <Scalar S, int N>
struct BestPlane {
  using Span = typename ContactFormats<S>::Span;

  std::size_t face = 0;
  Span separation{};

  constexpr BestPlane(const Polytope<S, N>& shape,
                      std::span<const Vec<typename Formats<S>::Lever, N>> points) noexcept {
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
      auto least = shape.height(shape.faces[f], points[0]);
      for (const auto& p : points.subspan(1)) {
        least = (min)(least, shape.height(shape.faces[f], p));
      }
      if (f == 0 || least > separation) face = f, separation = least;
    }
  }
};

/// An edge of each polytope, where they may be closest: `n` is a unit vector across both, from a to b.
template <Scalar S>
struct BestEdges {
  std::size_t a = 0, b = 0;
  Vec<typename Formats<S>::Ratio, 3> normal{};
  typename Formats<S>::Gap separation{};
  bool found = false;
};

/// The unit vector across two edges, in the half space of `outward`; none if they are within 2^-6 of
/// parallel.
template <Scalar S, Number T, class Ratio = typename Formats<S>::Ratio>
[[nodiscard]] constexpr std::optional<Vec<Ratio, 3>> across_edges(
    const Vec<Ratio, 3>& e, const Vec<Ratio, 3>& f, const Vec<T, 3>& outward) noexcept {
  const auto cosine = nearest_to<Ratio>(narrow_dot<62>(e, f));
  if (square(cosine) > Ratio(1) - quotient_nearest<Ratio>(Ratio(1), as_operand<Ratio>(4096))) {
    return std::nullopt;
  }
  const auto n = unit_or_x<Ratio>(narrow_cross<62>(e, f));
  return dot(n, outward) < 0 ? narrow_negative(n) : n;
}

/// The pair of edges with the greatest separation among those whose faces' normals cross, so that
/// they bound the difference of the polytopes; the first of equals.
///
/// source: arcs on the Gauss map, Gregorius, The Separating Axis Test between Convex Polyhedra, GDC
///         2013
template <Scalar S>
[[nodiscard]] constexpr BestEdges<S> best_edges(
    const Polytope<S, 3>& a, const Polytope<S, 3>& b, const RelativePose<S, 3>& pose,
    std::span<const Vec<typename Formats<S>::Lever, 3>> b_points) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  using Gap = typename Formats<S>::Gap;
  using Turned = Vec<Ratio, 3>;
  constexpr std::size_t face_room = 2 * polytope_room - 4, edge_room = 3 * polytope_room - 6;
  std::array<Turned, face_room> normals;
  std::array<Turned, edge_room> directions;
  for (std::size_t i = 0; i < b.faces.size(); ++i) {
    normals[i] = nearest_to<Ratio>(turned(pose, b.faces[i].normal));
  }
  for (std::size_t j = 0; j < b.edges.size(); ++j) {
    directions[j] = nearest_to<Ratio>(turned(pose, b.edges[j].along));
  }
  const auto sign = [](const Turned& u, const Turned& v) {
    const auto x = narrow_dot<62>(u, v);
    return x > 0 ? 1 : x < 0 ? -1 : 0;
  };
  BestEdges<S> best;
  std::array<int, face_room> side{};
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    const auto& edge = a.edges[i];
    const auto& left = a.faces[edge.left].normal;
    const auto& right = a.faces[edge.right].normal;
    for (std::size_t f = 0; f < b.faces.size(); ++f) side[f] = sign(normals[f], edge.along);
    for (std::size_t j = 0; j < b.edges.size(); ++j) {
      const auto& other = b.edges[j];
      const int x = side[other.left];
      if (x == 0 || side[other.right] != -x) continue;
      if (sign(left, directions[j]) != x || sign(right, directions[j]) != -x) continue;
      const auto n = across_edges<S>(edge.along, directions[j], left + right);
      if (!n) continue;
      const auto s =
          nearest_to<Gap>(Polytope<S, 3>::along(*n, b_points[other.from], a.points[edge.from]));
      if (best.found && s <= best.separation) continue;
      best = {i, j, *n, s, true};
    }
  }
  return best;
}

/// One point midway between two segments, where they are closest.
template <Scalar S>
[[nodiscard]] constexpr Manifold<S, 3> crossed_edges(
    const RoundCore<S, 3>& a, const RoundCore<S, 3>& b,
    const Vec<typename Formats<S>::Ratio, 3>& normal, const typename Formats<S>::Gap& separation,
    std::uint32_t feature, const typename Formats<S>::Gap& margin) noexcept {
  const auto feet = closest_feet(a, b);
  const auto p = nearest_to<typename Formats<S>::Lever>(feet.first + normal * half(separation));
  return one_point<S, 3>(normal, p, separation, feature, margin);
}

/// The face of `other` most opposed to face `reference`, clipped against the sides of the latter,
/// in the frame of the reference. `move` transforms points of `other` there, `turn` vectors.
template <Scalar S, int N, class Turn>
[[nodiscard]] constexpr Manifold<S, N> clipped_faces(
    const Polytope<S, N>& own, std::size_t reference, const Polytope<S, N>& other,
    std::span<const Vec<typename Formats<S>::Lever, N>> other_points, const Turn& turn,
    std::uint32_t name, const typename Formats<S>::Gap& margin) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  const auto& face = own.faces[reference];
  std::size_t incident = 0;
  auto least = narrow_dot<62>(face.normal, face.normal);
  for (std::size_t f = 0; f < other.faces.size(); ++f) {
    const auto cosine = narrow_dot<62>(face.normal, nearest_to<Ratio>(turn(other.faces[f].normal)));
    if (f == 0 || cosine < least) least = cosine, incident = f;
  }
  const auto& opposite = other.faces[incident];
  ClippedPolygon<S, N> polygon;
  for (std::size_t k = 0; k < opposite.count; ++k) {
    polygon.add(other_points[other.corners[opposite.first + k]], static_cast<int>(k));
  }
  polygon.clip(own, face);
  const auto faces = (name * 64 + static_cast<std::uint32_t>(reference)) * 64 +
                     static_cast<std::uint32_t>(incident);
  return polygon.manifold(own, face, S(0), faces << 12, margin);
}

/// Two convex polytopes, each in the frame of its body; `pose` is that of b in the frame of a.
/// `rim` has the edges of a, and their faces.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> polytope_manifold(
    const Polytope<S, N>& a, const Polytope<S, N>& rim, const Polytope<S, N>& b,
    const RelativePose<S, N>& pose, const typename Formats<S>::Gap& margin) noexcept {
  using Gap = typename Formats<S>::Gap;
  using Lever = typename Formats<S>::Lever;
  if (a.faces.empty() || b.faces.empty()) return {};
  const auto back = [&](const auto& v) { return turned_back(pose, v); };
  const auto out = [&](const auto& v) { return turned(pose, v); };
  const MovedPoints<S, N> b_points(b, [&](const auto& p) { return placed_point<Lever>(pose, p); });
  const BestPlane<S, N> of_a(a, b_points.view());
  if (of_a.separation > margin) return {};
  const MovedPoints<S, N> a_points(a, [&](const auto& p) { return back(p - pose.translation); });
  const BestPlane<S, N> of_b(b, a_points.view());
  if (of_b.separation > margin) return {};
  const bool is_of_b = of_b.separation > of_a.separation + ContactFormats<S>::tolerance;
  if constexpr (N == 3) {
    const auto face = nearest_to<Gap>(is_of_b ? of_b.separation : of_a.separation);
    const auto best = best_edges(rim, b, pose, b_points.view());
    if (best.found && best.separation > margin) return {};
    if (best.found && best.separation > nearest_to<Gap>(face + ContactFormats<S>::tolerance)) {
      const auto& edge = rim.edges[best.a];
      const auto& other = b.edges[best.b];
      const RoundCore<S, 3> first{a.points[edge.from], a.points[edge.to], S(0)};
      const RoundCore<S, 3> second{b_points.at[other.from], b_points.at[other.to], S(0)};
      const auto name =
          (std::uint32_t{1} << 30) + static_cast<std::uint32_t>(best.a * 128 + best.b);
      return crossed_edges<S>(first, second, best.normal, best.separation, name, margin);
    }
  }
  if (!is_of_b) return clipped_faces(a, of_a.face, b, b_points.view(), out, 0u, margin);
  auto result = clipped_faces(b, of_b.face, a, a_points.view(), back, 1u, margin);
  return result.count > 0 ? swapped(pose, result) : result;
}
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> polytope_manifold(
    const Polytope<S, N>& a, const Polytope<S, N>& b, const RelativePose<S, N>& pose,
    const typename Formats<S>::Gap& margin) noexcept {
  return polytope_manifold(a, a, b, pose, margin);
}

}  // namespace detent::detail
