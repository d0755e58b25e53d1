// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/number/filter/filtered.hpp"
#include "detent/number/fraction.hpp"
#include "detent/number/min_max.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "detent/query/kernel/touch_witness.hpp"

// A point that two convex polytopes share.

namespace detent::detail {

/// `bodies_overlap`, by a witness if that pays.
template <class A, class B>
[[nodiscard]] constexpr bool share_point(const A& a, const B& b) noexcept {
  if constexpr (witness_pays<A, B>) {
    return or_exact(still_witness(a, b).overlap(), [&] { return bodies_overlap(a, b); });
  } else {
    return bodies_overlap(a, b);
  }
}

/// Calls f with the corners of a body in order, until it returns true. Returns whether it did.
template <class Body, class F>
constexpr bool any_corner(const Body& body, const F& f) noexcept {
  const auto from = body.some();
  using Corner = std::remove_cvref_t<decltype(from)>;
  bool is_found = false;
  body.template for_each_extreme<bits_of<decltype(Corner().x)> + 1>(
      Corner(), from, true, [&](const auto& corner) { is_found = is_found || f(corner); });
  return is_found;
}

/// Calls f(corner, other) for every corner of a body and each later one, until it returns true.
template <class Body, class F>
constexpr bool any_two_corners(const Body& body, const F& f) noexcept {
  int i = 0;
  return any_corner(body, [&](const auto& corner) {
    int j = 0;
    const bool is_found =
        any_corner(body, [&](const auto& other) { return j++ > i && f(corner, other); });
    ++i;
    return is_found;
  });
}

/// Whether points lie beyond one side of a body, seen along the edges of a box, exactly. Other
/// bodies have no such sides.
template <class Body>
class Sides {
 public:
  explicit constexpr Sides(const Body&) noexcept {}
  template <class... Corner>
  [[nodiscard]] constexpr bool are_outside(const Corner&...) const noexcept {
    return false;
  }
};
template <class Body>
requires(has_filters&& IsBoxBody<Body>&& is_fixed<decltype(Body::Edge::x)>) class Sides<Body> {
 public:
  explicit constexpr Sides(const Body& body) noexcept {
    constexpr int bits = bits_of<decltype(body.some().x)> + 1;
    std::size_t i = 0;
    body.for_each_edge([&](const auto& edge) {
      const auto end = [&](bool upper) {
        return dot(edge, body.template extreme<bits>(edge, body.some(), upper));
      };
      slabs_[i++] = {edge, end(false), end(true)};
    });
  }
  template <class... Corner>
  [[nodiscard]] constexpr bool are_outside(const Corner&... corner) const noexcept {
    for (const auto& slab : slabs_) {
      if ((... && (dot(slab.edge, corner) < slab.low))) return true;
      if ((... && (dot(slab.edge, corner) > slab.high))) return true;
    }
    return false;
  }

 private:
  using Place = decltype(dot(typename Body::Edge(), std::declval<const Body&>().some()));
  struct Slab {
    typename Body::Edge edge;
    Place low, high;
  };
  std::array<Slab, static_cast<std::size_t>(Body::dimension)> slabs_{};
};

/// The type of the corners of two bodies on the finer of their grids.
template <Number A, Number B>
struct CommonCorner {
  using type = A;
};
template <int BitsA, int FracA, int BitsB, int FracB>
struct CommonCorner<Fixed<BitsA, FracA>, Fixed<BitsB, FracB>> {
  using type = common_fixed<Fixed<BitsA, FracA>, Fixed<BitsB, FracB>>;
};

/// Finds where the segment from p to q first enters a body that it meets, if p is outside. No
/// corner of the body is on the segment.
///
/// It enters through the interior of a face, where it pierces a triangle of corners, or of an edge,
/// which it crosses. (In the plane of a face or along an edge it would enter earlier, at the
/// border.) All such triangles and segments of corners are inside the body, so the first point on
/// any of them is the entry.
template <Scalar S, Number P, class Body, int N = Body::dimension>
class Entry {
 public:
  constexpr Entry(const Vec<P, N>& p, const Vec<P, N>& q, const Body& body) noexcept
      : p_(p), e_(q - p), body_(body) {}

