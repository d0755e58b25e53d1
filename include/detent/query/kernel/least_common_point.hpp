// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include "detent/math/components.hpp"
#include "detent/number/rounding.hpp"
#include "detent/query/kernel/for_each_two.hpp"

// The overlap of two flat, parallel features of polytopes: its point with the least x, then y, then
// z.
//
// A feature is the hull of the corners that `for_each(f)` passes to f, all in one plane (in 2D on
// one line); `some()` is one of them. The corners of both features have one type, which also holds
// their differences. The planes of both features are parallel. Along u, which crosses them, one
// point lies over another if their difference is a multiple of u. The caller knows that some points
// do. Both features may be single points, segments or polygons; corners may repeat, and corners
// that are not extreme in their feature do not matter.
//
// Projected along u, the common points are a convex polygon, whose least point is one of its
// corners: the least corner of one feature, if that is over the other feature; or else a crossing
// of two edges. (A corner of one feature inside the other is least near itself only if it is least
// in its feature, and on an edge it is a crossing.) A segment between any two corners of a feature
// lies inside, so segments that are not edges add only common points, none of which is less.

namespace detent::detail {

/// The point over / under, where under > 0.
template <Number Over, Number Under, int N>
struct RationalPoint {
  Vec<Over, N> over;
  Under under;
};

template <Number Over, Number Under, int N>
RationalPoint(Vec<Over, N>, Under) -> RationalPoint<Over, Under, N>;

/// Whether p comes before q in the order of x, then y, then z.
template <Number T, int N>
[[nodiscard]] constexpr bool is_before(const Vec<T, N>& p, const Vec<T, N>& q) noexcept {
  for (int i = 0; i < N; ++i) {
    if (p[i] != q[i]) return p[i] < q[i];
  }
  return false;
}
template <Number Over, Number Under, int N>
[[nodiscard]] constexpr bool is_before(const RationalPoint<Over, Under, N>& p,
                                       const RationalPoint<Over, Under, N>& q) noexcept {
  for (int i = 0; i < N; ++i) {
    const auto left = p.over[i] * q.under, right = q.over[i] * p.under;
    if (left != right) return left < right;
  }
  return false;
}

/// q - p in the type of the corners p and q.
template <Number T, int N>
[[nodiscard]] constexpr Vec<T, N> edge_between(const Vec<T, N>& q, const Vec<T, N>& p) noexcept {
  return narrow<bits_of<T>>(q - p);
}

/// The components of a feature's corners.
template <class Feature>
using CornerOf = std::remove_cvref_t<decltype(std::declval<const Feature&>().some().x)>;

/// The least corner of a feature.
template <class Feature>
[[nodiscard]] constexpr auto least_corner(const Feature& feature) noexcept {
  auto least = feature.some();
  feature.for_each([&](const auto& corner) {
    if (is_before(corner, least)) least = corner;
  });
  return least;
}

/// The directions in which two features extend: none, `e`, or `e` and `f`.
template <Number E, int N>
struct Extent {
  int dimension = 0;
  Vec<E, N> e, f;

  constexpr void add(const Vec<E, N>& edge) noexcept {
    if (is_zero(edge)) return;
    if (dimension == 0) {
      e = edge;
      dimension = 1;
    } else if (N == 3 && dimension == 1 && !are_parallel(e, edge)) {
      f = edge;
      dimension = 2;
    }
  }
};

template <class A, class B>
[[nodiscard]] constexpr auto extent_of(const A& a, const B& b) noexcept {
  Extent<CornerOf<A>, A::dimension> extent;
  const auto add = [&](const auto& feature) {
    const auto from = feature.some();
    feature.for_each([&](const auto& corner) { extent.add(edge_between(corner, from)); });
  };
  add(a);
  add(b);
  return extent;
}

/// Two features on one line or on parallel lines with the direction `e`, or two points with e = 0.
/// `w` is a vector with w . u = 0 and w . e > 0, or 0 for two points. Returns f(p, q) with the
/// least common point p on `a` and q on `b`.
template <class A, class B, Number E, Number W, int N, class F>
constexpr auto common_point_on_lines(const A& a, const B& b, const Vec<E, N>& e, const Vec<W, N>& w,
                                     const F& f) noexcept {
  const auto p = least_corner(a), q = least_corner(b);
  using Under = std::remove_cvref_t<decltype(dot(w, e))>;
  const auto whole = is_zero(e) ? Under(1) : dot(w, e);
  const auto ahead = dot(w, edge_between(p, q));
  const auto past = [&](const auto& corner, const Under& along) {
    return RationalPoint{corner * whole + e * along, whole};
  };
  // The later of the least corners is common.
  const bool is_later = is_before(Vec<E, N>(), e) ? ahead >= 0 : ahead <= 0;
  return is_later ? f(past(p, Under()), past(q, ahead))
                  : f(past(p, narrow_negative(ahead)), past(q, Under()));
}

/// Two features in parallel planes with the directions e and f, projected along u.
template <class A, class B, Number U>
class CommonPointOfPlanes {
 public:
  using Corner = CornerOf<A>;
  using Edge = Vec<Corner, 3>;

