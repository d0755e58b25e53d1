// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/shape/frustum.hpp"
#include "oracle/hull.hpp"

/// Random frusta.
namespace detent::oracle {

/// Eight points of a setting in any order, often coplanar or equal, or the frustum of a camera.
template <Scalar S>
Frustum<S> draw_frustum(Artist<S, 3>& artist) {
  auto& random = artist.random;
  const auto corners = artist.template corners<8>();
  if (!artist.is(Kind::general) && random.coin()) return Frustum<S>{corners};
  using D = Draw<S, 3>;
  const auto size = std::max<std::int64_t>(artist.size, 4);
  const auto far = D::scalar(random.between(2, 2 * size));
  const auto near = D::scalar(random.between(1, std::max<std::int64_t>(far.raw() / 2, 1)));
  const auto lens =
      random.one_in(4)
          ? Lens<S>::orthographic(D::scalar(random.between(1, size)),
                                  D::scalar(random.between(1, size)), near, far)
          : Lens<S>::perspective(Angle<S>::turn(static_cast<int>(random.between(2, 11)), 24), S(1),
                                 near, far);
  if (!lens) return Frustum<S>{corners};
  // The eye stands back, so that the middle of the frustum is at the artist's point.
  const auto rotation = artist.rotation();
  const auto eye = nearest_to<S>(D::vec(artist.point()) + half(far) * rotation.axis(2).vec());
  return Frustum{Camera<S>{Transform<S, 3>{eye, rotation, S(1)}, *lens}};
}

}  // namespace detent::oracle
