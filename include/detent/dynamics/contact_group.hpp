// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/four.hpp"
#include "detent/dynamics/solve.hpp"

namespace detent::detail {

/// Up to four contacts of one colour, one per lane. Rows of missing points and missing contacts are
/// 0.
template <Scalar S>
struct ContactGroup {
  using F = Formats<S>;
  static constexpr std::size_t capacity = ReadyContact<S, 3>::capacity;
  template <class T>
  using Vector = std::array<Quad<T>, 3>;

  struct Push {
    Vector<typename F::Ratio> along{}, on_a{}, on_b{};
  };
  struct Lever {
    Vector<typename F::Moment> moment_a{}, moment_b{};
    Vector<typename F::Response> response_a{}, response_b{};
    Quad<typename F::Ratio> mass{};
  };

  std::uint32_t first = 0;           // index of the first in the list of ready contacts
  std::uint8_t size = 0, count = 0;  // number of contacts, and the most points of any
  bool has_rows = false;             // whether the contacts have the rows too
  bool are_even = false;             // impulses change both velocities of each contact equally
  bool is_idle = false;              // its contacts have no impulses, and no rows yet
  std::uint32_t idle = 0;            // index in the list of idle groups
  Quad<std::uint32_t> a{}, b{};
  Quad<bool> pushes_a{}, pushes_b{};
  Push normal{};
  std::array<Push, 2> tangent{};
  std::array<Lever, capacity> pressure{};
  std::array<Lever, 2> friction{};
  Lever twist{};
  std::array<Quad<typename F::Speed>, capacity> gap{}, gap_now{};
  std::array<Quad<typename F::Ratio>, capacity> reach{};
  Quad<typename F::Ratio> rigid{}, pull{}, loss{}, grip{};

