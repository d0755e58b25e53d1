// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/math/orthonormal.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/gjk.hpp"

namespace detent {

namespace detail {

/// `edge_body` with half extents `longer` steps longer and edges rounded to the grid of the
/// coordinates.
template <Scalar S, int N>
[[nodiscard]] constexpr auto short_edge_body(const Obb<S, N>& box, int longer) noexcept {
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

/// Filter for `overlaps` with half the bits per coordinate: tests a box that contains `box` and one
/// that `box` contains (docs/filters.md, lemma 9).
template <Scalar S, int N>
[[nodiscard]] constexpr Filtered decide_overlap(const Obb<S, N>& box,
                                                const HullBody<S, N>& hull) noexcept {
  constexpr int error = 3;  // of edges, in steps
  if (!are_perpendicular<10>(box.rotation)) return Filtered::unsure;
  bool is_thick = true;
  for (int i = 0; i < N; ++i) is_thick = is_thick && box.half_extents[i].raw() >= error;
  if (is_thick && bodies_overlap(short_edge_body(box, -error), hull)) return Filtered::yes;
  return bodies_overlap(short_edge_body(box, error), hull) ? Filtered::unsure : Filtered::no;
}

}  // namespace detail

/// Whether `box` and `hull` share a point.
///
/// The box is the one that its edges span, {center + sum s_i half_extents[i] axis(i) : |s_i| <= 1},
/// with the axes exactly as stored.
///
/// domain: every input; an empty box or hull overlaps nothing
/// exact:  yes or no exact; touching counts                        (tests/oracle/obb_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Obb<S, N>& box, const ConvexHull<S, N>& hull) noexcept {
  if (is_empty(box) || is_empty(hull)) return false;
  const detail::HullBody body(hull);
  const auto exact = [&] { return detail::bodies_overlap(detail::edge_body(box), body); };
  if constexpr (filter_pays<S>) {
    return or_exact(detail::decide_overlap(box, body), exact);
  } else {
    return exact();
  }
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const ConvexHull<S, N>& hull, const Obb<S, N>& box) noexcept {
  return overlaps(box, hull);
}

}  // namespace detent
