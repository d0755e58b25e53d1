// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "detent/math/components.hpp"
#include "detent/query/kernel/span.hpp"
#include "detent/shape/segment.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

// A line against a flat shape in the same plane: the 2D case, and in 3D a ray in the plane of a
// triangle or against a collapsed triangle.

/// A line through `origin` along `direction` in a plane, and the exact predicates on it.
///
/// `direction` is a direction, or one with a component dropped, so it is no longer than a
/// direction.
template <Scalar S>
struct PlanarLine {
  using Speed = direction_component<S>;
  using Offset = decltype(S() - S());
  // |v| |direction| < sqrt(2) 2^B (1 + 2^-13), so one bit more than those of v.
  static constexpr int side_bits = bits_of<Offset> + bits_of<Speed>;
  using Side = decltype(narrow_cross<side_bits>(Vec<Speed, 2>(), Vec<Offset, 2>()));
  using Area = decltype(cross(Vec<Offset, 2>(), Vec<Offset, 2>()));
  using Distance = Fraction<Area, Side>;

  Vec<S, 2> origin;
  Vec<Speed, 2> direction;

  /// Positive if `p` lies to the left of the line, 0 if on it.
  [[nodiscard]] constexpr Side side(const Vec<S, 2>& p) const noexcept {
    return narrow_cross<side_bits>(direction, p - origin);
  }

  /// The distance at which the line crosses the line through p and q, which must not be parallel:
  /// origin + t direction = p + s (q - p), crossed with q - p.
  [[nodiscard]] constexpr Distance crossing(const Vec<S, 2>& p, const Vec<S, 2>& q) const noexcept {
    const auto edge = q - p;
    return make_fraction(Area(cross(p - origin, edge)), narrow_cross<side_bits>(direction, edge));
  }

  /// The distance of a point known to be on the line.
  [[nodiscard]] constexpr Distance distance(const Vec<S, 2>& p) const noexcept {
    const int i = longest_axis(direction);
    return make_fraction(Area(p[i] - origin[i]), Side(direction[i]));
  }
};

template <Scalar S>
using PlanarSpan = Span<typename PlanarLine<S>::Area, typename PlanarLine<S>::Side>;

template <Number N, Number D>
[[nodiscard]] constexpr Span<N, D> ordered(const Fraction<N, D>& a,
                                           const Fraction<N, D>& b) noexcept {
  // Both come from `distance` on one axis, so their denominators are equal.
  return b.numerator < a.numerator ? Span<N, D>{b, a} : Span<N, D>{a, b};
}

/// The part of `line` in the segment from p to q.
template <Scalar S>
[[nodiscard]] constexpr std::optional<PlanarSpan<S>> span(const PlanarLine<S>& line,
                                                          const Vec<S, 2>& p,
                                                          const Vec<S, 2>& q) noexcept {
  const auto side_p = line.side(p), side_q = line.side(q);
  if (side_p == 0 && side_q == 0) return ordered(line.distance(p), line.distance(q));
  if ((side_p > 0 && side_q > 0) || (side_p < 0 && side_q < 0)) return std::nullopt;
  const auto distance = line.crossing(p, q);
  return PlanarSpan<S>{distance, distance};
}

/// The part of a line in a triangle, and the edge (ab, bc, ca: 0, 1, 2) through which it enters.
template <Scalar S>
struct TriangleSpan {
  PlanarSpan<S> span;
  int entry_edge;
};

/// The part of `line` in a triangle with an area.
///
/// The line crosses an edge whose ends are not strictly on the same side of it. It enters through
/// the edges that it crosses toward the inside and leaves through the others. At a corner it
/// crosses two edges at the same point.
template <Scalar S>
[[nodiscard]] constexpr std::optional<TriangleSpan<S>> span(
    const PlanarLine<S>& line, const Triangle<S, 2>& triangle) noexcept {
  const std::array<const Vec<S, 2>*, 3> corners{&triangle.a, &triangle.b, &triangle.c};
  const std::array sides{line.side(triangle.a), line.side(triangle.b), line.side(triangle.c)};
  const bool counter_clockwise = cross(triangle.b - triangle.a, triangle.c - triangle.a) > 0;
  constexpr int none = -1;
  int enter = none, exit = none;
  for (int i = 0; i < 3; ++i) {
    const auto& from = sides[static_cast<std::size_t>(i)];
    const auto& to = sides[static_cast<std::size_t>((i + 1) % 3)];
    if ((from > 0 && to > 0) || (from < 0 && to < 0) || from == to) continue;
    // In counter-clockwise order the inside is left of an edge, so an edge that leads from the
    // line's left to its right has the inside ahead.
    int& crossed = (to < from) == counter_clockwise ? enter : exit;
    if (crossed == none) crossed = i;
  }
  if (enter == none || exit == none) return std::nullopt;
  const auto crossing = [&](int edge) {
    return line.crossing(*corners[static_cast<std::size_t>(edge)],
                         *corners[static_cast<std::size_t>((edge + 1) % 3)]);
  };
  return TriangleSpan<S>{{crossing(enter), crossing(exit)}, enter};
}

/// The part of a ray's line in a segment.
template <Scalar S>
[[nodiscard]] constexpr std::optional<PlanarSpan<S>> span(const Ray<S, 2>& ray,
                                                          const Segment<S, 2>& segment) noexcept {
  return span(PlanarLine<S>{ray.origin, ray.direction.vec()}, segment.start, segment.end);
}

template <Scalar S>
[[nodiscard]] constexpr std::optional<PlanarSpan<S>> span(const Ray<S, 3>& ray,
                                                          const Segment<S, 3>& segment) noexcept {
  const auto to_start = segment.start - ray.origin;
  const auto across = cross(ray.direction, segment.end - segment.start);
  const auto start_offset = cross(ray.direction, to_start);
  int dropped = 0;
  if (is_zero(across)) {
    // Parallel, or a point: it meets the line only if it lies on it. Any axis may be dropped except
    // the line's longest.
    if (!is_zero(start_offset)) return std::nullopt;
    dropped = (longest_axis(ray.direction.vec()) + 1) % 3;
  } else {
    // |w| |direction| |edge| < 3 2^(2B) (1 + 2^-13), two bits more than the factors' own.
    constexpr int volume_bits = bits_of<decltype(to_start.x)> + bits_of<decltype(across.x)> + 1;
    if (narrow_dot<volume_bits>(to_start, across) != 0) return std::nullopt;
    dropped = longest_axis(across);
  }
  return span(PlanarLine<S>{without(ray.origin, dropped), without(ray.direction.vec(), dropped)},
              without(segment.start, dropped), without(segment.end, dropped));
}

}  // namespace detent::detail