  [[nodiscard]] constexpr Vec<S, N> find() noexcept {
    if constexpr (N == 3 && IsBoxBody<Body>) {
      enter_few<std::size_t{8}>(body_.corners());
      return at_first();
    } else if constexpr (N == 3 && has_filters && is_fixed<P> &&
                         requires(const Body& body) { body.corners(); }) {
      constexpr std::size_t few = 16;
      if (body_.corners().size() <= few) {
        enter_few<few>(body_.corners());
        return at_first();
      }
    }
    any_two_corners(body_, [&](const auto& k, const auto& l) {
      cross_segment(from_p(k), from_p(l));
      return false;
    });
    if constexpr (N == 3) {
      any_two_corners(body_, [&](const auto& k, const auto& l) {
        any_corner(body_, [&](const auto& m) {
          pierce_triangle(from_p(k), from_p(l), from_p(m));
          return false;
        });
        return false;
      });
    }
    return at_first();
  }

 private:
  using Edge = decltype(Vec<P, N>() - Vec<P, N>());
  using Component = std::remove_cvref_t<decltype(Edge().x)>;
  using Area = std::remove_cvref_t<decltype(cross(Vec<Component, 2>(), Vec<Component, 2>()))>;
  using Part = std::remove_cvref_t<decltype(dot(Vec<Component, 3>(), Vec<Area, 3>()))>;
  using Volume = std::remove_cvref_t<decltype(Part() + Part() + Part())>;

  [[nodiscard]] constexpr Vec<S, N> at_first() const noexcept {
    if constexpr (N == 3) {
      if (pierced_ < crossed_) return at(pierced_);
    }
    return at(crossed_);
  }

  /// Each product of two corners serves all their triangles.
  template <std::size_t Most, class Corners>
  constexpr void enter_few(const Corners& corners) noexcept {
    const std::size_t count = corners.size();
    std::array<Edge, Most> places;
    std::array<std::array<Part, Most>, Most> turns;
    for (std::size_t l = 0; l < count; ++l) {
      places[l] = from_p(corners[l]);
      for (std::size_t k = 0; k < l; ++k) {
        turns[k][l] = dot(e_, cross(places[k], places[l]));
        if (turns[k][l] == 0) cross_segment(places[k], places[l]);
      }
    }
    for (std::size_t m = 2; m < count; ++m) {
      for (std::size_t l = 1; l < m; ++l) {
        for (std::size_t k = 0; k < l; ++k) {
          pierce(turns[k][l], turns[l][m], narrow_negative(turns[k][m]),
                 [&] { return dot(places[m], cross(places[k], places[l])); });
        }
      }
    }
  }

  template <class Corner>
  [[nodiscard]] constexpr Edge from_p(const Corner& corner) const noexcept {
    return make_vec<N>([&](int i) { return P(corner[i]); }) - p_;
  }

  /// The point p + s e.
  template <Number T>
  [[nodiscard]] constexpr Vec<S, N> at(const Fraction<T, T>& s) const noexcept {
    return make_vec<N>([&](int i) {
      return quotient_nearest<S>(p_[i] * s.denominator + e_[i] * s.numerator, s.denominator);
    });
  }

  /// Takes s / all into account. It is at least 0, because the body is ahead of p.
  template <Number T>
  static constexpr void count(const T& s, const T& all, Fraction<T, T>& least) noexcept {
    const auto here = make_fraction(s, all);
    if (here < least) least = here;
  }

  /// Where p + s e = k + t (l - k), in the plane of both.
  constexpr void cross_segment(const Edge& k, const Edge& l) noexcept {
    const auto g = narrow<bits_of<Component>>(l - k);
    if constexpr (N == 2) {
      cross_in_plane(cross(e_, g), cross(k, g), cross(k, e_));
    } else {
      if (dot(e_, cross(k, l)) != 0) return;
      const auto all = cross(e_, g);
      const int i = longest_axis(all);
      cross_in_plane(all[i], cross(k, g)[i], cross(k, e_)[i]);
    }
  }
  constexpr void cross_in_plane(const Area& all, const Area& s, const Area& t) noexcept {
    if (all == 0) return;
    const auto beyond = make_fraction(t, all);
    if (beyond.numerator < 0 || beyond.numerator > beyond.denominator) return;
    count(s, all, crossed_);
  }

