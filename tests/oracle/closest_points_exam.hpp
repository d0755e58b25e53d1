// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
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
    examine_apart<A, B>(
        draw_, Kind::lattice, count, [&](const A& a, const B& b) -> std::optional<bool> {
          const auto found = closest_points(a, b);
          const auto fail = [&](const char* why) -> std::optional<bool> {
            FAIL_CHECK(draw_.random << why << ": " << describe(a) << "; " << describe(b)
                                    << "; found " << describe(found.first) << " and "
                                    << describe(found.second));
            return std::nullopt;
          };
          if (!detail::has_points(a) || !detail::has_points(b)) {
            if (found == decltype(found)()) return false;
            return fail(", empty");
          }
          const auto exact = closest_pair<S, N>(a, b);
          if (!exact) return fail(", no proof");
          if (!is_rounded(exact->first, found.first) || !is_rounded(exact->second, found.second)) {
            return fail("");
          }
          return found.first != found.second;
        });
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
