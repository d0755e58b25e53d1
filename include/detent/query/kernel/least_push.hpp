// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <type_traits>

#include "detent/math/width.hpp"
#include "detent/number/filter/leading.hpp"
#include "detent/query/kernel/axis_push.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/core.hpp"
#include "detent/query/kernel/expansion.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/point_obb.hpp"
#include "detent/query/kernel/point_plane.hpp"
#include "detent/query/kernel/push_witness.hpp"
#include "detent/query/kernel/within_slabs.hpp"
#include "detent/shape/plane.hpp"

namespace detent::detail {

/// The least translation that separates two shapes, each a core grown by a radius: `normal` leads
/// from a to b, exact and of any length (or a `Direction`), and b must move along it by `depth`,
/// rounded up to the grid.
template <class Normal, Number Depth>
struct LeastPush {
  Normal normal;
  Depth depth;
};

/// The same for a box in its frame: `local` is the normal there.
template <class Normal, class Local, Number Depth>
struct LeastPushInFrame {
  Normal normal;
  Local local;
  Depth depth;
};

/// `v` in a vector type that holds all its numbers.
template <class Wide, Number T, int N>
[[nodiscard]] constexpr Wide widened(const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) { return decltype(Wide::x)(v[i]); });
}

/// f(normal), where `Normal` holds the components of v: in numbers of 61 bits, at another length, if
/// they fit.
template <class Normal, Number T, int N, class F>
[[nodiscard]] constexpr auto with_normal(const Vec<T, N>& v, const F& f) noexcept {
  if constexpr (is_fixed<T> && has_filters) {
    using Short = Fixed<61, 0>;
    if (fits<Short::bits>(v)) {
      return f(make_vec<N>([&](int i) {
        return Short::assume_raw(integer_cast<typename Short::raw_type>(v[i].raw()));
      }));
    }
  }
  return f(widened<Normal>(v));
}

/// Holds every normal of a feature or a facet of differences with components of type T.
template <Number T, int N>
using LongestNormal = std::conditional_t<
    N == 2, Vec<decltype(-(T() - T())), 2>,
    std::remove_cvref_t<decltype(-(Vec<T, 3>() * squared_length(Vec<T, 3>() - Vec<T, 3>()) -
                                   (Vec<T, 3>() - Vec<T, 3>()) *
                                       dot(Vec<T, 3>() - Vec<T, 3>(), Vec<T, 3>())))>>;

/// Holds the sum of two radii and of a distance.
template <Scalar S>
using Depth = decltype(S() + S() + Length<S>());

/// The depth of shapes with these radii if the distance of their cores is the root of `squared`;
/// nothing if they do not touch. The radii are on the grid, so the distance may be rounded down
/// first.
template <Scalar S, Number Radii, Number Over, Number Under>
[[nodiscard]] constexpr std::optional<Depth<S>> depth_of_gap(
    const Radii& radii, const Fraction<Over, Under>& squared) noexcept {
  const auto gap = sqrt_floor<Length<S>>(squared);
  if (gap > radii || (gap == radii && !(squared <= square(gap)))) return std::nullopt;
  return Depth<S>(radii - gap);
}

/// height / sqrt(square_of()), rounded up, for a height >= 0. The exact quotient is within 2^-43 of
/// `quotient` (docs/filters.md, lemma 31); a step that it might reach is compared exactly.
template <Scalar S, Number Height, class Square>
[[nodiscard]] constexpr Length<S> depth_near(const Leading& quotient, const Height& height,
                                             const Square& square_of) noexcept {
  const auto floor = decide_floor<Length<S>>(Approximate{quotient, Relative{43}});
  if (floor.is_sure) return next_up(floor.value);
  if (height == 0) return Length<S>(0);
  const auto square_of_height = square(height);
  if (floor.value > 0) {
    const bool is_reached = square_of_height <= square(floor.value) * square_of();
    return is_reached ? floor.value : next_up(floor.value);
  }
  return sqrt_ceil<Length<S>>(Fraction{square_of_height, square_of()});
}

