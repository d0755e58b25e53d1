// SPDX-License-Identifier: MIT
//
// Boxes, planes and triangles against one another, in both orders: overlaps is exact.

#include <type_traits>

#include "decode.hpp"
#include "detent/query/overlaps.hpp"
#include "oracle/describe.hpp"
#include "oracle/linear.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <Scalar S, int N, class Shape>
bool meet(const Plane<S, N>& plane, const Shape& shape) {
  return oracle::meet(plane, oracle::hull_of(shape));
}
/// Planes are disjoint when the normals are parallel, n = k m, and the offsets are not in that
/// ratio.
template <Scalar S, int N>
bool meet(const Plane<S, N>& a, const Plane<S, N>& b) {
  const auto n = oracle::widen(oracle::raw(a.normal)), m = oracle::widen(oracle::raw(b.normal));
  for (std::size_t i = 0; i < n.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (n[i] * m[j] != n[j] * m[i]) return true;
    }
  }
  std::size_t i = 0;
  while (m[i].is_zero()) ++i;
  return oracle::raw(a.offset) * m[i] == oracle::raw(b.offset) * n[i];
}
template <class A, class B>
bool meet(const A& a, const B& b) {
  return oracle::meet(oracle::hull_of(a), oracle::hull_of(b));
}

template <class A, class B, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto a = decoder.template shape<A>();
  const auto b = decoder.template shape<B>();
  const bool expected = meet(a, b);
  require(overlaps(a, b) == expected && overlaps(b, a) == expected,
          [&] { return oracle::describe(a) + "; " + oracle::describe(b); });
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    const auto pair = source.below(10);
    Decoder<S, N> decoder(source);
    switch (pair) {
      case 0:
        return check<Aabb<S, N>, Aabb<S, N>>(decoder);
      case 1:
        return check<Aabb<S, N>, Obb<S, N>>(decoder);
      case 2:
        return check<Plane<S, N>, Aabb<S, N>>(decoder);
      case 3:
        return check<Aabb<S, N>, Triangle<S, N>>(decoder);
      case 4:
        return check<Obb<S, N>, Obb<S, N>>(decoder);
      case 5:
        return check<Plane<S, N>, Obb<S, N>>(decoder);
      case 6:
        return check<Obb<S, N>, Triangle<S, N>>(decoder);
      case 7:
        return check<Plane<S, N>, Plane<S, N>>(decoder);
      case 8:
        return check<Plane<S, N>, Triangle<S, N>>(decoder);
      default:
        return check<Triangle<S, N>, Triangle<S, N>>(decoder);
    }
  });
}

}  // namespace detent::fuzz