  // The impulses so far, and the union of the bits of all pressures after passes.
  std::array<Quad<typename F::Impulse>, capacity> pressures{}, pressed{};
  std::array<Quad<typename F::Impulse>, 3> frictions{};
};

/// Loads the impulses and gaps of a group's contacts. `ready` starts at the first of them.
template <Scalar S, class Contact>
constexpr void gather_impulses(ContactGroup<S>& group, const ReadyContact<S, 3>* ready,
                               const Contact* contacts) noexcept {
  for (std::size_t k = 0; k < group.size; ++k) {
    const auto& contact = contacts[ready[k].contact];
    for (std::size_t i = 0; i < ready[k].count; ++i) {
      group.pressures[i][k] = contact.pressure[i];
      group.gap_now[i][k] = ready[k].gap_now[i];
    }
    for (std::size_t t = 0; t < 3; ++t) group.frictions[t][k] = contact.friction[t];
  }
}

/// The softness and grip of contact k of a group.
template <Scalar S>
constexpr void place_surface(ContactGroup<S>& group, const ReadyContact<S, 3>& contact,
                             std::size_t k) noexcept {
  const auto& soft = contact.is_wall ? wall_softness<S> : contact_softness<S>;
  group.rigid[k] = soft.rigid;
  group.pull[k] = soft.pull;
  group.loss[k] = soft.loss;
  group.grip[k] = contact.grip;
}

/// Calls exchange(x, y) for every number x of the rows of contact k of a group, with `count` points,
/// and its counterpart y in the contact's own rows.
template <class Group, class Rows, class Exchange>
constexpr void exchange_rows(Group& group, Rows& rows, std::size_t k, std::size_t count,
                             const Exchange& exchange) noexcept {
  const auto each = [&](auto& side, auto& vector) {
    for (std::size_t i = 0; i < 3; ++i) {
      if constexpr (requires { vector.x; }) {
        exchange(side[i][k], vector[static_cast<int>(i)]);
      } else {
        exchange(side[i][k], vector[i]);
      }
    }
  };
  const auto push = [&](auto& side, auto& thrust) {
    each(side.along, thrust.along);
    each(side.on_a, thrust.on_a);
    each(side.on_b, thrust.on_b);
  };
  const auto lever = [&](auto& side, auto& row) {
    each(side.moment_a, row.moment_a);
    each(side.moment_b, row.moment_b);
    each(side.response_a, row.response_a);
    each(side.response_b, row.response_b);
    exchange(side.mass[k], row.mass);
  };
  push(group.normal, rows.normal);
  for (std::size_t t = 0; t < 2; ++t) {
    push(group.tangent[t], rows.tangent[t]);
    lever(group.friction[t], rows.friction[t]);
  }
  lever(group.twist, rows.twist);
  for (std::size_t i = 0; i < count; ++i) {
    lever(group.pressure[i], rows.pressure[i]);
    exchange(group.reach[i][k], rows.reach[i]);
  }
}

template <Scalar S, class Contact>
constexpr void gather(ContactGroup<S>& group, const ReadyContact<S, 3>* ready,
                      const ContactRows<S, 3>* rows, const Contact* contacts) noexcept {
  const auto first = group.first;
  const auto size = group.size;
  group = {};
  group.first = first;
  group.size = size;
  group.has_rows = true;
  for (std::size_t k = 0; k < long_lane_count; ++k) {
    const auto& contact = ready[k < size ? k : 0];
    group.a[k] = contact.a;
    group.b[k] = contact.b;
    if (k >= size) continue;
    group.count = (std::max)(group.count, contact.count);
    group.pushes_a[k] = contact.pushed.a;
    group.pushes_b[k] = contact.pushed.b;
    exchange_rows(group, rows[k], k, contact.count, [](auto& to, const auto& from) { to = from; });
    for (std::size_t i = 0; i < contact.count; ++i) group.gap[i][k] = contact.gap[i];
    place_surface(group, contact, k);
  }
  gather_impulses(group, ready, contacts);
}

/// Copies the rows of a group to its contacts, unless they have them.
template <Scalar S>
constexpr void spread_rows(ContactGroup<S>& group, const ReadyContact<S, 3>* ready,
                           ContactRows<S, 3>* rows) noexcept {
  if (group.has_rows) return;
  group.has_rows = true;
  for (std::size_t k = 0; k < group.size; ++k) {
    rows[k].rolling = nullptr;
    exchange_rows(group, rows[k], k, ready[k].count, [](const auto& from, auto& to) { to = from; });
  }
}

/// Writes impulses back.
template <Scalar S, class Contact>
constexpr void scatter(const ContactGroup<S>& group, ReadyContact<S, 3>* ready,
                       Contact* contacts) noexcept {
  for (std::size_t k = 0; k < group.size; ++k) {
    auto& contact = contacts[ready[k].contact];
    for (std::size_t i = 0; i < ready[k].count; ++i) {
      contact.pressure[i] = group.pressures[i][k];
      ready[k].gap_now[i] = group.gap_now[i][k];
      ready[k].was_pushed[i] = ready[k].was_pushed[i] || group.pressed[i][k] != 0;
    }
    for (std::size_t t = 0; t < 3; ++t) contact.friction[t] = group.frictions[t][k];
  }
}

DETENT_BEGIN_LONG_LANES

/// The passes of solve.hpp for all contacts of a group at once, with the same bits. Each function
/// returns false, and changes nothing, if some number left its range and must be clamped. `AreEven`
/// requires a group with `are_even` and takes fewer products.
template <class L, Scalar S, bool AreEven = false>
class GroupSolver : FourPairs<L, S> {
  using F = Formats<S>;
  using Speed = typename F::Speed;
  using Sum = typename F::Sum;
  using Ratio = typename F::Ratio;
  using Impulse = typename F::Impulse;
  using Group = ContactGroup<S>;
  using Push = typename Group::Push;
  using Lever = typename Group::Lever;
  using Motions = FourMotions<S, L>;
  using Pairs = FourPairs<L, S>;
  using Pairs::a_, Pairs::b_, Pairs::bodies_a_, Pairs::bodies_b_, Pairs::round_;
  template <class T>
  using Side = Four<T, L>;

 public:
  GroupSolver(Group& group, Moving<S, 3>* bodies) noexcept
      : Pairs(bodies, group.a, group.b), group_(group) {}

  [[nodiscard]] bool warm_start() noexcept {
    for (std::size_t i = 0; i < group_.count; ++i) {
      apply(group_.normal, group_.pressure[i], Side<Impulse>(group_.pressures[i]));
    }
    for (std::size_t t = 0; t < 2; ++t) {
      apply(group_.tangent[t], group_.friction[t], Side<Impulse>(group_.frictions[t]));
    }
    turn(group_.twist, Side<Impulse>(group_.frictions[2]));
    return store();
  }

