// SPDX-License-Identifier: MIT
//
// Boxes, planes and triangles against one another, in both orders: overlaps is exact.

#include "pairs.hpp"

namespace detent::fuzz {

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    const auto pair = source.below(10);
    Decoder<S, N> decoder(source);
    switch (pair) {
      case 0:
        return check_overlap<Aabb<S, N>, Aabb<S, N>>(decoder);
      case 1:
        return check_overlap<Aabb<S, N>, Obb<S, N>>(decoder);
      case 2:
        return check_overlap<Plane<S, N>, Aabb<S, N>>(decoder);
      case 3:
        return check_overlap<Aabb<S, N>, Triangle<S, N>>(decoder);
      case 4:
        return check_overlap<Obb<S, N>, Obb<S, N>>(decoder);
      case 5:
        return check_overlap<Plane<S, N>, Obb<S, N>>(decoder);
      case 6:
        return check_overlap<Obb<S, N>, Triangle<S, N>>(decoder);
      case 7:
        return check_overlap<Plane<S, N>, Plane<S, N>>(decoder);
      case 8:
        return check_overlap<Plane<S, N>, Triangle<S, N>>(decoder);
      default:
        return check_overlap<Triangle<S, N>, Triangle<S, N>>(decoder);
    }
  });
}

}  // namespace detent::fuzz
