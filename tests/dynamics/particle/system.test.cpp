// SPDX-License-Identifier: MIT
#include "detent/dynamics/particle/system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "detent/dynamics/particle/snapshot.hpp"
#include "detent/number/literals.hpp"
#include "detent/query/overlaps.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {

using namespace literals;

namespace {

using S = q16_16;
using Point = Vec<S, 2>;
using Box = Obb<S, 2>;
using System = ParticleSystem<S, 2>;

Box box_at(double x, double y, double half_width, double half_height, double angle = 0) {
  return {at<S, 2>(x, y), at<S, 2>(half_width, half_height),
          Rotation<S, 2>::from_angle(Angle<S>::from_radians(num<S>(angle)))};
}

ParticleOptions<S, 2> moving(double vx, double vy, double radius) {
  ParticleOptions<S, 2> options;
  options.velocity = at<S, 2>(vx, vy);
  options.radius = num<S>(radius);
  return options;
}

/// A room of 6 by 6 around (x, y) with a rotated box in it.
std::array<Box, 5> room(const Point& by = {}) {
  std::array<Box, 5> boxes{box_at(0, -4, 5, 1), box_at(-4, 0, 1, 5), box_at(4, 0, 1, 5),
                           box_at(0, 4, 5, 1), box_at(0.5, -1, 1, 0.25, 0.5)};
  for (auto& box : boxes) box = translated(box, by);
  return boxes;
}

System swarm(Integrator integrator, double restitution, const Point& by = {}) {
  ParticleSettings<S, 2> settings;
  settings.integrator = integrator;
  settings.restitution = num<S>(restitution);
  settings.friction = num<S>(0.1);
  System system(settings);
  for (int i = 0; i < 12; ++i) {
    const auto start = at<S, 2>(-2.5 + 0.4 * i, 2.2 - 0.1 * (i % 4));
    REQUIRE(system.add(nearest_to<S>(start + by),
                       moving(7 * i - 40, 30 - 11 * i, i % 3 == 0 ? 0 : 0.04 * i)));
  }
  return system;
}

/// The energy of all particles, with unit mass and gravity (0, -10).
double energy(const System& system) {
  double sum = 0;
  for (ParticleIndex i = 0; i < system.size(); ++i) {
    const auto v = system.velocity(i);
    sum += (std::pow(static_cast<double>(v.x), 2) + std::pow(static_cast<double>(v.y), 2)) / 2;
    sum += 10 * (static_cast<double>(system.position(i).y) + 3);
  }
  return sum;
}

/// Steps a particle on a slope of 0.4 radians for a second. Returns how far it slides.
double slide(Integrator integrator, double friction) {
  ParticleSettings<S, 2> settings;
  settings.integrator = integrator;
  settings.friction = num<S>(friction);
  System system(settings);
  REQUIRE(system.add(at<S, 2>(-std::sin(0.4) * 1.06, std::cos(0.4) * 1.06)));
  const Box slope = box_at(0, 0, 20, 1, 0.4);
  for (int t = 0; t < 30; ++t) system.step(obstacles<S, 2>(slope));
  const auto before = system.position(0);
  for (int t = 0; t < 60; ++t) system.step(obstacles<S, 2>(slope));
  return static_cast<double>(length(system.position(0) - before));
}

}  // namespace

TEST_CASE("particles: a bullet never passes a thin plate") {
  const Box plate = box_at(0, 0, 50, 0.01, 0.1);
  Random random(7);
  for (const auto integrator : {Integrator::verlet, Integrator::euler}) {
    ParticleSettings<S, 2> settings;
    settings.integrator = integrator;
    settings.gravity = {};
    settings.restitution = num<S>(0.5);
    System system(settings);
    for (int i = 0; i < 60; ++i) {
      const auto unit = [&] { return static_cast<double>(random.below(1000)) / 1000; };
      const double side = i % 2 == 0 ? 1 : -1;
      const auto bullet = moving(900 * unit() - 450, -side * (100 + 400 * unit()), i % 3 * 0.05);
      REQUIRE(system.add(at<S, 2>(20 * unit() - 10, side * (2 + 4 * unit())), bullet));
    }
    for (int t = 0; t < 20; ++t) {
      system.step(obstacles<S, 2>(plate));
      for (ParticleIndex i = 0; i < system.size(); ++i) {
        CAPTURE(t, i);
        REQUIRE_FALSE(overlaps(system.ball(i), plate));
        const auto p = system.position(i);
        const auto height = dot(plate.rotation.axis(1), p);
        const bool is_above = height > 0;
        if (abs(p.x) < 45_q16_16) REQUIRE(is_above == (i % 2 == 0));
      }
    }
  }
}

