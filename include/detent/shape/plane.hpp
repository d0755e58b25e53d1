// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "detent/math/direction.hpp"
#include "detent/shape/fields.hpp"

namespace detent {

/// The points x with dot(normal, x) = offset; a line in 2D. It has two sides.
template <Scalar S, int N>
struct Plane {
  Direction<S, N> normal;
  S offset{};

  [[nodiscard]] friend constexpr bool operator==(const Plane&, const Plane&) noexcept = default;
};

template <Scalar S, int N>
struct detail::ShapeFields<Plane<S, N>> {
  static constexpr std::string_view name = "plane", names[] = {"normal", "offset"};

  template <class Self, class F>
  static constexpr auto of(Self& plane, const F& f) {
    return f(plane.normal, plane.offset);
  }
};

template <Scalar S, int N>
Plane(Direction<S, N>, S) -> Plane<S, N>;

}  // namespace detent
