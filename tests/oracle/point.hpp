// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "detent/shape/shape.hpp"
#include "oracle/exact.hpp"

namespace detent::oracle {

/// A point with the coordinates over[i] / under raw units, and its squared distance from the query
/// point. Denominators are positive.
template <int N>
struct Place {
  Vector<N> over;
  Integer under = 1;
  Moment squared;
};

/// The result for a point and a shape, nothing for an empty shape. The shape is all points within
/// `radius` of its core (points, lines, faces or boxes), and `core` is the closest point of the
/// core.
template <int N>
struct Nearest {
  Place<N> core;
  Integer radius = 0;
  /// Whether a point inside is its own closest point.
  bool keeps_inside = false;
};

template <int N>
Place<N> place_at(const Vector<N>& p, const Vector<N>& corner) {
  const auto apart = difference(p, corner);
  return {corner, 1, {dot(apart, apart), 1}};
}

/// The candidate with the least squared distance, so no regions are needed.
template <int N>
const Place<N>& least(const std::vector<Place<N>>& candidates) {
  const Place<N>* best = &candidates.front();
  for (const auto& candidate : candidates) {
    if (candidate.squared < best->squared) best = &candidate;
  }
  return *best;
}

/// Adds the foot of the perpendicular from p to the line through `start` along `e`, if it is at
/// start + t e with 0 <= t <= limit. Its squared distance is a quotient of Gram determinants.
template <int N>
void add_foot(std::vector<Place<N>>& candidates, const Vector<N>& p, const Vector<N>& start,
              const Vector<N>& e, const Moment& limit) {
  const auto w = difference(p, start);
  const Integer ee = dot(e, e), we = dot(w, e), ww = dot(w, w);
  if (ee.is_zero() || we < 0 || limit < Moment{we, ee}) return;
  Place<N> foot{{}, ee, {ww * ee - we * we, ee}};
  for (std::size_t i = 0; i < e.size(); ++i) foot.over[i] = start[i] * ee + e[i] * we;
  candidates.push_back(foot);
}

template <int N>
void add_segment(std::vector<Place<N>>& candidates, const Vector<N>& p, const Vector<N>& a,
                 const Vector<N>& b) {
  candidates.push_back(place_at<N>(p, a));
  candidates.push_back(place_at<N>(p, b));
  add_foot<N>(candidates, p, a, difference(b, a), {1, 1});
}

/// Adds the foot of the perpendicular to a triangle's plane if it is in the triangle: its weights
/// solve the normal equations by Cramer's rule, in 2D and in 3D.
template <int N>
void add_face(std::vector<Place<N>>& candidates, const Vector<N>& p, const Vector<N>& a,
              const Vector<N>& b, const Vector<N>& c) {
  const auto u = difference(b, a), v = difference(c, a), w = difference(p, a);
  const Integer uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const Integer uw = dot(u, w), vw = dot(v, w), ww = dot(w, w);
  const Integer total = uu * vv - uv * uv;
  const Integer of_b = vv * uw - uv * vw, of_c = uu * vw - uv * uw;
  if (total.is_zero() || of_b < 0 || of_c < 0 || of_b + of_c > total) return;
  const Integer volume = ww * total - uw * of_b - vw * of_c;
  Place<N> foot{{}, total, {volume, total}};
  for (std::size_t i = 0; i < u.size(); ++i) {
    foot.over[i] = a[i] * total + u[i] * of_b + v[i] * of_c;
  }
  candidates.push_back(foot);
}

template <Scalar S, int N>
std::optional<Nearest<N>> nearest(const Sphere<S, N>& sphere, const Vec<S, N>& point) {
  if (sphere.radius < 0) return {};
  return Nearest<N>{place_at<N>(raw(point), raw(sphere.center)), raw(sphere.radius), true};
}

template <Scalar S, int N>
std::optional<Nearest<N>> nearest(const Aabb<S, N>& box, const Vec<S, N>& point) {
  const auto p = raw(point), low = raw(box.min), high = raw(box.max);
  Nearest<N> result{{p, 1, {}}, 0, true};
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (high[i] < low[i]) return {};
    const Integer& side = p[i] < low[i] ? low[i] : high[i];
    if (p[i] >= low[i] && p[i] <= high[i]) continue;
    result.core.over[i] = side;
    result.core.squared.over += (p[i] - side) * (p[i] - side);
  }
  return result;
}

