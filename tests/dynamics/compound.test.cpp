// SPDX-License-Identifier: MIT
#include "detent/dynamics/compound.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "detent/dynamics/fields.hpp"
#include "detent/dynamics/snapshot.hpp"
#include "detent/scene/sync_test.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"
#include "support/seal.hpp"

namespace detent::test {
namespace {

using S = q16_16;
template <int N>
using Parts = World<S, N, Sphere, Obb, BodyCompound>;

PartOptions<S> part(double density, double friction = 0.6, bool is_sensor = false) {
  PartOptions<S> options;
  options.density = num<S>(density);
  options.friction = num<S>(friction);
  options.is_sensor = is_sensor;
  return options;
}

template <int N>
BodyOptions<S, N> fixed() {
  BodyOptions<S, N> options;
  options.motion = BodyMotion::fixed;
  return options;
}

/// A hammer along x: handle, head, and a zone around the head.
template <int N>
std::vector<BodyPart<S, N>> hammer_parts() {
  return {BodyPart(box_of<S, N>(0, 0, 1, 0.125)), BodyPart(box_of<S, N>(1, 0, 0.25, 0.5), part(8)),
          BodyPart(Sphere<S, N>{at<S, N>(1, 0), num<S>(1.5)}, part(0, 0.6, true))};
}

/// A floor, two hammers on it, a ball and a box; returns the one at this index.
template <int N>
class Yard {
 public:
  [[nodiscard]] bool put(Parts<N>& world, std::uint32_t i) const {
    const BodyId id{i, 1 + i % 3};
    BodyOptions<S, N> options;
    options.velocity = at<S, N>(i % 2 == 0 ? -1 : 0.5, 0);
    if (i == 0) return world.put(id, box_of<S, N>(0, -1, 40, 1), fixed<N>());
    if (i == 1) return world.put(id, Sphere<S, N>{at<S, N>(0.5, 2), num<S>(0.5)}, options);
    if (i == 2) return world.put(id, box_of<S, N>(-0.5, 5, 0.5, 0.25), options);
    const BodyCompound<S, N> body{&solid_, at<S, N>(0.25 * i - 1, 0.75 * i - 1), {}};
    return world.put(id, body, options);
  }
  static constexpr std::uint32_t count = 6;
  [[nodiscard]] Parts<N> world() const {
    Parts<N> result;
    for (std::uint32_t i = 0; i < count; ++i) REQUIRE(put(result, i));
    return result;
  }
  [[nodiscard]] auto assets() const { return std::span(&solid_, 1); }

 private:
  std::vector<BodyPart<S, N>> parts_ = hammer_parts<N>();
  SolidCompound<S, N> solid_ = solid_compound(7, parts_).value();
};

/// Whether two bodies of two worlds have the same motion, bit for bit.
template <class A, class B>
bool equal_states(const A& a, const B& b, std::size_t i) {
  return detail::WorldAccess::bodies(a)[i].state == detail::WorldAccess::bodies(b)[i].state;
}

}  // namespace

TEST_CASE("compound: two halves of a box have the box's mass properties") {
  const std::array halves{BodyPart(Obb<S, 3>{{S(2), S(3), S(-1)}, {S(1), S(2), S(3)}, {}}),
                          BodyPart(Obb<S, 3>{{S(4), S(3), S(-1)}, {S(1), S(2), S(3)}, {}})};
  const auto solid = solid_compound(1, halves);
  REQUIRE(solid);
  const auto whole = mass_properties(Obb<S, 3>{{S(3), S(3), S(-1)}, {S(2), S(2), S(3)}, {}}, S(1));
  CHECK(solid->mass().mass == whole.mass);
  CHECK(solid->center() == whole.center);
  for (int i = 0; i < 3; ++i) {
    // The gyrations of the halves are rounded first.
    const auto twice = half(solid->mass().gyration.diagonal[i] - whole.gyration.diagonal[i]);
    CHECK(abs(twice) < num<S>(0.0001));
  }
  CHECK(solid->mass().gyration.mixed == whole.gyration.mixed);
}

TEST_CASE("compound: rotated parts have the inertia of rotated shapes") {
  const auto turn = [](int x, int y, int z, int w) {
    return to_rotation(Quat<S>::normalize(S(x), S(y), S(z), S(w)).value());
  };
  const Obb<S, 3> box{{S(3), S(-1), S(2)}, {S(1), S(2), S(3)}, turn(1, 2, 2, 4)};
  const BodyPart<S, 3> one(box);
  const auto exact = mass_properties(box, S(1));
  CHECK(one.mass().mass == exact.mass);
  CHECK(one.mass().center == exact.center);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const auto off = one.mass().gyration.at(i, j) - exact.gyration.at(i, j);
      CHECK(abs(off) < num<S>(0.0001));  // the axes come from an orientation rounded to 2^-30
    }
  }
}

