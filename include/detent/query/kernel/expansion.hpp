// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/math/components.hpp"
#include "detent/number/filter/leading.hpp"
#include "detent/number/filter/quotient_key.hpp"
#include "detent/number/patience.hpp"
#include "detent/query/kernel/gjk.hpp"

namespace detent::detail {

/// Whether the first component of `v` that is not 0 is positive.
template <Number T, int N>
[[nodiscard]] constexpr bool is_positive(const Vec<T, N>& v) noexcept {
  for (int i = 0; i < N; ++i) {
    if (v[i] != 0) return v[i] > 0;
  }
  return false;
}

/// Breaks ties between two directions, given by nonzero vectors. Each line through the origin has a
/// positive direction, whose first nonzero component is positive. Of two lines, it chooses the one
/// whose positive unit vector has the greater x, then y, then z; of the two directions of one line,
/// the positive one.
///
/// So the choice depends only on the directions, and mirrored directions give the mirrored choice
/// unless both directions of a line are candidates.
template <Number T, int N>
[[nodiscard]] constexpr bool is_preferred(const Vec<T, N>& v, const Vec<T, N>& over) noexcept {
  const bool v_positive = is_positive(v), over_positive = is_positive(over);
  const auto v_squared = squared_length(v), over_squared = squared_length(over);
  for (int i = 0; i < N; ++i) {
    const int v_sign = v_positive ? (v[i] > 0) - (v[i] < 0) : (v[i] < 0) - (v[i] > 0);
    const int over_sign =
        over_positive ? (over[i] > 0) - (over[i] < 0) : (over[i] < 0) - (over[i] > 0);
    if (v_sign != over_sign) return v_sign > over_sign;
    const auto left = square(v[i]) * over_squared, right = square(over[i]) * v_squared;
    if (left != right) return v_sign > 0 ? left > right : left < right;
  }
  return v_positive && !over_positive;
}

/// How far one body must move along `normal` to leave another: height / |normal|.
template <class Normal, class Height>
struct Push {
  Normal normal{};
  Height height{};
};

/// Whether one push is less than another, or equal and preferred. Heights may be negative.
template <class Normal, class Height>
[[nodiscard]] constexpr bool is_less(const Push<Normal, Height>& a,
                                     const Push<Normal, Height>& b) noexcept {
  const bool a_negative = a.height < 0, b_negative = b.height < 0;
  if (a_negative != b_negative) return a_negative;
  const auto squared_a = squared_length(a.normal), squared_b = squared_length(b.normal);
  const auto exact = [&] {
    const Fraction left{square(a.height), squared_a}, right{square(b.height), squared_b};
    return left < right ? -1 : right < left ? 1 : 0;
  };
  const int order = [&] {
    if constexpr (is_fixed<Height>) {
      const auto product = [](const Height& height, const auto& squared) {
        const Leading leading(abs(height));
        return leading * leading * Leading(squared);
      };
      const auto apart =
          difference(product(a.height, squared_b), product(b.height, squared_a), Relative{56});
      return sign_or_exact(decide(apart), exact);
    } else {
      return exact();
    }
  }();
  if (order != 0) return (order < 0) != a_negative;
  return is_preferred(a.normal, b.normal);
}

/// The least push that separates two convex bodies a and b that share a point, found by expanding a
/// polytope of at most `MostCorners` corners. `T` holds the components of differences of their
/// points.
///
/// The differences a - b of all points are a convex polytope P that holds the origin. If b moves by
/// v, the difference moves by -v. So the bodies touch at most in their surfaces if v is outside P
/// or on its surface, and the least such v is the perpendicular to the nearest facet of P.
///
/// The search keeps a polytope Q whose corners are points of P. Each facet of Q has a signed
/// distance from the origin. Take the nearest facet. If P reaches no farther along its normal, it
/// is final: a part of a facet of P. Otherwise add the corner of P farthest along the normal, which
/// replaces the facets that it sees. Each step adds a corner of P, so the search ends: when all other
/// facets are farther away than a final one, or final. Then no facet of P is nearer, because the
/// least signed distance of Q is at most that of P, which contains Q.
///
/// Keys, which are approximate, order the facets during the search; it ends if they prove that the
/// other facets are farther away. Then `is_less` compares the final ones exactly, and
/// `is_preferred` orders those at equal distances. If the least distance d is positive, all facets
/// of P at that distance are facets of Q in the end: otherwise the point where one of them touches
/// the ball of radius d would be outside Q. If d = 0, all facets of Q through the origin are final.
/// Then P and Q have the same cone at the origin, so the same facets there.
///
/// A flat P pushes along a perpendicular to it, by 0. If Q has too many corners, all facets of P
/// are compared instead.
///
/// source: van den Bergen, Proximity Queries and Penetration Depth Computation on 3D Game Objects
///         (2001)
template <Number T, class A, class B, std::size_t MostCorners = 128, int N = A::dimension>
class Expansion {
 public:
  using Corner = Vec<T, N>;
  using Normal = decltype(facet_normal(Simplex<T, N>()));
  using Height = decltype(dot(Normal(), Corner()));

