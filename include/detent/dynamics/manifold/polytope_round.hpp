// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/manifold/polytope_pair.hpp"

namespace detent::detail {

/// A point of a round shape with this radius, over a face at this height.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> over_face(const PolytopeFace<S, N>& face,
                                                 const Vec<typename Formats<S>::Lever, N>& p,
                                                 const typename Formats<S>::Gap& height,
                                                 const S& radius,
                                                 const typename Formats<S>::Gap& margin) noexcept {
  using Lever = typename Formats<S>::Lever;
  using Gap = typename Formats<S>::Gap;
  return one_point<S, N>(face.normal, nearest_to<Lever>(p - face.normal * half(height + radius)),
                         nearest_to<Gap>(height - radius), 0, margin);
}

/// The closest points of a polytope and a segment (or a point) that do not meet, as the manifold of
/// the ball about the one on the segment.
///
/// The closest feature is a face that is below an end of the segment, or an edge (in 2D a corner);
/// the first of equals.
template <Scalar S, int N>
class ClosestOnPolytope {
 public:
  using Gap = typename Formats<S>::Gap;
  using Foot = typename ContactFormats<S>::Foot;
  using Length = typename ContactFormats<S>::Length;
  using Lever = typename Formats<S>::Lever;

  constexpr ClosestOnPolytope(const Polytope<S, N>& shape, const RoundCore<S, N>& core) noexcept
      : shape_(shape), core_(core) {
    over_faces(core.a);
    if (core.a != core.b) over_faces(core.b);
    if constexpr (N == 3) {
      for (const auto& edge : shape.edges) {
        const RoundCore<S, 3> line{shape.points[edge.from], shape.points[edge.to], S(0)};
        if (core.a == core.b) {
          consider(foot_on(line, core.a), nearest_to<Foot>(core.a));
        } else {
          const auto feet = closest_feet(line, core);
          consider(feet.first, feet.second);
        }
      }
    } else {
      for (const auto& corner : shape.points) {
        consider(nearest_to<Foot>(corner),
                 core.a == core.b ? nearest_to<Foot>(core.a) : foot_on(core, corner));
      }
    }
  }

  [[nodiscard]] constexpr const Length& distance() const noexcept { return distance_; }

  [[nodiscard]] constexpr Manifold<S, N> manifold(std::size_t nearest_face,
                                                  const Gap& margin) const noexcept {
    if (face_ != nullptr) return over_face(*face_, end_, height_, core_.radius, margin);
    auto result = balls_manifold(on_shape_, on_core_, S(0), core_.radius, margin);
    if (distance_ <= 0) result.normal = shape_.faces[nearest_face].normal;
    return result;
  }

 private:
  constexpr void over_faces(const Vec<Lever, N>& p) noexcept {
    for (const auto& face : shape_.faces) {
      const auto exact = shape_.height(face, p);
      if (exact <= 0) continue;
      const auto height = nearest_to<Gap>(exact);
      if ((found_ && height >= distance_) || !shape_.covers(face, p)) continue;
      face_ = &face;
      end_ = p;
      distance_ = Length(height_ = height);
      found_ = true;
    }
  }
  constexpr void consider(const Vec<Foot, N>& on_shape, const Vec<Foot, N>& on_core) noexcept {
    const auto squared = squared_length(on_core - on_shape);
    const auto distance = sqrt_nearest<Length>(squared);
    if (found_ && distance >= distance_) return;
    face_ = nullptr;
    on_shape_ = on_shape;
    on_core_ = on_core;
    distance_ = distance;
    found_ = true;
  }

  const Polytope<S, N>& shape_;
  const RoundCore<S, N>& core_;
  const PolytopeFace<S, N>* face_ = nullptr;
  Vec<Lever, N> end_{};
  Gap height_{};
  Vec<Foot, N> on_shape_{}, on_core_{};
  Length distance_{};
  bool found_ = false;
};

/// An axis across a segment and an edge, in 2D a corner, of a polytope.
template <Scalar S, int N>
struct AcrossSegment {
  std::size_t edge = 0;
  Vec<typename Formats<S>::Ratio, N> normal{};
  typename Formats<S>::Gap separation{};
  bool found = false;
};

