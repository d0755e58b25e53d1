// SPDX-License-Identifier: MIT
//
// Points and rays against convex hulls: contains, on, distance, closest_point and the raycasts give
// the exact result, rounded as their docstrings say.

#include "detent/query/closest_point/hull.hpp"
#include "decode.hpp"
#include "detent/query/contains/hull.hpp"
#include "detent/query/distance/hull.hpp"
#include "detent/query/on.hpp"
#include "detent/query/raycast/hull.hpp"
#include "point_truth.hpp"
#include "ray_truth.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto hull = decoder.template shape<ConvexHull<S, N>>();
  check_point(hull, decoder.point(), decoder.reach());
  check_ray(decoder.template shape<Ray<S, N>>(), hull, hull);
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    Decoder<S, N> decoder(source);
    check(decoder);
  });
}

}  // namespace detent::fuzz
