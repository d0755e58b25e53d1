// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/direction.hpp"
#include "detent/number/filter/ratio.hpp"

namespace detent::detail {

/// origin + direction * ratio, each coordinate the exact one rounded to nearest, ties to even, and
/// clamped to the range of the scalar. |direction * ratio| must be the distance between two points.
template <Scalar S, Number T, int N, class R>
[[nodiscard]] constexpr Vec<S, N> point_on_line(const Vec<S, N>& origin, const Vec<T, N>& direction,
                                                const R& ratio) noexcept {
  return make_vec<N>([&](int i) { return add_product(origin[i], direction[i], ratio); });
}

}  // namespace detent::detail
