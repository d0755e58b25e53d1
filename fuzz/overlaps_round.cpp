// SPDX-License-Identifier: MIT
//
// Spheres and other round shapes against every shape, in both orders: overlaps is exact.

#include "decode.hpp"
#include "detent/query/overlaps.hpp"
#include "oracle/describe.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class Round, class Shape, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto shape = decoder.template shape<Shape>();
  const auto round = decoder.template shape<Round>();
  const bool expected = oracle::meet(round, shape);
  require(overlaps(round, shape) == expected && overlaps(shape, round) == expected,
          [&] { return oracle::describe(round) + "; " + oracle::describe(shape); });
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    using Shapes = support::SceneShapes<S, N>;
    with_one_of(support::RoundShapes<S, N>(), source, [&]<class Round>(std::type_identity<Round>) {
      with_one_of(Shapes(), source, [&]<class Shape>(std::type_identity<Shape>) {
        Decoder<S, N> decoder(source);
        check<Round, Shape>(decoder);
      });
    });
  });
}

}  // namespace detent::fuzz
