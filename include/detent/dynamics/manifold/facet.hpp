// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/dynamics/manifold/polytope_round.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// A triangle of a surface, in levers: the top of an infinitely deep prism. Face 0 of the prism is
/// the top, face k + 1 the wall below side k.
template <Scalar S>
struct Facet {
  PolytopeParts<S, 3, 4> parts{};

  [[nodiscard]] constexpr Polytope<S, 3> prism() const noexcept { return parts.view(); }
  /// Only the top, without the walls.
  [[nodiscard]] constexpr Polytope<S, 3> top() const noexcept {
    auto view = parts.view();
    view.faces = view.faces.first(1);
    return view;
  }
  [[nodiscard]] constexpr const auto& normal() const noexcept { return parts.faces[0].normal; }
};

/// The facet of a triangle, or nothing if it collapses.
template <Scalar S>
[[nodiscard]] constexpr std::optional<Facet<S>> facet_of(const Triangle<S, 3>& triangle) noexcept {
  using Lever = typename Formats<S>::Lever;
  using Ratio = typename Formats<S>::Ratio;
  const auto across = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  if (across == decltype(across){}) return std::nullopt;
  const auto normal = unit_or_x<Ratio>(across);
  const std::array corners{triangle.a, triangle.b, triangle.c};
  Facet<S> facet;
  auto& parts = facet.parts;
  parts.add_face(normal);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto edge = corners[(k + 1) % 3] - corners[k];
    parts.points[parts.point_count++] = nearest_to<Lever>(corners[k]);
    parts.add_corner(k, unit_or_x<Ratio>(cross(edge, normal)));
    parts.add_edge(k, (k + 1) % 3, unit_or_x<Ratio>(edge), 0, k + 1);
  }
  for (std::size_t k = 0; k < 3; ++k) parts.add_face(parts.sides[k]);
  return facet;
}

/// Whether `p` is beyond no side of the top by more than the tolerance.
template <Scalar S>
[[nodiscard]] constexpr bool is_over(const Polytope<S, 3>& top,
                                     const Vec<typename Formats<S>::Lever, 3>& p) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (top.beyond(top.faces[0], k, p) > ContactFormats<S>::tolerance) return false;
  }
  return true;
}

/// Whether a segment meets the top, exactly: where it crosses the plane it is beyond no side.
template <Scalar S>
[[nodiscard]] constexpr bool crosses(const Polytope<S, 3>& top,
                                     const RoundCore<S, 3>& core) noexcept {
  const auto& face = top.faces[0];
  const auto a = top.height(face, core.a), b = top.height(face, core.b);
  if ((a > 0 && b > 0) || (a < 0 && b < 0)) return false;
  if (a == 0 && b == 0) return top.covers(face, core.a) || top.covers(face, core.b);
  for (std::size_t k = 0; k < 3; ++k) {
    // Two products of 63 bits each.
    if (top.beyond(face, k, core.a) * abs(b) + top.beyond(face, k, core.b) * abs(a) > 0) {
      return false;
    }
  }
  return true;
}

/// A facet and a round shape in the frame of the surface; with `on_top` along the facet's normal.
/// The manifold's normal points away from the facet.
template <Scalar S>
[[nodiscard]] constexpr Manifold<S, 3> facet_manifold(
    const Facet<S>& facet, const RoundCore<S, 3>& core, bool on_top,
    const typename Formats<S>::Gap& margin) noexcept {
  using Gap = typename Formats<S>::Gap;
  const auto top = facet.top();
  const auto& face = top.faces[0];
  const auto low = (min)(top.height(face, core.a), top.height(face, core.b));
  const auto height = nearest_to<Gap>(low);
  if (nearest_to<Gap>(height - core.radius) > margin) return {};
  if (core.a == core.b) {
    if (is_over(top, core.a)) return over_face(face, core.a, height, core.radius, margin);
    if (on_top || low < 0) return {};
    return ClosestOnPolytope<S, 3>(top, core).manifold(0, margin);
  }
  if (on_top) return segment_on_face(top, 0, core, margin);
  const auto meets = [&](const auto&) { return crosses(top, core); };
  return polytope_capsule_manifold(top, facet.prism(), 0, height, core, meets, margin);
}

/// A facet and a polytope, whose body has the pose in the frame of the surface.
template <Scalar S>
[[nodiscard]] constexpr Manifold<S, 3> facet_manifold(
    const Facet<S>& facet, const Polytope<S, 3>& shape, const RelativePose<S, 3>& pose, bool on_top,
    const typename Formats<S>::Gap& margin) noexcept {
  using Lever = typename Formats<S>::Lever;
  const auto top = facet.top();
  if (!on_top) return polytope_manifold(top, facet.prism(), shape, pose, margin);
  if (shape.faces.empty()) return {};
  const MovedPoints<S, 3> points(shape,
                                 [&](const auto& p) { return placed_point<Lever>(pose, p); });
  const auto out = [&](const auto& v) { return turned(pose, v); };
  const auto back = [&](const auto& v) { return turned_back(pose, v); };
  return clipped_faces(top, 0, shape, points.view(), out, back, 0u, margin);
}

}  // namespace detent::detail
