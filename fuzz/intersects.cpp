// SPDX-License-Identifier: MIT
//
// Segments against every shape: intersects is exact.

#include "detent/query/intersects.hpp"
#include "decode.hpp"
#include "oracle/describe.hpp"
#include "oracle/linear.hpp"
#include "oracle/near_segment.hpp"
#include "oracle/segment_box.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <Scalar S, int N>
bool meet(const Segment<S, N>& segment, const Sphere<S, N>& sphere) {
  return sphere.radius >= 0 &&
         oracle::near_point(segment, sphere.center, oracle::raw(sphere.radius));
}
template <Scalar S, int N>
bool meet(const Segment<S, N>& segment, const Aabb<S, N>& box) {
  return oracle::meets(segment, box);
}
template <Scalar S, int N>
bool meet(const Segment<S, N>& segment, const Obb<S, N>& box) {
  return oracle::meets(segment, box);
}
template <Scalar S, int N>
bool meet(const Segment<S, N>& segment, const Plane<S, N>& plane) {
  return oracle::meet(plane, oracle::hull_of(segment));
}
template <Scalar S, int N>
bool meet(const Segment<S, N>& segment, const Triangle<S, N>& triangle) {
  return oracle::meet(oracle::hull_of(segment), oracle::hull_of(triangle));
}
template <Scalar S, int N>
bool meet(const Segment<S, N>& segment, const Capsule<S, N>& capsule) {
  return capsule.radius >= 0 &&
         oracle::near_segment(Segment{capsule.a, capsule.b}, segment, oracle::raw(capsule.radius));
}
template <Scalar S, int N>
bool meet(const Segment<S, N>& a, const Segment<S, N>& b) {
  return oracle::meet(oracle::hull_of(a), oracle::hull_of(b));
}

template <class Shape, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto shape = decoder.template shape<Shape>();
  const auto segment = decoder.template shape<Segment<S, N>>();
  const Segment<S, N> reversed{segment.end, segment.start};
  const bool expected = meet(segment, shape);
  require(intersects(segment, shape) == expected && intersects(reversed, shape) == expected,
          [&] { return oracle::describe(segment) + "; " + oracle::describe(shape); });
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_of<Sphere<S, N>, Aabb<S, N>, Obb<S, N>, Plane<S, N>, Triangle<S, N>, Capsule<S, N>,
                Segment<S, N>>(source, [&]<class Shape>(std::type_identity<Shape>) {
      Decoder<S, N> decoder(source);
      check<Shape>(decoder);
    });
  });
}

}  // namespace detent::fuzz
