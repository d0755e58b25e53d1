// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "detent/query/time_of_impact.hpp"
#include "oracle/impact_exam.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

template <class A, Scalar S, int N>
void examine_plane(oracle::Bodies<S, N>& bodies, HitRate& hits) {
  for (int i = 0; i < 60; ++i) {
    bodies.next_case();
    const auto a = bodies.template shape<A>();
    const auto sweep = bodies.sweep();
    const auto normal = bodies.rotation().axis(0);
    const auto through = bodies.point(S::bits - 2);
    const Plane<S, N> plane{normal,
                            nearest_to<S>(dot(normal, bodies.random.coin() ? sweep.end : through))};
    const auto impact = time_of_impact(a, sweep, plane);
    hits.count(impact.has_value());
    // Along its normal a plane acts like a distant point, so it needs no other oracle.
    const auto body = oracle::moving(a, sweep);
    const auto n = oracle::raw_point<S>(normal.vec());
    const double norm = oracle::motion::length(n), offset = plane.offset.raw();
    const double unit = std::ldexp(1.0, -direction_component<S>::frac);
    const auto gap = [&](double t) {
      double least = 1e300, most = -1e300;
      for (const auto& p : body.at(t)) {
        const double height = oracle::motion::dot(p, n) / std::ldexp(1.0, S::frac) - offset;
        least = std::min(least, height);
        most = std::max(most, height);
      }
      return (least > 0  ? least
              : most < 0 ? -most
                         : 0) /
                 norm * std::ldexp(1.0, S::frac) -
             body.radius;
    };
    INFO(bodies.random << ", case " << i << " of kind " << typeid(A).name());
    const double end = impact ? static_cast<double>(impact->time) : 1;
    for (int k = 0; k < 20 && end > 0; ++k) REQUIRE(gap(end * k / 20) > 0);
    if (!impact) continue;
    REQUIRE(gap(end) <= impact->distance.raw() + 1e-2);
    REQUIRE(impact->is_hit);
    REQUIRE(impact->distance.raw() <=
            std::ceil(oracle::stated_distance(body, oracle::motion::Body{}, S::from_raw(8)) +
                      unit * body.radius));
  }
}

TEMPLATE_TEST_CASE("time of impact: random bodies and planes", "[toi]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  oracle::Bodies<S, N> bodies(0x91a);
  HitRate hits;
  examine_plane<Sphere<S, N>>(bodies, hits);
  examine_plane<Aabb<S, N>>(bodies, hits);
  examine_plane<Obb<S, N>>(bodies, hits);
  examine_plane<Triangle<S, N>>(bodies, hits);
  examine_plane<Capsule<S, N>>(bodies, hits);
  examine_plane<ConvexHull<S, N>>(bodies, hits);
  INFO(hits);
  CHECK(hits.is_balanced());
}

}  // namespace
}  // namespace detent::test
