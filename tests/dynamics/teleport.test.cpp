// SPDX-License-Identifier: MIT
#include <vector>

#include "detent/dynamics/snapshot.hpp"
#include "detent/dynamics/world.hpp"
#include "dynamics/stage.hpp"
#include "dynamics/zoo.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;

template <class World>
void step(World& world, int ticks) {
  for (int i = 0; i < ticks; ++i) world.step();
}

/// A floor, and a column of boxes that sleeps on it.
template <int N>
struct Column {
  static constexpr int count = 3;

  World<S, N, Obb, Sphere, BallJoint> world;
  BodyId floor;
  std::vector<BodyId> boxes;

  Column() {
    floor = *world.add(box_of<S, N>(0, -1, 20, 1), {.motion = BodyMotion::fixed});
    for (int i = 0; i < count; ++i) boxes.push_back(*world.add(box_of<S, N>(0, 0.5 + i, 0.5, 0.5)));
    step(world, 200);
    for (const auto& id : boxes) REQUIRE(world.is_asleep(id));
  }
};

}  // namespace

TEMPLATE_TEST_CASE("set_position: puts a body elsewhere and keeps everything but its position", "",
                   Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  World<S, N, Obb> world;
  BodyOptions<S, N> options{.velocity = at<S, N>(1, 2)};
  options.angular_velocity[0] = num<S>(0.75);
  const auto id = *world.add(box_of<S, N>(0, 0, 0.5, 0.25), options);
  step(world, 7);
  const auto before = world;
  const auto there = at<S, N>(100.25, -31);
  CHECK(world.set_position(id, there));
  CHECK(world.position(id) == there);
  CHECK(world.rotation(id) == before.rotation(id));
  CHECK(world.velocity(id) == before.velocity(id));
  CHECK(world.angular_velocity(id) == before.angular_velocity(id));
  for (int i = 0; i < N; ++i) {
    CHECK(detail::WorldAccess::bodies(world)[0].state.place[i] == there[i]);  // on the grid
  }

  const auto turned = [&] {
    if constexpr (N == 2) {
      return Rotation<S, 2>::from_angle(Angle<S>::turn(1, 5));
    } else {
      return Rotation<S, 3>::from_axis_angle(direction_of<S>(at3(1, 2, 3)).value(),
                                             Angle<S>::turn(1, 5));
    }
  }();
  CHECK(world.set_rotation(id, turned));
  CHECK(world.position(id) == there);
  CHECK(world.velocity(id) == before.velocity(id));
  World<S, N, Obb> other;
  auto box = box_of<S, N>(100.25, -31, 0.5, 0.25);
  box.rotation = turned;
  other.add(box);
  CHECK(detail::WorldAccess::bodies(world)[0].state.orientation ==
        detail::WorldAccess::bodies(other)[0].state.orientation);

  CHECK_FALSE(world.set_position(no_object, there));
  CHECK_FALSE(world.set_rotation({0, 9}, turned));
}

TEMPLATE_TEST_CASE("set_position: wakes what touched the body, which then falls", "", Dim<2>,
                   Dim<3>) {
  constexpr int N = TestType::value;
  Column<N> column;
  auto& world = column.world;
  const auto height = world.position(column.boxes[1]).y;
  CHECK(world.set_position(column.boxes[0], at<S, N>(8, 0.5)));
  CHECK_FALSE(world.is_asleep(column.boxes[0]));
  CHECK_FALSE(world.is_asleep(column.boxes[1]));
  CHECK(world.is_asleep(column.boxes[2]));  // woken by the next step
  world.step();
  CHECK_FALSE(world.is_asleep(column.boxes[2]));
  int ended = 0, began = 0;
  for (std::size_t i = 0; i < world.event_count(); ++i) {
    ++(world.event(i).begins ? began : ended);
  }
  CHECK(ended == 1);  // of the lowest box and the one above; it still touches the floor
  CHECK(began == 0);
  step(world, 120);
  CHECK(world.position(column.boxes[1]).y < height - num<S>(0.9));
  CHECK(abs(world.position(column.boxes[0]).x - S(8)) < num<S>(0.01));
}

TEMPLATE_TEST_CASE("set_position: moving a fixed body away wakes what lay on it", "", Dim<2>,
                   Dim<3>) {
  constexpr int N = TestType::value;
  Column<N> column;
  auto& world = column.world;
  const auto bytes = snapshot(world);
  auto copy = world;
  CHECK(world.set_position(column.floor, at<S, N>(0, -50)));
  step(world, 60);
  for (const auto& id : column.boxes) CHECK(world.position(id).y < S(-2));
  CHECK(restore(world, bytes) == Restored::other_fixed_part);
  CHECK(restore(copy, bytes) == Restored::yes);
}

