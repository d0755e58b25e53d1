// SPDX-License-Identifier: MIT
//
// Spheres and capsules against every shape, in both orders: overlaps is exact.

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

template <class Round, Scalar S, int N>
void check_against(std::size_t shape, Decoder<S, N>& decoder) {
  switch (shape) {
    case 1:
      return check<Round, Aabb<S, N>>(decoder);
    case 2:
      return check<Round, Obb<S, N>>(decoder);
    case 3:
      return check<Round, Plane<S, N>>(decoder);
    case 4:
      return check<Round, Triangle<S, N>>(decoder);
    default:
      return check<Capsule<S, N>, Round>(decoder);
  }
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    const auto round = source.below(2), shape = source.below(6);
    Decoder<S, N> decoder(source);
    if (shape == 0) return check<Sphere<S, N>, Sphere<S, N>>(decoder);
    if (round == 0) return check_against<Sphere<S, N>>(shape, decoder);
    check_against<Capsule<S, N>>(shape, decoder);
  });
}

}  // namespace detent::fuzz
