// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/math/orthonormal.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "detent/query/kernel/nearness.hpp"
#include "detent/shape/obb.hpp"

namespace detent {

namespace detail {

/// The body {center + sum s_i edges[i] : |s_i| <= 1}; `senses[i]` points the same way as edges[i].
///
/// The center is below 2^b and a component of an edge at most 2^b in numbers of b bits, so the
/// components of a corner are below 2^(b + 2).
template <Number E, Number V, int N>
class SpannedBody {
 public:
  static constexpr int dimension = N;
  template <class T>
  using Each = std::array<Vec<T, N>, static_cast<std::size_t>(N)>;

  template <Scalar S>
  constexpr SpannedBody(const Vec<S, N>& center, const Each<E>& edges,
                        const Each<V>& senses) noexcept
      : center_(make_vec<N>([&](int j) { return narrow_sum<bits>(center[j], E(0)); })),
        edges_(edges),
        senses_(senses) {}

  [[nodiscard]] constexpr auto some() const noexcept {
    return corner([](int, int) { return true; });
  }
  [[nodiscard]] constexpr auto low() const noexcept {
    return corner([this](int i, int j) { return edge(i)[j] < 0; });
  }
  [[nodiscard]] constexpr auto high() const noexcept {
    return corner([this](int i, int j) { return edge(i)[j] > 0; });
  }

  template <int, Number D, class From>
  [[nodiscard]] constexpr auto extreme(const Vec<D, N>& v, const From&,
                                       bool farthest) const noexcept {
    std::array<bool, static_cast<std::size_t>(N)> is_added{};
    for (std::size_t i = 0; i < is_added.size(); ++i) {
      is_added[i] = (dot(v, senses_[i]) > 0) == farthest;
    }
    return corner([&](int i, int) { return is_added[static_cast<std::size_t>(i)]; });
  }

 private:
  static constexpr int bits = bits_of<E> + 2;
  using Corner = decltype(narrow_sum<bits>(E(), E()));

  [[nodiscard]] constexpr const Vec<E, N>& edge(int i) const noexcept {
    return edges_[static_cast<std::size_t>(i)];
  }
  /// In component j: the center, plus each edge i with is_added(i, j), minus the others.
  template <class IsAdded>
  [[nodiscard]] constexpr auto corner(const IsAdded& is_added) const noexcept {
    auto result = center_;
    for (int j = 0; j < N; ++j) {
      for (int i = 0; i < N; ++i) {
        result[j] = is_added(i, j) ? narrow_sum<bits>(result[j], edge(i)[j])
                                   : narrow_difference<bits>(result[j], edge(i)[j]);
      }
    }
    return result;
  }

  Vec<Corner, N> center_;
  Each<E> edges_;
  Each<V> senses_;
};

/// A nonempty oriented box as the body that its edges, half_extents[i] axis(i), span.
template <Scalar S, int N>
[[nodiscard]] constexpr auto edge_body(const Obb<S, N>& box) noexcept {
  using Component = direction_component<S>;
  constexpr int bits = bits_of<S> + bits_of<Component> - 1;  // no component exceeds 1
  using Edge = decltype(narrow_product<bits>(S(), Component()));
  using Body = SpannedBody<Edge, Component, N>;
  typename Body::template Each<Edge> edges;
  typename Body::template Each<Component> senses;
  for (int i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    senses[k] = box.rotation.axis(i).vec();
    edges[k] =
        make_vec<N>([&](int j) { return narrow_product<bits>(box.half_extents[i], senses[k][j]); });
  }
  return Body(box.center, edges, senses);
}

/// The same with half extents `longer` steps longer and edges rounded to the grid of the
/// coordinates.
template <Scalar S, int N>
[[nodiscard]] constexpr auto rough_edge_body(const Obb<S, N>& box, int longer) noexcept {
  using Edge = Fixed<S::bits + 1, S::frac>;
  using Body = SpannedBody<Edge, Edge, N>;
  typename Body::template Each<Edge> edges;
  for (int i = 0; i < N; ++i) {
    const auto half = box.half_extents[i] + S::from_raw(static_cast<typename S::raw_type>(longer));
    edges[static_cast<std::size_t>(i)] =
        make_vec<N>([&](int j) { return nearest_to<Edge>(half * box.rotation.axis(i)[j]); });
  }
  return Body(box.center, edges, edges);
}

/// Filter for `overlaps` with coordinates of half the bits: tests a box that contains `box` and one
/// that `box` contains.
///
/// A rounded edge is off by at most sqrt(N) / 2 steps, and N of them by less than 2.6. Half extents
/// that are m longer extend the reach of a body along a unit vector d by m sum |d . a_i|. That is
/// at least m |A d| for the matrix A of the axes a_i, which is 0.998 m or more if these are
/// perpendicular within 2^-10. So with m = 3 the longer box reaches as far as `box` along every d,
/// and with -3 the shorter one no farther. (tests/query/overlaps/hull_boxes.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Nearness roughly_overlap(const Obb<S, N>& box,
                                                 const HullBody<S, N>& hull) noexcept {
  constexpr int margin = 3;
  if (!are_perpendicular<10>(box.rotation)) return Nearness::unknown;
  bool is_thick = true;
  for (int i = 0; i < N; ++i) is_thick = is_thick && box.half_extents[i].raw() >= margin;
  if (is_thick && bodies_overlap(rough_edge_body(box, -margin), hull)) return Nearness::meeting;
  return bodies_overlap(rough_edge_body(box, margin), hull) ? Nearness::unknown : Nearness::apart;
}

}  // namespace detail

/// Whether `box` and `hull` share a point.
///
/// The box is what its edges span, {center + sum s_i half_extents[i] axis(i) : |s_i| <= 1}, with
/// the axes exactly as stored.
///
/// domain: every input; an empty box or hull overlaps nothing
/// exact:  yes or no exact; touching counts                        (tests/oracle/obb_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Obb<S, N>& box, const ConvexHull<S, N>& hull) noexcept {
  if (is_empty(box) || is_empty(hull)) return false;
  const detail::HullBody body(hull);
  if constexpr (detail::looks_first<S>) {
    const auto nearness = detail::roughly_overlap(box, body);
    if (nearness != detail::Nearness::unknown) return nearness == detail::Nearness::meeting;
  }
  return detail::bodies_overlap(detail::edge_body(box), body);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const ConvexHull<S, N>& hull, const Obb<S, N>& box) noexcept {
  return overlaps(box, hull);
}

}  // namespace detent
