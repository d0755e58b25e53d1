// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "detent/math/vec.hpp"
#include "detent/shape/fields.hpp"

namespace detent {

/// The points within `radius` of `center`; a disc in 2D.
///
/// A radius of 0 makes it a point; a negative radius makes it empty.
template <Scalar S, int N>
struct Sphere {
  Vec<S, N> center;
  S radius{};

  [[nodiscard]] friend constexpr bool operator==(const Sphere&, const Sphere&) noexcept = default;
};

template <Scalar S, int N>
struct detail::ShapeFields<Sphere<S, N>> {
  static constexpr std::string_view name = "sphere", names[] = {"center", "radius"};

  template <class Self, class F>
  static constexpr auto of(Self& sphere, const F& f) {
    return f(sphere.center, sphere.radius);
  }
  static constexpr const Vec<S, N>& core(const Sphere<S, N>& sphere) noexcept {
    return sphere.center;
  }
};

template <Scalar S, int N>
Sphere(Vec<S, N>, S) -> Sphere<S, N>;

}  // namespace detent
