// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <utility>

#include "detent/shape/shape.hpp"
#include "oracle/exact.hpp"

/// Whether two convex shapes overlap. Tries all planes that could separate them, or all pairs of
/// corners, edges and faces that could be nearest to each other.
namespace detent::small {

using oracle::cross;
using oracle::difference;
using oracle::dot;
using oracle::Integer;
using oracle::is_zero;
using oracle::raw;
using oracle::Vector;
using oracle::widen;

/// A list of fixed capacity.
template <class T, std::size_t Most>
class List {
 public:
  void add(const T& x) { elements_[size_++] = x; }
  [[nodiscard]] const T* begin() const { return elements_.data(); }
  [[nodiscard]] const T* end() const { return elements_.data() + size_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return elements_[i]; }

 private:
  std::array<T, Most> elements_;
  std::size_t size_ = 0;
};

/// The convex hull of some points, empty if there are none. `edges` contains all its edges as
/// vectors, and possibly others.
template <int N>
struct Body {
  List<Vector<N>, 8> points;
  List<Vector<N>, 12> edges;
};

/// The number of raw units in 1 for a direction, and of fine units in a raw unit for the
/// coordinates below.
template <Scalar S>
Integer one() {
  return Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
}

template <int N>
Vector<N> scaled(Vector<N> v, const Integer& factor) {
  for (auto& component : v) component *= factor;
  return v;
}

/// Bodies in coordinates with `unit` steps per raw unit.
template <Scalar S, int N>
Body<N> body(const Vec<S, N>& point, const Integer& unit) {
  Body<N> result;
  result.points.add(scaled<N>(raw(point), unit));
  return result;
}

template <int N>
Body<N> hull_of(const List<Vector<N>, 8>& points) {
  Body<N> result;
  for (const auto& p : points) {
    for (const auto& q : result.points) result.edges.add(difference(p, q));
    result.points.add(p);
  }
  return result;
}
template <Scalar S, int N, class... Points>
Body<N> hull_of(const Integer& unit, const Vec<S, N>& first, const Points&... points) {
  List<Vector<N>, 8> all;
  for (const auto& point : {first, points...}) all.add(scaled<N>(raw(point), unit));
  return hull_of<N>(all);
}
template <Scalar S, int N>
Body<N> body(const Segment<S, N>& segment, const Integer& unit) {
  return hull_of(unit, segment.start, segment.end);
}
template <Scalar S, int N>
Body<N> body(const Triangle<S, N>& triangle, const Integer& unit) {
  return hull_of(unit, triangle.a, triangle.b, triangle.c);
}
template <Scalar S, int N>
Body<N> body(const ConvexHull<S, N>& hull, const Integer& unit) {
  List<Vector<N>, 8> all;
  for (const auto& point : hull.points) all.add(scaled<N>(raw(point), unit));
  return hull_of<N>(all);
}

/// The parallelepiped with this corner and the edges from it.
template <int N>
Body<N> box_of(const Vector<N>& corner, const std::array<Vector<N>, N>& edges) {
  Body<N> result;
  for (const auto& edge : edges) result.edges.add(edge);
  for (unsigned choice = 0; choice < 1u << N; ++choice) {
    auto point = corner;
    for (unsigned j = 0; j < unsigned{N}; ++j) {
      for (std::size_t i = 0; i < point.size(); ++i) {
        if ((choice >> j & 1) != 0) point[i] += edges[j][i];
      }
    }
    result.points.add(point);
  }
  return result;
}
template <Scalar S, int N>
Body<N> body(const Aabb<S, N>& box, const Integer& unit) {
  std::array<Vector<N>, N> edges;
  for (int i = 0; i < N; ++i) {
    if (box.max[i] < box.min[i]) return {};
    const auto k = static_cast<std::size_t>(i);
    edges[k][k] = (raw(box.max)[k] - raw(box.min)[k]) * unit;
  }
  return box_of<N>(scaled<N>(raw(box.min), unit), edges);
}
/// The box spanned by its edges; `unit` must be one<S>().
template <Scalar S, int N>
Body<N> body(const Obb<S, N>& box, const Integer& unit) {
  auto corner = scaled<N>(raw(box.center), unit);
  std::array<Vector<N>, N> edges;
  for (int i = 0; i < N; ++i) {
    if (box.half_extents[i] < 0) return {};
    const auto axis = scaled<N>(widen(raw(box.rotation.axis(i))),
                                static_cast<std::int64_t>(box.half_extents[i].raw()));
    corner = difference(corner, axis);
    edges[static_cast<std::size_t>(i)] = scaled<N>(axis, 2);
  }
  return box_of<N>(corner, edges);
}

/// Whether a line or plane perpendicular to `axis` separates the bodies and touches neither.
template <int N>
bool separates(const Vector<N>& axis, const Body<N>& a, const Body<N>& b) {
  const auto least_and_most = [&](const auto& points) {
    Integer low = dot(axis, points[0]), high = low;
    for (const auto& point : points) {
      const Integer height = dot(axis, point);
      if (height < low) low = height;
      if (high < height) high = height;
    }
    return std::pair{low, high};
  };
  const auto [a_low, a_high] = least_and_most(a.points);
  const auto [b_low, b_high] = least_and_most(b.points);
  return a_high < b_low || b_high < a_low;
}

inline Vector<2> across(const Vector<2>& v) { return {-v[1], v[0]}; }

/// The part of `v` perpendicular to `e`, times e^2.
template <int N>
Vector<N> aside(const Vector<N>& v, const Vector<N>& e) {
  return difference(scaled<N>(v, dot(e, e)), scaled<N>(e, dot(v, e)));
}

/// Whether a line or plane separates two bodies. If the edges span the space, it suffices to try
/// those parallel to one edge of either body in 2D, or to two edges in 3D: these are the sides of
/// the Minkowski difference. Otherwise also tries those perpendicular to the shortest line between
/// two corners, or between a corner and an edge.
template <int N>
bool are_apart(const Body<N>& a, const Body<N>& b) {
  if (a.points.size() == 0 || b.points.size() == 0) return true;
  List<Vector<N>, 24> edges;
  for (const auto& e : a.edges) edges.add(e);
  for (const auto& e : b.edges) edges.add(e);
  bool is_full = false;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if constexpr (N == 2) {
      const auto axis = across(edges[i]);
      if (separates<N>(axis, a, b)) return true;
      for (std::size_t k = 0; k < i; ++k) is_full = is_full || !dot(axis, edges[k]).is_zero();
    } else {
      for (std::size_t j = 0; j < i; ++j) {
        const auto axis = cross(edges[i], edges[j]);
        if (separates<N>(axis, a, b)) return true;
        for (std::size_t k = 0; k < j && !is_full; ++k) is_full = !dot(axis, edges[k]).is_zero();
      }
    }
  }
  if (is_full) return false;
  for (const auto& p : a.points) {
    for (const auto& q : b.points) {
      const auto w = difference(p, q);
      if (separates<N>(w, a, b)) return true;
      for (const auto& e : edges) {
        if (separates<N>(aside<N>(w, e), a, b)) return true;
      }
    }
  }
  return false;
}

