// SPDX-License-Identifier: MIT
#include "detent/dynamics/particle/cloth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "detent/dynamics/particle/snapshot.hpp"
#include "detent/number/literals.hpp"
#include "detent/query/overlaps.hpp"
#include "dynamics/stage.hpp"
#include "dynamics/step_alike.hpp"
#include "support/catch.hpp"

namespace detent::test {

using namespace literals;

namespace {

template <Scalar S>
Vec<S, 3> point(double x, double y, double z) {
  return {num<S>(x), num<S>(y), num<S>(z)};
}

template <Scalar S, int N>
double distance_of(const Vec<S, N>& a, const Vec<S, N>& b) {
  double squared = 0;
  for (int i = 0; i < N; ++i) {
    const auto d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    squared += d * d;
  }
  return std::sqrt(squared);
}

template <class System>
double fastest(const System& system) {
  double most = 0;
  for (ParticleIndex i = 0; i < system.size(); ++i) {
    const auto v = system.velocity(i);
    most = (std::max)(most, distance_of(v, decltype(v)()));
  }
  return most;
}

/// Kinetic and potential energy of unit masses in gravity (0, -10, 0).
template <class System>
double energy(const System& system) {
  const auto& particles = detail::ParticleAccess::particles(system);
  const double rate = system.settings().ticks_per_second * system.settings().substeps;
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles[i].is_held()) continue;
    for (int k = 0; k < 3; ++k) {
      const auto v = static_cast<double>(particles[i].velocity[k]) * rate;
      sum += v * v / 2;
    }
    sum += 10 * static_cast<double>(particles[i].place.y);
  }
  return sum;
}

struct Draped {
  double fastest = 0, lowest = 9, closest = 9, edge = 0;
  int touching = 0;
  std::uint64_t digest = 0;
};

/// An 11 x 11 cloth that falls on a ball.
template <Scalar S>
Draped drape(int ticks) {
  ParticleSettings<S, 3> settings;
  settings.damping = S(2);
  ParticleSystem<S, 3> system(settings);
  FabricOptions<S, 3> linen;
  linen.bend = S(5);
  const auto cloth = add_cloth(system, point<S>(-1, 1.25, -1), point<S>(0.2, 0, 0),
                               point<S>(0, 0, 0.2), 11, 11, linen);
  REQUIRE(cloth);
  const Sphere<S, 3> ball{point<S>(0, 0, 0), S(1)};
  Draped result;
  for (int t = 0; t < ticks; ++t) {
    system.step(obstacles<S, 3>(ball));
    for (ParticleIndex i = 0; i < system.size(); ++i) {
      result.touching += overlaps(system.ball(i), ball) ? 1 : 0;
    }
  }
  for (ParticleIndex i = 0; i < system.size(); ++i) {
    const auto p = system.position(i);
    result.lowest = (std::min)(result.lowest, static_cast<double>(p.y));
    result.closest = (std::min)(result.closest, distance_of(p, ball.center));
  }
  for (std::uint32_t k = 1; k < 11; ++k) {
    result.edge +=
        distance_of(system.position(cloth->at(k, 0)), system.position(cloth->at(k - 1, 0)));
  }
  result.fastest = fastest(system);
  result.digest = digest(system);
  return result;
}

/// The greatest length beyond 4, from first to last particle and relative to 4, of a rope of 20
/// parts with a heavy end that falls for a second from level.
template <Scalar S>
double stretch(int mass, bool has_tethers) {
  ParticleSettings<S, 3> settings;
  settings.substeps = 8;
  ParticleSystem<S, 3> system(settings);
  FabricOptions<S, 3> cord;
  cord.has_tethers = has_tethers;
  const auto rope = add_rope(system, point<S>(0, 0, 0), point<S>(4, 0, 0), 21, cord);
  REQUIRE(rope);
  system.set_pinned(rope->first, true);
  ParticleOptions<S, 3> heavy;
  heavy.mass = S(mass);
  const auto end = system.add(point<S>(4, 0, 0), heavy);
  REQUIRE(end);
  REQUIRE(system.add(DistanceConstraint<S>{rope->last(), *end, S(0)}));
  if (has_tethers) {
    REQUIRE(system.add(DistanceConstraint<S>{rope->first, *end, S(4), S(0), true}));
  }
  double most = 0;
  for (int t = 0; t < 300; ++t) {
    system.step();
    if (t >= 60) most = (std::max)(most, distance_of(system.position(*end), Vec<S, 3>()));
  }
  return most / 4 - 1;
}

}  // namespace

TEST_CASE("cloth: it comes to rest over a ball and is never inside") {
  const auto fixed = drape<q16_16>(300), real = drape<double>(300);
  CAPTURE(fixed.fastest, fixed.lowest, fixed.closest, fixed.edge, real.fastest, real.lowest,
          real.closest, real.edge);
  CHECK(fixed.touching == 0);
  CHECK(fixed.closest >= 1.05 - 1e-4);
  CHECK(fixed.closest < 1.0505);
  CHECK(fixed.fastest < 0.02);
  CHECK(std::fabs(fixed.lowest - real.lowest) < 0.02);
  CHECK(std::fabs(fixed.edge - 2) < 0.04);
  CHECK(fixed.digest == 0xfd19c8b287163bb8u);
}