TEMPLATE_TEST_CASE("compound: a compound of one part has the bits of its shape", "",
                   (std::integral_constant<int, 2>), (std::integral_constant<int, 3>)) {
  constexpr int N = TestType::value;
  auto box = box_of<S, N>(0.25, 2, 0.5, 0.25);
  const std::array parts{BodyPart(box_of<S, N>(0, 0, 0.5, 0.25))};
  const auto solid = solid_compound(1, parts).value();
  Parts<N> plain, compound;
  for (auto* world : {&plain, &compound}) {
    REQUIRE(world->add(box_of<S, N>(0, -1, 40, 1), fixed<N>()));
    REQUIRE(world->add(Sphere<S, N>{at<S, N>(0, 0.5), num<S>(0.5)}));
  }
  BodyOptions<S, N> options;
  for (auto& w : options.angular_velocity) w = S(2);
  REQUIRE(plain.add(box, options));
  REQUIRE(compound.add(BodyCompound<S, N>{&solid, box.center, {}}, options));
  box.center.y += S(3);
  REQUIRE(compound.add(box, options));
  REQUIRE(plain.add(BodyCompound<S, N>{&solid, box.center, {}}, options));
  for (int t = 0; t < 400; ++t) {
    for (std::size_t i = 0; i < 4; ++i) REQUIRE(equal_states(plain, compound, i));
    plain.step();
    compound.step();
  }
  CHECK(plain.position({2, 3}) == compound.position({2, 3}));
}

TEST_CASE("compound: each part has its own friction, events and sensor flag") {
  // A tilted plank with a smooth and a rough half, a box on each, and a zone above it.
  const auto slope = Rotation<S, 2>::from_angle(Angle<S>::from_degrees(S(20)));
  const std::array parts{BodyPart(box_of<S, 2>(-4, 0, 4, 0.25), part(1, 0)),
                         BodyPart(box_of<S, 2>(4, 0, 4, 0.25), part(1, 1)),
                         BodyPart(Sphere<S, 2>{at<S, 2>(4, 0), S(2)}, part(1, 1, true))};
  const auto plank = solid_compound(3, parts).value();
  Parts<2> world;
  const auto ground = *world.add(BodyCompound<S, 2>{&plank, {}, slope}, fixed<2>());
  const auto put = [&](double along) {
    const Obb<S, 2> box{at<S, 2>(along, 0.51), at<S, 2>(0.25, 0.25), {}};
    return *world.add(placed(Transform<S, 2>{{}, slope, S(1)}, box));
  };
  const auto smooth = put(-3), rough = put(5);
  const auto start = world.position(rough);
  std::vector<TouchEvent> events;
  for (int t = 0; t < 60; ++t) {
    world.step();
    for (std::size_t i = 0; i < world.event_count(); ++i) events.push_back(world.event(i));
  }
  CHECK(abs(world.velocity(smooth).x) > S(2));
  CHECK(distance(world.position(rough), start) < num<S>(0.05));
  CHECK(std::count(events.begin(), events.end(), TouchEvent{ground, smooth, true, 0, 0}) == 1);
  CHECK(std::count(events.begin(), events.end(), TouchEvent{ground, rough, true, 1, 0}) == 1);
  CHECK(std::count(events.begin(), events.end(), TouchEvent{ground, rough, true, 2, 0}) == 1);
}