/// In the frame of the box.
template <Scalar S, int N>
std::optional<Nearest<N>> nearest(const Obb<S, N>& box, const Vec<S, N>& point) {
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  const auto center = raw(box.center), half = raw(box.half_extents);
  const auto apart = difference(raw(point), center);
  Nearest<N> result{{{}, one * one, {0, one * one}}, 0, true};
  for (std::size_t j = 0; j < apart.size(); ++j) result.core.over[j] = center[j] * one * one;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    if (half[i] < 0) return {};
    const auto axis = widen(raw(box.rotation.axis(static_cast<int>(i))));
    const Integer place = dot(axis, apart), reach = half[i] * one;
    const Integer size = place < 0 ? Integer(-place) : place;
    const Integer beyond = size > reach ? Integer(size - reach) : Integer(0);
    const Integer kept = place < 0 ? Integer(place + beyond) : Integer(place - beyond);
    result.core.squared.over += beyond * beyond;
    for (std::size_t j = 0; j < apart.size(); ++j) result.core.over[j] += kept * axis[j];
  }
  return result;
}

template <Scalar S, int N>
std::optional<Nearest<N>> nearest(const Plane<S, N>& plane, const Vec<S, N>& point) {
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  const auto n = widen(raw(plane.normal));
  const auto p = raw(point);
  const Integer nn = dot(n, n), short_of = raw(plane.offset) * one - dot(n, p);
  Nearest<N> result{{{}, nn, {short_of * short_of, nn}}};
  for (std::size_t i = 0; i < n.size(); ++i) result.core.over[i] = p[i] * nn + n[i] * short_of;
  return result;
}

template <Scalar S, int N>
std::optional<Nearest<N>> nearest(const Segment<S, N>& segment, const Vec<S, N>& point) {
  std::vector<Place<N>> candidates;
  add_segment<N>(candidates, raw(point), raw(segment.start), raw(segment.end));
  return Nearest<N>{least<N>(candidates)};
}

template <Scalar S, int N>
std::optional<Nearest<N>> nearest(const Capsule<S, N>& capsule, const Vec<S, N>& point) {
  if (capsule.radius < 0) return {};
  auto result = nearest(Segment<S, N>{capsule.a, capsule.b}, point);
  result->radius = raw(capsule.radius);
  result->keeps_inside = true;
  return result;
}

template <Scalar S, int N>
std::optional<Nearest<N>> nearest(const Ray<S, N>& ray, const Vec<S, N>& point) {
  const auto line = oracle::line(ray);
  if (line.max < 0) return {};
  const auto p = raw(point);
  std::vector<Place<N>> candidates{place_at<N>(p, line.origin)};
  // In steps of 1 / `one` raw unit, so that the end is on the grid too.
  Vector<N> end, from_end;
  for (std::size_t i = 0; i < end.size(); ++i) {
    end[i] = line.origin[i] * line.one + line.max * line.direction[i];
    from_end[i] = p[i] * line.one - end[i];
  }
  candidates.push_back({end, line.one, {dot(from_end, from_end), line.one * line.one}});
  add_foot<N>(candidates, p, line.origin, line.direction, {line.max, line.one});
  return Nearest<N>{least<N>(candidates)};
}

template <Scalar S, int N>
std::optional<Nearest<N>> nearest(const Triangle<S, N>& triangle, const Vec<S, N>& point) {
  const auto p = raw(point), a = raw(triangle.a), b = raw(triangle.b), c = raw(triangle.c);
  std::vector<Place<N>> candidates;
  add_segment<N>(candidates, p, a, b);
  add_segment<N>(candidates, p, b, c);
  add_segment<N>(candidates, p, c, a);
  add_face<N>(candidates, p, a, b, c);
  return Nearest<N>{least<N>(candidates)};
}

}  // namespace detent::oracle
