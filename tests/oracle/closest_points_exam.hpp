// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/query/closest_points/pair.hpp"
#include "oracle/closest_pair.hpp"
#include "oracle/hull.hpp"
#include "oracle/pair_exam.hpp"
#include "support/shapes.hpp"

namespace detent::oracle {

/// Compares the closest points of random pairs of shapes with the exact ones.
template <Scalar S, int N>
class ClosestPointsExam {
 public:
  explicit ClosestPointsExam(std::uint64_t seed) : draw_(seed) {}

  template <class A, class B>
  void examine(long count) {
    long apart = 0;
    for (long i = 0; i < count; ++i) {
      const auto setting = any_setting(draw_, Kind::lattice, 150);
      const auto a = draw_shape<A>(draw_, setting);
      const auto b = draw_shape<B>(draw_, setting);
      const auto found = closest_points(a, b);
      const auto because = [&] {
        return describe(a) + "; " + describe(b) + "; found " + describe(found.first) + " and " +
               describe(found.second);
      };
      INFO(draw_.random << ": case " << i);
      if (!detail::has_points(a) || !detail::has_points(b)) {
        if (found == decltype(found)()) continue;
        FAIL_CHECK("empty: " << because());
        return;
      }
      const auto exact = closest_pair<S, N>(a, b);
      if (!exact) {
        FAIL_CHECK("no proof: " << because());
        return;
      }
      if (!is_rounded(exact->first, found.first) || !is_rounded(exact->second, found.second)) {
        FAIL_CHECK(because());
        return;
      }
      if (found.first != found.second) ++apart;
    }
    INFO(draw_.random);
    CHECK(apart >= (std::is_same_v<A, Plane<S, N>> && std::is_same_v<A, B> ? 1 : count / 10));
  }

  /// A with itself and with each of the others, in both orders if these have different code.
  template <class A, class... Others>
  void examine_with(long count) {
    examine<A, A>(count);
    (examine<A, Others>(count), ...);
    (examine_swapped<A, Others>(count / 2), ...);
  }

  template <class A, class... Others>
  void examine_with_all(support::ShapeList<Others...>, long count) {
    examine_with<A, Others...>(count);
  }

 private:
  template <class A, class B>
  void examine_swapped(long count) {
    constexpr bool differ = requires(A a) { a.radius; }
    != requires(B b) { b.radius; };
    if constexpr (differ || detail::is_kind<A, Plane>) examine<B, A>(count);
  }

  Draw<S, N> draw_;
};

/// `count` pairs of every round or flat shape with any other.
template <Scalar S, int N>
void examine_round_points(std::uint64_t seed, long count) {
  ClosestPointsExam<S, N> exam(seed);
  using Others = typename support::SceneShapes<S, N>::template without<Sphere<S, N>, Plane<S, N>>;
  exam.template examine_with_all<Sphere<S, N>>(Others(), count);
  exam.template examine_with_all<Plane<S, N>>(
      typename support::AllShapes<S, N>::template without<Plane<S, N>>(), count);
  support::RoundShapes<S, N>::template without<Sphere<S, N>>::for_each(
      [&]<class Round>(const Round&) {
        exam.template examine_with<Round, Obb<S, N>, ConvexHull<S, N>>(count);
      });
}
/// `count` pairs of every two polytopes.
template <Scalar S, int N>
void examine_polytope_points(std::uint64_t seed, long count) {
  ClosestPointsExam<S, N> exam(seed);
  exam.template examine_with<Aabb<S, N>, Obb<S, N>, Triangle<S, N>, ConvexHull<S, N>>(count);
  exam.template examine_with<Obb<S, N>, Triangle<S, N>, Segment<S, N>, ConvexHull<S, N>>(count);
  exam.template examine_with<Segment<S, N>, Triangle<S, N>>(count);
  exam.template examine_with<ConvexHull<S, N>, Triangle<S, N>>(count);
}

}  // namespace detent::oracle
