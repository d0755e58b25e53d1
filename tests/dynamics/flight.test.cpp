// SPDX-License-Identifier: MIT
#include "detent/dynamics/flight.hpp"

#include <cmath>
#include <cstdlib>

#include "detent/scene/one_of.hpp"
#include "support/catch.hpp"
#include "support/num.hpp"

namespace {

using namespace detent;
using test::num;

template <Scalar S, int N>
using BoxBody = detail::BodyRecord<S, N, detail::OneOf<Obb<S, N>>>;

/// A box with these half extents at the origin.
template <Scalar S, int N>
BoxBody<S, N> box_body(const Vec<S, N>& half_extents) {
  BoxBody<S, N> body;
  body.generation = 1;
  body.motion = BodyMotion::dynamic;
  body.density = S(1);
  const auto local = detail::local_form(Obb<S, N>{{}, half_extents, {}});
  body.shape = detail::OneOf<Obb<S, N>>(local.shape);
  body.state.orientation = local.orientation;
  detail::derive(body, 240);
  return body;
}

template <Scalar S, int N>
void fly(BoxBody<S, N>& body, detail::Moving<S, N>& moving, const detail::Pace<S, N>& pace,
         int substeps) {
  auto axes = detail::axes_of<S, N>(body.state.orientation), half_way = axes;
  const auto carry = [&](const auto& orientation, const auto& from, auto& to) {
    if constexpr (N == 3) {
      if (detail::tumbles(body)) detail::carry(body, moving, orientation, from, to);
    }
  };
  for (int i = 0; i < substeps; ++i) {
    auto& q = body.state.orientation;
    detail::accelerate(body, moving, pace);
    carry(detail::turned<S, N, 1>(q, moving.spin), axes, half_way);
    detail::move(body, moving);
    q = detail::turned<S, N, 0>(q, moving.spin);
    carry(q, half_way, axes);
  }
}

/// Twice the rotational energy in doubles: w . R K R^T w with the squared gyration K of a box.
template <Scalar S>
double spin_energy(const BoxBody<S, 3>& body, const detail::Moving<S, 3>& moving,
                   const std::array<double, 3>& half_extents) {
  const auto axes = detail::axes_of<S, 3>(body.state.orientation);
  double energy = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double w = 0;
    for (int k = 0; k < 3; ++k) {
      w += static_cast<double>(axes[i][k]) *
           static_cast<double>(moving.spin[static_cast<std::size_t>(k)]);
    }
    const double a = half_extents[(i + 1) % 3], b = half_extents[(i + 2) % 3];
    energy += w * w * (a * a + b * b) / 3;
  }
  return energy;
}

/// The greatest relative change of the energy of a spinning 1 x 2 x 4 box over this many substeps.
template <Scalar S>
double energy_error(const std::array<double, 3>& radians_per_second, int substeps) {
  const std::array<double, 3> half_extents = {0.5, 1, 2};
  auto body = box_body<S, 3>({num<S>(0.5), num<S>(1), num<S>(2)});
  WorldSettings<S, 3> settings;
  settings.gravity = {};
  const auto pace = detail::pace_of(settings);
  detail::Moving<S, 3> moving;
  for (std::size_t i = 0; i < 3; ++i) {
    moving.spin[i] = num<typename detail::Formats<S>::Spin>(radians_per_second[i] / 240);
  }
  const double before = spin_energy(body, moving, half_extents);
  double worst = 0;
  for (int i = 0; i < substeps; i += 10) {
    fly(body, moving, pace, 10);
    worst = (std::max)(worst, std::fabs(spin_energy(body, moving, half_extents) / before - 1));
  }
  return worst;
}

}  // namespace

