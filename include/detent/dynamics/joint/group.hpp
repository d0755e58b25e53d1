// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/flight.hpp"
#include "detent/dynamics/joint/aim.hpp"

namespace detent::detail {

/// The joint capacity of a world with this body capacity.
[[nodiscard]] constexpr std::size_t joint_room(std::size_t bodies) noexcept { return 2 * bodies; }

/// The joints of a tick. It is scratch data that does not outlive the step.
template <class Storage, Scalar S, int N, class... Joints>
class JointGroup {
 public:
  using Record = JointRecord<S, N, Joints...>;
  static constexpr std::size_t room = joint_room(Storage::capacity);
  using List = typename Storage::template List<Record, room>;
  using Broken = typename Storage::template List<JointId, room>;

  /// Finds the pairs that may not collide.
  constexpr void part(const List& joints) {
    apart_.clear();
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (joints[i].generation == 0) continue;
      const bool collide = joints[i].joint.visit([](const auto& joint) { return joint.collide; });
      const auto pair = joints[i].bodies();
      if (!collide) apart_.push_back(pair.a < pair.b ? pair : BodyPair{pair.b, pair.a});
    }
    if (apart_.size() != 0) std::sort(&apart_[0], &apart_[0] + apart_.size());
  }
  [[nodiscard]] constexpr bool keeps_apart(const BodyPair& pair) const noexcept {
    return apart_.size() != 0 && std::binary_search(&apart_[0], &apart_[0] + apart_.size(), pair);
  }

