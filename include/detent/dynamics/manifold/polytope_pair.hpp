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

/// The most faces and edges of a polyhedron.
inline constexpr std::size_t polytope_faces = 2 * polytope_room - 4;
inline constexpr std::size_t polytope_edges = 3 * polytope_room - 6;

/// Heights of one point over the faces of a polytope; empty where no filter uses them.
struct NoHeights {};
template <Scalar S>
using FaceHeights =
    std::conditional_t<has_filters, std::array<typename ContactFormats<S>::Span, polytope_faces>,
                       NoHeights>;

/// The face of a polytope with the greatest separation from these points; the first of equals.
template <Scalar S, int N>
class BestPlane {
 public:
  using Span = typename ContactFormats<S>::Span;
  using Lever = typename Formats<S>::Lever;
  using Points = std::span<const Vec<Lever, N>>;

  std::size_t face = 0;
  std::size_t lowest = 0;  // the point with the least height over the face tested first
  Span separation{};

  constexpr BestPlane(const Polytope<S, N>& shape, const Points& points) noexcept {
    const auto height = [&](std::size_t f, const auto& p) {
      return shape.height(shape.faces[f], p);
    };
    start(points, height);
    for (std::size_t f = 1; f < shape.faces.size(); ++f) consider(points, f, height);
  }
  /// If some separation exceeds the margin, finds any face with such a separation. Otherwise
  /// `heights` are those of the point `lowest`. The face over which `center`, a point in the middle
  /// of the others, is highest is tested first: that rules out most other faces after one or two
  /// points.
  constexpr BestPlane(const Polytope<S, N>& shape, const Points& points,
                      const Vec<Lever, N>& center, const typename Formats<S>::Gap& margin,
                      FaceHeights<S>& heights) noexcept requires(has_filters) {
    constexpr int bits = bits_of<Span>;
    const auto height = [&](std::size_t f, const auto& p) {
      return shape.height(shape.faces[f], p);
    };
    Span most{};
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
      const auto above = height(f, center);
      if (f == 0 || above > most) most = above, face = f;
    }
    const auto first = face;
    start(points, height);
    heights[first] = separation;
    const auto limit = narrow_product<bits>(margin, typename Formats<S>::Ratio(1));
    for (std::size_t f = 0; f < shape.faces.size() && separation <= limit; ++f) {
      if (f == first) continue;
      heights[f] = height(f, points[lowest]);
      if (!is_behind(f, heights[f])) consider(points, f, height);
    }
  }

 private:
  template <class Height>
  constexpr void start(const Points& points, const Height& height_over) noexcept {
    separation = height_over(face, points[0]);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto height = height_over(face, points[i]);
      if (height < separation) separation = height, lowest = i;
    }
  }
  [[nodiscard]] constexpr bool is_behind(std::size_t f, const Span& height) const noexcept {
    return height < separation || (height == separation && f > face);
  }
  /// A face is left out as soon as one point is too low over it.
  template <class Height>
  constexpr void consider(const Points& points, std::size_t f, const Height& height_over) noexcept {
    auto least = height_over(f, points[lowest]);
    if (is_behind(f, least)) return;
    for (const auto& p : points) {
      least = (min)(least, height_over(f, p));
      if (is_behind(f, least)) return;
    }
    face = f;
    separation = least;
  }
};

template <Scalar S, int N, class Lever = typename Formats<S>::Lever>
[[nodiscard]] constexpr BestPlane<S, N> best_plane(
    const Polytope<S, N>& shape, std::span<const Vec<Lever, N>> points, const Vec<Lever, N>& center,
    const typename Formats<S>::Gap& margin, [[maybe_unused]] FaceHeights<S>& heights) noexcept {
  if constexpr (has_filters) {
    return {shape, points, center, margin, heights};
  } else {
    return {shape, points};
  }
}