  constexpr CommonPointOfPlanes(const A& a, const B& b, const Edge& e, const Edge& f,
                                const Vec<U, 3>& u) noexcept
      : a_(a), b_(b), e_(e), f_(f), u_(u) {}

  /// Returns f(p, q) with the least common point p on a and q on b.
  template <class F>
  constexpr auto find(const F& f) const noexcept {
    const auto p = least_corner(a_), q = least_corner(b_);
    if (is_over(p, b_)) return f(at(p), under(p, q));
    if (is_over(q, a_)) return f(under(q, p), at(q));
    auto best = at(p), best_on_b = at(q);
    bool is_found = false;
    for_each_segment(a_, [&](const auto& from, const auto& to) {
      if (!is_edge(from, to)) return;
      for_each_segment(b_, [&](const auto& start, const auto& end) {
        const auto g = edge_between(to, from), h = edge_between(end, start);
        const auto r = edge_between(start, from);
        const auto all = volume(g, h);
        if (all == 0) return;
        const auto s = oriented(volume(r, h), all), t = oriented(volume(r, g), all);
        const auto whole = oriented(all, all);
        if (s < 0 || s > whole || t < 0 || t > whole) return;
        const auto here = past(from, whole, g * s);
        if (is_found && !is_before(here, best)) return;
        is_found = true;
        best = here;
        best_on_b = past(start, whole, h * t);
      });
    });
    return f(best, best_on_b);
  }

 private:
  using Volume = std::remove_cvref_t<decltype(dot(Vec<U, 3>(), cross(Edge(), Edge())))>;
  using Part = std::remove_cvref_t<decltype(Corner() * Volume())>;
  using Over = std::remove_cvref_t<decltype(Part() + (Part() + Part()))>;
  using Point = RationalPoint<Over, Volume, 3>;

  /// Twice the area of the triangle of v and w, projected along u, times a common factor.
  [[nodiscard]] constexpr Volume volume(const Edge& v, const Edge& w) const noexcept {
    return dot(u_, cross(v, w));
  }
  /// x with the sign that makes `all` positive.
  [[nodiscard]] static constexpr Volume oriented(const Volume& x, const Volume& all) noexcept {
    return all < 0 ? narrow_negative(x) : x;
  }

  /// corner + step / all.
  template <Number Step>
  [[nodiscard]] static constexpr Point past(const Edge& corner, const Volume& all,
                                            const Vec<Step, 3>& step) noexcept {
    return {make_vec<3>([&](int i) { return Over(corner[i] * all + step[i]); }), all};
  }
  [[nodiscard]] static constexpr Point at(const Edge& corner) noexcept {
    return past(corner, Volume(1), Vec<Part, 3>());
  }
  /// The point over `corner` in the plane through `from`.
  [[nodiscard]] constexpr Point under(const Edge& corner, const Edge& from) const noexcept {
    const auto v = edge_between(corner, from);
    const auto all = volume(e_, f_);
    const auto s = oriented(volume(v, f_), all), t = oriented(volume(e_, v), all);
    return past(from, oriented(all, all), e_ * s + f_ * t);
  }

