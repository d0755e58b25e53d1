// SPDX-License-Identifier: MIT
//
// Rolling resistance. tests/dynamics/twin compares its bits with a second implementation.
#include "detent/dynamics/rolling.hpp"

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "detent/dynamics/fields.hpp"
#include "detent/scene/difference.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"
#include "support/seal.hpp"

namespace detent::test {
namespace {

template <Scalar S, int N>
using Rollers = World<S, N, Sphere, Capsule, Obb, BodyCompound>;

template <Scalar S, int N>
WorldSettings<S, N> restless() {
  WorldSettings<S, N> settings;
  settings.sleep_speed = {};
  return settings;
}

/// The floor, whose top is at y = 0.
template <Scalar S, int N>
void add_floor(Rollers<S, N>& world, double resistance = 0) {
  BodyOptions<S, N> fixed;
  fixed.motion = BodyMotion::fixed;
  fixed.rolling_resistance = num<S>(resistance);
  (void)world.add(box_of<S, N>(0, -1, 100, 1), fixed);
}

/// A ball of radius 1/2 on the floor that rolls along x at `speed`.
template <Scalar S, int N>
BodyId add_rolling(Rollers<S, N>& world, double speed, double resistance) {
  BodyOptions<S, N> options;
  options.rolling_resistance = num<S>(resistance);
  options.velocity = at<S, N>(speed, 0);
  options.angular_velocity[N == 2 ? 0 : 2] = num<S>(-2 * speed);
  return world.add(Sphere<S, N>{at<S, N>(0, 0.5), num<S>(0.5)}, options).value_or(no_object);
}

template <class World>
void step(World& world, int ticks) {
  for (int t = 0; t < ticks; ++t) world.step();
}

/// Over how many units, and for how many ticks, a ball rolls.
struct Way {
  double length = 0;
  int ticks = 0;
};
template <Scalar S, int N>
Way way(double speed, double resistance) {
  Rollers<S, N> world(restless<S, N>());
  add_floor(world);
  const auto ball = add_rolling(world, speed, resistance);
  Way way;
  for (int t = 1; t <= 600; ++t) {
    world.step();
    if (std::fabs(static_cast<double>(world.velocity(ball).x)) > 0.005) way.ticks = t;
  }
  way.length = static_cast<double>(world.position(ball).x);
  return way;
}

/// A heap of balls and capsules, of which every fourth has no resistance of its own.
template <Scalar S, int N>
Rollers<S, N> heap(double resistance, double of_floor = 0) {
  Rollers<S, N> world;
  add_floor(world, of_floor);
  BodyOptions<S, N> options;
  for (int i = 0; i < 12; ++i) {
    options.rolling_resistance = num<S>(i % 4 == 3 ? 0 : resistance);
    auto a = at<S, N>(0.3 * (i % 3), 0.5 + 0.9 * i),
         b = at<S, N>(0.3 * (i % 3) + 0.4, 0.6 + 0.9 * i);
    a[N - 1] = N == 3 ? num<S>(0.2 * (i % 4)) : a[N - 1];
    if (i % 2 == 0) {
      (void)world.add(Sphere<S, N>{a, num<S>(0.4)}, options);
    } else {
      (void)world.add(Capsule<S, N>{a, b, num<S>(0.3)}, options);
    }
  }
  return world;
}

}  // namespace

TEST_CASE("rolling: a ball stops after the distance that its resistance gives") {
  // The torque R r m g slows by R g / (1 + k^2 / r^2) a second.
  const auto check = [](const Way& way, double inertia) {
    const double slowing = 0.05 * 10 / (1 + inertia);
    CAPTURE(way.length, way.ticks);
    CHECK(std::fabs(way.length - 2 * 2 / (2 * slowing)) < 0.05);
    CHECK(std::fabs(way.ticks / 60.0 - 2 / slowing) < 0.1);
  };
  check(way<q16_16, 2>(2, 0.05), 0.5);
  check(way<q16_16, 3>(2, 0.05), 0.4);
  check(way<double, 2>(2, 0.05), 0.5);
  check(way<double, 3>(2, 0.05), 0.4);
}

TEST_CASE("rolling: without resistance, or with a negative one, a ball rolls on") {
  CHECK(way<q16_16, 3>(2, 0).ticks == 600);
  CHECK(way<q16_16, 3>(2, -1).ticks == 600);
  CHECK(way<q16_16, 3>(2, 0).length > 19.9);
}

TEST_CASE("rolling: spin about the normal stops too") {
  using S = q16_16;
  Rollers<S, 3> world(restless<S, 3>());
  add_floor(world);
  BodyOptions<S, 3> options;
  options.rolling_resistance = num<S>(0.05);
  options.angular_velocity = {S(0), S(10), S(0)};
  const auto ball = *world.add(Sphere<S, 3>{at<S, 3>(0, 0.5), num<S>(0.5)}, options);
  step(world, 120);  // R g / (0.4 r) = 2.5 a second less
  CHECK(std::fabs(static_cast<double>(world.angular_velocity(ball)[1]) - 5) < 0.1);
  step(world, 180);
  for (const auto& w : world.angular_velocity(ball)) CHECK(abs(w) <= num<S>(1e-3));
}

TEST_CASE("rolling: a ball stays on a slope that is less steep than its resistance") {
  using S = q16_16;
  const auto moved = [](double slope, double resistance) {
    auto settings = restless<S, 2>();
    settings.gravity = at<S, 2>(10 * slope, -10);
    Rollers<S, 2> world(settings);
    add_floor(world, resistance);
    const auto ball = add_rolling(world, 0, 0);
    step(world, 60);
    const auto start = world.position(ball).x;
    step(world, 600);
    return std::fabs(static_cast<double>(world.position(ball).x - start));
  };
  CHECK(moved(0.09, 0.1) < 1e-3);
  CHECK(moved(0.11, 0.1) > 1);
}

TEST_CASE("rolling: the greater resistance and the lesser radius of two bodies count") {
  using S = q16_16;
  using Body = detail::BodyRecord<S, 3, detail::OneOf<Sphere<S, 3>, Capsule<S, 3>, Obb<S, 3>>>;
  const auto body = [](const auto& shape, double resistance) {
    Body made;
    made.shape = decltype(made.shape)(shape);
    made.rolling_resistance = num<S>(resistance);
    return made;
  };
  const auto small = body(Sphere<S, 3>{{}, S(1)}, 0.25);
  const auto large = body(Capsule<S, 3>{{}, at<S, 3>(1, 0), S(50)}, 0.5);
  const auto box = body(box_of<S, 3>(0, 0, 1, 1), 0.125);
  const auto point = body(Sphere<S, 3>{{}, S(0)}, 1);
  const detail::RollingContact<S, 3> contact;
  const auto check = [&](const Body& a, const Body& b, double resistance, double radius) {
    for (const auto& limit :
         {detail::rolling_limit<S, 3>(a, b, contact), detail::rolling_limit<S, 3>(b, a, contact)}) {
      CHECK(limit.resistance == num<S>(resistance));
      CHECK(limit.radius == num<S>(radius));
      CHECK(limit.is_any() == (radius > 0));
    }
  };
  check(small, large, 0.5, 1);
  check(small, box, 0.25, 1);
  check(large, box, 0.5, 50);
  check(box, box, 0.125, 0);
  check(point, small, 1, 0);
}

TEST_CASE("rolling: a pass removes no more rotational energy than there is") {
  // A long capsule at an angle, whose inertia mixes the axes, on another one.
  using S = q16_16;
  for (int k = 0; k < 40; ++k) {
    Rollers<S, 3> world;
    BodyOptions<S, 3> options;
    options.rolling_resistance = S(1);
    options.angular_velocity = {S(k % 7 - 3), S(k % 5 - 2), S(k % 3 - 1)};
    const auto c = [&](int i) { return num<S>(0.25 * ((k * 7 + i * 5) % 9) - 1); };
    (void)world.add(Capsule<S, 3>{{c(0), c(1), c(2)}, {c(3), c(4), c(5)}, num<S>(0.1)}, options);
    (void)world.add(Capsule<S, 3>{{c(6), c(7), c(8)}, {c(9), c(2), c(5)}, num<S>(0.3)}, options);
    auto& bodies = detail::WorldAccess::bodies(world);
    using F = detail::Formats<S>;
    std::array<detail::Support<S, 3>, 2> support{};
    std::array<detail::Moving<S, 3>, 2> moving{};
    for (std::size_t i = 0; i < 2; ++i) {
      support[i] = detail::support_of<S, 3>(bodies[i]);
      moving[i].spin = bodies[i].state.spin;
    }
    moving[1].spin = {};
    const auto half = detail::dyadic<S>(1 << 29);
    const detail::RollingLimit<S> limit{S(1), num<S>(0.1)};
    const auto rolling =
        detail::prepare_rolling<S, 3>(limit, detail::share_of<S, 3>(support[0].spread, half),
                                      detail::share_of<S, 3>(support[1].spread, half));
    detail::ReadyContact<S, 3> ready;
    ready.count = 1;
    detail::ContactRows<S, 3> rows;
    rows.rolling = &rolling;
    detail::RollingContact<S, 3> contact;
    contact.pressure[0] = F::Impulse::assume_raw(1 << 30);
    double before = 1e9;
    for (int pass = 0; pass < 30; ++pass) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double w = static_cast<double>(moving[1].spin[i] - moving[0].spin[i]);
        sum += w * w;
      }
      CAPTURE(k, pass, sum, before);
      REQUIRE(sum <= before * (1 + 1e-6) + 1e-15);
      before = sum;
      detail::solve_rolling(ready, rows, contact, moving[0], moving[1]);
    }
  }
}

