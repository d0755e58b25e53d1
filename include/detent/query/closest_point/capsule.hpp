// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>

#include "detent/number/filter/ratio.hpp"
#include "detent/query/closest_point/sphere.hpp"
#include "detent/query/kernel/point_capsule.hpp"

namespace detent {

namespace detail {

/// One coordinate of a capsule's closest point if the query point projects between the ends: the
/// axis point, over / whole, plus `radius` along `outward`, with |outward|^2 = whole * square.
template <Scalar S, Number Over, Number Whole, Number Outward, Number Square>
struct CapsuleSide {
  Over over;
  Whole whole;
  Outward outward;
  S radius;
  Square square;

  /// The sign of the exact coordinate minus x, which is radius outward / |outward| - d / whole with
  /// d = x whole - over. It compares the squares of both terms times whole:
  /// (radius outward)^2 / square and d^2 / whole.
  template <Number T>
  [[nodiscard]] constexpr int sign_of_difference(const T& x) const noexcept {
    const auto short_of = x * whole - over;
    // On the grid of x, or wider if x's bits cannot hold a radius of 14 or 30 bits.
    using Radius = std::conditional_t<std::convertible_to<S, T>, T, decltype(x + radius)>;
    const auto step = Radius(radius) * outward;
    const int step_sign = (step > 0) - (step < 0);
    const int short_sign = (short_of > 0) - (short_of < 0);
    if (step_sign != short_sign) return step_sign > short_sign ? 1 : -1;
    const Fraction left{step * step, square};
    const Fraction right{short_of * short_of, whole};
    return step_sign * ((right < left) - (left < right));
  }
};

template <Scalar S, Number Over, Number Whole, Number Outward, Number Square>
CapsuleSide(Over, Whole, Outward, S, Square) -> CapsuleSide<S, Over, Whole, Outward, Square>;

/// The point of `capsule` closest to `point`, where the closest point of the axis is at
/// along / whole between the ends.
template <Scalar S, int N, Number T, Number Along, Number Whole>
[[nodiscard]] constexpr Vec<S, N> closest_beside(const Capsule<S, N>& capsule,
                                                 const Vec<S, N>& point, const Vec<T, N>& axis,
                                                 const Along& along, const Whole& whole) noexcept {
  const auto a = capsule.a;
  const auto radius = capsule.radius;
  const auto from_a = point - a;
  // Projected along a coordinate axis, the triangle of `point` and two points of the capsule's axis
  // covers at most half of the world's square, so no component exceeds the square of an offset.
  constexpr int area_bits = 4 * bits_of<T> + (N == 3 ? 2 : 0);
  const auto side = [&](int i) {
    return CapsuleSide{a[i] * whole + axis[i] * along, whole, from_a[i] * whole - axis[i] * along,
                       radius, narrow_square<area_bits>(cross(from_a, axis))};
  };
  if constexpr (!is_fixed<S>) {
    if (holds(capsule, point)) return point;
    const auto outward = make_vec<N>([&](int i) { return side(i).outward; });
    // With scalars that round, a point off the axis may appear to be on it.
    const auto unit = unit_vector<S>(to_array(outward)).value_or(to_array(Vec<S, N>()));
    return make_vec<N>(
        [&](int i) { return side(i).over / whole + radius * unit[static_cast<std::size_t>(i)]; });
  } else {
    // Errors: docs/filters.md, lemma 10.
    const auto ratio = make_ratio_below_one(along, whole);
    const auto to_axis =
        make_vec<N>([&](int i) { return approximate_product(axis[i], ratio).value; });
    const auto outward =
        make_vec<N>([&](int i) { return narrow_difference<63>(from_a[i], to_axis[i]); });
    constexpr auto squared_error = Fixed<14, 2 * S::frac>::from_raw(1 << 13);
    const Approximate excess{
        narrow_difference<126>(narrow_dot<126>(outward, outward), square(radius)), squared_error};
    if (!or_exact(decide(excess), [&] { return !holds(capsule, point); })) return point;
    const auto steps = step_along(radius, to_array(outward));
    constexpr Steps<1 << 18> error;
    return make_vec<N>([&](int i) {
      const auto sum = narrow_sum<62>(narrow_sum<62>(a[i], to_axis[i]),
                                      steps.value[static_cast<std::size_t>(i)]);
      const auto nearest = decide_nearest<S>(Approximate{sum, error});
      return or_exact(nearest, [&](const S& upper) {
        return nearest_at_midpoint(upper, side(i).sign_of_difference(midpoint_below(upper)));
      });
    });
  }
}

}  // namespace detail

/// The point of `capsule` closest to `point`; `point` itself if inside.
///
/// units:  world units
/// domain: every input; an empty capsule gives `point`
/// exact:  each coordinate is the exact one rounded to nearest, ties to even
///         (tests/oracle/point_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Capsule<S, N>& capsule,
                                                const Vec<S, N>& point) noexcept {
  const auto& [a, b, radius] = capsule;
  if (radius < 0) return point;
  const auto axis = b - a;
  const auto from_a = point - a;
  const auto along = dot(from_a, axis);
  const auto whole = squared_length(axis);
  if (along <= 0) return closest_point(Sphere{a, radius}, point);
  if (along >= whole) return closest_point(Sphere{b, radius}, point);
  return detail::closest_beside(capsule, point, axis, along, whole);
}

}  // namespace detent
