// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "detent/query/closest_points/pair.hpp"
#include "oracle/exact.hpp"
#include "oracle/program.hpp"

/// The closest points of two shapes by the definition: the closest difference of two polytopes is
/// proved by the planes through its ends, and the least pair is found by linear programs.
namespace detent::oracle {

template <int N>
using Position = std::array<Rational, static_cast<std::size_t>(N)>;

/// a + t b.
template <std::size_t N>
std::array<Rational, N> along(std::array<Rational, N> a, const std::array<Rational, N>& b,
                              const Rational& t = 1) {
  for (std::size_t i = 0; i < N; ++i) a[i] += t * b[i];
  return a;
}
template <std::size_t N>
std::array<Rational, N> minus(std::array<Rational, N> a, const std::array<Rational, N>& b) {
  return along(a, b, Rational(-1));
}

template <Scalar S, int N>
Position<N> position(const Vec<S, N>& v) {
  Position<N> result;
  for (int i = 0; i < N; ++i) result[static_cast<std::size_t>(i)] = std::int64_t{v[i].raw()};
  return result;
}
/// In units of 1.
template <Scalar S, int N>
Position<N> position(const Direction<S, N>& direction) {
  auto result = position(direction.vec());
  for (auto& x : result) x /= Rational(one_of<S>());
  return result;
}

template <int N>
using Corners = std::vector<Position<N>>;

template <Scalar S, int N>
Corners<N> corners_of(const Vec<S, N>& point) {
  return {position(point)};
}
template <Scalar S, int N>
Corners<N> corners_of(const Segment<S, N>& segment) {
  return {position(segment.start), position(segment.end)};
}
template <Scalar S, int N>
Corners<N> corners_of(const Triangle<S, N>& t) {
  return {position(t.a), position(t.b), position(t.c)};
}
template <Scalar S, int N>
Corners<N> corners_of(const ConvexHull<S, N>& hull) {
  Corners<N> result;
  for (const auto& point : hull.points) result.push_back(position(point));
  return result;
}
/// corner(is_upper) for every choice of a lower or an upper side on each axis.
template <int N, class Corner>
Corners<N> corners_of_sides(const Corner& corner) {
  Corners<N> result;
  for (std::size_t bits = 0; bits < std::size_t{1} << N; ++bits) {
    result.push_back(corner([&](int axis) { return (bits >> axis & 1) != 0; }));
  }
  return result;
}
template <Scalar S, int N>
Corners<N> corners_of(const Aabb<S, N>& box) {
  return corners_of_sides<N>([&](const auto& is_upper) {
    auto corner = position(box.min);
    for (std::size_t i = 0; i < N; ++i) {
      if (is_upper(static_cast<int>(i))) corner[i] = position(box.max)[i];
    }
    return corner;
  });
}
template <Scalar S, int N>
Corners<N> corners_of(const Obb<S, N>& box) {
  return corners_of_sides<N>([&](const auto& is_upper) {
    auto corner = position(box.center);
    for (int i = 0; i < N; ++i) {
      const Rational extent = std::int64_t{box.half_extents[i].raw()};
      corner =
          along(corner, position(box.rotation.axis(i)), is_upper(i) ? extent : Rational(-extent));
    }
    return corner;
  });
}

/// The exact value that `closest_points` must round: a point, and a distance and a direction from
/// it.
template <int N>
struct Exact {
  Position<N> point;
  Rational radius = 0;
  Position<N> direction{};
  bool is_rounded_once = true;
};
template <int N>
using ExactPair = std::pair<Exact<N>, Exact<N>>;

/// The sign of the exact coordinate minus x.
template <int N>
int sign_of_difference(const Exact<N>& exact, std::size_t i, const Rational& x) {
  const Rational step = exact.radius * exact.direction[i], rest = x - exact.point[i];
  if (step.sign() != rest.sign()) return step.sign() > rest.sign() ? 1 : -1;
  const Rational left = square(step), right = square(rest) * dot(exact.direction, exact.direction);
  return step.sign() * Rational(left - right).sign();
}

/// Whether a point has the coordinates of `exact`, rounded to nearest, ties to even, and clamped; or
/// within 2^-12 of that if it is not rounded once.
template <Scalar S, int N>
bool is_rounded(const Exact<N>& exact, const Vec<S, N>& point) {
  const Rational half = Rational(1, 2) + (exact.is_rounded_once ? Rational(0) : Rational(1, 4096));
  for (int i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const std::int64_t raw = point[i].raw();
    const int below = sign_of_difference(exact, k, Rational(raw) - half);
    const int above = sign_of_difference(exact, k, Rational(raw) + half);
    const bool is_even = raw % 2 == 0 || !exact.is_rounded_once;
    if (point[i] != lowest<S> && (below < 0 || (below == 0 && !is_even))) return false;
    if (point[i] != largest<S> && (above > 0 || (above == 0 && !is_even))) return false;
  }
  return true;
}

/// The program whose unknowns are the weights of a's corners and of b's, each with the sum 1, of
/// one point: of a, and of b translated by v.
template <int N>
Program common_points(const Corners<N>& a, const Corners<N>& b, const Position<N>& v) {
  const std::size_t unknowns = a.size() + b.size();
  Program program(unknowns);
  for (const bool is_a : {true, false}) {
    Program::Row row(unknowns, Rational(0));
    for (std::size_t j = 0; j < unknowns; ++j) row[j] = (j < a.size()) == is_a ? 1 : 0;
    program.add_equation(row, 1);
  }
  for (std::size_t i = 0; i < N; ++i) {
    Program::Row row;
    for (const auto& corner : a) row.push_back(corner[i]);
    for (const auto& corner : b) row.push_back(-corner[i]);
    program.add_equation(row, v[i]);
  }
  return program;
}

/// The least point of a that is also one of b translated by v; nothing if there is none.
template <int N>
std::optional<Position<N>> least_common(const Corners<N>& a, const Corners<N>& b,
                                        const Position<N>& v) {
  auto program = common_points<N>(a, b, v);
  Position<N> result;
  for (std::size_t i = 0; i < N; ++i) {
    Program::Row cost;
    for (const auto& corner : a) cost.push_back(corner[i]);
    cost.resize(a.size() + b.size(), Rational(0));
    const auto least = program.least(cost);
    if (!least) return std::nullopt;
    result[i] = *least;
    program.add_equation(cost, *least);
  }
  return result;
}

/// The point where the segment from p to q first meets b; nothing if it does not.
template <int N>
std::optional<Position<N>> entry(const Position<N>& p, const Position<N>& q, const Corners<N>& b) {
  const auto program = common_points<N>({p, q}, b, Position<N>{});
  Program::Row cost(2 + b.size(), Rational(0));
  cost[1] = 1;
  const auto least = program.least(cost);
  if (!least) return std::nullopt;
  return along(p, minus(q, p), *least);
}

/// The documented common point of two polytopes that meet.
template <int N>
std::optional<Position<N>> first_common(const Corners<N>& a, const Corners<N>& b) {
  for (const bool is_a : {true, false}) {
    for (const auto& corner : is_a ? a : b) {
      if (entry<N>(corner, corner, is_a ? b : a)) return corner;
    }
  }
  for (const bool is_a : {true, false}) {
    const auto& corners = is_a ? a : b;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        if (const auto point = entry<N>(corners[i], corners[j], is_a ? b : a)) return point;
      }
    }
  }
  return std::nullopt;
}

