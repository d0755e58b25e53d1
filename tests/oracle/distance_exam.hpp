// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "detent/query/distance/pair.hpp"
#include "oracle/hull.hpp"
#include "oracle/pair_exam.hpp"
#include "support/shapes.hpp"

namespace detent::oracle {

/// Compares the distances of random pairs of shapes with the oracle's.
template <class A, class B, Scalar S, int N>
void examine_distance(Draw<S, N>& draw, long count) {
  examine_apart<A, B>(
      draw, Kind::general, count, [&](const A& a, const B& b) -> std::optional<bool> {
        const auto exact = distance_floor(a, b);
        const Integer most = raw(S::max());
        const Integer expected = exact ? std::min(*exact, most) : most;
        if (raw(distance(a, b)) == expected && raw(distance(b, a)) == expected) {
          return exact && *exact > 0;
        }
        FAIL_CHECK(draw.random << ": " << describe(a) << "; " << describe(b) << "; expected "
                               << expected.str() << ", found " << distance(a, b).raw() << " and "
                               << distance(b, a).raw());
        return std::nullopt;
      });
}

/// `count` pairs of every two kinds of shapes.
template <Scalar S, int N>
void examine_distances(std::uint64_t seed, long count) {
  Draw<S, N> draw(seed);
  support::AllShapes<S, N>::for_each_pair(
      [&]<class A, class B>(const A&, const B&) { examine_distance<A, B>(draw, count); });
}

}  // namespace detent::oracle
