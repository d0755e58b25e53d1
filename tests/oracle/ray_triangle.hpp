// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>

#include "detent/shape/segment.hpp"
#include "detent/shape/triangle.hpp"
#include "oracle/half_spaces.hpp"

namespace detent::oracle {

inline Vector<2> without(const Vector<3>& v, std::size_t axis) {
  return axis == 0   ? Vector<2>{v[1], v[2]}
         : axis == 1 ? Vector<2>{v[2], v[0]}
                     : Vector<2>{v[0], v[1]};
}

/// The moving point `start + t * velocity / one` against the three edges of a 2D triangle of either
/// winding, by the sign of the area it spans with each.
inline std::array<HalfSpace, 3> edges(const std::array<Vector<2>, 3>& corners,
                                      const Vector<2>& start, const Vector<2>& velocity,
                                      const Integer& one) {
  const int winding =
      cross(difference(corners[1], corners[0]), difference(corners[2], corners[0])).sign();
  std::array<HalfSpace, 3> spaces;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto edge = difference(corners[(i + 1) % 3], corners[i]);
    spaces[i] = {-winding * cross(edge, difference(start, corners[i])) * one,
                 -winding * cross(edge, velocity)};
  }
  return spaces;
}

/// The times at which `line` is on the segment p q, which may be a point. If the line runs along
/// the segment, these are between its ends; otherwise the crossing must be between them.
template <int N>
std::optional<Span> on_segment(const Line<N>& line, const Vector<N>& p, const Vector<N>& q) {
  const auto& d = line.direction;
  std::size_t k = 0;
  while (d[k].is_zero()) ++k;
  // The offset of a point from the line at the point's coordinate k, scaled: zero in every
  // coordinate if the point is on the line.
  const auto aside = [&](const Vector<N>& point) {
    const auto w = difference(point, line.origin);
    Vector<N> result;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = w[i] * d[k] - w[k] * d[i];
    return result;
  };
  const auto time_of = [&](const Vector<N>& point) {
    return Moment::fraction((point[k] - line.origin[k]) * line.one, d[k]);
  };
  const auto p_aside = aside(p);
  const auto q_aside = aside(q);
  Moment first;
  Moment last;
  if (is_zero(p_aside) && is_zero(q_aside)) {
    first = std::min(time_of(p), time_of(q));
    last = std::max(time_of(p), time_of(q));
  } else {
    // p + s (q - p) is on the line where every coordinate of (1 - s) p_aside + s q_aside is zero.
    std::size_t j = 0;
    while (p_aside[j] == q_aside[j]) {
      if (++j == p_aside.size()) return {};
    }
    const auto s = Moment::fraction(p_aside[j], p_aside[j] - q_aside[j]);
    if (s.over < 0 || s.over > s.under) return {};
    for (std::size_t i = 0; i < p_aside.size(); ++i) {
      if (p_aside[i] * (s.under - s.over) + q_aside[i] * s.over != 0) return {};
    }
    const Integer w =
        (p[k] - line.origin[k]) * (s.under - s.over) + (q[k] - line.origin[k]) * s.over;
    first = last = Moment::fraction(w * line.one, d[k] * s.under);
  }
  const Moment end{line.max, 1};
  if (last.over < 0 || end < first) return {};
  return Span{std::max(first, Moment{}), std::min(last, end)};
}

/// A triangle without area is the longest of its edges, which may be a point.
template <int N>
Expected<N> raycast_collapsed(const Line<N>& line, const std::array<Vector<N>, 3>& corners) {
  std::size_t longest = 0;
  Integer length = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto edge = difference(corners[(i + 1) % 3], corners[i]);
    if (dot(edge, edge) <= length) continue;
    length = dot(edge, edge);
    longest = i;
  }
  const auto inside = on_segment<N>(line, corners[longest], corners[(longest + 1) % 3]);
  if (!inside) return {};
  return hit<N>(line, floor(inside->enter), floor(inside->exit), against(line));
}

template <Scalar S, int N>
Expected<N> expected_raycast(const Ray<S, N>& ray, const Segment<S, N>& segment) {
  const auto line = oracle::line(ray);
  if (line.max < 0) return {};
  const auto inside = on_segment<N>(line, raw(segment.start), raw(segment.end));
  if (!inside) return {};
  return hit<N>(line, floor(inside->enter), floor(inside->exit), against(line));
}

template <Scalar S>
Expected<2> expected_raycast(const Ray<S, 2>& ray, const Triangle<S, 2>& triangle) {
  const auto line = oracle::line(ray);
  const std::array corners{raw(triangle.a), raw(triangle.b), raw(triangle.c)};
  if (line.max < 0) return {};
  const Integer area =
      cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
  if (area == 0) return raycast_collapsed<2>(line, corners);

  const auto spaces = edges(corners, line.origin, line.direction, line.one);
  const auto inside = span(spaces, line.max);
  if (!inside) return {};
  auto normal = against(line);
  if (!inside_at_start(spaces)) {
    std::size_t i = 0;
    while (!spaces[i].entered_at(inside->enter)) ++i;
    const auto edge = difference(corners[(i + 1) % 3], corners[i]);
    const int winding = area.sign();
    normal = normalized<2>({winding * edge[1], -winding * edge[0]}, line);
  }
  return hit(line, floor(inside->enter), floor(inside->exit), normal);
}

/// The ray crosses the plane at a rational time. The point there is tested against the edges,
/// projected along an axis that is not parallel to the triangle. If the ray is in the plane, the
/// ray itself is projected.
template <Scalar S>
Expected<3> expected_raycast(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle) {
  const auto line = oracle::line(ray);
  const std::array corners{raw(triangle.a), raw(triangle.b), raw(triangle.c)};
  if (line.max < 0) return {};
  const auto across = cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
  if (is_zero(across)) return raycast_collapsed<3>(line, corners);

  const Integer height = dot(across, difference(line.origin, corners[0])) * line.one;
  const Integer speed = dot(across, line.direction);
  std::size_t axis = 0;
  while (across[axis].is_zero()) ++axis;
  const std::array flat{without(corners[0], axis), without(corners[1], axis),
                        without(corners[2], axis)};
  const auto spaces =
      edges(flat, without(line.origin, axis), without(line.direction, axis), line.one);
  if (speed == 0) {
    if (height != 0) return {};
    const auto inside = span(spaces, line.max);
    if (!inside) return {};
    return hit(line, floor(inside->enter), floor(inside->exit), normalized(across, line));
  }
  const auto t = Moment::fraction(-height, speed);
  if (t.over < 0 || line.max * t.under < t.over) return {};
  for (const auto& space : spaces) {
    if (!space.holds(t)) return {};
  }
  auto facing = across;
  if (speed > 0) {
    for (auto& component : facing) component = -component;
  }
  return hit(line, floor(t), floor(t), normalized(facing, line));
}

/// Whether the ray runs against the normal, as Facing::front requires. By Cramer's rule, so that it
/// does not reuse the cross product.
template <Scalar S>
bool meets_front(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle) {
  const auto a = raw(triangle.a), d = widen(raw(ray.direction));
  const auto u = difference(raw(triangle.b), a), v = difference(raw(triangle.c), a);
  Integer determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    determinant += u[i] * v[j] * d[k] - u[i] * v[k] * d[j];
  }
  return determinant < 0;
}

}  // namespace detent::oracle