  /// `first` holds points of P, none in the span of the others; it may be empty.
  constexpr Expansion(const A& a, const B& b, const Simplex<T, N>& first = {}) noexcept
      : a_(a), b_(b), simplex_(first) {}

  /// The least push of b out of a.
  [[nodiscard]] constexpr Push<Normal, Height> least_push() noexcept {
    if (!start()) return {flat_normal(), Height()};
    for (Patience<T> patience; patience.step();) {
      const auto i = next();
      if (i == facet_count_) break;
      const auto corner = farthest(facets_[i].push.normal);
      if (!is_beyond(corner, facets_[i])) {
        make_final(i);
      } else if (!add(corner)) {
        return least_facet();
      }
    }
    return nearest();
  }

  /// The same push, for a P that is not flat, without storing a polytope: from all facets, each
  /// spanned by corners of one body or by an edge of each. It takes much longer.
  [[nodiscard]] constexpr Push<Normal, Height> least_facet() const noexcept {
    std::optional<Push<Normal, Height>> best;
    const auto offer = [&](const Simplex<T, N>& simplex, const auto& is_facet) {
      const auto across = facet_normal(simplex);
      if (is_zero(across)) return;
      for (const auto& normal : {across, narrow_negative(across)}) {
        const auto end = farthest(normal);
        if (!is_facet(normal, end)) continue;
        const Push<Normal, Height> push{normal, dot(normal, end)};
        if (!best || is_less(push, *best)) best = push;
      }
    };
    const auto& as = a_.corners();
    const auto& bs = b_.corners();
    const auto apart = [](const auto& a, const auto& b) { return narrow<bits_of<T>>(a - b); };
    // Faces of one body, with any corner of the other.
    for_each_facet(as, [&](const auto& first, const auto&... rest) {
      const auto& b = b_.some();
      offer(simplex_of(apart(first, b), apart(rest, b)...), [&](const auto& v, const auto&) {
        return dot(v, a_.template extreme<bits_of<T>>(v, b, true) - first) == 0;
      });
    });
    for_each_facet(bs, [&](const auto& first, const auto&... rest) {
      const auto& a = a_.some();
      offer(simplex_of(apart(a, first), apart(a, rest)...), [&](const auto& v, const auto&) {
        return dot(v, b_.template extreme<bits_of<T>>(v, a, false) - first) == 0;
      });
    });
    if constexpr (N == 3) {
      for_each_edge(as, [&](const auto& a, const auto& a_end) {
        for_each_edge(bs, [&](const auto& b, const auto& b_end) {
          const auto simplex = simplex_of(apart(a, b), apart(a_end, b), apart(a, b_end));
          offer(simplex,
                [&](const auto& v, const auto& end) { return dot(v, end) == dot(v, simplex[0]); });
        });
      });
    }
    return best ? *best : facets_[0].push;
  }

 private:
  static constexpr std::size_t most_corners = MostCorners;
  // Euler: a polytope of n corners has at most 2 n - 4 triangles.
  static constexpr std::size_t most_facets = N == 2 ? most_corners : 2 * most_corners - 4;
  using Index = std::uint8_t;
  using Key = QuotientKey<Height>;
  /// A side of a facet: in 3D the corners of an edge, in 2D one corner and which end it is.
  struct Ridge {
    Index from, to;
    [[nodiscard]] constexpr bool operator==(const Ridge&) const noexcept = default;
  };
  struct Facet {
    Push<Normal, Height> push;
    Key key;  // of the distance
    std::array<Index, std::size_t{N}> corners;
  };