TEST_CASE("rolling: parts of compounds have their own resistance") {
  using S = q16_16;
  const auto rolled = [](double resistance) {
    Rollers<S, 2> world(restless<S, 2>());
    add_floor(world);
    PartOptions<S> options;
    options.rolling_resistance = num<S>(resistance);
    const std::array parts{BodyPart(Sphere<S, 2>{{}, num<S>(0.5)}, options),
                           BodyPart(box_of<S, 2>(0, 0, 0.1, 0.1))};
    const auto solid = solid_compound(1, parts).value();
    BodyOptions<S, 2> moving;
    moving.rolling_resistance = S(1);  // that of its parts counts
    moving.velocity = at<S, 2>(2, 0);
    moving.angular_velocity = {S(-4)};
    const auto body = *world.add(BodyCompound<S, 2>{&solid, at<S, 2>(0, 0.5), {}}, moving);
    step(world, 300);
    return static_cast<double>(world.position(body).x);
  };
  CHECK(rolled(0) > 9.9);
  CHECK(rolled(0.1) < 4);
}

TEST_CASE("rolling: a compound without it keeps its earlier digest") {
  using S = q16_16;
  PartOptions<S> options, sensor;
  sensor.is_sensor = true;
  const auto digest_with = [&](const PartOptions<S>& first, const PartOptions<S>& second) {
    const std::array parts{BodyPart(Sphere<S, 2>{{}, S(1)}, first),
                           BodyPart(box_of<S, 2>(0, 1, 1, 1), second)};
    return solid_compound(1, parts).value().digest();
  };
  const auto without = digest_with(options, sensor);
  CHECK(without == 0x1706cb89c858178cu);
  options.rolling_resistance = num<S>(0.5);
  const auto first = digest_with(options, sensor);
  sensor.rolling_resistance = num<S>(0.5);
  CHECK(first != without);
  CHECK(digest_with({}, sensor) != without);
  CHECK(digest_with({}, sensor) != first);
}