  [[nodiscard]] bool measure_gaps() noexcept {
    const Motions path_a = bodies_a_.paths(), path_b = bodies_b_.paths();
    std::array<Side<Speed>, Group::capacity> gap;
    for (std::size_t i = 0; i < group_.count; ++i) {
      gap[i] = round_.template checked<Speed>(
          Side<Speed>(group_.gap[i]) + rate(group_.normal, group_.pressure[i], path_a, path_b));
    }
    if (round_.is_beyond()) return false;
    for (std::size_t i = 0; i < group_.count; ++i) gap[i].store(group_.gap_now[i]);
    return true;
  }

  template <Pass P>
  [[nodiscard]] bool solve(const Speed& fastest, std::size_t substep) noexcept {
    std::array<Side<Impulse>, Group::capacity> pressures;
    const Motions path_a = P == Pass::relaxed ? bodies_a_.paths() : Motions();
    const Motions path_b = P == Pass::relaxed ? bodies_b_.paths() : Motions();
    for (std::size_t k = 0; k < Group::capacity; ++k) {
      const auto i = nth_point<P, Group::capacity>(k, substep);
      if (i >= group_.count) continue;
      const Lever& lever = group_.pressure[i];
      Side<Speed> gap;
      if constexpr (P == Pass::relaxed) {
        gap = round_.template checked<Speed>(Side<Speed>(group_.gap[i]) +
                                             rate(group_.normal, lever, path_a, path_b));
        gap.store(group_.gap_now[i]);
      } else {
        gap = Side<Speed>(group_.gap_now[i]);
      }
      const Side<Impulse> before(group_.pressures[i]);
      const auto v = rate(group_.normal, lever, a_, b_);
      pressures[i] = pushed<P>(Side<Ratio>(lever.mass), v, gap, before, fastest);
      apply(group_.normal, lever, narrow<31>(pressures[i] - before));
    }
    std::array<Side<Impulse>, 3> frictions;
    if constexpr (P == Pass::relaxed) rub(pressures, frictions);
    if (!store()) return false;
    for (std::size_t i = 0; i < group_.count; ++i) {
      pressures[i].store(group_.pressures[i]);
      (Side<Impulse>(group_.pressed[i]) | pressures[i]).store(group_.pressed[i]);
    }
    if constexpr (P == Pass::relaxed) {
      for (std::size_t t = 0; t < 3; ++t) frictions[t].store(group_.frictions[t]);
    }
    return true;
  }

 private:
  /// c_b . w_b - c_a . w_a.
  [[nodiscard]] Side<Sum> turning(const Lever& lever, const Motions& a,
                                  const Motions& b) const noexcept {
    using Moment = Side<typename F::Moment>;
    Side<Sum> sum;
    for (std::size_t i = 0; i < 3; ++i) {
      sum = sum + (Moment(lever.moment_b[i]) * b.spin[i] - Moment(lever.moment_a[i]) * a.spin[i]);
    }
    return sum;
  }
  /// `rate_along` for four contacts.
  [[nodiscard]] Side<Speed> rate(const Push& push, const Lever& lever, const Motions& a,
                                 const Motions& b) noexcept {
    Side<Fixed<62, Ratio::frac + Speed::frac>> along;
    for (std::size_t i = 0; i < 3; ++i) {
      along = along + Side<Ratio>(push.along[i]) * narrow<31>(b.velocity[i] - a.velocity[i]);
    }
    return round_.template nearest<Speed>(round_.template nearest_long<Sum>(along) +
                                          turning(lever, a, b));
  }
  void turn(const Lever& lever, const Side<Impulse>& impulse) noexcept {
    Pairs::template turn<typename F::Response>(lever.response_a, lever.response_b, impulse);
  }
  void apply(const Push& push, const Lever& lever, const Side<Impulse>& impulse) noexcept {
    if constexpr (AreEven) {
      for (std::size_t i = 0; i < 3; ++i) Pairs::push(i, push.on_a[i], impulse);
    } else {
      for (std::size_t i = 0; i < 3; ++i) Pairs::push(i, push.on_a[i], push.on_b[i], impulse);
    }
    turn(lever, impulse);
  }