TEST_CASE("particles: in a room they stay outside every box and lose energy") {
  const auto boxes = room();
  for (const auto integrator : {Integrator::verlet, Integrator::euler}) {
    auto system = swarm(integrator, 0.9);
    const auto start = energy(system);
    auto before = start;
    for (int t = 0; t < 600; ++t) {
      system.step(obstacles<S, 2>(boxes));
      for (ParticleIndex i = 0; i < system.size(); ++i) {
        for (const auto& box : boxes) REQUIRE_FALSE(overlaps(system.ball(i), box));
        REQUIRE(abs(system.position(i).x) <= 3_q16_16);
        REQUIRE(abs(system.position(i).y) <= 3_q16_16);
      }
      const auto now = energy(system);
      CAPTURE(t, before, now);
      REQUIRE(now <= before * 1.0001 + 0.02);
      before = now;
    }
    CHECK(before < start / 10);
  }
}

TEST_CASE("particles: golden digests of Verlet and Euler") {
  const auto boxes = room();
  const auto after = [&](Integrator integrator) {
    auto system = swarm(integrator, 0.7);
    for (int t = 0; t < 120; ++t) system.step(obstacles<S, 2>(boxes));
    return digest(system);
  };
  CHECK(after(Integrator::verlet) == 0x8923a852f34ebb53u);
  CHECK(after(Integrator::euler) == 0xe54584ea3f864484u);
}

TEST_CASE("particles: the far corner of the world gives the same bits, shifted") {
  const auto run = [](const Point& by) {
    auto system = swarm(Integrator::verlet, 0.6, by);
    const auto boxes = room(by);
    for (int t = 0; t < 100; ++t) system.step(obstacles<S, 2>(boxes));
    Digest digest;
    for (const auto& particle : detail::ParticleAccess::particles(system)) {
      digest.add(particle.place - make_vec<2>([&](int i) { return by[i]; }), particle.velocity);
    }
    return digest.value();
  };
  const auto here = run({});
  CHECK(run({32000_q16_16, -32000_q16_16}) == here);
  CHECK(run({S::from_raw(-1234567891), S::from_raw(77)}) == here);
}

TEST_CASE("particles: friction holds on a slope exactly when it suffices") {
  for (const auto integrator : {Integrator::verlet, Integrator::euler}) {
    CHECK(slide(integrator, 0.6) < 1e-3);  // tan 0.4 = 0.42
    CHECK(slide(integrator, 0.3) > 0.5);
    // Sliding from rest at t = 0.5 s: 10 (sin 0.4 - 0.3 cos 0.4) (1.5^2 - 0.5^2) / 2 = 1.13.
    CHECK(std::fabs(slide(integrator, 0.3) - 1.13) < 0.2);
  }
}

TEST_CASE("particles: restitution is the fraction of the speed that comes back") {
  for (const auto integrator : {Integrator::verlet, Integrator::euler}) {
    ParticleSettings<S, 2> settings;
    settings.integrator = integrator;
    settings.restitution = 0.5_q16_16;
    settings.gravity = {};
    System system(settings);
    const Box floor = box_at(0, -1, 5, 1);
    REQUIRE(system.add(at<S, 2>(0, 1), moving(0, -8, 0.1)));
    REQUIRE(system.add(at<S, 2>(1, 0.2), moving(0, -0.5, 0.1)));  // below the threshold
    for (int t = 0; t < 60; ++t) system.step(obstacles<S, 2>(floor));
    CHECK(std::fabs(static_cast<double>(system.velocity(0).y) - 4) < 0.01);
    CHECK(std::fabs(static_cast<double>(system.velocity(1).y)) < 0.01);
  }
}