TEMPLATE_TEST_CASE("set_position: joints stay, and wake the body at their other end", "", Dim<2>,
                   Dim<3>) {
  constexpr int N = TestType::value;
  World<S, N, Sphere, BallJoint> world;
  const auto hook =
      *world.add(Sphere<S, N>{at<S, N>(0, 5), num<S>(0.125)}, {.motion = BodyMotion::fixed});
  const auto bob = *world.add(Sphere<S, N>{at<S, N>(0, 4), num<S>(0.25)}, {.linear_damping = S(2)});
  BallJoint<S, N> joint;
  joint.a = hook;
  joint.b = bob;
  joint.anchor_b = at<S, N>(0, 1);
  const auto id = *world.add(joint);
  step(world, 120);
  REQUIRE(world.is_asleep(bob));
  CHECK(world.set_position(hook, at<S, N>(3, 5)));
  CHECK(world.contains(id));
  CHECK_FALSE(world.is_asleep(bob));
  step(world, 600);
  CHECK(abs(world.position(bob).x - S(3)) < num<S>(0.05));
}

TEMPLATE_TEST_CASE("set_position: a step depends only on the state after it", "", Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  const auto seed = GENERATE(1, 2, 3);
  INFO("seed " << seed);
  Zoo<S, N> zoo(static_cast<std::uint64_t>(seed));
  for (int round = 0; round < 12; ++round) {
    zoo.live();
    const auto moved = zoo.any();
    if (zoo.world.info(moved)->motion != BodyMotion::fixed) {
      zoo.world.set_position(moved, zoo.somewhere());
    }
    // A copy has the state, but none of the scratch data of steps.
    auto copy = zoo.world;
    REQUIRE(digest(copy) == digest(zoo.world));
    for (int tick = 0; tick < 5; ++tick) {
      copy.step();
      zoo.world.step();
      REQUIRE(digest(copy) == digest(zoo.world));
      REQUIRE(copy.event_count() == zoo.world.event_count());
      for (std::size_t i = 0; i < copy.event_count(); ++i) {
        CHECK(copy.event(i) == zoo.world.event(i));
      }
    }
  }
}

TEST_CASE("set_position: a snapshot taken right after it restores the same future") {
  Column<2> column;
  auto& world = column.world;
  world.set_position(column.boxes[0], at<S, 2>(0.75, 0.5));
  world.set_rotation(column.boxes[2], Rotation<S, 2>::from_angle(Angle<S>::turn(1, 12)));
  const auto bytes = snapshot(world);
  Column<2> other;
  REQUIRE(restore(other.world, bytes) == Restored::yes);
  for (int tick = 0; tick < 120; ++tick) {
    world.step();
    other.world.step();
    REQUIRE(digest(world) == digest(other.world));
  }
}

TEST_CASE("set_position: contacts lose their impulses and stay") {
  Column<2> column;
  auto& world = column.world;
  const auto& contacts = detail::WorldAccess::contacts(world);
  const auto before = contacts.size();
  world.set_position(column.boxes[0], world.position(column.boxes[0]));
  REQUIRE(contacts.size() == before);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const bool is_of_moved =
        contacts[i].a == column.boxes[0].index || contacts[i].b == column.boxes[0].index;
    CHECK(contacts[i].touches);
    for (std::size_t k = 0; k < contacts[i].count; ++k) {
      CHECK((contacts[i].pressure[k] > 0) == !is_of_moved);
    }
  }
  step(world, 120);  // the column stands
  for (int i = 0; i < 3; ++i) {
    CHECK(abs(world.position(column.boxes[static_cast<std::size_t>(i)]).x) < num<S>(0.01));
    CHECK(world.is_asleep(column.boxes[static_cast<std::size_t>(i)]));
  }
}

TEST_CASE("set_rotation: height fields stay upright") {
  Zoo<S, 3> zoo(1);
  const BodyId field{1, 2};
  const auto before = zoo.world.rotation(field);
  const auto turn =
      Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(0), Angle<S>::turn(1, 4));
  CHECK(zoo.world.set_rotation(field, turn));
  CHECK(zoo.world.rotation(field) == before);
}

}  // namespace detent::test
