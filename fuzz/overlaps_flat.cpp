// SPDX-License-Identifier: MIT
//
// Boxes, planes and triangles against one another, in both orders: overlaps is exact.

#include <type_traits>

#include "decode.hpp"
#include "detent/query/overlaps.hpp"
#include "oracle/describe.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class A, class B, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto a = decoder.template shape<A>();
  const auto b = decoder.template shape<B>();
  const bool expected = oracle::meet(a, b);
  require(overlaps(a, b) == expected && overlaps(b, a) == expected,
          [&] { return oracle::describe(a) + "; " + oracle::describe(b); });
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    const auto pair = source.below(10);
    Decoder<S, N> decoder(source);
    switch (pair) {
      case 0:
        return check<Aabb<S, N>, Aabb<S, N>>(decoder);
      case 1:
        return check<Aabb<S, N>, Obb<S, N>>(decoder);
      case 2:
        return check<Plane<S, N>, Aabb<S, N>>(decoder);
      case 3:
        return check<Aabb<S, N>, Triangle<S, N>>(decoder);
      case 4:
        return check<Obb<S, N>, Obb<S, N>>(decoder);
      case 5:
        return check<Plane<S, N>, Obb<S, N>>(decoder);
      case 6:
        return check<Obb<S, N>, Triangle<S, N>>(decoder);
      case 7:
        return check<Plane<S, N>, Plane<S, N>>(decoder);
      case 8:
        return check<Plane<S, N>, Triangle<S, N>>(decoder);
      default:
        return check<Triangle<S, N>, Triangle<S, N>>(decoder);
    }
  });
}

}  // namespace detent::fuzz
