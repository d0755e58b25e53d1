// SPDX-License-Identifier: MIT
#include "detent/query/time_of_impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <typeinfo>

#include "detent/query/cast/pair.hpp"
#include "detent/query/distance/pair.hpp"
#include "detent/shape/moved.hpp"
#include "oracle/impact_exam.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

// A sweep in the plane of x and y, also in space.
template <Scalar S, int N>
Sweep<S, N> from_to(double x, double y, double to_x, double to_y) {
  return {at<S, N>(x, y), at<S, N>(to_x, to_y)};
}
template <Scalar S, int N>
Rotation<S, N> turned(int part, int of) {
  if constexpr (N == 2) {
    return Rotation<S, 2>::from_angle(Angle<S>::turn(part, of));
  } else {
    return Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(2), Angle<S>::turn(part, of));
  }
}
template <Scalar S>
inline constexpr bool is_coarse = false;
template <int Bits>
inline constexpr bool is_coarse<Fixed<Bits, 8>> = true;

/// Whether the impact is at this time or so much before it that the bodies are nearly touching.
template <Scalar S>
bool is_about(const std::optional<Impact<S>>& impact, double time) {
  return impact && impact->is_hit && static_cast<double>(impact->time) <= time &&
         static_cast<double>(impact->time) > time - (is_coarse<S> ? 1.0 / 32 : 1.0 / 1024);
}

TEMPLATE_TEST_CASE("time of impact: a bullet does not pass through a thin plate", "[toi]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> bullet{Vec<S, N>{}, S(0)};
  const auto half_extents = make_vec<N>([](int i) { return i == 0 ? S(0) : S(8); });
  const Obb<S, N> plate{{}, half_extents, {}};
  const auto fired = from_to<S, N>(-100, 0, 100, 1), rests = from_to<S, N>(50, 0, 50, 0);
  CHECK(is_about(time_of_impact(bullet, fired, plate, rests), 0.75));
  CHECK(is_about(time_of_impact(plate, rests, bullet, fired), 0.75));
  CHECK(time_of_impact(bullet, fired, plate, rests) == time_of_impact(plate, rests, bullet, fired));
  const auto above = from_to<S, N>(-100, 9, 100, 9);
  CHECK_FALSE(time_of_impact(bullet, above, plate, rests));
}

TEMPLATE_TEST_CASE("time of impact: a rod hits by its turn alone", "[toi]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Capsule<S, N> rod{at<S, N>(-5), at<S, N>(5), S(0)};
  const Sphere<S, N> ball{{}, S(1)};
  auto turn = from_to<S, N>(0, 0, 0, 0);
  turn.end_rotation = turned<S, N>(1, 4);
  const auto rests = from_to<S, N>(0, 4, 0, 4);
  // It touches the ball at the angle a = acos(1 / 4). With r = sqrt(1 / 2), its quaternion is
  // (1 - t) 1 + t (r + r k), so tan(a / 2) = t r / (1 - t + t r).
  const double tangent = std::tan(std::acos(0.25) / 2), r = std::sqrt(0.5);
  CHECK(is_about(time_of_impact(rod, turn, ball, rests), tangent / (r + tangent * (1 - r))));
  // The other way about.
  auto back = turn;
  back.end_rotation = turned<S, N>(-1, 4);
  CHECK(is_about(time_of_impact(rod, back, ball, rests), tangent / (r + tangent * (1 - r))));
  // Out of its reach.
  CHECK_FALSE(time_of_impact(rod, turn, ball, from_to<S, N>(0, 7, 0, 7)));
  // Nearly half a turn, and exactly half.
  for (const int part : {511, 512}) {
    auto half_turn = from_to<S, N>(0, 0, 0, 0);
    half_turn.end_rotation = turned<S, N>(part, 1024);
    const auto hit = time_of_impact(rod, half_turn, ball, rests);
    REQUIRE(hit);
    CHECK((hit->time > 0 && hit->time < 1));
  }
}

TEMPLATE_TEST_CASE("time of impact: touch at the start, none, and equal motion", "[toi]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> ball{{}, S(1)};
  const Aabb<S, N> box{filled<S, N>(S(-1)), filled<S, N>(S(1))};
  const auto rests = from_to<S, N>(0, 0, 0, 0), leaves = from_to<S, N>(2, 0, 9, 0);
  const auto touches = time_of_impact(ball, leaves, box, rests);
  REQUIRE(touches);
  CHECK(touches->time == 0);
  CHECK(time_of_impact(ball, rests, box, rests)->time == 0);
  CHECK_FALSE(time_of_impact(ball, from_to<S, N>(3, 0, 9, 0), box, rests));
  // In step, one unit apart, turning about themselves, is no touch.
  const auto first = from_to<S, N>(-9, 0, 20, 3), second = from_to<S, N>(-6, 0, 23, 3);
  CHECK_FALSE(time_of_impact(ball, first, box, second));
  auto spins = first;
  spins.end_rotation = turned<S, N>(3, 8);
  CHECK_FALSE(time_of_impact(ball, spins, box, second));
}

TEMPLATE_TEST_CASE("time of impact: grazing is decided to within the target", "[toi]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> ball{{}, S(1)};
  const auto rests = from_to<S, N>(0, 0, 0, 0);
  const auto passing = [&](int above) {
    auto pass = from_to<S, N>(-20, 2, 20, 2);
    pass.start.y = pass.end.y =
        S::from_raw(static_cast<typename S::raw_type>(pass.end.y.raw() + above));
    return time_of_impact(ball, pass, ball, rests);
  };
  CHECK(is_about(passing(0), 0.5));
  CHECK(is_about(passing(-1), 0.5));
  CHECK_FALSE(passing(12));
  CHECK_FALSE(time_of_impact(ball, from_to<S, N>(-20, 5, 20, 5), ball, rests, S(2)));
  CHECK(time_of_impact(ball, from_to<S, N>(-20, 5, 20, 5), ball, rests, S(4)));
}

