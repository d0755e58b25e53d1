// SPDX-License-Identifier: MIT
//
// Points and every shape: contains, on, distance and closest_point give the exact result, rounded
// as their docstrings say.

#include "decode.hpp"
#include "detent/query/closest_point.hpp"
#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"
#include "point_truth.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class Shape, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto shape = decoder.template shape<Shape>();
  const auto point = decoder.point();
  check_point(shape, point, decoder.reach());
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_shape<S, N, Segment<S, N>, Ray<S, N>>(source,
                                                   [&]<class Shape>(std::type_identity<Shape>) {
                                                     Decoder<S, N> decoder(source);
                                                     check<Shape>(decoder);
                                                   });
  });
}

}  // namespace detent::fuzz