TEST_CASE("compound: parts of one body do not touch each other, parts of two bodies do") {
  const Yard<2> yard;
  Parts<2> world;
  REQUIRE(yard.put(world, 4));
  world.step();
  CHECK(detail::WorldAccess::contacts(world).empty());
  REQUIRE(yard.put(world, 5));
  world.step();
  const auto& contacts = detail::WorldAccess::contacts(world);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const auto& contact : contacts) pairs.push_back({contact.member, contact.part});
  CHECK(std::is_sorted(pairs.begin(), pairs.end()));
  CHECK(std::count(pairs.begin(), pairs.end(), std::array{2u, 2u}) == 1);  // both zones
  CHECK(pairs.size() > 3);
}

TEST_CASE("compound: hull points and parts, as given, are at the body's frame") {
  const Yard<3> yard;
  auto world = yard.world();
  for (int t = 0; t < 50; ++t) world.step();
  const BodyId id{3, 1};
  const auto solid = yard.assets()[0];
  const auto center = make_vec<3>([&](int i) { return saturate_to<S>(solid.center()[i]); });
  const auto at_center = transform_point(world.frame(id), center);
  CHECK(distance(at_center, world.position(id)) < num<S>(0.001));
  CHECK(world.frame({1, 2}) == world.pose({1, 2}));
}

TEMPLATE_TEST_CASE("compound: bits do not depend on history, and continue from a snapshot", "",
                   (std::integral_constant<int, 2>), (std::integral_constant<int, 3>)) {
  constexpr int N = TestType::value;
  const Yard<N> yard;
  auto world = yard.world();
  Parts<N> backward;
  for (std::uint32_t i = Yard<N>::count; i-- > 0;) REQUIRE(yard.put(backward, i));
  std::size_t most = 0;
  for (int t = 0; t < 300; ++t) {
    REQUIRE(digest(world) == digest(backward));
    if (t % 40 == 7) {
      Parts<N> fresh;
      REQUIRE(yard.put(fresh, 0));
      const auto bytes = snapshot(world);
      REQUIRE(restore(fresh, bytes, yard.assets()) == Restored::yes);
      REQUIRE(snapshot(fresh) == bytes);
      backward = fresh;
    }
    if (t == 150) {
      for (auto* some : {&world, &backward}) {
        REQUIRE(some->remove({4, 2}));
        REQUIRE(yard.put(*some, 4));
      }
    }
    world.step();
    backward.step();
    most = (std::max)(most, detail::WorldAccess::contacts(world).size());
  }
  CHECK(most > 6);
}

TEST_CASE("compound: hostile bytes change nothing and do no harm") {
  const Yard<2> yard;
  auto world = yard.world();
  for (int t = 0; t < 100; ++t) world.step();
  const auto good = snapshot(world);
  Parts<2> fresh;
  REQUIRE(yard.put(fresh, 0));
  CHECK(restore(fresh, good) == Restored::unknown_asset);
  auto other_parts = hammer_parts<2>();
  other_parts.pop_back();
  const auto other = solid_compound(7, other_parts).value();
  CHECK(restore(fresh, good, std::span(&other, 1)) == Restored::other_asset);
  int refused = 0, accepted = 0;
  for (std::size_t i = 0; i + 8 < good.size(); ++i) {
    for (const int bit : {0, 1, 5}) {
      auto bytes = good;
      bytes[i] ^= static_cast<std::byte>(1 << bit);
      seal(bytes);
      auto target = fresh;
      if (restore(target, bytes, yard.assets()) == Restored::yes) {
        ++accepted;
        REQUIRE(snapshot(target) == bytes);
        if (i % 8 == 0) target.step();
      } else {
        ++refused;
      }
    }
  }
  CHECK(refused > 200);
  CHECK(accepted > 200);
}

