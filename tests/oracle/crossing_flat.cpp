// SPDX-License-Identifier: MIT
#include <algorithm>

#include "oracle/crossing_parts.hpp"

namespace detent::oracle {
namespace {

/// A box is 2N half-spaces: for every axis the lower, then the upper one. The face hit is the first
/// whose half-space is entered exactly at the time of the hit.
template <int N>
MaybeCrossing<N> crossing_of_faces(const Line<N>& line, const std::array<HalfSpace, 2 * N>& faces,
                                   const std::array<Vector<N>, N>& axes) {
  const auto inside = span(faces, line.max);
  if (!inside) return {};
  auto normal = against(line);
  if (!inside_at_start(faces)) {
    for (std::size_t i = faces.size(); i-- > 0;) {
      if (!faces[i].entered_at(inside->enter)) continue;
      const auto& axis = axes[i / 2];
      normal = stored<N>(i % 2 == 0 ? negated(axis) : axis);
    }
  }
  return crossing_at<N>(*inside, normal);
}

Vector<2> without(const Vector<3>& v, std::size_t axis) {
  return axis == 0   ? Vector<2>{v[1], v[2]}
         : axis == 1 ? Vector<2>{v[2], v[0]}
                     : Vector<2>{v[0], v[1]};
}

/// The moving point `start + t * velocity / one` against the three edges of a 2D triangle of either
/// winding, by the sign of the area it spans with each.
std::array<HalfSpace, 3> sides(const std::array<Vector<2>, 3>& corners, const Vector<2>& start,
                               const Vector<2>& velocity, const Integer& one) {
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

/// A triangle without area is the longest of its edges, which may be a point.
template <int N>
MaybeCrossing<N> crossing_of_collapsed(const Line<N>& line,
                                       const std::array<Vector<N>, 3>& corners) {
  std::size_t longest = 0;
  Integer length = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto edge = difference(corners[(i + 1) % 3], corners[i]);
    if (dot(edge, edge) <= length) continue;
    length = dot(edge, edge);
    longest = i;
  }
  return crossing_of(line, Edge<N>{corners[longest], corners[(longest + 1) % 3]});
}

}  // namespace

template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Box<N>& box) {
  std::array<HalfSpace, 2 * N> faces;
  std::array<Vector<N>, N> axes{};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (box.high[i] < box.low[i]) return {};
    faces[2 * i] = {(box.low[i] - line.origin[i]) * line.one, -line.direction[i]};
    faces[2 * i + 1] = {(line.origin[i] - box.high[i]) * line.one, line.direction[i]};
    axes[i][i] = line.one;
  }
  return crossing_of_faces<N>(line, faces, axes);
}

/// As slabs, with the axes exactly as stored: they need not be quite orthogonal.
template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const TurnedBox<N>& box) {
  const auto apart = difference(line.origin, box.center);
  std::array<HalfSpace, 2 * N> faces;
  for (std::size_t i = 0; i < box.axes.size(); ++i) {
    if (box.half[i] < 0) return {};
    const Integer place = dot(box.axes[i], apart);
    const Integer speed = dot(box.axes[i], line.direction);
    faces[2 * i] = {(-box.half[i] * box.one - place) * line.one, -speed};
    faces[2 * i + 1] = {(place - box.half[i] * box.one) * line.one, speed};
  }
  return crossing_of_faces<N>(line, faces, box.axes);
}

/// The plane as the intersection of its two half-spaces.
template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Wall<N>& wall) {
  const Integer height = (dot(wall.normal, line.origin) - wall.offset * wall.one) * line.one;
  const Integer speed = dot(wall.normal, line.direction);
  const auto inside =
      span(std::array{HalfSpace{height, speed}, HalfSpace{-height, -speed}}, line.max);
  if (!inside) return {};
  return crossing_at<N>(*inside, stored<N>(speed > 0 ? negated(wall.normal) : wall.normal));
}

template <int N>
std::optional<Span> on_edge(const Line<N>& line, const Edge<N>& edge) {
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
  const auto& [p, q] = edge;
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

template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Edge<N>& edge) {
  const auto inside = on_edge(line, edge);
  if (!inside) return {};
  return crossing_at<N>(*inside, against(line));
}

MaybeCrossing<2> crossing_of(const Line<2>& line, const Face<2>& face) {
  const auto& corners = face.corners;
  const Integer area =
      cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
  if (area == 0) return crossing_of_collapsed<2>(line, corners);

  const auto spaces = sides(corners, line.origin, line.direction, line.one);
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
  return crossing_at<2>(*inside, normal);
}

/// The ray crosses the plane at a rational time. The point there is tested against the edges,
/// projected along an axis that is not parallel to the triangle. If the ray is in the plane, the
/// ray itself is projected.
MaybeCrossing<3> crossing_of(const Line<3>& line, const Face<3>& face) {
  const auto& corners = face.corners;
  const auto across = cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
  if (is_zero(across)) return crossing_of_collapsed<3>(line, corners);

  const Integer height = dot(across, difference(line.origin, corners[0])) * line.one;
  const Integer speed = dot(across, line.direction);
  if (speed == 0 && height != 0) return {};
  const auto t = Moment::fraction(-height, speed);
  if (speed != 0 && (t.over < 0 || line.max * t.under < t.over)) return {};
  std::size_t axis = 0;
  while (across[axis].is_zero()) ++axis;
  const std::array flat{without(corners[0], axis), without(corners[1], axis),
                        without(corners[2], axis)};
  const auto spaces =
      sides(flat, without(line.origin, axis), without(line.direction, axis), line.one);
  if (speed == 0) {
    const auto inside = span(spaces, line.max);
    if (!inside) return {};
    return crossing_at<3>(*inside, normalized(across, line));
  }
  for (const auto& space : spaces) {
    if (!space.holds(t)) return {};
  }
  return crossing_at<3>({t, t}, normalized(speed > 0 ? negated(across) : across, line));
}

template MaybeCrossing<2> crossing_of(const Line<2>&, const Box<2>&);
template MaybeCrossing<3> crossing_of(const Line<3>&, const Box<3>&);
template MaybeCrossing<2> crossing_of(const Line<2>&, const TurnedBox<2>&);
template MaybeCrossing<3> crossing_of(const Line<3>&, const TurnedBox<3>&);
template MaybeCrossing<2> crossing_of(const Line<2>&, const Wall<2>&);
template MaybeCrossing<3> crossing_of(const Line<3>&, const Wall<3>&);
template MaybeCrossing<2> crossing_of(const Line<2>&, const Edge<2>&);
template MaybeCrossing<3> crossing_of(const Line<3>&, const Edge<3>&);

}  // namespace detent::oracle