/// The points of two round shapes, given the closest points of their cores and whether the gap is
/// at most the first radius, or both.
template <int N>
ExactPair<N> surface_points(const Position<N>& p, const Position<N>& q, const Rational& radius_a,
                            const Rational& radius_b) {
  const auto to_b = minus(q, p);
  const Rational squared = dot(to_b, to_b);
  if (squared <= square(radius_a)) return {{q, 0, to_b}, {q, 0, to_b}};
  const Exact<N> on_a{p, radius_a, to_b};
  if (squared <= square(radius_a + radius_b)) return {on_a, on_a};
  return {on_a, {q, radius_b, minus(p, q)}};
}

/// The closest difference of two polytopes, found by GJK; nothing here relies on that, because
/// `closest_polytopes` proves it.
template <Scalar S, int N, class A, class B>
Position<N> proposed_difference(const A& a, const B& b) {
  return detail::with_gjk(a, b, [&](auto search) {
    Position<N> v{};
    if (search.touches()) return v;
    const auto& feature = search.closest_feature();
    using T = std::remove_cvref_t<decltype(feature.newest().x)>;
    const Rational unit(Integer(1) << static_cast<unsigned>(T::frac - S::frac));
    Corners<N> corners;
    for (int k = 0; k < feature.count; ++k) {
      Position<N> corner;
      for (int i = 0; i < N; ++i) {
        corner[static_cast<std::size_t>(i)] = Rational(whole(feature[k][i].raw())) / unit;
      }
      corners.push_back(corner);
    }
    const auto& w = corners[0];
    v = w;
    if (corners.size() == 2) {
      const auto e = minus(corners[1], w);
      v = along(w, e, Rational(-dot(w, e) / dot(e, e)));
    } else if (corners.size() == 3) {
      const auto e = minus(corners[1], w), f = minus(corners[2], w);
      // w + s e + t f with both products with e and f zero.
      const Rational ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), we = dot(w, e), wf = dot(w, f);
      const Rational all = ee * ff - ef * ef;
      v = along(along(w, e, Rational((wf * ef - we * ff) / all)), f,
                Rational((we * ef - wf * ee) / all));
    }
    return v;
  });
}

