// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/fraction.hpp"
#include "detent/query/contains/sphere.hpp"

namespace detent {

/// The point of `sphere` that is closest to `point`, which is `point` itself inside.
///
/// units:  world units
/// domain: every input; an empty sphere has no point and gives `point`
/// exact:  each coordinate is the exact one, c + r (p - c) / |p - c|, rounded to nearest, ties to
///         even                                               (tests/oracle/point_sphere.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Sphere<S, N>& sphere,
                                                const Vec<S, N>& point) noexcept {
  const auto& [center, radius] = sphere;
  if (radius < 0 || contains(sphere, point)) return point;
  const auto from_center = point - center;
  const auto squared = squared_length(from_center);
  Vec<S, N> closest;
  for (int i = 0; i < N; ++i) {
    // A radius is below 2^bits and a difference below 2^(bits + 1), so their product, squared, fits
    // twice that.
    constexpr int bits = bits_of<S> + bits_of<decltype(S() - S())>;
    const auto product = narrow_product<bits>(radius, from_center[i]);
    const auto step = sqrt_odd<finer<S, 2>>(Fraction{product * product, squared});
    closest[i] = nearest_to<S>(from_center[i] < 0 ? center[i] - step : center[i] + step);
  }
  return closest;
}

}  // namespace detent