  template <class Corners, class F>
  static constexpr void for_each_edge(const Corners& corners, const F& f) noexcept {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) f(corners[i], corners[j]);
    }
  }
  template <class Corners, class F>
  static constexpr void for_each_facet(const Corners& corners, const F& f) noexcept {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if constexpr (N == 2) {
          f(corners[i], corners[j]);
        } else {
          for (std::size_t k = 0; k < j; ++k) f(corners[i], corners[j], corners[k]);
        }
      }
    }
  }

  template <Number V>
  [[nodiscard]] constexpr Corner farthest(const Vec<V, N>& v) const noexcept {
    constexpr int bits = bits_of<T>;
    return narrow<bits>(a_.template extreme<bits>(v, b_.some(), true) -
                        b_.template extreme<bits>(v, a_.some(), false));
  }

  /// Adds a corner off the plane through the last corner perpendicular to `v`, if there is one.
  template <Number V>
  constexpr bool leave(const Vec<V, N>& v) noexcept {
    const auto at = dot(v, simplex_.newest());
    for (const auto& along : {v, narrow_negative(v)}) {
      const auto next = farthest(along);
      if (dot(v, next) == at) continue;
      simplex_.add(next);
      return true;
    }
    return false;
  }

  /// Completes N + 1 points that span the space; false if P is flat.
  constexpr bool start() noexcept {
    const auto unit = [](int i) { return make_vec<N>([&](int j) { return T(i == j ? 1 : 0); }); };
    if (simplex_.count == 0) simplex_.add(farthest(unit(0)));
    for (int i = 0; i < N && simplex_.count == 1; ++i) leave(unit(i));
    if (simplex_.count == 1) return false;
    if constexpr (N == 3) {
      const auto line = simplex_[1] - simplex_[0];
      for (int i = 0; i < N && simplex_.count == 2; ++i) {
        const auto across = cross(line, unit(i));
        if (!is_zero(across)) leave(across);
      }
      if (simplex_.count == 2) return false;
    }
    if (simplex_.count == N && !leave(facet_normal(simplex_))) return false;

    for (int i = 0; i <= N; ++i) corners_[static_cast<std::size_t>(i)] = simplex_[i];
    corner_count_ = std::size_t{N} + 1;
    Simplex<T, N> facet;
    for (int i = 0; i < N; ++i) facet.add(simplex_[i]);
    const auto normal = facet_normal(facet);
    const bool is_outward = dot(normal, simplex_[N]) < dot(normal, simplex_[0]);
    if constexpr (N == 2) {
      for (const auto& [from, to] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}}) {
        is_outward ? add_facet(from, to) : add_facet(to, from);
      }
    } else {
      if (!is_outward) std::swap(corners_[0], corners_[1]);
      add_facet(0, 1, 2);
      add_facet(0, 3, 1);
      add_facet(1, 3, 2);
      add_facet(2, 3, 0);
    }
    return true;
  }

  template <class... Indices>
  constexpr void add_facet(Indices... indices) noexcept {
    Simplex<T, N> simplex;
    (simplex.add(corners_[static_cast<std::size_t>(indices)]), ...);
    const auto normal = facet_normal(simplex);
    const auto height = dot(normal, simplex.newest());
    if constexpr (has_filters) {
      // One by one: a temporary would be copied in words that overlap numbers just written, which
      // stalls.
      auto& facet = facets_[facet_count_++];
      facet.push.normal = normal;
      facet.push.height = height;
      facet.key = Key(height, squared_length(normal));
      facet.corners = {static_cast<Index>(indices)...};
    } else {
      facets_[facet_count_++] = {
          {normal, height}, Key(height, squared_length(normal)), {static_cast<Index>(indices)...}};
    }
  }

  [[nodiscard]] static constexpr bool is_beyond(const Corner& corner, const Facet& facet) noexcept {
    return dot(facet.push.normal, corner) > facet.push.height;
  }
  /// Whether two facets have the same outward normal, so that they are in one plane.
  [[nodiscard]] static constexpr bool are_coplanar(const Facet& a, const Facet& b) noexcept {
    const auto& v = a.push.normal;
    const auto& w = b.push.normal;
    return is_fixed<T> && are_parallel(v, w) && is_positive(v) == is_positive(w);
  }
  /// The first facets are final: those along which P reaches no farther, and those in their planes.
  constexpr void make_final(std::size_t i) noexcept {
    const auto key = facets_[i].key;
    if (final_count_ == 0 || key < least_final_) least_final_ = key;
    const auto first = final_count_++;
    std::swap(facets_[i], facets_[first]);
    for (std::size_t j = final_count_; j < facet_count_; ++j) {
      const auto& other = facets_[j];
      if (key.is_surely_less(other.key) || other.key.is_surely_less(key)) continue;
      if (are_coplanar(facets_[first], other)) std::swap(facets_[j], facets_[final_count_++]);
    }
  }
  /// The facet to examine: the nearest that is not final; none if a final one is surely nearer.
  [[nodiscard]] constexpr std::size_t next() const noexcept {
    std::size_t best = final_count_;
    for (std::size_t i = best + 1; i < facet_count_; ++i) {
      if (facets_[i].key < facets_[best].key) best = i;
    }
    if (best == facet_count_) return best;
    const bool is_done = final_count_ > 0 && least_final_.is_surely_less(facets_[best].key);
    return is_done ? facet_count_ : best;
  }
  /// The exact choice among the final facets; with numbers that round, among all.
  [[nodiscard]] constexpr const Push<Normal, Height>& nearest() const noexcept {
    const auto count = is_fixed<T> ? final_count_ : facet_count_;
    std::size_t least = 0;
    for (std::size_t i = 1; i < count; ++i) {
      if (facets_[i].key < facets_[least].key) least = i;
    }
    std::size_t best = least;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& facet = facets_[i];
      if (i == best || facets_[least].key.is_surely_less(facet.key)) continue;
      if (are_coplanar(facet, facets_[best])) continue;
      if (is_less(facet.push, facets_[best].push)) best = i;
    }
    return facets_[best].push;
  }

  /// Adds a corner beyond some facet; false if there is no room.
  constexpr bool add(const Corner& corner) noexcept {
    if (corner_count_ == most_corners) return false;
    const auto added = corner_count_++;
    corners_[added] = corner;
    std::array<Ridge, 3 * most_facets> rim;  // not set to 0: few are used
    std::size_t ridges = 0;
    // A ridge between two facets that the corner sees occurs twice, once in each direction.
    const auto see = [&](int from, int to) {
      const Ridge back{static_cast<Index>(to), static_cast<Index>(from)};
      for (std::size_t i = 0; i < ridges; ++i) {
        if (rim[i] != back) continue;
        rim[i] = rim[--ridges];
        return;
      }
      rim[ridges++] = {static_cast<Index>(from), static_cast<Index>(to)};
    };
    constexpr int none = 255;
    for (std::size_t i = final_count_; i < facet_count_;) {
      const auto& facet = facets_[i];
      if (!is_beyond(corner, facet)) {
        ++i;
        continue;
      }
      if constexpr (N == 2) {
        see(facet.corners[0], none);
        see(none, facet.corners[1]);
      } else {
        for (std::size_t k = 0; k < 3; ++k) see(facet.corners[k], facet.corners[(k + 1) % 3]);
      }
      facets_[i] = facets_[--facet_count_];
    }
    // Cannot happen with exact numbers.
    if (facet_count_ + ridges > most_facets) return false;
    for (std::size_t i = 0; i < ridges; ++i) {
      if constexpr (N == 2) {
        rim[i].to == none ? add_facet(rim[i].from, added) : add_facet(added, rim[i].to);
      } else {
        add_facet(rim[i].from, rim[i].to, added);
      }
    }
    return true;
  }

  /// The preferred perpendicular of a flat P.
  [[nodiscard]] constexpr Normal flat_normal() const noexcept {
    Normal normal{};
    using Component = std::remove_cvref_t<decltype(normal.x)>;
    if (simplex_.count == N) {
      normal = facet_normal(simplex_);
      if (!is_positive(normal)) normal = narrow_negative(normal);
    } else if (simplex_.count == 2) {
      // |d|^2 e - (e . d) d is perpendicular to d, and nearest to the x axis e.
      if constexpr (N == 3) {
        const auto d = simplex_[1] - simplex_[0];
        normal = {Component(d.y * d.y + d.z * d.z), Component(-(d.x * d.y)),
                  Component(-(d.x * d.z))};
        if (is_zero(normal)) normal.y = Component(1);
      }
    } else {
      normal.x = Component(1);
    }
    return normal;
  }

  A a_;
  B b_;
  Simplex<T, N> simplex_;
  std::array<Corner, most_corners> corners_{};
  std::array<Facet, most_facets> facets_{};
  std::size_t corner_count_ = 0, facet_count_ = 0, final_count_ = 0;
  Key least_final_;
};

}  // namespace detent::detail
