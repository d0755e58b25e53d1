// SPDX-License-Identifier: MIT
#include "detent/dynamics/fast.hpp"

#include <cmath>
#include <vector>

#include "detent/dynamics/fields.hpp"
#include "detent/number/literals.hpp"
#include "detent/scene/difference.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {

using namespace detent::literals;

namespace {

template <Scalar S, int N>
auto place_of(const auto& world, std::size_t body) {
  return detail::WorldAccess::bodies(world)[body].state.place;
}

/// Whether the segment from p to q meets the box around the origin with these half extents: exact,
/// by separating axes.
template <class P, Scalar S, int N>
bool meets(const Vec<P, N>& p, const Vec<P, N>& q, const Vec<S, N>& half_extents) {
  const auto d = q - p, c = p + q;
  for (int i = 0; i < N; ++i) {
    if (abs(c[i]) > abs(d[i]) + half_extents[i] + half_extents[i]) return false;
    for (int j = 0; j < i; ++j) {
      const auto reach = abs(d[i]) * half_extents[j] + abs(d[j]) * half_extents[i];
      if (abs(d[i] * c[j] - d[j] * c[i]) > reach + reach) return false;
    }
  }
  return true;
}

/// A ball of radius 0.05 at 500 units per second that starts 4.1 above a plate of thickness 0.02.
/// Returns its position after this many ticks.
template <Scalar S, int N>
Vec<S, N> shot(bool is_fast, int ticks, double bounce = 0, double x = 0) {
  WorldSettings<S, N> settings;
  settings.gravity = {};
  World<S, N, Sphere, Obb> world(settings);
  BodyOptions<S, N> options;
  options.motion = BodyMotion::fixed;
  (void)world.add(box_of<S, N>(0, 0, 3, 0.01), options);
  options.motion = BodyMotion::dynamic;
  options.velocity = at<S, N>(0, -500);
  options.restitution = num<S>(bounce);
  options.is_fast = is_fast;
  const auto ball = world.add(Sphere<S, N>{at<S, N>(x, 4.1), num<S>(0.05)}, options);
  for (int i = 0; i < ticks; ++i) world.step();
  return world.position(ball.value_or(no_object));
}

}  // namespace

TEMPLATE_TEST_CASE("fast: a ball at 500 units per second never passes a plate of 0.02", "", q16_16,
                   q14_16, q24_8, float, double) {
  using S = TestType;
  for (const double x : {0.0, 2.0, 2.99}) {
    for (const int ticks : {1, 2, 3, 60}) {
      CAPTURE(x, ticks);
      for (const double height : {static_cast<double>(shot<S, 2>(true, ticks, 0, x).y),
                                  static_cast<double>(shot<S, 3>(true, ticks, 0, x).y)}) {
        CHECK(height > 0.03);
        CHECK(height < 0.09);
      }
    }
  }
  CHECK(shot<S, 2>(false, 2).y < -4);
}

TEST_CASE("fast: a ball bounces off a plate at its full speed") {
  // One tick to the plate, one to turn, and one back.
  const auto y = static_cast<double>(shot<q16_16, 2>(true, 3, 0.5).y);
  CHECK(y > 4.2);
  CHECK(y < 4.3);
}

TEST_CASE("fast: a ball that meets nothing flies on unchanged") {
  CHECK(shot<q16_16, 3>(true, 3, 0, 3.2) == shot<q16_16, 3>(false, 3, 0, 3.2));
  // Flies along a plate, at a distance from it, for ten ticks.
  const auto along = [](bool is_fast) {
    WorldSettings<q16_16, 2> settings;
    settings.gravity = {};
    World<q16_16, 2, Sphere, Obb> world(settings);
    BodyOptions<q16_16, 2> options;
    options.motion = BodyMotion::fixed;
    (void)world.add(box_of<q16_16, 2>(0, 0, 90, 0.01), options);
    options.motion = BodyMotion::dynamic;
    options.velocity = at<q16_16, 2>(450, 0);
    options.is_fast = is_fast;
    (void)world.add(Sphere<q16_16, 2>{at<q16_16, 2>(-100, 0.1), num<q16_16>(0.05)}, options);
    for (int i = 0; i < 20; ++i) world.step();
    return place_of<q16_16, 2>(world, 1);
  };
  CHECK(along(true) == along(false));
}

namespace {

template <int N>
using Range = World<q16_16, N, Sphere, Capsule, Obb, BodyHull>;

template <int N>
struct Shots {
  using S = q16_16;
  Random random;
  std::vector<Vec<S, N>> corners;
  SolidHull<S, N> solid;

