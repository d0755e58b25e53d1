// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>

#include "detent/math/rotation.hpp"

namespace detent::detail {

/// Directions and the reach of a box along each, to either side.
template <Number G, Number H, int N>
struct Edges {
  std::array<Vec<G, N>, static_cast<std::size_t>(N)> directions;
  Vec<H, N> extents;
};

/// The axes of `rotation` with these extents.
template <Scalar S, Number H, int N>
[[nodiscard]] constexpr auto edges_along(const Rotation<S, N>& rotation,
                                         const Vec<H, N>& extents) noexcept {
  Edges<direction_component<S>, H, N> edges{{}, extents};
  for (int i = 0; i < N; ++i) {
    edges.directions[static_cast<std::size_t>(i)] = rotation.axis(i).vec();
  }
  return edges;
}

/// Separating axes of a box about the origin, {sum of s[k] extents[k] generators[k] : |s[k]| <= 1},
/// and the hull of some points.
///
/// If they are apart, they stay apart if every extent grows a little. If the generators span the
/// space, the difference of the two sets then has an interior, whatever the extents were, even for
/// a single point. So it has faces, one of which separates them. A face is spanned by two edges,
/// each parallel to a generator or to the line through two of the points. So it is enough to try
/// the directions perpendicular to two of these; in 2D, to one.
///
/// source: separating axes, Ericson, Real-Time Collision Detection, 5.2.1
template <int N, Number G, std::size_t Generators, Number H, Number P, std::size_t Points>
struct Separation {
  std::array<Vec<G, N>, Generators> generators;
  std::array<H, Generators> extents;
  std::array<Vec<P, N>, Points> points;

  [[nodiscard]] constexpr bool exists() const noexcept {
    std::array<Vec<Edge, N>, Points*(Points - 1) / 2> edges;
    std::size_t count = 0;
    for (std::size_t i = 0; i < Points; ++i) {
      for (std::size_t j = 0; j < i; ++j) edges[count++] = points[i] - points[j];
    }
    if constexpr (N == 2) {
      return is_across_any(generators) || is_across_any(edges);
    } else {
      return is_across_any(generators, generators) || is_across_any(generators, edges) ||
             is_across_any(edges, edges);
    }
  }

 private:
  using Edge = decltype(P() - P());

  template <Number T, std::size_t Count>
  constexpr bool is_across_any(const std::array<Vec<T, N>, Count>& vectors) const noexcept {
    for (const auto& v : vectors) {
      if (is_along(Vec{narrow_negative(v.y), v.x})) return true;
    }
    return false;
  }
  template <Number T, std::size_t CountT, Number U, std::size_t CountU>
  constexpr bool is_across_any(const std::array<Vec<T, N>, CountT>& us,
                               const std::array<Vec<U, N>, CountU>& vs) const noexcept {
    for (const auto& u : us) {
      for (const auto& v : vs) {
        if (is_along(cross(u, v))) return true;
      }
    }
    return false;
  }

  /// Whether `n` separates: along it, all points are beyond the reach of the box on one side.
  template <Number T>
  constexpr bool is_along(const Vec<T, N>& n) const noexcept {
    using Term = decltype(extents[0] * abs(dot(generators[0], n)));
    constexpr int more_bits = std::bit_width(Generators - 1);  // for a sum of this many terms
    using Reach = decltype(narrow<bits_of<Term> + more_bits>(Term()));
    Reach reach(0);
    for (std::size_t k = 0; k < Generators; ++k) {
      reach = narrow_sum<bits_of<Reach>>(reach, extents[k] * abs(dot(generators[k], n)));
    }
    bool above = true, below = true;
    for (const auto& point : points) {
      const auto place = dot(n, point);
      above = above && place > reach;
      below = below && place < -reach;
    }
    return above || below;
  }
};

/// Whether the hull of `points` and the box about the origin spanned by `edges` are apart. The
/// edges belong to one box or two.
template <int N, Number P, std::size_t Points, Number G, Number H,
          std::same_as<Edges<G, H, N>>... More>
[[nodiscard]] constexpr bool are_apart(const std::array<Vec<P, N>, Points>& points,
                                       const Edges<G, H, N>& edges, const More&... more) noexcept {
  constexpr auto size = static_cast<std::size_t>(N);
  Separation<N, G, size*(1 + sizeof...(More)), H, P, Points> separation{{}, {}, points};
  std::size_t count = 0;
  for (const auto& some : {edges, more...}) {
    for (std::size_t i = 0; i < size; ++i, ++count) {
      separation.generators[count] = some.directions[i];
      separation.extents[count] = some.extents[static_cast<int>(i)];
    }
  }
  return separation.exists();
}

}  // namespace detent::detail