TEST_CASE("particles: a shape that moves onto them pushes them out to rest") {
  ParticleSettings<S, 2> settings;
  settings.gravity = {};
  System system(settings);
  for (int i = 0; i < 5; ++i) REQUIRE(system.add(at<S, 2>(0.1 * i, 0.3)));
  Sphere<S, 2> ball{at<S, 2>(0.2, -0.5), 0.5_q16_16};
  const Box lid = box_at(0.2, 0.75, 5, 0.25);
  for (int t = 0; t < 40; ++t) {
    ball.center.y = nearest_to<S>(ball.center.y + num<S>(0.01));
    system.step(obstacles<S, 2>(ball, lid));
    for (ParticleIndex i = 0; i < system.size(); ++i) {
      REQUIRE_FALSE(overlaps(system.ball(i), lid));  // even without room
    }
  }
  CHECK_FALSE(overlaps(system.ball(0), ball));
  CHECK_FALSE(overlaps(system.ball(4), ball));
  CHECK(system.velocity(0) == Point());
  CHECK(system.position(0).x < 0_q16_16);
}

TEST_CASE("particles: a shape that moves onto one does not push it through another shape") {
  System system;
  REQUIRE(system.add(at<S, 2>(0, 0)));
  const Box plate = box_at(0, 0.1, 5, 0.01);
  const Sphere<S, 2> ball{at<S, 2>(0, -0.2), 0.5_q16_16};
  system.step(obstacles<S, 2>(plate, ball));
  CHECK(system.position(0).y < 0.1_q16_16);
  CHECK_FALSE(overlaps(system.ball(0), plate));
  system.step(obstacles<S, 2>(ball));
  CHECK(system.position(0).y > 0.3_q16_16);
}

TEST_CASE("particles: a pinned particle follows its point") {
  System system;
  const auto pin = system.add(at<S, 2>(1, 1));
  REQUIRE(pin);
  system.set_pinned(*pin, true);
  for (int t = 1; t < 50; ++t) {
    const auto point = at<S, 2>(1 + 0.03 * t, 1 - 0.07 * t);
    system.move_to(*pin, point);
    system.step();
    REQUIRE(system.position(*pin) == point);
    REQUIRE(system.velocity(*pin) == Point());
  }
  const auto held = system.position(*pin);
  system.step();
  CHECK(system.position(*pin) == held);
  system.set_pinned(*pin, false);
  system.step();
  CHECK(system.position(*pin).y < held.y);
}

TEMPLATE_TEST_CASE("particles: nothing overflows at the ends of the range", "", q16_16, q24_8,
                   q8_8) {
  using T = TestType;
  ParticleSettings<T, 2> settings;
  settings.gravity = {largest<T>, lowest<T>};
  settings.friction = largest<T>;
  settings.restitution = largest<T>;
  settings.damping = lowest<T>;
  for (const auto integrator : {Integrator::verlet, Integrator::euler}) {
    settings.integrator = integrator;
    ParticleSystem<T, 2> system(settings);
    ParticleOptions<T, 2> options;
    const std::array<T, 4> extremes{lowest<T>, largest<T>, T(0), T(1)};
    for (int i = 0; i < 16; ++i) {
      options.velocity = {extremes[static_cast<std::size_t>(i % 4)],
                          extremes[static_cast<std::size_t>(i / 4)]};
      options.mass = i % 3 == 0 ? largest<T> : detail::grid_step<T>();
      options.radius = i % 5 == 0 ? largest<T> : T(i % 2);
      REQUIRE(system.add(
          {extremes[static_cast<std::size_t>(i / 4)], extremes[static_cast<std::size_t>(i % 4)]},
          options));
    }
    for (std::uint32_t i = 0; i < 16; ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        const T length = (i + j) % 3 == 0 ? lowest<T> : largest<T>;
        const T frequency = (i * j) % 5 == 0 ? largest<T> : T(0);
        REQUIRE(system.add(DistanceConstraint<T>{i, j, length, frequency, (i ^ j) % 4 == 1}));
      }
    }
    system.set_pinned(3, true);
    system.move_to(3, {lowest<T>, largest<T>});
    const Sphere<T, 2> ball{{}, T(3)};
    const Obb<T, 2> box{{T(5), T(5)}, {T(1), T(1)}, {}};
    for (int t = 0; t < 12; ++t) system.step(obstacles<T, 2>(ball, box));
    CHECK(system.size() == 16);
  }
}

}  // namespace detent::test
