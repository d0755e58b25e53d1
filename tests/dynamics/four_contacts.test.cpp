// SPDX-License-Identifier: MIT
// Four contacts prepared at once have the bits of one after another, or are refused.
#include "detent/dynamics/four_contacts.hpp"

#include <vector>

#include "detent/dynamics/flight.hpp"
#include "detent/dynamics/rolling.hpp"
#include "dynamics/draw.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using F = detail::Formats<S>;
using Ready = detail::ReadyContact<S, 3>;
using Rows = detail::ContactRows<S, 3>;
using State = detail::BodyContact<S, 3>;
using Group = detail::ContactGroup<S>;

/// A body that is fixed or can move, with inverse gyrations of up to `bits` bits.
detail::Support<S, 3> draw_support(Random& random, int bits) {
  detail::Support<S, 3> support;
  support.axes = detail::axes_of<S, 3>(draw_unit<F::Ratio, 4>(random));
  support.is_fixed = random.one_in(4);
  if (!support.is_fixed) {
    for (std::size_t i = 0; i < 6; ++i) {
      const auto x = draw<F::Gyration>(random, i < 3 ? bits : bits - 3);
      support.spread[i] = i < 3 && x < 0 ? narrow_negative(x) : x;
    }
  }
  return support;
}

struct Scene {
  std::vector<detail::Support<S, 3>> supports;
  std::vector<detail::Manifold<S, 3>> manifolds;
  std::vector<Vec<F::Lever, 3>> offsets;
  std::vector<std::array<F::Ratio, 2>> shares;
  std::vector<Ready> ready;
  std::vector<State> states;
};

/// Contacts of bodies of their own, with arms of up to `bits` bits.
Scene draw_scene(Random& random, std::size_t size, int bits) {
  Scene scene;
  for (std::size_t k = 0; k < size; ++k) {
    const auto gyration = static_cast<int>(random.between(24, 46));
    auto a = draw_support(random, gyration), b = draw_support(random, gyration);
    if (a.is_fixed && b.is_fixed) b.is_fixed = false;
    scene.supports.push_back(a);
    scene.supports.push_back(b);
    detail::Manifold<S, 3> manifold;
    manifold.normal = draw_unit<F::Ratio, 3>(random);
    manifold.count = static_cast<int>(random.between(1, 4));
    const bool is_same = random.one_in(8);
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
      auto& point = manifold.points[i];
      for (int c = 0; c < 3; ++c) point.point[c] = draw<F::Lever>(random, bits);
      if (is_same) point.point = manifold.points[0].point;
      point.separation = draw<F::Gap>(random, random.one_in(32) ? 31 : 20);
      point.feature = static_cast<std::uint32_t>(i);
    }
    scene.manifolds.push_back(manifold);
    scene.offsets.push_back(make_vec<3>([&](int) { return draw<F::Lever>(random, bits); }));
    auto share = F::Ratio::assume_raw(static_cast<std::int32_t>(random.between(0, 1 << 30)));
    if (a.is_fixed) share = F::Ratio(0);
    if (b.is_fixed) share = F::Ratio(1);
    scene.shares.push_back({share, narrow<31>(F::Ratio(1) - share)});
    Ready ready;
    ready.contact = static_cast<std::uint32_t>(k);
    ready.a = static_cast<std::uint32_t>(2 * k);
    ready.b = static_cast<std::uint32_t>(2 * k + 1);
    ready.count = static_cast<std::uint8_t>(manifold.count);
    ready.is_wall = share == 0 || share == 1;
    ready.pushed = {share != 0, share != 1};
    ready.grip = narrow_abs(draw<F::Ratio>(random, 30));
    scene.ready.push_back(ready);
    State state;
    for (auto& x : state.pressure) x = narrow_abs(draw<F::Impulse>(random, 30));
    for (auto& x : state.friction) x = draw<F::Impulse>(random, 30);
    scene.states.push_back(state);
  }
  return scene;
}

