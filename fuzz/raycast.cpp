// SPDX-License-Identifier: MIT
//
// Every raycast gives the exact result, rounded as its docstring says.

#include "decode.hpp"
#include "ray_truth.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class Shape, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto shape = decoder.template shape<Shape>();
  const auto ray = decoder.template shape<Ray<S, N>>();
  check_ray(ray, shape, shape);
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_shape<S, N>(source, [&]<class Shape>(std::type_identity<Shape>) {
      Decoder<S, N> decoder(source);
      check<Shape>(decoder);
    });
  });
}

}  // namespace detent::fuzz