  /// Whether `corner` is over a feature. If it is not, the feature's corners, seen from it, fill a
  /// wedge of less than half a turn, from `right` to `left`.
  template <class Feature>
  [[nodiscard]] constexpr bool is_over(const Edge& corner, const Feature& feature) const noexcept {
    Edge right = edge_between(feature.some(), corner), left = right;
    bool is_inside = are_parallel(u_, right);
    feature.for_each([&](const auto& other) {
      if (is_inside) return;
      const Edge v = edge_between(other, corner);
      const auto from_right = volume(right, v), from_left = volume(left, v);
      if (from_right > 0 && from_left > 0) {
        left = v;
      } else if (from_right < 0 && from_left < 0) {
        right = v;
      } else if (from_right == 0 && from_left == 0) {
        is_inside = is_opposite(right, v);  // or left = right, and v points the same way
      } else {
        is_inside = from_right <= 0 && from_left >= 0;
      }
    });
    return is_inside;
  }

  /// Whether no two corners of a are on different sides of the line from p to q. Always returning
  /// true would be correct, but a face of 30 corners has 435 segments.
  [[nodiscard]] constexpr bool is_edge(const Edge& p, const Edge& q) const noexcept {
    const auto along = edge_between(q, p);
    bool is_left = false, is_right = false;
    a_.for_each([&](const auto& corner) {
      if (is_left && is_right) return;
      const auto side = volume(along, edge_between(corner, p));
      is_left = is_left || side > 0;
      is_right = is_right || side < 0;
    });
    return !is_left || !is_right;
  }

  /// Whether the projection of w points against that of v, to which it is parallel, or is 0.
  [[nodiscard]] constexpr bool is_opposite(const Edge& v, const Edge& w) const noexcept {
    const auto side = cross(u_, v), other = cross(u_, w);
    const int i = longest_axis(side);
    return side[i] > 0 ? other[i] <= 0 : other[i] >= 0;
  }

  template <class Feature, class F>
  static constexpr void for_each_segment(const Feature& feature, const F& f) noexcept {
    for_each_two([&](const auto& g) { feature.for_each(g); }, f);
  }

  const A& a_;
  const B& b_;
  Edge e_, f_;
  Vec<U, 3> u_;
};

/// Returns f(p, q), where p on `a` lies over q on `b`, perpendicular to both features, and p is the
/// least such point. The caller knows that there is one.
template <class A, class B, class F>
constexpr auto least_common_point(const A& a, const B& b, const F& f) noexcept {
  const auto extent = extent_of(a, b);
  if constexpr (A::dimension == 3) {
    if (extent.dimension == 2) {
      const auto u = cross(extent.e, extent.f);
      return CommonPointOfPlanes(a, b, extent.e, extent.f, u).find(f);
    }
  }
  return common_point_on_lines(a, b, extent.e, extent.e, f);
}

/// Returns f(p, q), where p on `a` lies over q on `b` along u, and p is the least such point. The
/// caller knows that there is one, and that u crosses the planes of the features.
template <class A, class B, Number U, int N, class F>
constexpr auto least_common_point(const A& a, const B& b, const Vec<U, N>& u, const F& f) noexcept {
  const auto extent = extent_of(a, b);
  const auto& e = extent.e;
  if constexpr (N == 2) {
    Vec<U, 2> across{u.y, narrow_negative(u.x)};
    if (dot(across, e) < 0) across = narrow_negative(across);
    return common_point_on_lines(a, b, e, across, f);
  } else {
    if (extent.dimension == 2) return CommonPointOfPlanes(a, b, e, extent.f, u).find(f);
    // Component k of v x u, for the k where e x u is longest.
    const int k = longest_axis(cross(e, u));
    Vec<U, 3> across;
    across[(k + 1) % 3] = u[(k + 2) % 3];
    across[(k + 2) % 3] = narrow_negative(u[(k + 1) % 3]);
    if (dot(across, e) < 0) across = narrow_negative(across);
    return common_point_on_lines(a, b, e, across, f);
  }
}

}  // namespace detent::detail