TEMPLATE_TEST_CASE("rolling: a world restores bit by bit, and its impulses are state", "", q16_16,
                   double) {
  using S = TestType;
  const auto exam = [](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    auto world = heap<S, N>(0.1);
    step(world, 100);
    Rollers<S, N> fresh;
    add_floor(fresh);
    const auto bytes = snapshot(world);
    REQUIRE(restore(fresh, bytes) == Restored::yes);
    CHECK(snapshot(fresh) == bytes);
    auto without = world;
    bool has_any = false;
    for (auto& contact : detail::WorldAccess::contacts(without)) {
      for (auto& impulse : contact.rolling) {
        has_any = has_any || abs(impulse) > 0;
        impulse = {};
      }
    }
    CHECK(has_any);
    CHECK(digest(without) != digest(world));
    for (int t = 0; t < 100; ++t) {
      step(world, 1);
      step(fresh, 1);
      step(without, 1);
      REQUIRE(digest(world) == digest(fresh));
    }
    CHECK(digest(without) != digest(world));
  };
  exam(std::integral_constant<int, 2>());
  exam(std::integral_constant<int, 3>());
}

TEST_CASE("rolling: a snapshot has no bytes for it without resistance") {
  using S = q16_16;
  const auto size = [](double ball, double floor) {
    Rollers<S, 3> world;
    add_floor(world, floor);
    (void)add_rolling(world, 1, ball);
    step(world, 3);
    REQUIRE(detail::WorldAccess::contacts(world).size() == 1);
    return snapshot(world).size();
  };
  const auto without = size(0, 0);
  CHECK(size(0.1, 0) - without == 4 + 12);
  CHECK(size(0, 0.1) - without == 12);  // of fixed bodies there is a digest
  CHECK(size(-0.1, 0) - without == 4);
}