TEMPLATE_TEST_CASE("flight: a reversed body retraces its path to the bit", "", q16_16, q14_16,
                   q24_8, q8_8) {
  using S = TestType;
  auto body = box_body<S, 2>({S(1), S(1)});
  const auto pace = detail::pace_of(WorldSettings<S, 2>());
  detail::Moving<S, 2> moving;
  using Speed = typename detail::Formats<S>::Speed;
  moving.velocity = {num<Speed>(0.0137), num<Speed>(0.0479)};
  const auto place = body.state.place;
  const auto start = moving.velocity;
  fly(body, moving, pace, 480);
  REQUIRE(!(body.state.place == place));
  // A substep adds gravity before it moves, so the first one back moves by -v.
  for (int i = 0; i < 2; ++i) {
    moving.velocity[i] = nearest_to<Speed>(-(moving.velocity[i] + pace.gravity[i]));
  }
  fly(body, moving, pace, 480);
  CHECK(body.state.place == place);
  CHECK(moving.velocity ==
        Vec<Speed, 2>{nearest_to<Speed>(-start.x), nearest_to<Speed>(-(start.y + pace.gravity.y))});
}

TEMPLATE_TEST_CASE("flight: a thrown body falls by the sum of its velocities", "", q16_16, q8_8,
                   double) {
  using S = TestType;
  auto body = box_body<S, 3>({S(1), S(1), S(1)});
  const auto pace = detail::pace_of(WorldSettings<S, 3>());
  detail::Moving<S, 3> moving;
  fly(body, moving, pace, 240);
  // -10 / 240^2 (1 + 2 + ... + 240)
  CHECK(std::fabs(static_cast<double>(body.state.place.y) + 10.0 * 240 * 241 / 2 / 57600) < 0.02);
}

TEMPLATE_TEST_CASE("flight: velocities and positions clamp at the ends of their formats", "",
                   q16_16, q8_8) {
  using S = TestType;
  using F = detail::Formats<S>;
  auto body = box_body<S, 2>({S(1), S(1)});
  WorldSettings<S, 2> settings;
  settings.gravity = {S::lowest(), (S::max)()};
  settings.ticks_per_second = settings.substeps = 1;
  detail::Moving<S, 2> moving;
  fly(body, moving, detail::pace_of(settings), 40000);
  CHECK(moving.velocity == Vec<typename F::Speed, 2>{F::Speed::lowest(), (F::Speed::max)()});
  CHECK(body.state.place == Vec<typename F::Place, 2>{F::Place::lowest(), (F::Place::max)()});
}

TEST_CASE("flight: a spinning box keeps its energy") {
  // Spins about the stable axes, and about the middle one, where it tumbles.
  CHECK(energy_error<q16_16>({10, 0.01, 0.02}, 20000) < 2e-5);
  CHECK(energy_error<q16_16>({0.05, 0.1, 10}, 20000) < 2e-5);
  CHECK(energy_error<q16_16>({0.01, 10, 0.01}, 20000) < 2e-2);
  CHECK(energy_error<q16_16>({3, 2, 6}, 20000) < 2e-2);
  CHECK(energy_error<double>({0.01, 10, 0.01}, 20000) < 2e-2);
}

TEST_CASE("flight: a cube keeps its spin, and orientations stay normalised") {
  auto body = box_body<q16_16, 3>({q16_16(1), q16_16(1), q16_16(1)});
  REQUIRE(body.inertia.is_round);
  const auto pace = detail::pace_of(WorldSettings<q16_16, 3>());
  detail::Moving<q16_16, 3> moving;
  using Spin = detail::Formats<q16_16>::Spin;
  moving.spin = {num<Spin>(0.3), num<Spin>(-0.01), num<Spin>(0.002)};
  const auto spin = moving.spin;
  for (int i = 0; i < 1000; ++i) {
    fly(body, moving, pace, 1);
    REQUIRE(is_unit(to_array(body.state.orientation)));
  }
  CHECK(moving.spin == spin);
}

TEST_CASE("flight: damping removes its share in every substep") {
  auto body = box_body<q16_16, 2>({q16_16(1), q16_16(1)});
  body.linear_damping = q16_16(24);
  body.angular_damping = q16_16(1000);
  detail::derive(body, 240);
  WorldSettings<q16_16, 2> settings;
  settings.gravity = {};
  detail::Moving<q16_16, 2> moving;
  using Speed = detail::Formats<q16_16>::Speed;
  moving.velocity.x = Speed(1);
  moving.spin[0] = detail::Formats<q16_16>::Spin(1);
  fly(body, moving, detail::pace_of(settings), 1);
  CHECK(std::fabs(static_cast<double>(moving.velocity.x) - 0.9) < 1e-8);
  CHECK(moving.spin[0] == 0);  // all of it is lost
}
