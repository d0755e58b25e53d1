// SPDX-License-Identifier: MIT
#include "detent/dynamics/threads.hpp"

#include <algorithm>
#include <numeric>

#include "detent/dynamics/snapshot.hpp"
#include "dynamics/crowd.hpp"
#include "support/catch.hpp"
#include "support/pool.hpp"

namespace detent::test {
namespace {

/// Runs the calls one after another in random order, which exposes any dependence on order.
class Shuffled {
 public:
  template <class F>
  void operator()(std::size_t count, const F& f) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random_.below(i)]);
    for (const auto i : order) f(i);
    calls += count;
  }
  std::size_t calls = 0;

 private:
  Random random_{0x5add1e};
};

}  // namespace

TEST_CASE("threads: worlds stepped by 1, 2 and 4 threads, or in any order, have the same bits") {
  Pool one(1), two(2), four(4);
  Shuffled shuffled;
  const auto seed = GENERATE(range(1, DETENT_TEST_ALL ? 8 : 3));
  CAPTURE(seed);
  const Crowd crowd(static_cast<std::uint64_t>(seed), seed % 2 == 0 ? 0.1 : 0);
  auto world = crowd.world();
  auto by_one = world, by_two = world, by_four = world, by_chance = world;
  std::size_t contacts = 0;
  for (int tick = 0; tick < 30; ++tick) {
    world.step();
    by_one.step(one);
    by_two.step(two);
    by_four.step(four);
    by_chance.step(shuffled);
    const auto expected = digest(world);
    REQUIRE(digest(by_one) == expected);
    REQUIRE(digest(by_two) == expected);
    REQUIRE(digest(by_four) == expected);
    REQUIRE(digest(by_chance) == expected);
    REQUIRE(by_four.event_count() == world.event_count());
    contacts = (std::max)(contacts, detail::WorldAccess::contacts(world).size());
  }
  CHECK(contacts > 250);         // more than one call per colour
  CHECK(shuffled.calls > 2000);  // and for much else
}

TEST_CASE("threads: a world in static memory has the same bits") {
  using Bounds = BoundedWorld<Bounded<100>, q16_16, 2, Sphere>;
  Bounds world;
  add_round_ground(world);
  for (int i = 0; i < 99; ++i) add_ball(world, 2.0 * (i % 33) - 32, 4 + 2 * (i / 33));
  auto other = world;
  Pool two(2);
  for (int tick = 0; tick < 100; ++tick) {
    world.step();
    other.step(two);
    REQUIRE(digest(other) == digest(world));
  }
}

}  // namespace detent::test