  /// Calls f(a, b) for the bodies of each joint.
  template <class F>
  static constexpr void for_each_pair(const List& joints, const F& f) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (joints[i].generation == 0) continue;
      const auto pair = joints[i].bodies();
      f(pair.a, pair.b);
    }
  }

  /// Prepares the joints of bodies that are awake, in the order of their indices.
  template <class Bodies, class Supports>
  constexpr void prepare(List& joints, const Bodies& bodies, Supports& supports, int rate) {
    ready_.clear();
    joined_.clear();
    joined_.resize(bodies.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
      Record& record = joints[i];
      if (record.generation == 0) continue;
      const auto pair = record.bodies();
      const auto &a = bodies[pair.a], &b = bodies[pair.b];
      if ((!a.can_move() || a.sleeps) && (!b.can_move() || b.sleeps)) continue;
      Ready ready;
      ready.joint = static_cast<std::uint32_t>(i);
      ready.a = pair.a;
      ready.b = pair.b;
      const auto [share_a, share_b] = mass_shares<S>(a, b);
      ready.share_a = share_a;
      ready.share_b = share_b;
      const LayOut<S, N, Ready, std::remove_cvref_t<decltype(a)>> lay_out(ready, a, b, rate);
      record.joint.visit(lay_out);
      for (std::size_t k = 0; k < record.push.size(); ++k) {
        if (ready.push[k].terms.law == Law::none) record.push[k] = {};
      }
      for (std::size_t k = 0; k < record.turn.size(); ++k) {
        if (ready.turn[k].terms.law == Law::none) record.turn[k] = {};
      }
      joined_[pair.a] = joined_[pair.b] = 1;
      ready_.push_back(ready);
    }
    aim(joints, supports);
  }

  /// Updates the rows after bodies have moved. `supports` has their new axes if they can move and
  /// are not round.
  template <class Bodies, class Supports>
  constexpr void follow(const List& joints, const Bodies& bodies, Supports& supports) {
    if (ready_.size() == 0) return;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (joined_[i] != 0 && bodies[i].motion != BodyMotion::fixed) {
        supports[i] = N == 3 && bodies[i].can_move() && !bodies[i].inertia.is_round
                          ? support_of<S, N>(bodies[i], supports[i].axes)
                          : support_of<S, N>(bodies[i]);
      }
    }
    aim(joints, supports);
  }

  template <class Movings>
  constexpr void warm_start(const List& joints, Movings& moving) noexcept {
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      const Ready& ready = ready_[i];
      const Record& record = joints[ready.joint];
      auto &a = moving[ready.a], &b = moving[ready.b];
      for (std::size_t k = 0; k < record.turn.size(); ++k) {
        if (ready.turn[k].terms.law != Law::none) apply(ready.turn[k], record.turn[k], a, b);
      }
      for (std::size_t k = 0; k < record.push.size(); ++k) {
        const auto& row = ready.push[k];
        if (row.terms.law != Law::none) apply(row.thrust, row.row, record.push[k], a, b);
      }
    }
  }

  template <Pass pass, class Movings>
  constexpr void solve_all(List& joints, Movings& moving) noexcept {
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      Ready& ready = ready_[i];
      Record& record = joints[ready.joint];
      auto &a = moving[ready.a], &b = moving[ready.b];
      for (std::size_t k = 0; k < record.turn.size(); ++k) {
        if (ready.turn[k].terms.law == Law::none) continue;
        solve<pass>(ready.turn[k], record.turn[k], a, b);
      }
      for (std::size_t k = 0; k < record.push.size(); ++k) {
        if (ready.push[k].terms.law == Law::none) continue;
        solve<pass>(ready.push[k], record.push[k], a, b);
      }
      if (pass == Pass::relaxed && ready.breaks && is_overloaded(ready, record)) {
        ready.is_broken = true;
      }
    }
  }

  /// Calls f(index) for each joint that broke in this tick, in order.
  template <class F>
  constexpr void for_each_broken(const F& f) const {
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      if (ready_[i].is_broken) f(ready_[i].joint);
    }
  }

 private:
  using Ready = ReadyJoint<S, N, Record::push_room, Record::turn_room>;

  template <class Supports>
  constexpr void aim(const List& joints, const Supports& supports) {
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      Ready& ready = ready_[i];
      Aim<S, N, Ready> rows(ready, supports[ready.a], supports[ready.b]);
      joints[ready.joint].joint.visit(rows);
    }
  }

  /// Whether the sum of all pushes is longer than the strength of the joint.
  static constexpr bool is_overloaded(const Ready& ready, const Record& record) noexcept {
    using Length = typename Formats<S>::Length;
    const auto load = make_vec<N>([&](int i) {
      Length sum{};
      for (std::size_t k = 0; k < record.push.size(); ++k) {
        if (ready.push[k].terms.law == Law::none) continue;
        sum = saturate_to<Length>(
            sum + nearest_to<Length>(ready.push[k].thrust.along[i] * record.push[k]));
      }
      return sum;
    });
    return squared_length(load) > square(ready.strength);
  }

  typename Storage::template List<Ready, room> ready_;
  typename Storage::template List<BodyPair, room> apart_;
  typename Storage::template List<std::uint8_t, Storage::capacity> joined_;
};

/// A world without joint types.
template <class Storage, Scalar S, int N>
class JointGroup<Storage, S, N> {
 public:
  struct Record {};
  struct List {
    static constexpr std::size_t size() noexcept { return 0; }
    static constexpr void clear() noexcept {}
  };
  static constexpr std::size_t room = 0;

  static constexpr void part(const List&) noexcept {}
  static constexpr bool keeps_apart(const BodyPair&) noexcept { return false; }
  template <class F>
  static constexpr void for_each_pair(const List&, const F&) noexcept {}
  template <class Bodies, class Supports>
  static constexpr void prepare(const List&, const Bodies&, const Supports&, int) noexcept {}
  template <class Bodies, class Supports>
  static constexpr void follow(const List&, const Bodies&, const Supports&) noexcept {}
  template <class Movings>
  static constexpr void warm_start(const List&, const Movings&) noexcept {}
  template <Pass, class Movings>
  static constexpr void solve_all(const List&, const Movings&) noexcept {}
  template <class F>
  static constexpr void for_each_broken(const F&) noexcept {}
};

}  // namespace detent::detail
