// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/contact_group.hpp"

// Contacts without impulses whose bodies stay apart: a pass changes nothing if no point can close
// its gap, and one bound for all points of four contacts shows that. The solver then needs neither
// their rows nor their gaps.                                (docs/filters.md, lemma 34)

namespace detent::detail {

/// Up to four contacts without impulses, one per lane: bounds of their gaps and of their rows.
/// Lanes without a contact repeat the first one.
template <Scalar S>
struct IdleGroup {
  using F = Formats<S>;
  using Reach = Fixed<31, F::Moment::frac>;

  Quad<std::uint32_t> a{}, b{};
  std::array<Quad<typename F::Ratio>, 3> normal{};
  Quad<typename F::Speed> gap{};     // the least of all points, when the bodies were held
  Quad<Reach> reach_a{}, reach_b{};  // the greatest component of a point's moment, without sign
};

/// Sets lane k from a contact's manifold. All separations are positive.
template <Scalar S>
constexpr void place_idle(IdleGroup<S>& group, std::size_t k, const Manifold<S, 3>& manifold,
                          const Support<S, 3>& a, const Support<S, 3>& b,
                          const Vec<typename Formats<S>::Lever, 3>& offset) noexcept {
  using F = Formats<S>;
  using Arm = typename F::Arm;
  using Reach = typename IdleGroup<S>::Reach;
  const auto n = out_of_axes<S, 3>(a.axes, manifold.normal);
  const auto reach_of = [&](const auto& arm, const Support<S, 3>& body, const Reach& before) {
    auto reach = before;
    if (body.is_fixed) return reach;
    for (const auto& c : moment<S, 3>(nearest_to<Arm>(arm), n)) reach = (max)(reach, Reach(abs(c)));
    return reach;
  };
  auto least = manifold.points[0].separation;
  group.reach_a[k] = group.reach_b[k] = Reach{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
    const auto& point = manifold.points[i];
    const auto p = out_of_axes<S, 3>(a.axes, point.point);
    group.reach_a[k] = reach_of(p, a, group.reach_a[k]);
    group.reach_b[k] = reach_of(p - offset, b, group.reach_b[k]);
    least = (min)(least, point.separation);
  }
  for (std::size_t i = 0; i < 3; ++i) group.normal[i][k] = n[static_cast<int>(i)];
  group.gap[k] = saturate_to<typename F::Speed>(least);
}

DETENT_BEGIN_LONG_LANES

/// Whether the next biased or relaxed pass surely changes nothing, and all gaps are positive.
template <class L, Scalar S>
[[nodiscard]] bool stay_idle(const IdleGroup<S>& group, Moving<S, 3>* bodies) noexcept {
  using F = Formats<S>;
  using Ratio = Four<typename F::Ratio, L>;
  using Motions = FourMotions<S, L>;
  constexpr int quarter = 2;  // sums of three spins in steps of four, so that products fit
  FourBodies<S, L> first(bodies, group.a), second(bodies, group.b);
  const Four<typename IdleGroup<S>::Reach, L> reach_a(group.reach_a), reach_b(group.reach_b);
  const auto turn_of = [](const Motions& m) {
    const L sum =
        (m.spin[0].raw.magnitudes() + m.spin[1].raw.magnitudes()) + m.spin[2].raw.magnitudes();
    return (sum + L(LongWord{(1 << quarter) - 1})) >> quarter;
  };
  // A bound below the rates along all rows, in steps of a speed.
  const auto least_rate = [&](const Motions& a, const Motions& b) {
    constexpr int to_speed = Ratio::Number::frac;
    L along(LongWord{1} << 62);
    for (std::size_t i = 0; i < 3; ++i) {
      along = along + (Ratio(group.normal[i]) * narrow<31>(b.velocity[i] - a.velocity[i])).raw;
    }
    const L turning = L::product(reach_a.raw, turn_of(a)) + L::product(reach_b.raw, turn_of(b));
    constexpr int to_turn = F::Moment::frac + F::Spin::frac - quarter - F::Speed::frac;
    return (along >> to_speed) - (turning >> to_turn) - L((LongWord{1} << (62 - to_speed)) + 2);
  };
  const auto speeds_a = first.motions(), speeds_b = second.motions();
  const L gap =
      Four<typename F::Speed, L>(group.gap).raw + least_rate(first.paths(), second.paths());
  const L speed = least_rate(speeds_a, speeds_b);
  const L one(LongWord{1}), most(LongWord{(1 << F::Speed::bits) - 1});
  return ((gap - one) | (gap + speed) | (most + speed)).signs() == 0;
}

DETENT_END_LONG_LANES

}  // namespace detent::detail
