// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/filter/components.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

/// The point of `sphere` closest to `point`; `point` itself if inside.
///
/// units:  world units
/// domain: every input; an empty sphere gives `point`
/// exact:  each coordinate is the exact one, c + r (p - c) / |p - c|, rounded to nearest, ties to
///         even                                               (tests/oracle/point_sphere.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Sphere<S, N>& sphere,
                                                const Vec<S, N>& point) noexcept {
  const auto center = sphere.center;
  const auto radius = sphere.radius;
  const auto from_center = point - center;
  const auto squared = squared_length(from_center);
  if (radius < 0 || squared <= square(radius)) return point;
  if constexpr (!is_fixed<S>) {
    return make_vec<N>([&](int i) {
      const auto product = radius * from_center[i];
      const S step = sqrt_floor<S>(product * product / squared);
      return from_center[i] < 0 ? center[i] - step : center[i] + step;
    });
  } else {
    const auto steps = step_along(radius, to_array(from_center));
    return make_vec<N>([&](int i) {
      // Between center and point, except for the error of a step, which may move it past the lowest
      // or the greatest number.
      const auto sum = narrow_sum<bits_of<finer<S, 30>> + 1>(
          center[i], steps.value[static_cast<std::size_t>(i)]);
      const auto nearest = decide_nearest<S>(Approximate{sum, steps.error});
      // The sign of radius d / |d| - (x - center). If both terms have the same sign, the difference
      // of their squares has the sign.
      return or_exact(nearest, [&](const S& upper) {
        const auto middle = midpoint_below(upper);
        return nearest_at_midpoint(
            upper,
            detail::compare_with_quotient(radius * from_center[i], squared, middle - center[i]));
      });
    });
  }
}

}  // namespace detent