/// The depth of shapes with these radii whose cores must move by height / sqrt(squared_normal).
template <Scalar S, Number Radii, Number Height, Number Square>
[[nodiscard]] constexpr Depth<S> depth_of_height(const Radii& radii, const Height& height,
                                                 const Square& squared_normal) noexcept {
  if constexpr (is_fixed<S>) {
    const auto over = abs(height);
    return radii + depth_near<S>(over_root(Leading(over), Leading(squared_normal)), over,
                                 [&] { return squared_normal; });
  } else {
    return radii + sqrt_ceil<Length<S>>(Fraction{square(height), squared_normal});
  }
}
/// The same for a vector `normal`.
template <Scalar S, Number Radii, Number Height, Number T, int N>
[[nodiscard]] constexpr Depth<S> depth_of_height(const Radii& radii, const Height& height,
                                                 const Vec<T, N>& normal) noexcept {
  if constexpr (is_fixed<S>) {
    const auto over = abs(height);
    return radii + depth_near<S>(over_root(Leading(over), squared_leading(to_array(normal))), over,
                                 [&] { return squared_length(normal); });
  } else {
    return depth_of_height<S>(radii, height, squared_length(normal));
  }
}

/// A plane, which is only its surface, and a body with this radius. Ties go to the side of the
/// plane's normal.
template <Scalar S, int N, class Body, Number Radius>
[[nodiscard]] constexpr auto least_push_from_plane(const Plane<S, N>& plane, const Body& body,
                                                   const Radius& radius) noexcept {
  using Result = LeastPush<Direction<S, N>, Depth<S>>;
  const auto [lowest, highest] = heights_above(plane, body);
  const auto squared = squared_length(plane.normal);
  std::optional<Result> result;
  if (lowest > 0 || highest < 0) {
    if (is_fixed<S> && radius == 0) return result;
    const auto depth =
        depth_of_gap<S>(radius, Fraction{square(lowest > 0 ? lowest : highest), squared});
    if (depth) result = Result{lowest > 0 ? plane.normal : -plane.normal, *depth};
  } else if (-lowest <= highest) {
    result = Result{plane.normal, depth_of_height<S>(radius, lowest, squared)};
  } else {
    result = Result{-plane.normal, depth_of_height<S>(radius, highest, squared)};
  }
  return result;
}

/// A box, which is its slabs, and a segment with this radius, measured in the frame of the box.
template <Scalar S, int N, Number Radius>
[[nodiscard]] constexpr auto least_push_in_frame(const Obb<S, N>& box, const Segment<S, N>& segment,
                                                 const Radius& radius) noexcept {
  const auto center = in_frame(box, box.center - segment.start);
  const auto d = in_frame(box, segment.end - segment.start);
  const auto low = center - box.half_extents, high = center + box.half_extents;
  using T = std::remove_cvref_t<decltype(low.x)>;
  const auto perpendicular = [](const auto& g, const auto& speed) {
    return g * squared_length(speed) - speed * dot(g, speed);
  };
  using Local = std::remove_cvref_t<decltype(perpendicular(low, d))>;
  using Normal = std::remove_cvref_t<decltype(from_frame(box, Local()))>;
  using Result = LeastPushInFrame<Normal, Local, Depth<S>>;
  const auto result = [&](const Local& local, const Depth<S>& depth) {
    return std::optional(Result{from_frame(box, local), local, depth});
  };
  const auto squared = squared_distance_from_slabs(low, high, d);
  if (squared.numerator > 0) {
    const auto depth = depth_of_gap<S>(radius, squared);
    if (!depth) return std::optional<Result>();
    return nearest_of_slabs(low, high, d, [&](const auto& g, const auto&... speed) {
      const auto& start = narrow<bits_of<T>>(g);
      if constexpr (sizeof...(speed) == 0) {
        return result(widened<Local>(start), *depth);
      } else {
        return result(perpendicular(start, speed...), *depth);
      }
    });
  }
  const AabbBody slabs(low, high);
  const std::array ends{Vec<std::remove_cvref_t<decltype(d.x)>, N>(), d};
  const HullBody span(ends);
  using Difference = std::remove_cvref_t<decltype((low - d).x)>;
  using Slabs = std::remove_cvref_t<decltype(slabs)>;
  using Span = std::remove_cvref_t<decltype(span)>;
  const auto pushed_by = [&](const auto& push) {
    return result(widened<Local>(push.normal),
                  depth_of_height<S>(radius, push.height, push.normal));
  };
  const auto push = AxisPush<Difference, Slabs, Span>(slabs, span).least();
  if (push && push->height > 0) return pushed_by(*push);
  return pushed_by(Expansion<Difference, Slabs, Span>(slabs, span).least_push());
}

