// SPDX-License-Identifier: MIT
// Four bodies at once turn and are supported as one after another, or are refused.
#include "detent/dynamics/four_flight.hpp"

#include <vector>

#include "dynamics/draw.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using F = detail::Formats<S>;
using Orientation = Vec<F::Ratio, 4>;

detail::Axial<F::Spin, 3> draw_spin(Random& random, int bits) {
  detail::Axial<F::Spin, 3> spin;
  for (auto& w : spin) {
    w = draw<F::Spin>(random, bits);
    if (random.below(8) == 0) w = {};
  }
  return spin;
}

template <int Halvings, class L>
bool check_turns(Random& random, int bits) {
  std::array<Orientation, 4> before;
  std::array<detail::Axial<F::Spin, 3>, 4> spins;
  std::array<detail::Four<F::Ratio, L>, 4> q;
  std::array<detail::Four<F::Spin, L>, 3> spin;
  std::array<detail::Quad<F::Ratio>, 4> parts;
  std::array<detail::Quad<F::Spin>, 3> turns;
  for (std::size_t k = 0; k < 4; ++k) {
    before[k] = draw_unit<F::Ratio, 4>(random);
    spins[k] = draw_spin(random, bits);
    for (std::size_t i = 0; i < 4; ++i) parts[i][k] = before[k][static_cast<int>(i)];
    for (std::size_t i = 0; i < 3; ++i) turns[i][k] = spins[k][i];
  }
  for (std::size_t i = 0; i < 4; ++i) q[i] = detail::Four<F::Ratio, L>(parts[i]);
  for (std::size_t i = 0; i < 3; ++i) spin[i] = detail::Four<F::Spin, L>(turns[i]);
  detail::FourRounder<L> round;
  const auto result = detail::turned_four<Halvings, S, L>(q, spin, round);
  if (round.is_beyond()) return false;
  for (std::size_t i = 0; i < 4; ++i) result[i].store(parts[i]);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto expected = detail::turned<S, 3, Halvings>(before[k], spins[k]);
    for (std::size_t i = 0; i < 4; ++i) REQUIRE(parts[i][k] == expected[static_cast<int>(i)]);
  }
  return true;
}

}  // namespace

TEMPLATE_TEST_CASE("four bodies: orientations turn by the bits of each", "", detail::ArrayLongLanes,
                   detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  Random random(0x4f1);
  const int rounds = DETENT_TEST_ALL ? 200'000 : 20'000;
  int slow = 0, fast = 0;
  for (int i = 0; i < rounds; ++i) {
    const int bits = static_cast<int>(random.below(23));
    slow += check_turns<0, TestType>(random, bits) + check_turns<1, TestType>(random, bits);
    fast += check_turns<0, TestType>(random, 24) + check_turns<1, TestType>(random, 30);
  }
  CAPTURE(slow, fast);
  CHECK(slow > 2 * rounds * 0.9);
  CHECK(fast < 2 * rounds * 0.5);
}

TEMPLATE_TEST_CASE("four bodies: supports and carried spins have the bits of each", "",
                   detail::ArrayLongLanes, detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  using L = TestType;
  using World = detent::World<S, 3, Capsule, Obb>;
  Random random(0x4f2);
  const int rounds = 3000;
  int supported = 0, carried = 0;
  for (int i = 0; i < rounds; ++i) {
    World world;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto half = make_vec<3>([&](int) {
        return S::assume_raw(static_cast<std::int32_t>(random.between(1 << 12, 1 << 17)));
      });
      if (i % 3 == 0) {
        (void)world.add(Obb<S, 3>{{}, half, {}});
      } else {  // of which the frame's axes are not those of inertia
        (void)world.add(Capsule<S, 3>{{}, half, S::assume_raw(1 << 14)});
      }
    }
    auto& bodies = detail::WorldAccess::bodies(world);
    std::vector<detail::Moving<S, 3>> moving(4), expected(4);
    std::array<detail::Axes<S, 3>, 4> from, to, wanted;
    std::array<detail::Support<S, 3>, 4> supports;
    detail::FourTurns<S> turns;
    const int bits = i % 2 == 0 ? 22 : 30;
    for (std::uint32_t k = 0; k < 4; ++k) {
      bodies[k].state.orientation = draw_unit<F::Ratio, 4>(random);
      from[k] = detail::axes_of<S, 3>(bodies[k].state.orientation);
      moving[k].spin = expected[k].spin = draw_spin(random, bits);
      const auto q = detail::turned<S, 3>(bodies[k].state.orientation, moving[k].spin);
      turns.add(k, q, bodies[k].inertia, from[k], to[k]);
      detail::carry(bodies[k], expected[k], q, from[k], wanted[k]);
    }
    using Body = std::remove_cvref_t<decltype(bodies[0])>;
    const detail::Quad<const Body*> which{&bodies[0], &bodies[1], &bodies[2], &bodies[3]};
    for (const bool has_axes : {false, true}) {
      if (!detail::support_four<L, S>(
              which, {&supports[0], &supports[1], &supports[2], &supports[3]}, has_axes)) {
        break;  // and there are no axes
      }
      ++supported;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto support = detail::support_of<S, 3>(bodies[k]);
        REQUIRE(supports[k].axes == support.axes);
        REQUIRE(supports[k].spread == support.spread);
      }
    }
    if (!detail::carry_four<L>(turns, moving.data())) continue;
    ++carried;
    for (std::size_t k = 0; k < 4; ++k) {
      REQUIRE(to[k] == wanted[k]);
      REQUIRE(moving[k].spin == expected[k].spin);
    }
  }
  CAPTURE(supported, carried);
  CHECK(supported > 2 * rounds * 0.8);
  CHECK(carried > rounds * 0.4);
}

/// Places have 32 bits in q8_8 and 64 in the others.
TEMPLATE_TEST_CASE("four bodies: supports are those in memory in every scalar", "", q16_16, q14_16,
                   q24_8, q8_8) {
  using T = TestType;
  using L = detail::ArrayLongLanes;
  Random random(0x4f3);
  const auto draw = [&]<class Number>(Number& x) {
    const auto end = std::int64_t{1} << Number::bits;
    x = Number::assume_raw(static_cast<typename Number::raw_type>(random.between(-end, end - 1)));
  };
  for (int i = 0; i < 100; ++i) {
    std::array<detail::Support<T, 3>, 4> supports;
    for (auto& support : supports) {
      for (int k = 0; k < 3; ++k) draw(support.place[k]);
      for (auto& x : support.spread) draw(x);
      for (auto& axis : support.axes) {
        for (int k = 0; k < 3; ++k) draw(axis[k]);
      }
    }
    const detail::FourSupports<T, L> four(supports.data(), {2, 0, 3, 1});
    const auto are_equal = [](const auto& lanes, const auto& get) {
      using Number = std::remove_cvref_t<decltype(get(0))>;
      detail::Quad<Number> numbers;
      lanes.store(numbers);
      return numbers == detail::Quad<Number>{get(2), get(0), get(3), get(1)};
    };
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(are_equal(four.place[k],
                        [&](std::size_t b) { return supports[b].place[static_cast<int>(k)]; }));
      for (std::size_t a = 0; a < 3; ++a) {
        REQUIRE(are_equal(four.axes[a][k],
                          [&](std::size_t b) { return supports[b].axes[a][static_cast<int>(k)]; }));
      }
    }
    for (std::size_t e = 0; e < 6; ++e) {
      REQUIRE(are_equal(four.spread[e], [&](std::size_t b) { return supports[b].spread[e]; }));
    }
  }
}

}  // namespace detent::test
