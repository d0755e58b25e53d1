// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/shape/plane.hpp"

namespace detent {

/// The point that three planes share, or nothing if their normals are coplanar, in which case they
/// share no point, a line or a plane.
///
/// units:  world units
/// domain: every input; coordinates are clamped to the scalar's range
/// exact:  each coordinate is the exact one rounded to nearest, ties to even
///         (tests/oracle/intersection.test.cpp)
/// source: Cramer's rule, Ericson, Real-Time Collision Detection, 5.4.5
template <Scalar S>
[[nodiscard]] constexpr std::optional<Vec<S, 3>> intersection(const Plane<S, 3>& a,
                                                              const Plane<S, 3>& b,
                                                              const Plane<S, 3>& c) noexcept {
  const auto product = [](const Direction<S, 3>& u, const Direction<S, 3>& v) {
    return narrow_cross<detail::cosine_bits<S>>(u.vec(), v.vec());
  };
  const auto bc = product(b.normal, c.normal);
  const auto ca = product(c.normal, a.normal);
  const auto ab = product(a.normal, b.normal);
  const auto volume = dot(bc, a.normal);
  if (volume == 0) return std::nullopt;
  return make_vec<3>([&](int i) {
    return quotient_nearest<S>(a.offset * bc[i] + b.offset * ca[i] + c.offset * ab[i], volume);
  });
}

/// The point where two lines cross, or nothing if they are parallel.
///
/// units:  world units
/// domain: every input; coordinates are clamped to the scalar's range
/// exact:  each coordinate is the exact one rounded to nearest, ties to even
///         (tests/oracle/intersection.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr std::optional<Vec<S, 2>> intersection(const Plane<S, 2>& a,
                                                              const Plane<S, 2>& b) noexcept {
  const auto area = narrow_cross<detail::cosine_bits<S>>(a.normal.vec(), b.normal.vec());
  if (area == 0) return std::nullopt;
  return Vec<S, 2>{quotient_nearest<S>(a.offset * b.normal[1] - b.offset * a.normal[1], area),
                   quotient_nearest<S>(b.offset * a.normal[0] - a.offset * b.normal[0], area)};
}

}  // namespace detent