  explicit Shots(std::uint64_t seed) : random(seed) {
    for (int i = 0; i < 9; ++i) corners.push_back(point(0.1));
    corners.push_back({});
    const auto made = solid_hull(1, ConvexHull<S, N>{corners});
    REQUIRE(made);
    solid = *made;
  }
  S number(double most) {
    return num<S>(most * static_cast<double>(random.between(-1000, 1000)) / 1000);
  }
  Vec<S, N> point(double most) {
    return make_vec<N>([&](int) { return number(most); });
  }
  BodyOptions<S, N> bullet(const Vec<S, N>& velocity, bool is_fast) {
    BodyOptions<S, N> options;
    options.velocity = velocity;
    options.restitution = num<S>(0.25 * static_cast<double>(random.below(5)));
    for (auto& w : options.angular_velocity) w = number(20);
    options.is_fast = is_fast;
    return options;
  }
  /// Adds a ball, a box, a capsule or a hull about `p`.
  void add(Range<N>& world, const Vec<S, N>& p, const BodyOptions<S, N>& options) {
    const auto size = num<S>(0.02 + 0.01 * static_cast<double>(random.below(6)));
    const auto next = random.below(4);
    if (next == 0) (void)world.add(Sphere<S, N>{p, size}, options);
    if (next == 1) {
      auto half_extents = make_vec<N>([&](int) { return size; });
      half_extents[0] = num<S>(0.1);
      (void)world.add(Obb<S, N>{p, half_extents, {}}, options);
    }
    if (next == 2) {
      auto end = p;
      end[1] = nearest_to<S>(end[1] + num<S>(0.1));
      (void)world.add(Capsule<S, N>{p, end, size}, options);
    }
    if (next == 3) (void)world.add(BodyHull<S, N>{&solid, p, {}}, options);
  }
};

/// Shoots at thin plates and counts the bodies whose center passes one within 8 ticks. The path
/// relative to the plate is tested exactly.
template <int N>
int passing(std::uint64_t seed, bool is_fast, BodyMotion motion) {
  using S = q16_16;
  Shots<N> shots(seed);
  Range<N> world;
  const bool is_fixed = motion == BodyMotion::fixed;
  const int plates = is_fixed ? 3 : 1;
  std::vector<Vec<S, N>> sizes;
  for (int i = 0; i < plates; ++i) {
    auto half_extents = make_vec<N>([](int) { return num<S>(4); });
    const int thin = static_cast<int>(shots.random.below(N));
    half_extents[thin] = num<S>(0.01);
    BodyOptions<S, N> options;
    options.motion = motion;
    options.density = S(100);
    options.locked = AxisLock::turn;
    if (!is_fixed) options.velocity = shots.point(200);
    const auto center = shots.point(1);
    sizes.push_back(half_extents);
    (void)world.add(Obb<S, N>{center, half_extents, {}}, options);
  }
  for (int i = 0; i < 4; ++i) {
    // Start 6 to 9 units away, towards the plates.
    auto from = shots.point(9);
    const int axis = static_cast<int>(shots.random.below(N));
    from[axis] = num<S>(shots.random.coin() ? 7 : -7);
    const auto to = shots.point(2);
    const auto velocity = make_vec<N>([&](int k) {
      return num<S>((static_cast<double>(to[k]) - static_cast<double>(from[k])) * 45);
    });
    shots.add(world, from, shots.bullet(velocity, is_fast));
  }
  int count = 0;
  const auto& bodies = detail::WorldAccess::bodies(world);
  const auto places = [&] {
    std::vector<decltype(bodies[0].state.place)> result;
    for (std::size_t i = 0; i < bodies.size(); ++i) result.push_back(bodies[i].state.place);
    return result;
  };
  auto before = places();
  for (int t = 0; t < 8; ++t) {
    world.step();
    const auto now = places();
    for (std::size_t b = static_cast<std::size_t>(plates); b < now.size(); ++b) {
      for (std::size_t p = 0; p < sizes.size(); ++p) {
        count += meets(before[b] - before[p], now[b] - now[p], sizes[p]) ? 1 : 0;
      }
    }
    before = now;
  }
  return count;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("fast: none of thousands of shots passes a plate", "", ((int N), N), 2, 3) {
  constexpr std::uint64_t rounds = 150;
  for (const auto motion : {BodyMotion::fixed, BodyMotion::kinematic, BodyMotion::dynamic}) {
    int passed = 0;
    for (std::uint64_t seed = 0; seed < rounds; ++seed) {
      CAPTURE(seed, static_cast<int>(motion));
      REQUIRE(passing<N>(seed, true, motion) == 0);
      passed += passing<N>(seed, false, motion) > 0 ? 1 : 0;
    }
    CHECK(passed > static_cast<int>(rounds) / 3);
  }
}

TEST_CASE("fast: none of ten times as many shots passes a plate", "[.demand]") {
  for (const auto motion : {BodyMotion::fixed, BodyMotion::kinematic, BodyMotion::dynamic}) {
    for (std::uint64_t seed = 1000; seed < 2500; ++seed) {
      CAPTURE(seed, static_cast<int>(motion));
      REQUIRE(passing<2>(seed, true, motion) == 0);
      REQUIRE(passing<3>(seed, true, motion) == 0);
    }
  }
}

TEST_CASE("fast: a turning plate carries a sleeping ball along") {
  using S = q16_16;
  WorldSettings<S, 2> settings;
  settings.gravity = {};
  for (const bool is_fast : {true, false}) {
    World<S, 2, Sphere, Obb> world(settings);
    BodyOptions<S, 2> options;
    options.is_fast = is_fast;
    const auto ball = world.add(Sphere<S, 2>{at<S, 2>(2, 0.1), num<S>(0.05)}, options);
    for (int i = 0; i < 60; ++i) world.step();
    REQUIRE(world.is_asleep(*ball));
    options.motion = BodyMotion::kinematic;
    options.angular_velocity = {S(30)};
    (void)world.add(box_of<S, 2>(0, -0.3, 3, 0.01), options);
    for (int i = 0; i < 2; ++i) world.step();
    const auto p = world.position(*ball);
    CHECK((p.y > 0.5_q16_16) == is_fast);
    CHECK(world.is_asleep(*ball) != is_fast);
  }
}

TEST_CASE("fast: sensors, other layers, joined bodies and locked axes are respected") {
  using S = q16_16;
  WorldSettings<S, 2> settings;
  settings.gravity = {};
  const auto height = [&](const BodyOptions<S, 2>& plate, BodyOptions<S, 2> ball, bool join) {
    World<S, 2, Sphere, Obb, DistanceJoint> world(settings);
    const auto a = world.add(box_of<S, 2>(0, 0, 3, 0.01), plate);
    ball.velocity = at<S, 2>(3, -500);
    ball.is_fast = true;
    const auto b = world.add(Sphere<S, 2>{at<S, 2>(0, 4.1), num<S>(0.05)}, ball);
    if (join) {
      DistanceJoint<S, 2> rope;
      rope.a = *a;
      rope.b = *b;
      rope.most = S(100);
      REQUIRE(world.add(rope));
    }
    world.step();
    return world.position(*b);
  };
  BodyOptions<S, 2> fixed;
  fixed.motion = BodyMotion::fixed;
  CHECK(height(fixed, {}, false).y > 0);
  CHECK(height(fixed, {}, true).y < -4);
  auto other = fixed;
  other.is_sensor = true;
  CHECK(height(other, {}, false).y < -4);
  other = fixed;
  other.layers = 2;
  BodyOptions<S, 2> ball;
  ball.collides_with = 1;
  CHECK(height(other, ball, false).y < -4);
  ball = {};
  ball.is_sensor = true;
  CHECK(height(fixed, ball, false).y < -4);
  ball = {};
  ball.locked = AxisLock::x;
  CHECK(height(fixed, ball, false) == at<S, 2>(0, 0.07));
}

TEST_CASE("fast: snapshots and field names include the flag") {
  using S = q16_16;
  const auto make = [](bool is_fast) {
    World<S, 2, Sphere, Obb> world;
    BodyOptions<S, 2> options;
    options.motion = BodyMotion::kinematic;
    (void)world.add(box_of<S, 2>(0, 0, 3, 0.01), options);
    options.motion = BodyMotion::dynamic;
    options.velocity = at<S, 2>(3, -500);
    options.is_fast = is_fast;
    (void)world.add(Sphere<S, 2>{at<S, 2>(0, 9), num<S>(0.05)}, options);
    return world;
  };
  auto world = make(true);
  CHECK(digest(world) != digest(make(false)));
  const auto difference = diff(world, make(false));
  REQUIRE(difference);
  CHECK(std::string(difference->field.view()) == "body 1:2 (sphere) is_fast");
  for (int t = 0; t < 10; ++t) {
    World<S, 2, Sphere, Obb> copy;
    REQUIRE(restore(copy, snapshot(world)) == Restored::yes);
    world.step();
    copy.step();
    REQUIRE(digest(copy) == digest(world));
  }
  CHECK(world.position({1, 2}).y > 0);
}

}  // namespace detent::test
