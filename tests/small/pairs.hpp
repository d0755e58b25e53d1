// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects.hpp"
#include "detent/query/overlaps.hpp"
#include "oracle/describe.hpp"
#include "oracle/hull.hpp"
#include "small/convex.hpp"
#include "small/world.hpp"

/// Every pair of shapes from exhaustive sets of a small world: overlaps, in both orders, and
/// intersects.
namespace detent::small {

template <class A, class B>
std::string pair_mistakes(const A& a, const B& b, bool expected) {
  std::string out;
  if constexpr (requires { overlaps(a, b); }) {
    if (overlaps(a, b) != expected) out += "  overlaps\n";
    if (overlaps(b, a) != expected) out += "  overlaps, the other way round\n";
  } else {
    if (intersects(a, b) != expected) out += "  intersects\n";
  }
  return out;
}

template <class A, class B>
void ask_pairs(Verdict& verdict, const std::vector<A>& some, const std::vector<B>& others) {
  for (const auto& a : some) {
    for (const auto& b : others) {
      const bool expected = meet(a, b);
      verdict.count(expected);
      verdict.judge(pair_mistakes(a, b, expected),
                    [&] { return oracle::describe(a) + "; " + oracle::describe(b); });
    }
  }
}

/// Every list with itself and with each later list.
inline void ask_each(Verdict&) {}
template <class First, class... Rest>
void ask_each(Verdict& verdict, const First& first, const Rest&... rest) {
  ask_pairs(verdict, first, first);
  (ask_pairs(verdict, first, rest), ...);
  ask_each(verdict, rest...);
}

/// Every pair of at most `most` shapes of each kind.
template <Scalar S, int N>
void ask_every_pair(std::size_t most, long expected) {
  Verdict verdict;
  with_some(most, all_parts<S, N>(), [&](const auto& segments, const auto&... shapes) {
    ask_each(verdict, shapes...);
    (ask_pairs(verdict, segments, shapes), ...);
    ask_pairs(verdict, segments, segments);
  });
  verdict.finish(expected);
}

}  // namespace detent::small