/// Nothing if the proposed difference `v` is not that of the closest points.
template <int N>
std::optional<ExactPair<N>> closest_polytopes(const Corners<N>& a, const Corners<N>& b,
                                              const Position<N>& v, const Rational& radius_a,
                                              const Rational& radius_b) {
  const Rational squared = dot(v, v);
  if (squared.is_zero()) {
    const auto point = first_common<N>(a, b);
    if (!point) return std::nullopt;
    return ExactPair<N>{{*point}, {*point}};
  }
  // No difference is before the plane through v, so v is the closest one if it is a difference.
  Rational least = dot(v, a.front()), most = dot(v, b.front());
  for (const auto& corner : a) least = std::min(least, dot(v, corner));
  for (const auto& corner : b) most = std::max(most, dot(v, corner));
  if (least - most != squared) return std::nullopt;
  const auto on_plane = [&](const Corners<N>& corners, const Rational& height) {
    Corners<N> result;
    for (const auto& corner : corners) {
      if (dot(v, corner) == height) result.push_back(corner);
    }
    return result;
  };
  const auto p = least_common<N>(on_plane(a, least), on_plane(b, most), v);
  if (!p) return std::nullopt;
  return surface_points<N>(*p, minus(*p, v), radius_a, radius_b);
}

template <Scalar S>
Rational rational(S x) {
  return std::int64_t{x.raw()};
}

/// The corner closest to a plane, the least one on ties, and its foot on the plane.
template <int N>
std::pair<Position<N>, Position<N>> nearest_corner(const Position<N>& normal,
                                                   const Rational& offset,
                                                   const Corners<N>& corners) {
  const auto height = [&](const Position<N>& at) { return Rational(dot(normal, at) - offset); };
  auto nearest = corners.front();
  for (const auto& corner : corners) {
    const Rational here = abs(height(corner)), there = abs(height(nearest));
    if (here < there || (here == there && corner < nearest)) nearest = corner;
  }
  return {nearest, along(nearest, normal, Rational(-height(nearest) / dot(normal, normal)))};
}