/// Whether polytope b is surely more than the margin above some face of a, because the ball around
/// b is; `center` is that of b in the frame of a.
///
/// A pose is a rotation within 2^-24, so its rounding and that of each corner move b by less than 2^6
/// steps. Those of a's normals move it by less, since no coordinate exceeds 2^30 steps.
template <Scalar S, int N>
[[nodiscard]] constexpr bool ball_is_above(
    [[maybe_unused]] const Polytope<S, N>& a, [[maybe_unused]] const Polytope<S, N>& b,
    [[maybe_unused]] const Vec<typename Formats<S>::Lever, N>& center,
    [[maybe_unused]] const typename Formats<S>::Gap& margin) noexcept {
  if constexpr (is_fixed<S> && has_filters) {
    using Gap = typename Formats<S>::Gap;
    constexpr int bits = bits_of<typename ContactFormats<S>::Span>;
    if (b.radius == 0) return false;
    for (int i = 0; i < N; ++i) {
      if (!fits<29>(center[i])) return false;  // corners might be clamped
    }
    const auto reach = narrow<32>(b.radius + margin + Gap::assume_raw(1 << 10));
    const auto least = narrow_product<bits>(reach, typename Formats<S>::Ratio(1));
    for (const auto& face : a.faces) {
      if (a.height(face, center) > least) return true;
    }
  }
  return false;
}

/// Edges of a polytope, in order.
struct EdgeList {
  std::array<std::uint8_t, polytope_edges> at;
  std::size_t count = 0;

  constexpr void add(std::size_t edge) noexcept { at[count++] = static_cast<std::uint8_t>(edge); }
};

/// A bound h: the separation along two edges is at most h if some corner of the other polytope is
/// at most h high over both faces of one of the edges. Nothing if there is no proof.
///                                            (tests/dynamics/manifold/hull.test.cpp)
///
/// Let u, v be the normals of an edge's faces, q a corner of the other polytope and n the unit vector
/// across both edges, towards the other polytope. Where the arcs of the Gauss map cross, n =
/// (x u + y v) / |x u + y v| with x, y >= 0, and the other edge is lowest along n. With p on the edge
/// the separation along n is at most n . (q - p), and as x + y >= |x u + y v| that is at most the
/// greater height of q if both are negative.
///
/// In numbers, with coordinates of at most M steps of a lever and e = 2^-30: `regular_reach` bounds
/// (x + y) / |x u + y v| by 2^4. Stored edges are perpendicular to u and v within 2^2 e, to those of
/// b, turned by the pose, within 2^5 e; edges that count are at least 2^-6 from parallel. So n differs
/// from (x u + y v) / |x u + y v| by at most 2^4 2^5 e 2^6 = 2^-15, and n . (q - p) by 2^-15 3.5 M <
/// 2^-13 M. (The sign of n cannot differ: |x u + y v| >= 2^-4, and the direction of an edge is that of
/// u x v, at least 2^-10 long.) Corners rounded by a step change heights by 2 steps and n . (q - p) by
/// 2^5 steps for each polytope. All of this is less than 2^-12 M + 2^7 steps.
template <Scalar S>
[[nodiscard]] constexpr std::optional<typename ContactFormats<S>::Span> facing_height(
    const Polytope<S, 3>& a, const Polytope<S, 3>& b, const RelativePose<S, 3>& pose,
    const typename Formats<S>::Gap& separation) noexcept {
  using Gap = typename Formats<S>::Gap;
  using Ratio = typename Formats<S>::Ratio;
  if (!has_filters || a.reach == 0 || b.reach == 0) return std::nullopt;
  const auto& t = pose.translation;
  // Corners in either frame are at most twice this far.
  const auto half_way = a.reach + b.reach + (max)((max)(abs(t.x), abs(t.y)), abs(t.z));
  if constexpr (is_fixed<S>) {
    if (half_way.raw() >> 30 != 0) return std::nullopt;
  }
  constexpr int bits = bits_of<typename ContactFormats<S>::Span>;
  const auto slack =
      narrow_sum<bits>(narrow_product<bits>(nearest_to<Gap>(half_way), one_over<Ratio>(2048)),
                       narrow_product<bits>(ContactFormats<S>::tolerance, one_over<Ratio>(16)));
  return narrow_difference<bits>(narrow_product<bits>((min)(separation, Gap{}), Ratio(1)), slack);
}

