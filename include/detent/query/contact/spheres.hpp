// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/math/direction.hpp"
#include "detent/query/contact/contact.hpp"
#include "detent/query/kernel/least_push.hpp"
#include "detent/query/kernel/length.hpp"

namespace detent::detail {

/// The contact of two spheres with different centers: the same as that of the general search, in
/// closed form. It has one point, on the line of both centers.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Contact<S, N>> contact_of_spheres(
    const Vec<S, N>& a, const Vec<S, N>& b, const S& radius_a, const S& radius_b) noexcept {
  const auto apart = b - a;
  const auto squared = squared_length(apart);
  const auto radii = radius_a + radius_b;
  if (squared > square(radii)) return std::nullopt;
  Contact<S, N> contact;
  contact.normal = direction_of<S>(apart).value_or(Direction<S, N>());
  contact.depth = floor_to<S>(Depth<S>(radii - sqrt_floor<Length<S>>(squared)));
  contact.count = 1;
  contact.points[0] = {
      make_vec<N>([&](int i) { return nearest_to<S>(a[i] + contact.normal[i] * radius_a); }),
      contact.depth, 0};
  return contact;
}

}  // namespace detent::detail