/// The axis across the segment with the greatest separation from the polytope; the first of equals.
template <Scalar S, int N>
[[nodiscard]] constexpr AcrossSegment<S, N> best_across(const Polytope<S, N>& shape,
                                                        const RoundCore<S, N>& core) noexcept {
  using Gap = typename Formats<S>::Gap;
  using Ratio = typename Formats<S>::Ratio;
  const auto u = unit_or_x<Ratio>(core.b - core.a);
  AcrossSegment<S, N> best;
  const auto consider = [&](std::size_t i, const auto& n, const Gap& s) {
    if (!best.found || s > best.separation) best = {i, n, s, true};
  };
  if constexpr (N == 3) {
    for (std::size_t i = 0; i < shape.edges.size(); ++i) {
      const auto& edge = shape.edges[i];
      const auto& left = shape.faces[edge.left].normal;
      const auto& right = shape.faces[edge.right].normal;
      const auto x = narrow_dot<62>(u, left), y = narrow_dot<62>(u, right);
      if (!((x > 0 && y < 0) || (x < 0 && y > 0))) continue;
      const auto n = across_edges<S>(edge.along, u, left + right);
      if (n) {
        consider(i, *n,
                 nearest_to<Gap>(Polytope<S, 3>::along(*n, core.a, shape.points[edge.from])));
      }
    }
  } else {
    for (const bool opposite : {false, true}) {
      const Vec<Ratio, 2> side{u.y, narrow_negative(u.x)};
      const auto n = opposite ? narrow_negative(side) : side;
      std::size_t corner = 0;
      auto least = Polytope<S, 2>::along(n, core.a, shape.points[0]);
      for (std::size_t i = 1; i < shape.points.size(); ++i) {
        const auto s = Polytope<S, 2>::along(n, core.a, shape.points[i]);
        if (s < least) least = s, corner = i;
      }
      consider(corner, n, nearest_to<Gap>(least));
    }
  }
  return best;
}

/// The part of a segment over a face, clipped against its sides.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> segment_on_face(
    const Polytope<S, N>& shape, std::size_t number, const RoundCore<S, N>& core,
    const typename Formats<S>::Gap& margin) noexcept {
  ClippedPolygon<S, N, true> segment;
  segment.add(core.a, 0);
  segment.add(core.b, 1);
  segment.clip(shape, shape.faces[number]);
  const auto name = (static_cast<std::uint32_t>(number) + 1) * 64;
  return segment.manifold(shape, shape.faces[number], core.radius, name, margin);
}

/// A polytope and a capsule in its frame: `number` is the face of greatest separation, at `height`;
/// `rim` has the edges, and their faces; meets(across) returns whether the capsule's segment meets
/// the polytope.
template <Scalar S, int N, class Meets>
[[nodiscard]] constexpr Manifold<S, N> polytope_capsule_manifold(
    const Polytope<S, N>& shape, const Polytope<S, N>& rim, std::size_t number,
    const typename Formats<S>::Gap& height, const RoundCore<S, N>& core, const Meets& meets,
    const typename Formats<S>::Gap& margin) noexcept {
  using Gap = typename Formats<S>::Gap;
  using Lever = typename Formats<S>::Lever;
  const auto limit = height + ContactFormats<S>::tolerance;
  const auto across = best_across(rim, core);
  const auto name = (std::uint32_t{1} << 30) + static_cast<std::uint32_t>(across.edge);
  if (meets(across)) {
    if (!across.found || across.separation <= limit) {
      return segment_on_face(shape, number, core, margin);
    }
    // The segment is inside: from the edge, or corner, to it and on to its surface.
    const auto separation = nearest_to<Gap>(across.separation - core.radius);
    if (separation > margin) return {};
    const auto& n = across.normal;
    const auto back = half(across.separation + core.radius);
    if constexpr (N == 3) {
      const auto& edge = rim.edges[across.edge];
      const RoundCore<S, 3> line{shape.points[edge.from], shape.points[edge.to], S(0)};
      const auto feet = closest_feet(line, core);
      return one_point<S, 3>(n, nearest_to<Lever>(feet.second - n * back), separation, name,
                             margin);
    } else {
      const auto foot = foot_on(core, shape.points[across.edge]);
      return one_point<S, 2>(n, nearest_to<Lever>(foot - n * back), separation, name, margin);
    }
  }
  const ClosestOnPolytope<S, N> closest(shape, core);
  const auto single = closest.manifold(number, margin);
  if (single.count == 0 || closest.distance() > limit) return single;
  const auto both = segment_on_face(shape, number, core, margin);
  return both.count > 0 ? both : single;
}

/// A polytope and a round shape in its frame; the normal points away from the polytope.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> polytope_round_manifold(
    const Polytope<S, N>& shape, const RoundCore<S, N>& core,
    const typename Formats<S>::Gap& margin) noexcept {
  using Gap = typename Formats<S>::Gap;
  using Lever = typename Formats<S>::Lever;
  if (shape.faces.empty() || core.is_empty()) return {};
  const bool is_ball = core.a == core.b;
  const std::array<Vec<Lever, N>, 2> ends{core.a, core.b};
  const BestPlane<S, N> plane(shape, std::span<const Vec<Lever, N>>(ends));
  const auto height = nearest_to<Gap>(plane.separation);
  if (nearest_to<Gap>(height - core.radius) > margin) return {};
  const auto& face = shape.faces[plane.face];
  if (is_ball) {
    if (plane.separation <= 0) return over_face(face, core.a, height, core.radius, margin);
    return ClosestOnPolytope<S, N>(shape, core).manifold(plane.face, margin);
  }
  const auto meets = [&](const AcrossSegment<S, N>& across) {
    return plane.separation <= 0 && (!across.found || across.separation <= 0);
  };
  return polytope_capsule_manifold(shape, shape, plane.face, height, core, meets, margin);
}

}  // namespace detent::detail
