// SPDX-License-Identifier: MIT
#include "detent/query/cast/pair.hpp"
#include "detent/query/time_of_impact.hpp"
#include "oracle/impact_exam.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

template <class Shape, class Space>
void compare_with_casts() {
  using S = typename Space::scalar;
  constexpr int N = Space::dimension;
  oracle::Bodies<S, N> bodies(0xca57);
  HitRate hits;
  for (int i = 0; i < 200; ++i) {
    bodies.next_case();
    const auto a = bodies.template shape<Shape>();
    const auto b = bodies.template shape<Shape>();
    // Along x by a whole number, so that the sweep and the cast are the same motion.
    Sweep<S, N> sweep;
    constexpr int whole = S::bits - S::frac;
    constexpr int most = whole < 8 ? 100 : whole < 15 ? 8000 : 20000;
    sweep.end.x = S(static_cast<int>(bodies.random.below(most)));
    const auto hit = cast(a, Direction<S, N>::along(0), sweep.end.x, b);
    const auto impact = time_of_impact(a, sweep, b);
    hits.count(hit.has_value());
    INFO(bodies.random << ", case " << i);
    REQUIRE((impact || !hit));
    if (!hit) continue;
    // Never past the first touch, which is at most a unit beyond the distance.
    const auto way = impact->time * sweep.end.x;
    REQUIRE(way <= hit->distance + S::from_raw(1));
  }
  INFO(hits);
  CHECK((hits.percent() > 30 && hits.percent() < 99));
}

// Casts take long to compile, and their oracles cover every space.
TEMPLATE_TEST_CASE("time of impact: without rotation, it is never past the hit of a cast", "[toi]",
                   DETENT_EVERYDAY_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  compare_with_casts<Sphere<S, N>, TestType>();
  compare_with_casts<Aabb<S, N>, TestType>();
}

}  // namespace
}  // namespace detent::test
