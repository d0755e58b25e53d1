// SPDX-License-Identifier: MIT
//
// The closest points of two shapes are the exact ones, rounded once; where the shapes meet, they
// are one point.

#include "decode.hpp"
#include "detent/query/closest_points/pair.hpp"
#include "detent/query/distance/pair.hpp"
#include "oracle/hull.hpp"
//
#include "oracle/closest_pair.hpp"
#include "pairs.hpp"

namespace detent::fuzz {
namespace {

constexpr auto check = []<Scalar S, int N>(Space<S, N>, const auto& a, const auto& b,
                                           const auto& because) {
  const auto found = closest_points(a, b);
  if (!detail::has_points(a) || !detail::has_points(b)) {
    require(found == std::pair<Vec<S, N>, Vec<S, N>>(), because);
    return;
  }
  const auto exact = oracle::closest_pair<S, N>(a, b);
  require(exact.has_value(), because);
  require(oracle::is_rounded(exact->first, found.first), because);
  require(oracle::is_rounded(exact->second, found.second), because);
  require(!share_a_point(a, b) || found.first == found.second, because);
};

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_two_shapes<S, N, ConvexHull<S, N>>(
        source, [&]<class A, class B>(std::type_identity<A>, std::type_identity<B>) {
          // Only one order of each pair: compiling both takes half as much memory again.
          Decoder<S, N> decoder(source);
          using Shapes = support::AllShapes<S, N>;
          if constexpr (Shapes::template index<A> <= Shapes::template index<B>) {
            decode_two<A, B>(decoder, check);
          } else {
            decode_two<B, A>(decoder, check);
          }
        });
  });
}

}  // namespace detent::fuzz