TEST_CASE("compound: differences name the parts") {
  const Yard<2> yard;
  auto world = yard.world();
  for (int t = 0; t < 30; ++t) world.step();
  auto other = world;
  for (auto& contact : detail::WorldAccess::contacts(other)) contact.touches = !contact.touches;
  std::vector<std::string> names;
  diff(world, other,
       [&](const FieldDifference& difference) { names.emplace_back(difference.field.view()); });
  CHECK(std::count(names.begin(), names.end(), "contact 0:1 3:1 part 2 touches") == 1);
  CHECK(std::count(names.begin(), names.end(), "contact 3:1 part 2 4:2 part 2 touches") == 1);
}

TEST_CASE("compound: worlds accept what they can, and worlds without compounds pay nothing") {
  Parts<2> world;
  CHECK_FALSE(solid_compound(1, std::vector<BodyPart<S, 2>>()));
  const std::array parts{BodyPart(Capsule<S, 2>{at<S, 2>(0, 0), at<S, 2>(1, 0), S(1)})};
  const auto capsule = solid_compound(1, parts).value();
  CHECK_FALSE(world.add(BodyCompound<S, 2>{&capsule, {}, {}}));  // the world has no capsules
  CHECK(world.size() == 0);
  const auto none = world.add(BodyCompound<S, 2>{});
  REQUIRE(none);
  world.step();
  CHECK(world.position(*none) == Vec<S, 2>());  // no mass
  struct Before {                               // the fields of a contact without compounds
    std::uint32_t a, b, part;
    std::uint8_t count;
    bool touches;
    std::array<std::uint32_t, 4> feature;
    std::array<detail::Formats<S>::Impulse, 4> pressure;
    std::array<detail::Formats<S>::Impulse, 3> friction;
  };
  CHECK(sizeof(detail::BodyContact<S, 3>) == sizeof(Before));
  BoundedWorld<Bounded<8>, S, 2, Sphere, Obb, BodyCompound> bounded;
  const Yard<2> yard;
  REQUIRE(bounded.add(box_of<S, 2>(0, -1, 40, 1), fixed<2>()));
  const auto hammer = bounded.add(BodyCompound<S, 2>{&yard.assets()[0], at<S, 2>(0, 2), {}});
  REQUIRE(hammer);
  for (int t = 0; t < 240; ++t) bounded.step();
  CHECK(bounded.is_asleep(*hammer));
}

TEST_CASE("compound: a fast one stops where the ball about its center in a part would touch") {
  const auto greatest_x = [](const std::vector<BodyPart<S, 2>>& list) {
    const auto solid = solid_compound(1, list).value();
    WorldSettings<S, 2> settings;
    settings.gravity = {};
    Parts<2> world(settings);
    (void)world.add(box_of<S, 2>(0.25, 0, 0.0625, 4), fixed<2>());
    BodyOptions<S, 2> thrown;
    thrown.velocity = at<S, 2>(300, 0);
    thrown.is_fast = true;
    const auto id = *world.add(BodyCompound<S, 2>{&solid, at<S, 2>(-7, 0), {}}, thrown);
    auto most = world.position(id).x;
    for (int t = 0; t < 20; ++t) {
      world.step();
      most = (std::max)(most, world.position(id).x);
    }
    return static_cast<double>(most);
  };
  const BodyPart above(box_of<S, 2>(0, 0.75, 0.125, 0.125)),
      below(box_of<S, 2>(0, -0.75, 0.125, 0.125));
  const double wall = 0.1875;
  const auto with_ball = greatest_x({above, below, BodyPart(Sphere<S, 2>{{}, num<S>(0.5)})});
  CHECK(with_ball < wall - 0.499);
  CHECK(with_ball > wall - 0.52);
  const auto with_sensor =
      greatest_x({above, below, BodyPart(Sphere<S, 2>{{}, num<S>(0.5)}, part(0, 0, true))});
  CHECK(with_sensor < wall);
  CHECK(with_sensor > wall - 0.125);
}

}  // namespace detent::test