  /// The pressure of a point after one more solve, as in `solve_pressure`.
  template <Pass P>
  [[nodiscard]] Side<Impulse> pushed(const Side<Ratio>& mass, const Side<Speed>& v,
                                     const Side<Speed>& gap, const Side<Impulse>& before,
                                     const Speed& fastest) noexcept {
    const Side<Speed> zero;
    const auto is_apart = above(gap, zero);
    const auto to_gap = narrow<31>(v + select(is_apart, gap, zero));
    Side<Impulse> sum;
    if constexpr (P == Pass::biased) {
      const Side<Ratio> rigid(group_.rigid), pull(group_.pull), loss(group_.loss);
      const Side<Fixed<62, Ratio::frac + Speed::frac>> limit(
          L(-(LongWord{fastest.raw()} << Ratio::frac)));
      const auto wanted = round_.template nearest<Speed>(rigid * v + larger(pull * gap, limit));
      sum = round_.minus_nearest(before,
                                 select(is_apart, mass * to_gap, mass * wanted + loss * before));
    } else {
      sum = round_.minus_nearest(before, mass * to_gap);
    }
    return larger(sum, Side<Impulse>());
  }

  /// `solve_friction` for four contacts.
  void rub(const std::array<Side<Impulse>, Group::capacity>& pressures,
           std::array<Side<Impulse>, 3>& frictions) noexcept {
    const Side<Ratio> grip(group_.grip);
    Side<Fixed<62, Impulse::frac>> pressure, at_lever;
    for (std::size_t i = 0; i < group_.count; ++i) {
      pressure = pressure + pressures[i];
      at_lever =
          at_lever + round_.template nearest<Impulse>(Side<Ratio>(group_.reach[i]) * pressures[i]);
    }
    const auto limit_of = [&](const auto& sum) {
      return round_.template nearest<Impulse>(grip * round_.template checked<Impulse>(sum));
    };
    const auto wanted = [&](std::size_t t, const Lever& lever, const Side<Speed>& v) {
      return round_.minus_nearest(Side<Impulse>(group_.frictions[t]), Side<Ratio>(lever.mass) * v);
    };
    const auto change = [&](std::size_t t) {
      return round_.template checked<Impulse>(frictions[t] - Side<Impulse>(group_.frictions[t]));
    };
    const auto twist_limit = limit_of(at_lever);
    const auto spinning = round_.template nearest<Speed>(turning(group_.twist, a_, b_));
    const auto least = narrow<31>(Side<Impulse>() - twist_limit);
    frictions[2] = smaller(larger(wanted(2, group_.twist, spinning), least), twist_limit);
    turn(group_.twist, change(2));

    for (std::size_t t = 0; t < 2; ++t) {
      const Lever& lever = group_.friction[t];
      frictions[t] = wanted(t, lever, rate(group_.tangent[t], lever, a_, b_));
    }
    clamp(frictions, limit_of(pressure));
    for (std::size_t t = 0; t < 2; ++t) {
      apply(group_.tangent[t], group_.friction[t], change(t));
    }
  }
  /// `clamp_to_disc` for four contacts. The sum of squares may be 2^63, so both sides are compared
  /// minus 1.
  void clamp(std::array<Side<Impulse>, 3>& frictions, const Side<Impulse>& limit) noexcept {
    const auto squared = frictions[0] * frictions[0] + frictions[1] * frictions[1];
    const L one(LongWord{1});
    const auto outside = L::above(squared.raw - one, (limit * limit).raw - one);
    if (!outside.any()) return;
    std::array<Quad<Impulse>, 2> each;
    Quad<Impulse> limits;
    limit.store(limits);
    for (std::size_t t = 0; t < 2; ++t) frictions[t].store(each[t]);
    for (std::size_t k = 0; k < group_.size; ++k) {
      std::array<Impulse, 2> impulse{each[0][k], each[1][k]};
      clamp_to_disc<S, 3>(impulse, limits[k]);
      each[0][k] = impulse[0];
      each[1][k] = impulse[1];
    }
    for (std::size_t t = 0; t < 2; ++t) frictions[t] = Side<Impulse>(each[t]);
  }

  [[nodiscard]] bool store() noexcept { return Pairs::store(group_.pushes_a, group_.pushes_b); }

  Group& group_;
};

DETENT_END_LONG_LANES

}  // namespace detent::detail