/// The edges with a face over which a point with these heights is higher than `limit`; all without
/// a limit.
template <Scalar S>
[[nodiscard]] constexpr EdgeList edges_facing(
    const Polytope<S, 3>& shape, [[maybe_unused]] const FaceHeights<S>& heights,
    const std::optional<typename ContactFormats<S>::Span>& limit) noexcept {
  EdgeList list;
  if constexpr (has_filters) {
    if (limit) {
      std::array<bool, polytope_faces> is_above;
      bool any = false;
      for (std::size_t f = 0; f < shape.faces.size(); ++f) {
        is_above[f] = heights[f] > *limit;
        any = any || is_above[f];
      }
      for (std::size_t i = 0; i < shape.edges.size() && any; ++i) {
        const auto& edge = shape.edges[i];
        list.at[list.count] = static_cast<std::uint8_t>(i);
        list.count += is_above[edge.left] || is_above[edge.right] ? 1u : 0u;
      }
      return list;
    }
  }
  for (std::size_t i = 0; i < shape.edges.size(); ++i) list.add(i);
  return list;
}

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

/// Whether the separation along the vector across two edges is surely at most this, or there is no
/// such vector: `d` is from a point of the first edge to one of the second, and the other arguments
/// are as in `across_edges`.
///
/// The cross product c, rounded to c', and the unit vector n along it are off by less than 2^-30. So
/// for |d| <= sqrt(3) 2^30 steps n . d differs from c' . d / |c'| by less than 2 + 2 / |c'| steps, and
/// |c'| is at least 2^-7 for edges that count. The sign of n is sure if c' . outward exceeds 2^-20.
/// |c'| is at most (1 + |c'|^2) / 2, and at least |c'|^2, both within 2^-28.
template <Scalar S, Number T, Number D, class Ratio = typename Formats<S>::Ratio>
[[nodiscard]] constexpr bool is_surely_at_most(
    const Vec<Ratio, 3>& e, const Vec<Ratio, 3>& f, const Vec<T, 3>& outward, const Vec<D, 3>& d,
    const typename Formats<S>::Gap& separation) noexcept {
  if constexpr (is_fixed<S> && has_filters) {
    using Gap = typename Formats<S>::Gap;
    if (!fits<30>(d)) return false;
    const auto c = nearest_to<Ratio>(narrow_cross<62>(e, f));
    const auto up = narrow_dot<62>(c, outward);
    constexpr auto least = one_over<Ratio>(1 << 20);
    if (up < least && up > -least) return false;
    const auto height = narrow_dot<62>(c, at_most<30>(d));
    const auto over = up < 0 ? narrow_negative(height) : height;
    const auto limit = narrow<32>(separation - Gap::assume_raw(1 << 10));
    const auto squared = nearest_to<Ratio>(narrow_dot<62>(c, c));
    const auto length = limit < 0 ? nearest_to<Ratio>(half(Ratio(1) + squared)) : squared;
    return over <= narrow_product<62>(limit, length);
  } else {
    return false;
  }
}

