// SPDX-License-Identifier: MIT
//
// The distance of two shapes is the exact one rounded down, in both orders, and 0 if they overlap.

#include "decode.hpp"
#include "detent/query/distance/pair.hpp"
#include "detent/query/intersects.hpp"
#include "detent/query/overlaps.hpp"
#include "oracle/hull.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class A, class B>
bool share_a_point(const A& a, const B& b) {
  if constexpr (requires { overlaps(a, b); }) {
    return overlaps(a, b);
  } else {
    return intersects(a, b);
  }
}

template <class A, class B, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto a = decoder.template shape<A>();
  const auto b = decoder.template shape<B>();
  const auto because = [&] { return oracle::describe(a) + "; " + oracle::describe(b); };
  const auto exact = oracle::distance_floor(a, b);
  const oracle::Integer most = oracle::raw(S::max());
  const oracle::Integer expected = exact ? std::min(*exact, most) : most;
  const S found = distance(a, b);
  require(oracle::raw(found) == expected && distance(b, a) == found, because);
  require(!share_a_point(a, b) || found == 0, because);
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    const auto one_of = [&](const auto& f) {
      with_one_shape<S, N, Segment<S, N>, ConvexHull<S, N>>(source, f);
    };
    one_of([&]<class A>(std::type_identity<A>) {
      one_of([&]<class B>(std::type_identity<B>) {
        Decoder<S, N> decoder(source);
        check<A, B>(decoder);
      });
    });
  });
}

}  // namespace detent::fuzz
