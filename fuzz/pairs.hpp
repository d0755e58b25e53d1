// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "decode.hpp"
#include "detent/query/intersects.hpp"
#include "detent/query/overlaps.hpp"
#include "oracle/describe.hpp"
#include "spaces.hpp"

namespace detent::fuzz {

/// Calls `check(std::type_identity<A>(), std::type_identity<B>())` for two shapes chosen by bytes:
/// of those that scenes hold, or of `More`.
template <Scalar S, int N, class... More, class Check>
void with_two_shapes(Source& source, const Check& check) {
  with_one_shape<S, N, More...>(source, [&]<class A>(std::type_identity<A> a) {
    with_one_shape<S, N, More...>(source, [&]<class B>(std::type_identity<B> b) { check(a, b); });
  });
}

/// Draws a space and two shapes of every kind, segments and hulls among them, and calls
/// check.template operator()<A, B>(decoder).
template <class Check>
void check_two_shapes(Bytes input, const Check& check) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_two_shapes<S, N, Segment<S, N>, ConvexHull<S, N>>(
        source, [&]<class A, class B>(std::type_identity<A>, std::type_identity<B>) {
          Decoder<S, N> decoder(source);
          check.template operator()<A, B>(decoder);
        });
  });
}

/// Whether two shapes or segments share a point.
template <class A, class B>
bool share_a_point(const A& a, const B& b) {
  if constexpr (requires { overlaps(a, b); }) {
    return overlaps(a, b);
  } else {
    return intersects(a, b);
  }
}

/// Decodes two shapes for `check(Space<S, N>, a, b, because)`, where because() describes them.
template <class A, class B, Scalar S, int N, class Check>
void decode_two(Decoder<S, N>& decoder, const Check& check) {
  const auto a = decoder.template shape<A>();
  const auto b = decoder.template shape<B>();
  check(Space<S, N>(), a, b, [&] { return oracle::describe(a) + "; " + oracle::describe(b); });
}

/// Decodes two shapes: whether they share a point is what the oracle says, in both orders. A segment
/// comes first.
template <class A, class B, Scalar S, int N>
void check_overlap(Decoder<S, N>& decoder) {
  decode_two<A, B>(decoder, [](auto, const auto& a, const auto& b, const auto& because) {
    const bool truth = oracle::meet(a, b);
    bool is_right = share_a_point(a, b) == truth;
    if constexpr (requires { overlaps(b, a); }) is_right = is_right && overlaps(b, a) == truth;
    require(is_right, because);
  });
}

}  // namespace detent::fuzz
