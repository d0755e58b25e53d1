// SPDX-License-Identifier: MIT
//
// Every raycast gives the exact answer, rounded as its docstring says.

#include "decode.hpp"
#include "oracle/ask.hpp"
#include "oracle/describe.hpp"
#include "oracle/ray_box.hpp"
#include "oracle/ray_capsule.hpp"
#include "oracle/ray_plane.hpp"
#include "oracle/ray_sphere.hpp"
#include "oracle/ray_triangle.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class Shape, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto shape = decoder.template shape<Shape>();
  const auto ray = decoder.template shape<Ray<S, N>>();
  const auto found = mistakes(oracle::expected_raycast(ray, shape), oracle::ask(ray, shape));
  require(found.empty(),
          [&] { return oracle::describe(ray) + "; " + oracle::describe(shape) + "\n" + found; });
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    const auto shape = source.below(6);
    Decoder<S, N> decoder(source);
    switch (shape) {
      case 0:
        return check<Sphere<S, N>>(decoder);
      case 1:
        return check<Aabb<S, N>>(decoder);
      case 2:
        return check<Obb<S, N>>(decoder);
      case 3:
        return check<Plane<S, N>>(decoder);
      default:
        return check<Triangle<S, N>>(decoder);
    }
  });
}

}  // namespace detent::fuzz