/// A plane and a polytope.
template <Scalar S, int N>
ExactPair<N> closest_to_plane(const Plane<S, N>& plane, const Corners<N>& corners,
                              const Rational& radius) {
  const auto n = position(plane.normal);
  const auto height = [&](const Position<N>& at) {
    return Rational(dot(n, at) - rational(plane.offset));
  };
  bool is_above = true, is_below = true;
  for (const auto& corner : corners) {
    is_above = is_above && height(corner) > 0;
    is_below = is_below && height(corner) < 0;
  }
  if (!is_above && !is_below) {
    for (const auto& corner : corners) {
      if (height(corner).is_zero()) return {{corner}, {corner}};
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        const Rational from = height(corners[i]), to = height(corners[j]);
        if (from.sign() == to.sign()) continue;
        const auto point =
            along(corners[i], minus(corners[j], corners[i]), Rational(from / (from - to)));
        return {{point}, {point}};
      }
    }
  }
  const auto [nearest, foot] = nearest_corner<N>(n, rational(plane.offset), corners);
  return surface_points<N>(foot, nearest, 0, radius);
}

/// The planes dot(m, x) = p and dot(n, x) = q.
inline ExactPair<2> closest_planes(const Position<2>& m, const Rational& p, const Position<2>& n,
                                   const Rational& q) {
  const Rational all = m[0] * n[1] - m[1] * n[0], mm = dot(m, m), nn = dot(n, n);
  Exact<2> on_a, on_b;
  if (all.is_zero()) {
    on_a.point = along(on_a.point, m, p / mm);
    on_b.point = along(on_b.point, n, q / nn);
    return {on_a, on_b};
  }
  on_a.point = {Rational((p * n[1] - q * m[1]) / all), Rational((q * m[0] - p * n[0]) / all)};
  return {on_a, on_a};
}
/// The common point that is closest to the origin is s m + t n.
inline ExactPair<3> closest_planes(const Position<3>& m, const Rational& p, const Position<3>& n,
                                   const Rational& q) {
  const Rational mm = dot(m, m), mn = dot(m, n), nn = dot(n, n), all = mm * nn - mn * mn;
  Exact<3> on_a, on_b;
  if (all.is_zero()) {
    on_a.point = along(on_a.point, m, p / mm);
    on_b.point = along(on_b.point, n, q / nn);
    return {on_a, on_b};
  }
  const Rational s = (p * nn - q * mn) / all, t = (q * mm - p * mn) / all;
  on_a.point = along(along(on_a.point, m, s), n, t);
  return {on_a, on_a};
}

