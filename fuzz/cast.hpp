// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "decode.hpp"
#include "oracle/describe.hpp"
#include "oracle/hull.hpp"
//
#include "oracle/cast_judge.hpp"
#include "spaces.hpp"

namespace detent::fuzz {

/// The property of one moving shape and one target.
template <class A, class B, Scalar S, int N>
void check_cast(Decoder<S, N>& decoder) {
  const auto shape = decoder.template shape<A>();
  const auto target = decoder.template shape<B>();
  const auto direction = decoder.direction();
  const S limit = decoder.number();
  const auto found = cast(shape, direction, limit, target);
  const auto travel = oracle::travel_of(shape, direction, target);
  const auto fault = oracle::fault_of(travel, shape, direction, target, found, limit);
  require(fault.empty(), [&] {
    return fault + ": " + oracle::describe(shape) + "; " + oracle::describe(target) + " along " +
           oracle::describe(direction);
  });
}

/// The property for the kinds of shapes that the bytes name, if the moving one is round or if it is
/// not: each takes a compiler half a gigabyte.
template <bool IsRound>
void check_casts(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_of<Sphere<S, N>, Capsule<S, N>, Obb<S, N>, ConvexHull<S, N>>(
        source, [&]<class A>(std::type_identity<A>) {
          if constexpr (requires(A a) { a.radius; } == IsRound) {
            with_one_of<Obb<S, N>, Triangle<S, N>, Capsule<S, N>>(
                source, [&]<class B>(std::type_identity<B>) {
                  Decoder<S, N> decoder(source);
                  check_cast<A, B>(decoder);
                });
          }
        });
  });
}

/// `check_casts<false>`, which has a source of its own.
void check_casts_of_polytopes(Bytes input);

}  // namespace detent::fuzz
