// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <type_traits>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/number/filter/shared_quotient.hpp"
#include "detent/query/kernel/common_point.hpp"
#include "detent/query/kernel/least_common_point.hpp"
#include "detent/query/kernel/line.hpp"
#include "detent/query/kernel/point_plane.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/query/kernel/support.hpp"

namespace detent::detail {

/// A point where a plane cuts a body that it meets: the first corner in the plane, or else a point
/// between the first two corners on different sides of it.
template <Scalar S, int N, class Body>
[[nodiscard]] constexpr Vec<S, N> common_point_with_plane(const Plane<S, N>& plane,
                                                          const Body& body) noexcept {
  const auto height = [&](const auto& corner) { return height_above(plane, corner); };
  auto result = nearest_to<S>(body.some());
  const bool has_corner = any_corner(body, [&](const auto& corner) {
    if (height(corner) != 0) return false;
    result = nearest_to<S>(corner);
    return true;
  });
  if (has_corner) return result;
  any_two_corners(body, [&](const auto& p, const auto& q) {
    const auto from = height(p), to = height(q);
    if ((from > 0) == (to > 0)) return false;
    const auto s = make_fraction(decltype(from - to)(from), from - to);
    const auto ratio = make_ratio_below_one(s.numerator, s.denominator);
    result = make_vec<N>([&](int i) { return nearest_between<S>(p[i], q[i] - p[i], ratio); });
    return true;
  });
  return result;
}

/// Filter: the foot on a plane of a corner that is `above` it, times the length of the normal, whose
/// square is `whole`; in numbers of 2^-24 steps of S (docs/filters.md, lemma 32).
template <Scalar S, int N, int BC, int FC, int BA, int FA, int BW, int FW>
[[nodiscard]] constexpr Decided<Vec<S, N>> decide_foot(const Vec<direction_component<S>, N>& n,
                                                       const Vec<Fixed<BC, FC>, N>& corner,
                                                       const Fixed<BA, FA>& above,
                                                       const Fixed<BW, FW>& whole) noexcept {
  using Value = Fixed<62, S::frac + 24>;
  using Excess = Fixed<FW - 27, FW>;
  const auto excess = whole - Fixed<FW + 1, FW>(1);
  if (!fits<Excess::bits>(excess)) return {{}, false};
  const auto height = narrow_floor<Value>(above);
  const auto correction = narrow_floor<Value>(height * narrow<Excess::bits>(excess));
  const auto down = narrow_difference<Value::bits>(height, correction);
  return decide_point<S, N>(
      [&](int i) {
        return narrow_difference<Value::bits>(narrow_floor<Value>(corner[i]),
                                              narrow_floor<Value>(n[i] * down));
      },
      Steps<32>());
}

/// The closest points of a plane and a body grown by a radius.
template <Scalar S, int N, class Body>
[[nodiscard]] constexpr std::pair<Vec<S, N>, Vec<S, N>> closest_points_to_plane(
    const Plane<S, N>& plane, const Body& body, const S& radius) noexcept {
  const auto& n = plane.normal.vec();
  const auto from = body.some();
  using Corner = decltype(from.x + from.x);
  const auto height = [&](const auto& corner) { return height_above(plane, corner); };
  const auto extreme = [&](bool farthest) {
    return body.template extreme<bits_of<Corner>>(n, from, farthest);
  };
  auto nearest = extreme(false);
  const bool is_above = height(nearest) > 0;
  if (!is_above) {
    nearest = extreme(true);
    if (!(height(nearest) < 0)) {
      const auto point = common_point_with_plane(plane, body);
      return {point, point};
    }
  }
  body.template for_each_extreme<bits_of<Corner>>(n, from, !is_above, [&](const auto& corner) {
    if (is_before(corner, nearest)) nearest = corner;
  });
  const auto above = height(nearest);
  const auto whole = squared_length(plane.normal);
  constexpr bool is_on_grid = std::is_same_v<decltype(from.x), S>;
  const auto on_plane = [&] {
    if constexpr (is_on_grid) {
      return point_on_line(nearest, n, make_ratio_to_unit(narrow_negative(above), whole));
    } else {
      const auto exact = [&] {
        return rounded<S>(RationalPoint{nearest * whole - n * above, whole});
      };
      if constexpr (is_fixed<S> && filter_pays<S>) {
        return or_exact(decide_foot<S>(n, nearest, above, whole), exact);
      } else {
        return exact();
      }
    }
  }();
  if constexpr (is_fixed<S> && !is_on_grid) {
    if (radius == 0) return {on_plane, nearest_to<S>(nearest)};
  }
  if (Fraction{square(above), whole} <= square(radius)) return {on_plane, on_plane};
  const auto to_plane = is_above ? narrow_negative(n) : n;
  if constexpr (is_on_grid) {
    return {on_plane, rounded_beyond(nearest, radius, to_plane)};
  } else {
    const RationalPoint p{nearest * decltype(whole)(1), decltype(whole)(1)};
    return {on_plane, rounded_beyond(p, radius, to_plane)};
  }
}

/// Filter: all(x, y, ...) with the coordinates of the point that two planes share, the one closest to
/// the origin, or otherwise() if unsure (docs/filters.md, lemma 37).
template <Scalar S, int N, class All, class Otherwise>
[[nodiscard]] DETENT_INLINE_FILTER constexpr auto decide_point_of_planes(
    const Plane<S, N>& a, const Plane<S, N>& b, const All& all,
    const Otherwise& otherwise) noexcept {
  const auto& m = a.normal.vec();
  const auto& n = b.normal.vec();
  if constexpr (N == 2) {
    const SharedQuotient over_area(narrow<62>(cross(m, n)));
    if (!over_area.is_sure) [[unlikely]]
      return otherwise();
    const Vec point{over_area(narrow_difference<63>(a.offset * n.y, b.offset * m.y)),
                    over_area(narrow_difference<63>(b.offset * m.x, a.offset * n.x))};
    if (!fits<bits_of<S> + 21>(point)) [[unlikely]]  // half the range
      return otherwise();
    return when_all_nearest<S>(to_array(point), Steps<64>(), all, otherwise);
  } else {
    const auto mm = squared_length(a.normal), nn = squared_length(b.normal);
    const auto mn = dot(a.normal, b.normal);
    using Unit = Fixed<63, 62>;
    using Square = Fixed<62, 60>;
    const auto cosine = Unit::assume_raw(shift_left(mn.raw(), 2));
    const auto squared = narrow_floor<Square>(cosine * cosine);
    const auto excess = narrow_difference<62>(narrow_sum<62>(mm, nn), Square(1));
    const SharedQuotient over_square(narrow_difference<62>(excess, squared));
    if (!over_square.is_sure) [[unlikely]]
      return otherwise();
    using Offset = Fixed<63, S::frac + 32>;
    using Over = Fixed<62, S::frac + 28>;
    const Offset at_a(a.offset), at_b(b.offset);
    const auto share = [&](const Offset& here, const auto& square, const Offset& there) {
      return narrow_difference<62>(narrow_floor<Over>(here * square),
                                   narrow_floor<Over>(there * mn));
    };
    const auto share_of_m = share(at_a, nn, at_b), share_of_n = share(at_b, mm, at_a);
    using Value = Fixed<62, S::frac + 26>;
    const auto point = make_vec<3>([&](int i) {
      return over_square(narrow_sum<63>(narrow_floor<Value>(share_of_m * Unit(m[i])),
                                        narrow_floor<Value>(share_of_n * Unit(n[i]))));
    });
    if (!fits<bits_of<S> + 17>(point)) [[unlikely]]  // half the range
      return otherwise();
    return when_all_nearest<S>(to_array(point), Steps<8>(), all, otherwise);
  }
}

/// The closest points of two planes: those closest to the origin.
///
/// Planes that are not parallel meet in a line, in 2D in a point. With normals m and n, and the
/// line's direction u = m x n, the line's point closest to the origin is
/// (a.offset n x u + b.offset u x m) / u^2.
template <Scalar S, int N>
[[nodiscard]] DETENT_OUTLINE constexpr std::pair<Vec<S, N>, Vec<S, N>>
exact_closest_points_of_planes(const Plane<S, N>& a, const Plane<S, N>& b) noexcept {
  const auto& m = a.normal.vec();
  const auto& n = b.normal.vec();
  if (are_parallel(m, n)) {
    const auto foot = [](const Plane<S, N>& plane) {
      return rounded<S>(
          RationalPoint{plane.normal.vec() * plane.offset, squared_length(plane.normal)});
    };
    return {foot(a), foot(b)};
  }
  Vec<S, N> point;
  if constexpr (N == 2) {
    const auto all = cross(m, n);
    const Vec over{a.offset * n.y - b.offset * m.y, b.offset * m.x - a.offset * n.x};
    point = make_vec<2>([&](int i) { return quotient_nearest<S>(over[i], all); });
  } else {
    const auto u = cross(m, n);
    point = rounded<S>(
        RationalPoint{cross(n, u) * a.offset + cross(u, m) * b.offset, squared_length(u)});
  }
  return {point, point};
}
template <Scalar S, int N>
[[nodiscard]] constexpr std::pair<Vec<S, N>, Vec<S, N>> closest_points_of_planes(
    const Plane<S, N>& a, const Plane<S, N>& b) noexcept {
  const auto exact = [&] { return exact_closest_points_of_planes(a, b); };
  if constexpr (is_fixed<S> && filter_pays<S>) {
    const auto twice = [](const auto&... x) {
      const Vec<S, N> point{x...};
      return std::pair{point, point};
    };
    return decide_point_of_planes(a, b, twice, exact);
  } else {
    return exact();
  }
}

}  // namespace detent::detail
