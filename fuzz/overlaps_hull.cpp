// SPDX-License-Identifier: MIT
//
// Convex hulls against every shape and segments, in both orders: overlaps and intersects are exact.

#include "decode.hpp"
#include "detent/query/intersects/hull.hpp"
#include "detent/query/overlaps/aabb_hull.hpp"
#include "detent/query/overlaps/capsule_hull.hpp"
#include "detent/query/overlaps/hull_hull.hpp"
#include "detent/query/overlaps/obb_hull.hpp"
#include "detent/query/overlaps/plane_hull.hpp"
#include "detent/query/overlaps/sphere_hull.hpp"
#include "detent/query/overlaps/triangle_hull.hpp"
#include "oracle/hull.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class Shape, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto shape = decoder.template shape<Shape>();
  const auto hull = decoder.template shape<ConvexHull<S, N>>();
  const bool truth = oracle::meet(shape, hull);
  const auto because = [&] { return oracle::describe(shape) + "; " + oracle::describe(hull); };
  if constexpr (requires { overlaps(shape, hull); }) {
    require(overlaps(shape, hull) == truth && overlaps(hull, shape) == truth, because);
  } else {
    require(intersects(shape, hull) == truth, because);
  }
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_shape<S, N, Segment<S, N>, ConvexHull<S, N>>(
        source, [&]<class Shape>(std::type_identity<Shape>) {
          Decoder<S, N> decoder(source);
          check<Shape>(decoder);
        });
  });
}

}  // namespace detent::fuzz
