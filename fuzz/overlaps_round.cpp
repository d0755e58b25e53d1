// SPDX-License-Identifier: MIT
//
// Spheres and other round shapes against every shape, in both orders: overlaps is exact.

#include "pairs.hpp"

namespace detent::fuzz {

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    using Shapes = support::SceneShapes<S, N>;
    with_one_of(support::RoundShapes<S, N>(), source, [&]<class Round>(std::type_identity<Round>) {
      with_one_of(Shapes(), source, [&]<class Shape>(std::type_identity<Shape>) {
        Decoder<S, N> decoder(source);
        check_overlap<Shape, Round>(decoder);
      });
    });
  });
}

}  // namespace detent::fuzz