void require_equal(const Group::Push& a, const Group::Push& b) {
  REQUIRE((a.along == b.along && a.on_a == b.on_a && a.on_b == b.on_b));
}
void require_equal(const Group::Lever& a, const Group::Lever& b) {
  REQUIRE((a.moment_a == b.moment_a && a.moment_b == b.moment_b));
  REQUIRE((a.response_a == b.response_a && a.response_b == b.response_b && a.mass == b.mass));
}
void require_equal(const Group& a, const Group& b) {
  REQUIRE((a.size == b.size && a.count == b.count && a.a == b.a && a.b == b.b));
  REQUIRE((a.pushes_a == b.pushes_a && a.pushes_b == b.pushes_b));
  REQUIRE((a.rigid == b.rigid && a.pull == b.pull && a.loss == b.loss && a.grip == b.grip));
  REQUIRE((a.gap == b.gap && a.gap_now == b.gap_now && a.reach == b.reach));
  REQUIRE((a.pressures == b.pressures && a.pressed == b.pressed && a.frictions == b.frictions));
  require_equal(a.normal, b.normal);
  require_equal(a.twist, b.twist);
  for (std::size_t t = 0; t < 2; ++t) {
    require_equal(a.tangent[t], b.tangent[t]);
    require_equal(a.friction[t], b.friction[t]);
  }
  for (std::size_t i = 0; i < a.count; ++i) require_equal(a.pressure[i], b.pressure[i]);
}

template <class L>
bool check(const Scene& start) {
  auto expected = start.ready, found = start.ready;
  const std::size_t size = found.size();
  // Rows of an earlier step, in which the contacts resisted rolling.
  const detail::Rolling<S, 3> rolling{};
  Rows used;
  used.rolling = &rolling;
  std::vector<Rows> expected_rows(size, used), found_rows(size, used);
  detail::FourContacts<S> from;
  for (std::size_t k = 0; k < detail::long_lane_count; ++k) {
    const std::size_t c = k < size ? k : 0;
    from.manifold[k] = &start.manifolds[c];
    from.offset[k] = &start.offsets[c];
    if (k >= size) continue;
    from.share_a[k] = start.shares[c][0];
    from.share_b[k] = start.shares[c][1];
  }
  Group group, wanted;
  group.size = wanted.size = static_cast<std::uint8_t>(size);
  if (!detail::prepare_four<L, S>(group, from, start.supports.data(), found.data())) return false;
  detail::gather_impulses(group, found.data(), start.states.data());
  for (std::size_t k = 0; k < size; ++k) {
    detail::prepare(expected[k], expected_rows[k], start.manifolds[k], start.supports[2 * k],
                    start.supports[2 * k + 1], start.offsets[k], start.shares[k][0],
                    start.shares[k][1]);
  }
  detail::gather(wanted, expected.data(), expected_rows.data(), start.states.data());
  require_equal(group, wanted);
  // Contacts that are solved alone get their rows from the group.
  REQUIRE(!group.has_rows);
  detail::spread_rows(group, found.data(), found_rows.data());
  Group again;
  again.size = group.size;
  detail::gather(again, found.data(), found_rows.data(), start.states.data());
  require_equal(again, wanted);
  for (std::size_t k = 0; k < size; ++k) {
    REQUIRE(found[k].gap == expected[k].gap);
    REQUIRE((expected_rows[k].rolling == nullptr && found_rows[k].rolling == nullptr));
  }
  return true;
}

}  // namespace

TEMPLATE_TEST_CASE("four contacts: prepared at once they have the bits of one after another", "",
                   detail::ArrayLongLanes, detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  Random random(0x4c0);
  const int rounds = DETENT_TEST_ALL ? 100'000 : 6000;
  int prepared = 0;
  for (int i = 0; i < rounds; ++i) {
    const int bits = i % 2 == 0 ? 24 : static_cast<int>(random.between(16, 31));
    prepared += check<TestType>(draw_scene(random, 1 + random.below(4), bits));
  }
  CAPTURE(prepared);
  CHECK(prepared > rounds * 0.3);
  CHECK(prepared < rounds * 0.9);
}

}  // namespace detent::test
