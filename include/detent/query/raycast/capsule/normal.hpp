// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/filter/leading.hpp"
#include "detent/query/raycast/capsule/cylinder.hpp"

namespace detent::detail {

/// Component i of the normal of the side; `back` is that of (d x e) x e.
template <Scalar S, int N, Number L, Number R, Number Back>
[[nodiscard]] constexpr auto exact_normal(const RayCylinder<S, N, L, R>& ray, int i,
                                          const Back& back) noexcept {
  constexpr int bits = bits_of<R> + bits_of<decltype(ray.a * ray.ee)>;  // |m . k| <= r sqrt(a)
  const auto root = leading_root(ray.reach() * ray.ee);
  const auto length = scale_up<bits + 63>(ray.a * ray.ee * ray.radius, root.scale);
  const auto closest = narrow<bits>(ray.det * ray.ee * ray.k[i]);
  return quotient_nearest<direction_component<S>>(
      narrow_difference<bits + 64>(scale_up<bits + 63>(closest, root.scale), root.root * back),
      length);
}

/// The unit vector from the axis to the point where the line enters through the side, for a
/// radius > 0. Leading bits decide its components if they settle the rounding.
///
/// The line is closest to the axis at the offset (m . k) k / a from it, where k = d x e. The entry
/// is farther back along e x k = e^2 d - (d . e) e, by the rest of the radius. The sum, divided by
/// r, is ((m . k) e^2 k - sqrt(b^2 - a c) e x k) / (r a e^2).
template <Scalar S, Number L, Number R>
[[nodiscard]] constexpr Direction<S, 3> side_normal(const RayCylinder<S, 3, L, R>& ray) noexcept {
  const auto back = make_vec<3>([&](int i) { return ray.ee * ray.d[i] - ray.de * ray.e[i]; });
  const auto exact = [&](int i) { return exact_normal(ray, i, back[i]); };
  if constexpr (!is_fixed<S>) {
    return Direction<S, 3>::assume_unit(make_vec<3>(exact));
  } else {
    const auto area = Leading(ray.a) * Leading(ray.radius), across = Leading(ray.ee);
    const auto beside = Leading(abs(ray.det)) / area;
    const auto behind = sqrt(Leading(ray.reach()) * across) / (area * across);
    return Direction<S, 3>::assume_unit(make_vec<3>([&](int i) {
      const auto nearest = decide_nearest_difference<direction_component<S>>(
          beside, ray.det < 0 ? narrow_negative(ray.k[i]) : ray.k[i], behind, back[i]);
      return or_exact(nearest, [&] { return exact(i); });
    }));
  }
}

/// In 2D, the normal of the axis on the ray's side.
template <Scalar S, Number L, Number R>
[[nodiscard]] constexpr Direction<S, 2> side_normal(const RayCylinder<S, 2, L, R>& ray) noexcept {
  const auto across = Vec{narrow_negative(ray.e.y), ray.e.x};
  const auto normal = *direction_of<S>(across);
  return dot(across, ray.d) > 0 ? -normal : normal;
}

}  // namespace detent::detail
