// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "detent/query/distance/pair.hpp"
#include "query/shapes_at.hpp"

namespace detent::test {

/// The distance of every two kinds of shapes.
template <Scalar S, int N>
void check_distances() {
  // The position of the other shape, and its distance there.
  constexpr std::array<std::array<double, 2>, 3> others{{{4, 5}, {-1, 0}, {-3, 0}}};
  const auto check = [](S got, S expected) { CHECK(got == expected); };
  visit_shapes<S, N>(-3, [&](const auto& a) {
    for (const auto& [x, expected] : others) {
      visit_shapes<S, N>(x, [&, d = num<S>(expected)](const auto& b) {
        check(distance(a, b), d);
        check(distance(b, a), d);
      });
    }
    const Plane<S, N> plane{toward<S, N>(1), num<S>(4)};
    CHECK(distance(a, plane) == num<S>(6));
    CHECK(distance(plane, a) == num<S>(6));
    CHECK(distance(Plane<S, N>{toward<S, N>(1), num<S>(-3)}, a) == S(0));
  });
}

}  // namespace detent::test