/// Whether the segment from p along d is within `reach` of 0, if its nearest point is the foot of
/// the perpendicular; otherwise false.
template <int N>
bool is_edge_within(const Vector<N>& p, const Vector<N>& d, const Integer& reach) {
  const Integer dd = dot(d, d), along = -dot(p, d);
  if (dd.is_zero() || along < 0 || along > dd) return false;
  return dot(p, p) * dd - along * along <= reach * reach * dd;
}

/// The same for the triangle from p along d and e, with the foot at p + s d + t e.
template <int N>
bool is_face_within(const Vector<N>& p, const Vector<N>& d, const Vector<N>& e,
                    const Integer& reach) {
  const Integer dd = dot(d, d), de = dot(d, e), ee = dot(e, e), pd = dot(p, d), pe = dot(p, e);
  const Integer whole = dd * ee - de * de;
  const Integer s = de * pe - ee * pd, t = de * pd - dd * pe;
  if (whole.is_zero() || s < 0 || t < 0 || s + t > whole) return false;
  return dot(p, p) * whole + s * pd + t * pe <= reach * reach * whole;
}

/// The same for the segments from 0 along d and from w along e: s d - w - t e is perpendicular to
/// both.
template <int N>
bool are_edges_within(const Vector<N>& d, const Vector<N>& w, const Vector<N>& e,
                      const Integer& reach) {
  const Integer dd = dot(d, d), de = dot(d, e), ee = dot(e, e), dw = dot(d, w), ew = dot(e, w);
  const Integer whole = dd * ee - de * de;
  const Integer s = ee * dw - de * ew, t = de * dw - dd * ew;
  if (whole.is_zero() || s < 0 || s > whole || t < 0 || t > whole) return false;
  Integer squared = dot(w, w) * whole;  // (w + t e - s d)^2 * whole
  squared += t * ew - s * dw;
  return squared <= reach * reach * whole;
}

/// Whether the corners, edges or faces of two bodies come within `reach` of each other.
template <int N>
bool are_sides_within(const Body<N>& a, const Body<N>& b, const Integer& reach) {
  for (const auto& p : a.points) {
    for (const auto& q : b.points) {
      const auto w = difference(p, q);
      if (dot(w, w) <= reach * reach) return true;
    }
  }
  const auto corner_within = [&](const Body<N>& corners, const Body<N>& sides) {
    for (const auto& p : corners.points) {
      for (std::size_t i = 0; i < sides.points.size(); ++i) {
        const auto w = difference(sides.points[i], p);
        for (std::size_t j = 0; j < i; ++j) {
          const auto d = difference(sides.points[j], sides.points[i]);
          if (is_edge_within<N>(w, d, reach)) return true;
          for (std::size_t k = 0; N == 3 && k < j; ++k) {
            if (is_face_within<N>(w, d, difference(sides.points[k], sides.points[i]), reach)) {
              return true;
            }
          }
        }
      }
    }
    return false;
  };
  if (corner_within(a, b) || corner_within(b, a)) return true;
  for (std::size_t i = 0; N == 3 && i < a.points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto d = difference(a.points[j], a.points[i]);
      for (std::size_t k = 0; k < b.points.size(); ++k) {
        for (std::size_t l = 0; l < k; ++l) {
          if (are_edges_within<N>(d, difference(b.points[k], a.points[i]),
                                  difference(b.points[l], b.points[k]), reach)) {
            return true;
          }
        }
      }
    }
  }
  return false;
}

