// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects.hpp"
#include "detent/query/overlaps.hpp"
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

/// Every list against itself and against each later list.
void ask_each(Verdict&) {}
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
  const auto all = points<S, N>();
  const auto corners = some(N == 2 ? 16 : 9, all);
  const Hulls<S, N> lists(corners, N == 2 ? 4 : 5);
  const auto balls = some(most, spheres<S, N>());
  const auto upright = some(most, boxes(all));
  const auto turned = some(most, turned_boxes(all, all, rotations<S, N>()));
  const auto flat = some(most, planes(directions<S, N>(2)));
  const auto faces = some(most, triangles(all, all));
  const auto pills = some(most, capsules(all));
  const auto hulls = some(most, lists.all());
  const auto lines = some(most, segments(all));
  ask_each(verdict, balls, upright, turned, flat, faces, pills, hulls);
  ask_pairs(verdict, lines, balls);
  ask_pairs(verdict, lines, upright);
  ask_pairs(verdict, lines, turned);
  ask_pairs(verdict, lines, flat);
  ask_pairs(verdict, lines, faces);
  ask_pairs(verdict, lines, pills);
  ask_pairs(verdict, lines, hulls);
  ask_pairs(verdict, lines, lines);
  verdict.finish(expected);
}

}  // namespace detent::small