/// The pair of these edges with the greatest separation among those whose faces' normals cross, so
/// that they bound the difference of the polytopes; the first of equals. None if that separation is
/// at most `least`. `filters` affects only the time.
///
/// source: arcs on the Gauss map, Gregorius, The Separating Axis Test between Convex Polyhedra, GDC
///         2013
template <Scalar S>
[[nodiscard]] constexpr BestEdges<S> best_edges(
    const Polytope<S, 3>& a, const Polytope<S, 3>& b, const RelativePose<S, 3>& pose,
    std::span<const Vec<typename Formats<S>::Lever, 3>> b_points, const EdgeList& a_edges,
    const EdgeList& b_edges, bool filters, const typename Formats<S>::Gap& least) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  using Gap = typename Formats<S>::Gap;
  using Turned = Vec<Ratio, 3>;
  std::array<Turned, polytope_faces> normals;
  std::array<Turned, polytope_edges> directions;
  std::array<std::uint8_t, polytope_faces> faces;  // of b's edges
  std::array<bool, polytope_faces> is_listed{};
  std::size_t face_count = 0;
  for (std::size_t l = 0; l < b_edges.count; ++l) {
    const auto& edge = b.edges[b_edges.at[l]];
    directions[l] = nearest_to<Ratio>(turned(pose, edge.along));
    for (const std::uint8_t f : {edge.left, edge.right}) {
      if (is_listed[f]) continue;
      is_listed[f] = true;
      faces[face_count++] = f;
      normals[f] = nearest_to<Ratio>(turned(pose, b.faces[f].normal));
    }
  }
  const auto sign = [](const Turned& u, const Turned& v) {
    const auto x = narrow_dot<62>(u, v);
    return x > 0 ? 1 : x < 0 ? -1 : 0;
  };
  BestEdges<S> best;
  best.separation = least;
  std::array<int, polytope_faces> side{};
  for (std::size_t k = 0; k < a_edges.count; ++k) {
    const std::size_t i = a_edges.at[k];
    const auto& edge = a.edges[i];
    const auto& left = a.faces[edge.left].normal;
    const auto& right = a.faces[edge.right].normal;
    for (std::size_t l = 0; l < face_count; ++l) {
      side[faces[l]] = sign(normals[faces[l]], edge.along);
    }
    for (std::size_t l = 0; l < b_edges.count; ++l) {
      const std::size_t j = b_edges.at[l];
      const auto& other = b.edges[j];
      const int x = side[other.left];
      if (x == 0 || side[other.right] != -x) continue;
      if (sign(left, directions[l]) != x || sign(right, directions[l]) != -x) continue;
      const auto outward = left + right;
      const auto &p = a.points[edge.from], &q = b_points[other.from];
      if (filters &&
          is_surely_at_most<S>(edge.along, directions[l], outward, q - p, best.separation)) {
        continue;
      }
      const auto n = across_edges<S>(edge.along, directions[l], outward);
      if (!n) continue;
      const auto s = nearest_to<Gap>(Polytope<S, 3>::along(*n, q, p));
      if (s <= best.separation) continue;
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

/// The face whose normal, turned by a matrix, is surely most opposed to `n`; nothing if another one
/// is too close. `turn_back` has the transposed matrix.
///
/// Turns `n` back instead of every normal. The cosines are then off by less than 2^-29, because
/// either way a vector is rounded to 2^-30; cosines within 2^-28 of each other need the exact
/// comparison.
template <Scalar S, int N, class Back, class Ratio = typename Formats<S>::Ratio>
[[nodiscard]] constexpr std::optional<std::size_t> surely_opposed(const Polytope<S, N>& shape,
                                                                  const Vec<Ratio, N>& n,
                                                                  const Back& turn_back) noexcept {
  const auto m = nearest_to<Ratio>(turn_back(n));
  std::array<decltype(narrow_dot<62>(m, m)), polytope_faces> cosines;
  std::size_t found = 0;
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    cosines[f] = narrow_dot<62>(shape.faces[f].normal, m);
    if (cosines[f] < cosines[found]) found = f;
  }
  const auto limit =
      narrow_sum<62>(cosines[found], narrow_product<62>(one_over<Ratio>(1 << 28), Ratio(1)));
  int close = 0;
  for (std::size_t f = 0; f < shape.faces.size(); ++f) close += cosines[f] <= limit ? 1 : 0;
  if (close > 1) return std::nullopt;
  return found;
}

/// The face whose normal, turned by `turn`, is most opposed to `n`; the first of equals.
template <Scalar S, int N, class Turn, class Back, class Ratio = typename Formats<S>::Ratio>
[[nodiscard]] constexpr std::size_t most_opposed(const Polytope<S, N>& shape,
                                                 const Vec<Ratio, N>& n, const Turn& turn,
                                                 [[maybe_unused]] const Back& turn_back) noexcept {
  if constexpr (is_fixed<S> && has_filters) {
    if (const auto sure = surely_opposed(shape, n, turn_back)) return *sure;
  }
  std::size_t found = 0;
  auto least = narrow_dot<62>(n, n);
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const auto cosine = narrow_dot<62>(n, nearest_to<Ratio>(turn(shape.faces[f].normal)));
    if (f == 0 || cosine < least) least = cosine, found = f;
  }
  return found;
}