TEMPLATE_TEST_CASE("time of impact: a plane is met from either side", "[toi]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Plane<S, N> wall{toward<S, N>(1), num<S>(4)}, across{toward<S, N>(-1), num<S>(-4)};
  const Sphere<S, N> ball{{}, S(1)};
  for (const auto& plane : {wall, across}) {
    CHECK(is_about(time_of_impact(ball, from_to<S, N>(-5, 0, 11, 2), plane), 0.5));
    CHECK(is_about(time_of_impact(ball, from_to<S, N>(9, 0, 1, 2), plane), 0.5));
    CHECK_FALSE(time_of_impact(ball, from_to<S, N>(-5, 0, 2, 9), plane));
    CHECK(time_of_impact(ball, from_to<S, N>(5, 0, 9, 0), plane)->time == 0);
    CHECK(time_of_impact(ball, from_to<S, N>(4, 0, 9, 0), plane)->time == 0);
    CHECK_FALSE(time_of_impact(Sphere<S, N>{{}, S(-1)}, from_to<S, N>(9, 0, 1, 2), plane));
  }
  // A rod along the plane, turned upright: its end is 5 sin(a) away, and a is at t as above.
  const Capsule<S, N> rod{at<S, N>(0, -5), at<S, N>(0, 5), S(0)};
  auto turn = from_to<S, N>(0, 0, 0, 0);
  turn.end_rotation = turned<S, N>(1, 4);
  const double tangent = std::tan(std::asin(0.8) / 2), r = std::sqrt(0.5);
  CHECK(is_about(time_of_impact(rod, turn, wall), tangent / (r + tangent * (1 - r))));
}

TEMPLATE_TEST_CASE("time of impact: a shape of the world is one that rests", "[toi]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> ball{{}, S(1)};
  const Aabb<S, N> box{filled<S, N>(S(3)), filled<S, N>(S(5))};
  const auto flies = from_to<S, N>(0, 4, 5, 4);
  auto rises = flies;
  rises.start[N - 1] = rises.end[N - 1] = S(4);
  CHECK(time_of_impact(ball, rises, box));
  CHECK(time_of_impact(ball, rises, box) ==
        time_of_impact(ball, rises, box, from_to<S, N>(0, 0, 0, 0)));
  CHECK_FALSE(time_of_impact(ball, from_to<S, N>(0, 0, 9, 0), box));
}

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
    // A plane is a point far off, as seen along its normal: it needs no other oracle.
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

template <class A, class B, Scalar S, int N>
void compare_with_casts(oracle::Bodies<S, N>& bodies, HitRate& hits) {
  for (int i = 0; i < 100; ++i) {
    bodies.next_case();
    const auto a = bodies.template shape<A>();
    const auto b = bodies.template shape<B>();
    // Along x, by a whole number, so that the sweep and the cast are the same motion.
    Sweep<S, N> sweep;
    constexpr int whole = S::bits - S::frac;
    constexpr int most = whole < 8 ? 100 : whole < 15 ? 8000 : 20000;
    sweep.end.x = S(static_cast<int>(bodies.random.below(most)));
    const auto hit = cast(a, Direction<S, N>::along(0), sweep.end.x, b);
    const auto impact = time_of_impact(a, sweep, b);
    hits.count(hit.has_value());
    INFO(bodies.random << ", case " << i << " of kinds " << typeid(A).name() << " and "
                       << typeid(B).name());
    REQUIRE((impact || !hit));
    if (!hit) continue;
    // Never past the first touch, which is at most a unit beyond the distance.
    const auto way = impact->time * sweep.end.x;
    REQUIRE(way <= hit->distance + S::from_raw(1));
  }
}

TEMPLATE_TEST_CASE("time of impact: without a turn, never past the hit of a cast", "[toi]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  oracle::Bodies<S, N> bodies(0xca57);
  HitRate hits;
  compare_with_casts<Sphere<S, N>, Sphere<S, N>>(bodies, hits);
  compare_with_casts<Aabb<S, N>, Aabb<S, N>>(bodies, hits);
  INFO(hits);
  CHECK((hits.percent() > 30 && hits.percent() < 99));
}

TEMPLATE_TEST_CASE("time of impact: empty shapes touch nothing", "[toi]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> ball{{}, S(1)}, none{{}, S(-1)};
  const auto rests = from_to<S, N>(0, 0, 0, 0);
  CHECK(time_of_impact(ball, rests, ball, rests));
  CHECK_FALSE(time_of_impact(none, rests, ball, rests));
  CHECK_FALSE(time_of_impact(ball, rests, none, rests));
  CHECK_FALSE(time_of_impact(ball, rests, ConvexHull<S, N>{}, rests));
  CHECK_FALSE(time_of_impact(Aabb<S, N>{filled<S, N>(S(1)), {}}, rests, ball, rests));
  CHECK_FALSE(time_of_impact(Obb<S, N>{{}, filled<S, N>(S(-1)), {}}, rests, ball, rests));
}

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

constexpr bool is_constant() {
  using S = q16_16;
  const Sphere<S, 2> ball{{}, S(1)};
  const Sweep<S, 2> rests{{}, {}}, flies{{S(-5), S(0)}, {S(3), S(0)}};
  const auto impact = time_of_impact(ball, flies, ball, rests);
  return impact && impact->is_hit && impact->time <= quotient_floor<q16_16>(3, 8);
}
static_assert(is_constant());

}  // namespace
}  // namespace detent::test
