// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/distance/pair.hpp"
#include "oracle/hull.hpp"
#include "oracle/pair_exam.hpp"
#include "support/shapes.hpp"

namespace detent::oracle {

/// Compares the distances of random pairs of shapes with the oracle's.
template <Scalar S, int N>
class DistanceExam {
 public:
  explicit DistanceExam(std::uint64_t seed) : draw_(seed) {}

  template <class A, class B>
  void examine(long count) {
    long apart = 0;
    for (long i = 0; i < count; ++i) {
      const auto setting = any_setting(draw_, Kind::general, 150);
      const auto a = draw_shape<A>(draw_, setting);
      const auto b = draw_shape<B>(draw_, setting);
      const auto exact = distance_floor(a, b);
      const Integer most = raw(S::max());
      const Integer expected = exact ? std::min(*exact, most) : most;
      if (exact && *exact > 0) ++apart;
      if (raw(distance(a, b)) == expected && raw(distance(b, a)) == expected) continue;
      FAIL_CHECK(draw_.random << ": " << describe(a) << "; " << describe(b) << "; expected "
                              << expected.str() << ", found " << distance(a, b).raw() << " and "
                              << distance(b, a).raw());
      return;
    }
    INFO(draw_.random);
    CHECK(apart >= (std::is_same_v<A, Plane<S, N>> && std::is_same_v<A, B> ? 1 : count / 10));
  }

 private:
  Draw<S, N> draw_;
};

/// `count` pairs of every two kinds of shapes.
template <Scalar S, int N>
void examine_distances(std::uint64_t seed, long count) {
  DistanceExam<S, N> exam(seed);
  support::AllShapes<S, N>::for_each_pair(
      [&]<class A, class B>(const A&, const B&) { exam.template examine<A, B>(count); });
}

}  // namespace detent::oracle