/// A box in its frame and a segment, or a point if both ends are equal. A common point is where the
/// segment enters the box, or else its least point there.
template <Scalar S, int N>
ExactPair<N> closest_in_frame(const Obb<S, N>& box, const Position<N>& start,
                              const Position<N>& end, const Rational& radius, bool is_exact,
                              bool is_entry = true) {
  Corners<N> axes;
  for (int i = 0; i < N; ++i) axes.push_back(position(box.rotation.axis(i)));
  const auto center = position(box.center);
  const auto at = [&](const Rational& t) { return along(start, minus(end, start), t); };
  const auto clamped = [&](const Position<N>& point) {
    Position<N> result;
    for (std::size_t i = 0; i < N; ++i) {
      const Rational extent = rational(box.half_extents[static_cast<int>(i)]);
      result[i] = std::max<Rational>(
          -extent, std::min<Rational>(extent, dot(axes[i], minus(point, center))));
    }
    return result;
  };
  const auto beyond = [&](const Rational& t) {
    const auto point = at(t);
    auto result = clamped(point);
    for (std::size_t i = 0; i < N; ++i) result[i] -= dot(axes[i], minus(point, center));
    return result;
  };
  const auto gap = [&](const Rational& t) {
    const auto v = beyond(t);
    return dot(v, v);
  };
  // The squared distance is quadratic between the times at which the segment passes sides of slabs.
  std::vector<Rational> times{0, 1};
  for (std::size_t i = 0; i < N; ++i) {
    const Rational from = dot(axes[i], minus(start, center));
    const Rational speed = dot(axes[i], minus(end, start));
    const Rational extent = rational(box.half_extents[static_cast<int>(i)]);
    if (speed.is_zero()) continue;
    for (const Rational& side : {Rational(-extent), extent}) {
      const Rational t = (side - from) / speed;
      if (t > 0 && t < 1) times.push_back(t);
    }
  }
  std::sort(times.begin(), times.end());
  for (std::size_t k = 0, count = times.size(); k + 1 < count; ++k) {
    const Rational low = times[k], high = times[k + 1];
    if (low == high) continue;
    const Rational middle = (low + high) / 2, length = high - low;
    const Rational f0 = gap(low), f1 = gap(middle), f2 = gap(high);
    const Rational curve = 2 * (f2 - 2 * f1 + f0), slope = 4 * f1 - f2 - 3 * f0;
    if (curve > 0 && slope < 0 && slope + 2 * curve > 0) {
      times.push_back(low - slope / (2 * curve) * length);
    }
  }
  Rational best = times.front();
  for (const auto& t : times) {
    const Rational here = gap(t), there = gap(best);
    const bool is_less = is_entry && here.is_zero() ? t < best : at(t) < at(best);
    if (here < there || (here == there && is_less)) best = t;
  }
  const auto on_axis = at(best);
  if (gap(best).is_zero()) return {{on_axis}, {on_axis}};
  const auto to_world = [&](const Position<N>& v) {
    Position<N> result{};
    for (std::size_t i = 0; i < N; ++i) result = along(result, axes[i], v[i]);
    return result;
  };
  const Exact<N> on_box{along(center, to_world(clamped(on_axis)))};
  if (gap(best) <= square(radius)) return {on_box, on_box};
  return {on_box, {on_axis, radius, to_world(beyond(best)), is_exact}};
}

template <class A, class B>
inline constexpr bool is_in_frame = detail::is_kind<A, Obb> &&
                                    (detail::is_kind<B, Vec> || detail::is_kind<B, Segment>);

/// The exact closest points; nothing if a proof fails.
template <Scalar S, int N, class A, class B>
std::optional<ExactPair<N>> closest_cores(const A& a, const B& b, S radius_a, S radius_b) {
  if constexpr (is_in_frame<B, A> || (detail::is_kind<B, Plane> && !detail::is_kind<A, Plane>)) {
    auto pair = closest_cores<S, N>(b, a, radius_b, radius_a);
    if (pair) std::swap(pair->first, pair->second);
    return pair;
  } else if constexpr (detail::is_kind<B, Plane>) {
    return closest_planes(position(a.normal), rational(a.offset), position(b.normal),
                          rational(b.offset));
  } else if constexpr (detail::is_kind<A, Plane>) {
    return closest_to_plane(a, corners_of(b), rational(radius_b));
  } else if constexpr (is_in_frame<A, B>) {
    const auto ends = corners_of(b);
    return closest_in_frame(a, ends.front(), ends.back(), rational(radius_b), ends.size() == 1);
  } else {
    const auto v = proposed_difference<S, N>(detail::body_of(a), detail::body_of(b));
    return closest_polytopes<N>(corners_of(a), corners_of(b), v, rational(radius_a),
                                rational(radius_b));
  }
}

/// The exact closest points of two non-empty shapes; nothing if a proof fails.
template <Scalar S, int N, class A, class B>
std::optional<ExactPair<N>> closest_pair(const A& a, const B& b) {
  return closest_cores<S, N>(detail::core_of(a), detail::core_of(b), detail::radius_of(a),
                             detail::radius_of(b));
}

}  // namespace detent::oracle