/// The face of `other` most opposed to face `reference`, clipped against the sides of the latter,
/// in the frame of the reference. `turn` turns vectors of `other` there, `turn_back` back.
template <Scalar S, int N, class Turn, class Back>
[[nodiscard]] constexpr Manifold<S, N> clipped_faces(
    const Polytope<S, N>& own, std::size_t reference, const Polytope<S, N>& other,
    std::span<const Vec<typename Formats<S>::Lever, N>> other_points, const Turn& turn,
    const Back& turn_back, std::uint32_t name, const typename Formats<S>::Gap& margin) noexcept {
  const auto& face = own.faces[reference];
  const std::size_t incident = most_opposed(other, face.normal, turn, turn_back);
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
/// `rim` has the edges of a, and their faces; if it is not a, it has no `reach`.
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
  FaceHeights<S> over_a, over_b;  // of the lowest corner of the other
  const auto of_a = best_plane(a, b_points.view(), pose.translation, margin, over_a);
  if (of_a.separation > margin) return {};
  const MovedPoints<S, N> a_points(a, [&](const auto& p) {
    const auto moved = [&](const auto& v) { return nearest_to<Lever>(back(v)); };
    return by_width<31>(moved, p - pose.translation);
  });
  const auto of_b =
      best_plane(b, a_points.view(), nearest_to<Lever>(back(-pose.translation)), margin, over_b);
  if (of_b.separation > margin) return {};
  const bool is_of_b = of_b.separation > of_a.separation + ContactFormats<S>::tolerance;
  if constexpr (N == 3) {
    const auto face = nearest_to<Gap>(is_of_b ? of_b.separation : of_a.separation);
    const auto limit = nearest_to<Gap>(face + ContactFormats<S>::tolerance);
    const auto least = (min)(limit, margin);  // edges count if they are farther apart
    const auto height = facing_height(rim, b, pose, least);
    const auto best = best_edges(rim, b, pose, b_points.view(), edges_facing(rim, over_a, height),
                                 edges_facing(b, over_b, height), height.has_value(), least);
    if (best.found && best.separation > margin) return {};
    if (best.found && best.separation > limit) {
      const auto& edge = rim.edges[best.a];
      const auto& other = b.edges[best.b];
      const RoundCore<S, 3> first{a.points[edge.from], a.points[edge.to], S(0)};
      const RoundCore<S, 3> second{b_points.at[other.from], b_points.at[other.to], S(0)};
      const auto name =
          (std::uint32_t{1} << 30) + static_cast<std::uint32_t>(best.a * 128 + best.b);
      return crossed_edges<S>(first, second, best.normal, best.separation, name, margin);
    }
  }
  if (!is_of_b) return clipped_faces(a, of_a.face, b, b_points.view(), out, back, 0u, margin);
  auto result = clipped_faces(b, of_b.face, a, a_points.view(), back, out, 1u, margin);
  return result.count > 0 ? swapped(pose, result) : result;
}
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> polytope_manifold(
    const Polytope<S, N>& a, const Polytope<S, N>& b, const RelativePose<S, N>& pose,
    const typename Formats<S>::Gap& margin) noexcept {
  return polytope_manifold(a, a, b, pose, margin);
}

}  // namespace detent::detail
