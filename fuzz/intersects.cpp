// SPDX-License-Identifier: MIT
//
// Segments against every shape: intersects is exact.

#include "detent/query/intersects.hpp"
#include "decode.hpp"
#include "oracle/describe.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class Shape, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto shape = decoder.template shape<Shape>();
  const auto segment = decoder.template shape<Segment<S, N>>();
  const Segment<S, N> reversed{segment.end, segment.start};
  const bool expected = oracle::meet(segment, shape);
  require(intersects(segment, shape) == expected && intersects(reversed, shape) == expected,
          [&] { return oracle::describe(segment) + "; " + oracle::describe(shape); });
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_shape<S, N, Segment<S, N>>(source, [&]<class Shape>(std::type_identity<Shape>) {
      Decoder<S, N> decoder(source);
      check<Shape>(decoder);
    });
  });
}

}  // namespace detent::fuzz
