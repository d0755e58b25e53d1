// SPDX-License-Identifier: MIT
//
// A moving shape touches a target at the exact distance rounded down, with a normal and a point of
// the target.

#include "decode.hpp"
#include "oracle/hull.hpp"
//
#include "oracle/cast_judge.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class A, class B, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto shape = decoder.template shape<A>();
  const auto target = decoder.template shape<B>();
  const auto direction = decoder.direction();
  const S limit = decoder.number();
  const auto found = cast(shape, direction, limit, target);
  const auto fault =
      oracle::fault_of(oracle::travel_of(shape, direction, target), shape, target, found, limit);
  require(fault.empty(), [&] {
    return fault + ": " + oracle::describe(shape) + "; " + oracle::describe(target) + " along " +
           oracle::describe(direction);
  });
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_of<Sphere<S, N>, Capsule<S, N>, Obb<S, N>, ConvexHull<S, N>>(
        source, [&]<class A>(std::type_identity<A>) {
          with_one_of<Obb<S, N>, Triangle<S, N>, Capsule<S, N>>(
              source, [&]<class B>(std::type_identity<B>) {
                Decoder<S, N> decoder(source);
                check<A, B>(decoder);
              });
        });
  });
}

}  // namespace detent::fuzz