/// Two convex bodies, with the sum of their radii: f(normal, depth) of the least push, which returns
/// an optional; nothing if they do not touch. The normal is exact, at any length, and its type one of
/// three: that of an axis of two edges of a box, a short one and a long one. If it is known which
/// corners of each body are extreme along the normal, a `LevelCorners` follows. `filter` is that of
/// the shapes: see axis_filter.hpp.
template <Scalar S, class A, class B, Number Radii, class Filter, class F>
[[nodiscard]] constexpr auto least_push_between(const A& a, const B& b, const Radii& radii,
                                                const Filter& filter, const F& f) noexcept {
  constexpr int N = A::dimension;
  using Longest = std::remove_cvref_t<decltype((a.some() - b.some()).x)>;
  using Normal = LongestNormal<Longest, N>;
  using Result = std::remove_cvref_t<decltype(f(Normal(), Depth<S>()))>;
  const auto depth_of = [&](const auto& push) {
    return depth_of_height<S>(radii, push.height, push.normal);
  };
  const auto found = [&](const auto& v, const Depth<S>& depth, auto... known) {
    return with_normal<Normal>(v, [&](const auto& normal) { return f(normal, depth, known...); });
  };
  const auto low = a.low() - b.high(), high = a.high() - b.low();
  if (is_fixed<S> && radii == 0 && !holds_origin(low, high)) return Result();
  return with_differences(low, high, [&]<Number T>(const T&) {
    Result result;
    if constexpr (has_push_witness<S, A, B>) {
      using Witness = PushWitness<T, A, B>;
      Witness witness(a, b);
      const auto outcome = witness.find(low, high);
      if (outcome == Witness::Outcome::apart && radii == 0) return result;
      if (outcome == Witness::Outcome::found)
        return found(witness.push().normal, depth_of(witness.push()), witness.level());
    }
    if (const auto push = AxisPush<T, A, B>(a, b).least(filter)) {
      if (push->height > 0) {
        if constexpr (IsBoxBody<A> || IsBoxBody<B>) return f(push->normal, depth_of(*push));
        return found(push->normal, depth_of(*push));
      }
      if (push->height < 0 && radii == 0) return result;
    }
    Gjk<T, A, B> search(a, b);
    if (is_fixed<S> && radii == 0) {
      if (!search.touches()) return result;
    } else {
      const auto squared = search.squared_distance(squared_distance_of_none<T, N>());
      if (squared.numerator > 0) {
        const auto depth = depth_of_gap<S>(radii, squared);
        if (!depth) return result;
        with_direction(search.closest_feature(), [&](const auto& v) {
          result = found(-v, *depth);
          return true;
        });
        return result;
      }
    }
    // With numbers that round, that feature may be nearly flat.
    const auto start = is_fixed<S> ? search.feature() : Simplex<T, N>();
    const auto push = Expansion<T, A, B>(a, b, start).least_push();
    return found(push.normal, depth_of(push));
  });
}

}  // namespace detent::detail