TEST_CASE("rope: its length stays within its bounds") {
  const auto light = stretch<q16_16>(1, false), heavy = stretch<q16_16>(100, false);
  const auto held = stretch<q16_16>(100, true);
  CAPTURE(light, heavy, held, stretch<double>(100, false), stretch<double>(100, true));
  CHECK(light > -0.001);
  CHECK(light < 0.02);
  CHECK(heavy > 0.08);
  CHECK(heavy < 0.12);
  CHECK(held < 1e-4);
  CHECK(std::fabs(heavy - stretch<double>(100, false)) < 0.001);
}

TEST_CASE("cloth: energy does not grow") {
  ParticleSystem<q16_16, 3> system;
  const auto cloth = add_cloth(system, point<q16_16>(0, 0, 0), point<q16_16>(0.25, 0, 0),
                               point<q16_16>(0, 0, 0.25), 8, 8);
  REQUIRE(cloth);
  system.set_pinned(cloth->at(0, 0), true);
  system.set_pinned(cloth->at(7, 0), true);
  const double start = energy(system);
  double peak = start;
  for (int second = 0; second < 8; ++second) {
    double most = -1e9;
    for (int t = 0; t < 60; ++t) {
      system.step();
      most = (std::max)(most, energy(system));
    }
    CAPTURE(second, peak);
    CHECK(most <= peak + 1e-3);
    peak = most;
  }
  CHECK(peak < start - 50);
}

TEST_CASE("cloth: a tear releases the part that hung there") {
  ParticleSystem<q16_16, 3> system;
  const auto rope = add_rope(system, point<q16_16>(0, 0, 0), point<q16_16>(2, 0, 0), 5);
  REQUIRE(rope);
  system.set_pinned(rope->first, true);
  CHECK(system.constraint_count() == 4);
  CHECK(system.remove(3, 2));
  CHECK_FALSE(system.remove(2, 3));
  for (int t = 0; t < 60; ++t) system.step();
  CHECK(system.position(2).y > -1.1_q16_16);
  CHECK(system.position(3).y < -4_q16_16);
}

TEST_CASE("cloth: bits do not depend on the order in which constraints come and go") {
  ParticleSystem<q16_16, 3> plain, other;
  FabricOptions<q16_16, 3> linen, loose;
  linen.bend = 5_q16_16;
  loose.stretch = loose.shear = -1_q16_16;
  const auto corner = point<q16_16>(0, 0, 0), right = point<q16_16>(0.25, 0, 0),
             down = point<q16_16>(0, 0, 0.25);
  REQUIRE(add_cloth(plain, corner, right, down, 5, 4, linen));
  REQUIRE(add_cloth(other, corner, right, down, 5, 4, loose));
  CHECK(other.constraint_count() == 0);
  CHECK(other.add(DistanceConstraint<q16_16>{7, 19, 1_q16_16}));
  for (auto i = plain.constraint_count(); i-- > 0;) {
    auto constraint = plain.constraint(i);
    std::swap(constraint.a, constraint.b);
    REQUIRE(other.add(constraint));
    REQUIRE_FALSE(other.add(constraint));
  }
  CHECK(other.remove(19, 7));
  plain.set_pinned(0, true);
  other.set_pinned(0, true);
  step_alike(plain, other, 50);
}

TEST_CASE("cloth: what does not fit is not added, and what fits needs no heap") {
  BoundedParticleSystem<Bounded<30>, q16_16, 3> small;
  ParticleSystem<q16_16, 3> large;
  const auto a = point<q16_16>(0, 0, 0), b = point<q16_16>(0.25, 0, 0),
             c = point<q16_16>(0, -0.25, 0);
  CHECK_FALSE(add_cloth(small, a, b, c, 6, 6));
  CHECK_FALSE(add_cloth(small, a, b, c, 0xffffffffu, 0xffffffffu));
  CHECK_FALSE(add_cloth(small, a, b, c, 0, 6));
  CHECK_FALSE(add_rope(small, a, b, 31));
  CHECK_FALSE(add_rope(small, a, b, 1));
  CHECK(small.size() == 0);
  REQUIRE(add_cloth(small, a, b, c, 5, 6));
  REQUIRE(add_cloth(large, a, b, c, 5, 6));
  CHECK_FALSE(small.add(a));
  small.set_pinned(0, true);
  large.set_pinned(0, true);
  for (int t = 0; t < 30; ++t) {
    small.step();
    large.step();
  }
  CHECK(digest(small) == digest(large));
}

TEMPLATE_TEST_CASE("rope: hangs in every scalar", "", q16_16, q14_16, q24_8, q8_8, float, double) {
  using S = TestType;
  ParticleSettings<S, 2> settings;
  settings.damping = S(2);
  ParticleSystem<S, 2> system(settings);
  FabricOptions<S, 2> cord;
  cord.bend = S(4);
  const auto rope = add_rope(system, at<S, 2>(0, 0), at<S, 2>(3, 0), 7, cord);
  REQUIRE(rope);
  system.set_pinned(rope->first, true);
  for (int t = 0; t < 900; ++t) system.step();
  const auto end = system.position(rope->last());
  CHECK(std::fabs(static_cast<double>(end.x)) < 0.15);
  CHECK(std::fabs(static_cast<double>(end.y) + 3) < 0.05);
}

}  // namespace detent::test
