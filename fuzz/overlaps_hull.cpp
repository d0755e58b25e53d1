// SPDX-License-Identifier: MIT
//
// Convex hulls against every shape and segments, in both orders: overlaps and intersects are exact.

#include "decode.hpp"
#include "pairs.hpp"

namespace detent::fuzz {

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_shape<S, N, Segment<S, N>, ConvexHull<S, N>>(
        source, [&]<class Shape>(std::type_identity<Shape>) {
          Decoder<S, N> decoder(source);
          check_overlap<Shape, ConvexHull<S, N>>(decoder);
        });
  });
}

}  // namespace detent::fuzz
