// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/query/kernel/simplex.hpp"

namespace detent::detail {

/// Holds every direction that `with_direction` computes from differences of type T, on one grid.
template <Number T, int N>
struct Directions {
  using type = std::remove_cvref_t<decltype(facet_normal(Simplex<T, N>()).x)>;
};
template <Number T>
struct Directions<T, 3> {
  using Edge = decltype(Vec<T, 3>() - Vec<T, 3>());
  using type = std::remove_cvref_t<
      decltype((Vec<T, 3>() * squared_length(Edge()) - Edge() * dot(Edge(), Vec<T, 3>())).x)>;
};

/// v, scaled by a power of two to the grid of T.
template <Number T, Number V, int N>
[[nodiscard]] constexpr Vec<T, N> on_grid_of(const Vec<V, N>& v) noexcept {
  return make_vec<N>([&](int i) {
    if constexpr (!is_fixed<T>) {
      return v[i];
    } else {
      return T::assume_raw(integer_cast<typename T::raw_type>(v[i].raw()));
    }
  });
}

}  // namespace detent::detail