  /// The segment pierces the triangle of k, l, m if it passes all edges on the same side.
  constexpr void pierce_triangle(const Edge& k, const Edge& l, const Edge& m) noexcept {
    const auto kl = cross(k, l);
    pierce(dot(e_, kl), dot(e_, cross(l, m)), dot(e_, cross(m, k)), [&] { return dot(m, kl); });
  }
  /// The same for the sides on which it passes the edges; `volume` is that of k, l, m and p.
  template <class GetVolume>
  constexpr void pierce(const Part& a, const Part& b, const Part& c,
                        const GetVolume& volume) noexcept {
    if ((a < 0 || b < 0 || c < 0) && (a > 0 || b > 0 || c > 0)) return;
    const Volume all = a + b + c;
    if (all != 0) count(Volume(volume()), all, pierced_);
  }

  Vec<P, N> p_;
  Edge e_;
  const Body& body_;
  // Greater than 1 until found.
  Fraction<Area, Area> crossed_{Area(2), Area(1)};
  Fraction<Volume, Volume> pierced_{Volume(2), Volume(1)};
};

/// Where the first segment between two corners of `from` that meets `other`, in the order of first
/// and then second corner, enters it, rounded to nearest. No corner is in the other body, whose
/// sides are `sides`.
template <Scalar S, class From, class Other, int N = From::dimension>
[[nodiscard]] constexpr std::optional<Vec<S, N>> first_entry(const From& from, const Other& other,
                                                             const Sides<Other>& sides) noexcept {
  using P = typename CommonCorner<std::remove_cvref_t<decltype(from.some().x)>,
                                  std::remove_cvref_t<decltype(other.some().x)>>::type;
  std::optional<Vec<S, N>> result;
  const auto on_grid = [](const auto& corner) {
    return make_vec<N>([&](int i) { return P(corner[i]); });
  };
  any_two_corners(from, [&](const auto& p, const auto& q) {
    if (sides.are_outside(p, q)) return false;
    if (!share_point(HullBody(std::array{p, q}), other)) return false;
    result = Entry<S, P, Other>(on_grid(p), on_grid(q), other).find();
    return true;
  });
  return result;
}

/// A common point of two bodies that overlap, rounded to nearest: the first corner of `a` that is
/// in `b`; or else the first corner of `b` in `a`; or else where the first segment between two
/// corners of `a` that meets `b`, in the order of first and then second corner, enters it; or else
/// the same with `b`'s corners.
///
/// One of these exists: each corner of the intersection is the only common point of one face of
/// each body. So the dimensions of the two faces have a sum of at most 3, and one of them is a
/// corner or an edge.
template <Scalar S, class A, class B, int N = A::dimension>
[[nodiscard]] constexpr Vec<S, N> common_point(const A& a, const B& b) noexcept {
  auto result = nearest_to<S>(a.some());
  const Sides sides_of_a(a);
  const Sides sides_of_b(b);
  const auto take_corner = [&](const auto& from, const auto& other, const auto& sides) {
    return any_corner(from, [&](const auto& corner) {
      if (sides.are_outside(corner)) return false;
      if (!share_point(HullBody(std::array{corner}), other)) return false;
      result = nearest_to<S>(corner);
      return true;
    });
  };
  const auto take_edge = [&](const auto& from, const auto& other, const auto& sides) {
    const auto entry = first_entry<S>(from, other, sides);
    if (entry) result = *entry;
    return entry.has_value();
  };
  // All fail only with scalars that round.
  static_cast<void>(take_corner(a, b, sides_of_b) || take_corner(b, a, sides_of_a) ||
                    take_edge(a, b, sides_of_b) || take_edge(b, a, sides_of_a));
  return result;
}

}  // namespace detent::detail
