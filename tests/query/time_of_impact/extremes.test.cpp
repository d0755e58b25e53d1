// SPDX-License-Identifier: MIT
#include <array>

#include "detent/query/time_of_impact.hpp"
#include "oracle/impact_exam.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("time of impact: is defined for every bit pattern", "[toi]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(0xed9e);
  INFO(random);
  const auto edge = [&] {
    return S::from_raw(static_cast<typename S::raw_type>(random.edgy(S::bits)));
  };
  const auto point = [&] { return make_vec<N>([&](int) { return edge(); }); };
  const auto extents = [&] {
    if (random.one_in(4)) return point();
    return make_vec<N>([&](int) { return nearest_to<S>(abs(edge())); });
  };
  HitRate hits;
  for (int i = 0; i < 400; ++i) {
    oracle::Bodies<S, N> bodies(random.next());
    const Sweep<S, N> sweep_a{point(), point(), bodies.rotation(), bodies.rotation()};
    const Sweep<S, N> sweep_b{point(), point(), bodies.rotation(), bodies.rotation()};
    const Obb<S, N> box{point(), extents(), bodies.rotation()};
    const std::array points{point(), point(), point(), point()};
    const ConvexHull<S, N> hull{points};
    const auto impact = time_of_impact(box, sweep_a, hull, sweep_b);
    if (is_empty(box)) {
      CHECK_FALSE(impact);
      continue;
    }
    hits.count(impact.has_value());
    const auto fault = oracle::fault_of(impact, oracle::moving(box, sweep_a),
                                        oracle::moving(hull, sweep_b), S::from_raw(8), 4);
    INFO("case " << i);
    if (fault) FAIL_CHECK(*fault);
  }
  INFO(hits);
  CHECK(hits.percent() > 30);
}

}  // namespace
}  // namespace detent::test
