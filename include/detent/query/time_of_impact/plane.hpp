// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/number/filter/unit_length.hpp"
#include "detent/query/time_of_impact/search.hpp"
#include "detent/shape/plane.hpp"

// A plane as the second body of an impact search: it does not move, and its normal is always the
// axis.

namespace detent::detail {

template <Scalar S, int N>
class StillPlane {
 public:
  static constexpr int dimension = N;

  explicit constexpr StillPlane(const Plane<S, N>& plane) noexcept : plane_(plane) {}

  [[nodiscard]] constexpr const Plane<S, N>& at(const direction_component<S>&) const noexcept {
    return plane_;
  }
  [[nodiscard]] constexpr S error() const noexcept { return S(0); }
  [[nodiscard]] constexpr S bend() const noexcept { return S(0); }
  [[nodiscard]] constexpr S straying(const direction_component<S>&) const noexcept { return S(0); }

 private:
  Plane<S, N> plane_;
};

/// How far a body is beyond `plane` along `axis`, its normal or the opposite.
template <class A, Scalar S, int N>
[[nodiscard]] constexpr auto gap_along(const Direction<S, N>& axis, const A& a,
                                       const Plane<S, N>& plane) noexcept {
  const auto least = dot(axis, a.extreme(axis, a.some(), false));
  const bool is_normal = axis == plane.normal;
  return is_normal ? least - plane.offset : least - -plane.offset;
}

/// gap / |n|, rounded down.
template <class T, Number Gap, Number Squared>
[[nodiscard]] constexpr T along_normal(const Gap& gap, const Squared& squared_norm) noexcept {
  if constexpr (bits_of < Gap >> 63) {
    return divide_by_length<T>(gap, squared_norm);
  } else {
    return sqrt_floor<T>(Fraction{square(gap), squared_norm});
  }
}

template <Scalar S, class A, int N>
[[nodiscard]] constexpr auto separation_of(const A& a, const Plane<S, N>& plane) noexcept {
  using P = Posed<S>;
  using Between = decltype((P() + P()) + (P() + P()));
  const auto squared_norm = squared_length(plane.normal);
  for (const auto& axis : {plane.normal, -plane.normal}) {
    const auto gap = gap_along(axis, a, plane);
    if (gap > 0) {
      return GapBetween<S, N, Between>{along_normal<Between>(gap, squared_norm), axis};
    }
  }
  return GapBetween<S, N, Between>{Between(0), std::nullopt};
}

}  // namespace detent::detail
