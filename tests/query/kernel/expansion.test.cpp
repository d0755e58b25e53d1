// SPDX-License-Identifier: MIT
#include "detent/query/kernel/expansion.hpp"

#include <cmath>
#include <vector>

#include "detent/query/contact.hpp"
#include "detent/query/overlaps.hpp"
#include "oracle/describe.hpp"
#include "oracle/hull.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("expansion: the nearest facet equals that of a search through all facets",
                   "[contact]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  oracle::Draw<S, N> draw(0xe9a);
  int met = 0;
  for (int i = 0; i < 150; ++i) {
    const auto kind = i % 3 == 0 ? oracle::Kind::lattice : oracle::Kind::general;
    const auto setting = oracle::draw_setting(draw, kind, 40);
    const auto a = oracle::draw_shape<ConvexHull<S, N>>(draw, setting);
    const auto b = oracle::draw_shape<ConvexHull<S, N>>(draw, setting);
    const detail::HullBody body_a(a), body_b(b);
    using T = decltype(S() - S());
    using Body = std::remove_cvref_t<decltype(body_a)>;
    if (!detail::bodies_overlap(body_a, body_b)) continue;
    const auto found = detail::Expansion<T, Body, Body>(body_a, body_b).least_push();
    const auto all = detail::Expansion<T, Body, Body>(body_a, body_b).least_facet();
    if (detail::is_zero(all.normal)) continue;  // flat
    const auto crowded = detail::Expansion<T, Body, Body, 6>(body_a, body_b).least_push();
    CHECK(unit_vector<direction_component<S>>(to_array(crowded.normal)) ==
          unit_vector<direction_component<S>>(to_array(all.normal)));
    ++met;
    INFO(draw.random << ": " << oracle::describe(a) << "; " << oracle::describe(b));
    CHECK(unit_vector<direction_component<S>>(to_array(found.normal)) ==
          unit_vector<direction_component<S>>(to_array(all.normal)));
    CHECK(sqrt_floor<S>(Fraction{square(found.height), squared_length(found.normal)}) ==
          sqrt_floor<S>(Fraction{square(all.height), squared_length(all.normal)}));
  }
  CHECK(met > 40);
}

TEMPLATE_TEST_CASE("expansion: round hulls inside each other", "[contact]", (Space<q16_16, 3>),
                   (Space<q16_16, 2>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  oracle::Draw<S, N> draw(0xba11);
  const std::size_t count = N == 2 ? 150 : 24;
  std::vector<Vec<S, N>> balls[2];
  for (auto& points : balls) {
    for (std::size_t i = 0; i < count; ++i) {
      points.push_back(draw.vec(draw.moved(oracle::Raw<N>{}, draw.any_direction(), 1 << 20)));
    }
  }
  const ConvexHull<S, N> a{balls[0]}, b{balls[1]};
  const auto found = contact(a, b);
  REQUIRE(found);
  // Approximately two concentric balls of radius 16.
  CHECK(found->depth > S(20));
  CHECK(found->depth <= S(32));
  for (int i = 0; i < 500; ++i) {
    const auto v = draw.any_direction();
    const detail::HullBody body_a(a), body_b(b);
    const auto reach = dot(v, body_a.template extreme<40>(v.vec(), b.points[0], true) -
                                  body_b.template extreme<40>(v.vec(), a.points[0], false));
    CHECK(floor_to<S>(reach) >= nearest_to<S>(found->depth - S::from_raw(1)));
  }
  CHECK(!overlaps(a, [&] {
    for (auto& point : balls[1]) point = nearest_to<S>(point + separation(*found));
    return ConvexHull<S, N>{balls[1]};
  }()));
}

}  // namespace
}  // namespace detent::test