/// Whether two bodies come within `reach` >= 0 of each other.
template <int N>
bool are_within(const Body<N>& a, const Body<N>& b, const Integer& reach) {
  if (a.points.size() == 0 || b.points.size() == 0) return false;
  return are_sides_within(a, b, reach) || !are_apart(a, b);
}

/// A shape given by a core and a radius around it; a negative radius is the empty set.
template <int N>
struct Rounded {
  Body<N> core;
  Integer radius;
};
template <template <Scalar, int> class Shape, Scalar S, int N>
requires detail::Round<Shape<S, N>> Rounded<N> rounded(const Shape<S, N>& shape) {
  return {body(detail::ShapeFields<Shape<S, N>>::core(shape), 1), raw(shape.radius)};
}
template <Scalar S, int N>
Rounded<N> rounded(const Segment<S, N>& segment) {
  return {body(segment, 1), 0};
}
template <class Shape>
concept IsRound = requires(const Shape& shape) {
  rounded(shape);
};

/// The points of a core in the frame of a box.
template <Scalar S, int N>
Body<N> seen_from(const Obb<S, N>& box, const Body<N>& core) {
  List<Vector<N>, 8> points;
  for (const auto& point : core.points) {
    const auto from_center = difference(point, raw(box.center));
    Vector<N> place;
    for (std::size_t i = 0; i < place.size(); ++i) {
      place[i] = dot(widen(raw(box.rotation.axis(static_cast<int>(i)))), from_center);
    }
    points.add(place);
  }
  return hull_of<N>(points);
}

/// Whether two shapes overlap. Against round shapes and segments, boxes are measured in their own
/// frame; against others, they are spanned by their edges.
template <class A, class B, Scalar S, int N>
bool meet_as(const A& a, const B& b, const Vec<S, N>& /* names the space */) {
  if constexpr (!IsRound<A> && !IsRound<B>) {
    return !are_apart(body(a, one<S>()), body(b, one<S>()));
  } else if constexpr (!IsRound<A>) {
    return meet_as(b, a, Vec<S, N>{});
  } else {
    const auto [core, radius] = rounded(a);
    if (radius < 0) return false;
    if constexpr (IsRound<B>) {
      const auto other = rounded(b);
      return other.radius >= 0 && are_within(core, other.core, radius + other.radius);
    } else if constexpr (std::same_as<B, Obb<S, N>>) {
      const Obb<S, N> at_home{{}, b.half_extents, {}};
      return are_within(seen_from(b, core), body(at_home, one<S>()), radius * one<S>());
    } else {
      return are_within(core, body(b, 1), radius);
    }
  }
}
template <template <Scalar, int> class A, template <Scalar, int> class B, Scalar S, int N>
bool meet(const A<S, N>& a, const B<S, N>& b) {
  return meet_as(a, b, Vec<S, N>{});
}

/// Whether a plane overlaps a shape: its core has corners on both sides, or one within the radius.
template <Scalar S, int N, class Shape>
bool meet_plane(const Plane<S, N>& plane, const Shape& shape) {
  const auto normal = widen(raw(plane.normal));
  Body<N> core;
  Integer radius = 0, unit = one<S>();
  if constexpr (IsRound<Shape>) {
    unit = 1;
    core = rounded(shape).core;
    radius = rounded(shape).radius;
  } else {
    core = body(shape, unit);
  }
  if (radius < 0) return false;
  bool is_above = false, is_below = false;
  for (const auto& point : core.points) {
    const Integer height = dot(normal, point) - raw(plane.offset) * one<S>() * unit;
    if (height * height <= radius * radius * dot(normal, normal)) return true;
    is_above = is_above || height > 0;
    is_below = is_below || height < 0;
  }
  return is_above && is_below;
}
template <template <Scalar, int> class Shape, Scalar S, int N>
bool meet(const Plane<S, N>& plane, const Shape<S, N>& shape) {
  return meet_plane(plane, shape);
}
template <template <Scalar, int> class Shape, Scalar S, int N>
bool meet(const Shape<S, N>& shape, const Plane<S, N>& plane) {
  return meet_plane(plane, shape);
}
/// Two planes overlap unless they are parallel and different.
template <Scalar S, int N>
bool meet(const Plane<S, N>& a, const Plane<S, N>& b) {
  const auto m = widen(raw(a.normal)), n = widen(raw(b.normal));
  if (dot(m, m) * dot(n, n) != dot(m, n) * dot(m, n)) return true;
  return scaled<N>(m, raw(b.offset)) == scaled<N>(n, raw(a.offset));
}

}  // namespace detent::small
