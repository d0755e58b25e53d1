// SPDX-License-Identifier: MIT
//
// The distance of two shapes is the exact one rounded down, in both orders, and 0 if they overlap.

#include "decode.hpp"
#include "detent/query/distance/pair.hpp"
#include "oracle/hull.hpp"
#include "pairs.hpp"

namespace detent::fuzz {
namespace {

constexpr auto check = []<Scalar S, int N>(Space<S, N>, const auto& a, const auto& b,
                                           const auto& because) {
  const auto exact = oracle::distance_floor(a, b);
  const oracle::Integer most = oracle::raw(S::max());
  const oracle::Integer expected = exact ? std::min(*exact, most) : most;
  const S found = distance(a, b);
  require(oracle::raw(found) == expected && distance(b, a) == found, because);
  require(!share_a_point(a, b) || found == 0, because);
};

}  // namespace

void property(Bytes input) {
  check_two_shapes(input,
                   []<class A, class B>(auto& decoder) { decode_two<A, B>(decoder, check); });
}

}  // namespace detent::fuzz
