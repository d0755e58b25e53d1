// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "detent/math/vec.hpp"
#include "detent/shape/fields.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// The points within `radius` of the segment from `a` to `b`; a stadium in 2D.
///
/// Equal ends make it a sphere, a radius of 0 a segment; a negative radius makes it empty.
template <Scalar S, int N>
struct Capsule {
  Vec<S, N> a;
  Vec<S, N> b;
  S radius{};

  [[nodiscard]] friend constexpr bool operator==(const Capsule&, const Capsule&) noexcept = default;
};

template <Scalar S, int N>
struct detail::ShapeFields<Capsule<S, N>> {
  static constexpr std::string_view name = "capsule", names[] = {"a", "b", "radius"};

  template <class Self, class F>
  static constexpr auto of(Self& capsule, const F& f) {
    return f(capsule.a, capsule.b, capsule.radius);
  }
  static constexpr Segment<S, N> core(const Capsule<S, N>& capsule) noexcept {
    return {capsule.a, capsule.b};
  }
};

template <Scalar S, int N>
Capsule(Vec<S, N>, Vec<S, N>, S) -> Capsule<S, N>;

}  // namespace detent
