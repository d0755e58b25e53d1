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

template <class A, class B, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  const auto a = decoder.template shape<A>();
  const auto b = decoder.template shape<B>();
  const auto because = [&] { return oracle::describe(a) + "; " + oracle::describe(b); };
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
}

/// An order of the kinds of shapes.
template <class T>
inline constexpr int rank = detail::is_kind<T, Sphere>     ? 0
                            : detail::is_kind<T, Capsule>  ? 1
                            : detail::is_kind<T, Triangle> ? 2
                            : detail::is_kind<T, Aabb>     ? 3
                            : detail::is_kind<T, Obb>      ? 4
                            : detail::is_kind<T, Plane>    ? 5
                                                           : 6;

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_two_shapes<S, N, ConvexHull<S, N>>(
        source, [&]<class A, class B>(std::type_identity<A>, std::type_identity<B>) {
          // One order of each pair: both would take half as much memory again to compile.
          Decoder<S, N> decoder(source);
          if constexpr (rank<A> <= rank<B>) {
            check<A, B>(decoder);
          } else {
            check<B, A>(decoder);
          }
        });
  });
}

}  // namespace detent::fuzz