TEST_CASE("rolling: every accepted snapshot is canonical") {
  auto world = heap<q16_16, 3>(0.1);
  step(world, 60);
  const auto good = snapshot(world);
  Rollers<q16_16, 3> fresh;
  add_floor(fresh);
  int refused = 0, accepted = 0;
  for (std::size_t i = 0; i + 8 < good.size(); ++i) {
    auto bytes = good;
    bytes[i] ^= static_cast<std::byte>(1 << i % 8);
    seal(bytes);
    auto target = fresh;
    if (restore(target, bytes) == Restored::yes) {
      ++accepted;
      REQUIRE(snapshot(target) == bytes);
    } else {
      ++refused;
    }
  }
  CHECK(refused > 200);
  CHECK(accepted > 200);
}

TEST_CASE("rolling: a difference names the resistance and the impulse") {
  auto world = heap<q16_16, 2>(0.1);
  step(world, 60);
  auto other = world;
  detail::WorldAccess::bodies(other)[1].rolling_resistance = {};
  for (auto& contact : detail::WorldAccess::contacts(other)) {
    if (contact.a == 0 && contact.b == 1) contact.rolling[0] = {};
  }
  std::vector<std::string> names;
  const auto count = diff(
      world, other,
      [&](const FieldDifference& difference) { names.emplace_back(difference.field.view()); },
      std::size_t{8});
  CHECK(count == 2);
  CHECK(names == std::vector<std::string>{"body 1:2 (sphere) rolling_resistance",
                                          "contact 0:1 1:2 rolling[0]"});
}

TEST_CASE("rolling: threads and a bounded world have the same bits") {
  auto world = heap<q16_16, 3>(0.1), other = world;
  const auto backward = [](std::size_t count, const auto& f) {
    for (std::size_t i = count; i-- > 0;) f(i);
  };
  BoundedWorld<Bounded<16>, q16_16, 3, Sphere, Capsule, Obb, BodyCompound> bounded;
  BodyOptions<q16_16, 3> fixed;
  fixed.motion = BodyMotion::fixed;
  (void)bounded.add(box_of<q16_16, 3>(0, -1, 100, 1), fixed);
  REQUIRE(restore(bounded, snapshot(world)) == Restored::yes);
  for (int t = 0; t < 150; ++t) {
    world.step();
    other.step(backward);
    bounded.step();
    REQUIRE(digest(world) == digest(other));
    REQUIRE(digest(world) == digest(bounded));
  }
}

TEST_CASE("rolling: a heap of balls and capsules sleeps") {
  auto world = heap<q16_16, 3>(0.05, 0.05);
  const auto sleeps = [&] {
    for (std::uint32_t i = 1; i <= 12; ++i) {
      if (!world.is_asleep({i, i + 1})) return false;
    }
    return true;
  };
  int ticks = 0;
  for (; ticks < 900 && !sleeps(); ++ticks) world.step();
  CAPTURE(ticks);
  CHECK(ticks < 900);
}

}  // namespace detent::test
