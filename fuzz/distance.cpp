// SPDX-License-Identifier: MIT
//
// The distance of two shapes is the exact one rounded down, in both orders, and 0 if they overlap.

#include "decode.hpp"
#include "detent/query/distance/pair.hpp"
#include "oracle/hull.hpp"
#include "pairs.hpp"

namespace detent::fuzz {
namespace {

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
  check_two_shapes(input, []<class A, class B>(auto& decoder) { check<A, B>(decoder); });
}

}  // namespace detent::fuzz
