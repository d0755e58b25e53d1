// SPDX-License-Identifier: MIT
#include "detent/query/time_of_impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "detent/query/distance/pair.hpp"
#include "detent/shape/moved.hpp"
#include "oracle/impact_exam.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

// A sweep in the xy plane, also in 3D.
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

/// Whether the impact is at this time, or earlier by so little that the bodies nearly touch.
template <Scalar S>
bool is_about(const std::optional<Impact<S>>& impact, double time) {
  return impact && impact->is_hit && static_cast<double>(impact->time) <= time &&
         static_cast<double>(impact->time) > time - (is_coarse<S> ? 1.0 / 32 : 1.0 / 1024);
}

TEMPLATE_TEST_CASE("time of impact: a bullet does not pass through a thin plate", "[toi]",
                   DETENT_EVERYDAY_SPACES) {
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

TEMPLATE_TEST_CASE("time of impact: a rod hits by rotation alone", "[toi]",
                   DETENT_EVERYDAY_SPACES) {
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
  // In the opposite direction.
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

TEMPLATE_TEST_CASE("time of impact: touch at the start, no touch, and equal motion", "[toi]",
                   DETENT_EVERYDAY_SPACES) {
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
  // Moving together, one unit apart and rotating, they do not touch.
  const auto first = from_to<S, N>(-9, 0, 20, 3), second = from_to<S, N>(-6, 0, 23, 3);
  CHECK_FALSE(time_of_impact(ball, first, box, second));
  auto spins = first;
  spins.end_rotation = turned<S, N>(3, 8);
  CHECK_FALSE(time_of_impact(ball, spins, box, second));
}

TEMPLATE_TEST_CASE("time of impact: grazing contact is decided to within the target", "[toi]",
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

TEMPLATE_TEST_CASE("time of impact: a plane is hit from either side", "[toi]",
                   DETENT_EVERYDAY_SPACES) {
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
  // A rod along the plane turns upright: its end is 5 sin(a) away, and a at t is as above.
  const Capsule<S, N> rod{at<S, N>(0, -5), at<S, N>(0, 5), S(0)};
  auto turn = from_to<S, N>(0, 0, 0, 0);
  turn.end_rotation = turned<S, N>(1, 4);
  const double tangent = std::tan(std::asin(0.8) / 2), r = std::sqrt(0.5);
  CHECK(is_about(time_of_impact(rod, turn, wall), tangent / (r + tangent * (1 - r))));
}

TEMPLATE_TEST_CASE("time of impact: a shape given in world space is at rest", "[toi]",
                   DETENT_EVERYDAY_SPACES) {
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

TEMPLATE_TEST_CASE("time of impact: empty shapes touch nothing", "[toi]", DETENT_EVERYDAY_SPACES) {
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
