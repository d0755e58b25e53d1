// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/dynamics/flight.hpp"
#include "detent/dynamics/joint/aim.hpp"
#include "detent/dynamics/joint/four_joints.hpp"

namespace detent::detail {

/// The joint capacity of a world with this body capacity.
[[nodiscard]] constexpr std::size_t joint_room(std::size_t bodies) noexcept { return 2 * bodies; }

/// The joints of a tick: scratch data that does not outlive the step.
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
      const Ready ready = ready_of(record, static_cast<std::uint32_t>(i), bodies, rate);
      for (std::size_t k = 0; k < record.push.size(); ++k) {
        if (ready.push[k].terms.law == Law::none) record.push[k] = {};
      }
      for (std::size_t k = 0; k < record.turn.size(); ++k) {
        if (ready.turn[k].terms.law == Law::none) record.turn[k] = {};
      }
      joined_[pair.a] = joined_[pair.b] = 1;
      ready_.push_back(ready);
    }
    if constexpr (has_fours) line_up(joints, bodies);
    aim(joints, supports);
  }

  /// Updates the rows after bodies have moved. `supports` has their new axes if they can move and
  /// are not round.
  template <class Bodies, class Supports>
  constexpr void follow(const List& joints, const Bodies& bodies, Supports& supports) {
    if (ready_.size() == 0) return;
    SupportQueue<has_fours, S, N, Bodies, Supports> queue(bodies, supports);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (joined_[i] != 0 && bodies[i].motion != BodyMotion::fixed) {
        queue.add(i, tumbles(bodies[i]));
      }
    }
    queue.flush();
    aim(joints, supports);
  }

  template <class Movings, class Supports>
  constexpr void warm_start(List& joints, Movings& moving, const Supports& supports) {
    visit(
        joints, moving, supports, [](auto& solver) { return solver.warm_start(); },
        [&](Ready& ready) {
          const Record& record = joints[ready.joint];
          auto &a = moving[ready.a], &b = moving[ready.b];
          for (std::size_t k = 0; k < record.turn.size(); ++k) {
            if (ready.turn[k].terms.law != Law::none) apply(ready.turn[k], record.turn[k], a, b);
          }
          if constexpr (has_points) {
            if (ready.is_point) {
              return for_each_axis([&]<int I>(std::integral_constant<int, I>) {
                const auto& row = ready.push[std::size_t{I}];
                apply_along_axis<I, S>(row.thrust, row.row, record.push[std::size_t{I}], a, b);
              });
            }
          }
          for (std::size_t k = 0; k < record.push.size(); ++k) {
            const auto& row = ready.push[k];
            if (row.terms.law != Law::none) apply(row.thrust, row.row, record.push[k], a, b);
          }
        });
  }

  template <Pass P, class Movings, class Supports>
  constexpr void solve_all(List& joints, Movings& moving, const Supports& supports) {
    visit(
        joints, moving, supports, [](auto& solver) { return solver.template solve<P>(); },
        [&](Ready& ready) {
          Record& record = joints[ready.joint];
          auto &a = moving[ready.a], &b = moving[ready.b];
          for (std::size_t k = 0; k < record.turn.size(); ++k) {
            if (ready.turn[k].terms.law == Law::none) continue;
            solve<P>(ready.turn[k], record.turn[k], a, b);
          }
          if constexpr (has_points) {
            if (ready.is_point) {
              for_each_axis([&]<int I>(std::integral_constant<int, I>) {
                constexpr auto k = std::size_t{I};
                solve_along_axis<P, I, S>(ready.push[k], record.push[k], a, b);
              });
            }
          }
          if (!has_points || !ready.is_point) {
            for (std::size_t k = 0; k < record.push.size(); ++k) {
              if (ready.push[k].terms.law == Law::none) continue;
              solve<P>(ready.push[k], record.push[k], a, b);
            }
          }
          if (P == Pass::relaxed && ready.breaks && is_overloaded(ready, record)) {
            ready.is_broken = true;
          }
        });
  }

  /// Writes the impulses back, after the last pass of a tick.
  constexpr void finish(List& joints) noexcept {
    if constexpr (has_fours) {
      for (auto& four : fours_) scatter(four, joints);
    }
  }

  /// The sum of all pushes of a joint along their directions, for the current poses of its bodies.
  template <class Bodies>
  [[nodiscard]] static constexpr auto load_of(const Record& record, const Bodies& bodies,
                                              int rate) noexcept {
    return aimed(record, bodies, rate,
                 [&](const Ready& ready, const auto&) { return load_of(ready, record); });
  }
  /// The sum of all turns of a joint about their axes, over the masses, for the current poses of its
  /// bodies.
  template <class Bodies>
  [[nodiscard]] static constexpr auto twist_of(const Record& record, const Bodies& bodies,
                                               int rate) noexcept {
    using Torque = typename Formats<S>::Torque;
    return aimed(record, bodies, rate, [&](const Ready& ready, const auto& rows) {
      Axial<Torque, N> sum{};
      for (std::size_t k = 0; k < record.turn.size(); ++k) {
        if (ready.turn[k].terms.law == Law::none) continue;
        const auto turned = rows.turned(k, record.turn[k]);
        for (std::size_t i = 0; i < sum.size(); ++i) {
          sum[i] = saturate_to<Torque>(sum[i] + nearest_to<Torque>(ready.turn[k].axis[i] * turned));
        }
      }
      return sum;
    });
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

  /// Joints in the order in which they are solved: one, or four.
  struct Place {
    bool is_four = false;
    std::uint32_t index = 0;
  };

  static constexpr bool has_fours = uses_long_lanes<Storage, S, N>;
  static constexpr bool has_points = is_fixed<S> && N == 3 && Record::push_room >= 3;
  template <class F>
  static constexpr void for_each_axis(const F& f) {
    f(std::integral_constant<int, 0>());
    f(std::integral_constant<int, 1>());
    f(std::integral_constant<int, 2>());
  }
  using FourOf = std::conditional_t<is_fixed<S> && N == 3, FourJoints<S, Record::turn_room>, Place>;
  /// A joint, the least number of joints that must come before it, and its kind.
  struct Line {
    std::uint32_t depth = 0, kind = 0, ready = 0;
    [[nodiscard]] friend constexpr auto operator<=>(const Line&, const Line&) noexcept = default;
  };

  /// Calls together(solver) for four joints or alone(ready) for one, in the order of each body's
  /// joints, and `alone` for each of four joints that `together` refuses.
  template <class Movings, class Supports, class Together, class Alone>
  constexpr void visit(List& joints, Movings& moving, const Supports& supports,
                       const Together& together, const Alone& alone) {
    if constexpr (has_fours) {
      for (const auto& turn : turns_) {
        if (!turn.is_four) {
          alone(ready_[turn.index]);
          continue;
        }
        auto& four = fours_[turn.index];
        if (!four.is_alone) {
          FourJointsSolver<FastLongLanes, S, Record::turn_room> solver(four, moving.data());
          if (together(solver)) continue;
        }
        scatter(four, joints);
        for (std::size_t k = 0; k < four.size; ++k) {
          Ready& ready = ready_[four.ready[k]];
          aim(ready, joints, supports);
          alone(ready);
        }
        gather(four, joints);
      }
    } else {
      for (std::size_t i = 0; i < ready_.size(); ++i) alone(ready_[i]);
    }
  }

  /// Groups joints of the same kind. A joint comes after all earlier joints of its bodies that can
  /// move, so joints with equally many predecessors share no such body and may be solved in any
  /// order.
  template <class Bodies>
  constexpr void line_up(const List& joints, const Bodies& bodies) requires(has_fours) {
    turns_.clear();
    fours_.clear();
    lines_.clear();
    depth_.clear();
    depth_.resize(bodies.size());
    for (std::uint32_t i = 0; i < ready_.size(); ++i) {
      const Ready& ready = ready_[i];
      const auto &a = bodies[ready.a], &b = bodies[ready.b];
      const auto depth = (std::max)(a.can_move() ? depth_[ready.a] : std::uint32_t{0},
                                    b.can_move() ? depth_[ready.b] : std::uint32_t{0});
      if (a.can_move()) depth_[ready.a] = depth + 1;
      if (b.can_move()) depth_[ready.b] = depth + 1;
      const bool is_locked = (a.can_move() && a.locked != 0) || (b.can_move() && b.locked != 0);
      const auto kind = is_locked || !runs_vectors()
                            ? std::uint32_t{0}
                            : joints[ready.joint].joint.visit(
                                  [&](const auto& joint) { return kind_of<S>(joint, ready); });
      lines_.push_back({depth, kind, i});
    }
    std::sort(lines_.begin(), lines_.end());
    for (std::size_t i = 0; i < lines_.size();) {
      if (lines_[i].kind == 0) {
        turns_.push_back({false, lines_[i++].ready});
        continue;
      }
      FourOf four;
      const auto first = lines_[i];
      for (; i < lines_.size() && four.size < 4 && lines_[i].depth == first.depth &&
             lines_[i].kind == first.kind;
           ++i) {
        four.ready[four.size++] = lines_[i].ready;
      }
      place(four, joints, bodies);
      turns_.push_back({true, static_cast<std::uint32_t>(fours_.size())});
      fours_.push_back(four);
    }
  }
  template <class Bodies>
  constexpr void place(FourOf& four, const List& joints, const Bodies& bodies) const {
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      const Ready& ready = ready_[four.ready[k < four.size ? k : 0]];
      four.a[k] = ready.a;
      four.b[k] = ready.b;
      if (k >= four.size) continue;
      four.moves_a[k] = bodies[ready.a].can_move();
      four.moves_b[k] = bodies[ready.b].can_move();
      four.share_a[k] = ready.share_a;
      four.share_b[k] = ready.share_b;
      joints[ready.joint].joint.visit([&](const auto& joint) {
        for (std::size_t i = 0; i < 3; ++i) {
          four.anchor_a[i][k] = joint.anchor_a[static_cast<int>(i)];
          four.anchor_b[i][k] = joint.anchor_b[static_cast<int>(i)];
        }
      });
      for (std::size_t i = 0; i < ready.turn.size(); ++i) {
        four.turn[i].law = ready.turn[i].terms.law;
      }
    }
    gather(four, joints);
  }
  constexpr void gather(FourOf& four, const List& joints) const noexcept {
    for (std::size_t k = 0; k < four.size; ++k) {
      const Record& record = joints[ready_[four.ready[k]].joint];
      for (std::size_t i = 0; i < 3; ++i) four.total[i][k] = record.push[i];
      for (std::size_t i = 0; i < record.turn.size(); ++i) four.turn[i].total[k] = record.turn[i];
    }
  }
  constexpr void scatter(const FourOf& four, List& joints) const noexcept {
    for (std::size_t k = 0; k < four.size; ++k) {
      Record& record = joints[ready_[four.ready[k]].joint];
      for (std::size_t i = 0; i < 3; ++i) record.push[i] = four.total[i][k];
      for (std::size_t i = 0; i < record.turn.size(); ++i) record.turn[i] = four.turn[i].total[k];
    }
  }

  template <class Supports>
  constexpr void aim(const List& joints, const Supports& supports) {
    if constexpr (has_fours) {
      for (const auto& turn : turns_) {
        if (turn.is_four) {
          aim(fours_[turn.index], joints, supports);
        } else {
          aim(ready_[turn.index], joints, supports);
        }
      }
    } else {
      for (std::size_t i = 0; i < ready_.size(); ++i) aim(ready_[i], joints, supports);
    }
  }
  template <class Supports>
  static constexpr void aim(Ready& ready, const List& joints, const Supports& supports) {
    Aim<S, N, Ready> rows(ready, supports[ready.a], supports[ready.b]);
    joints[ready.joint].joint.visit(rows);
  }
  template <class Supports>
  constexpr void aim(FourOf& four, const List& joints, const Supports& supports) {
    four.is_alone = !aim_points<FastLongLanes>(four, supports.data());
    bool turns = false;
    for (const auto& row : four.turn) turns = turns || row.law != Law::none;
    for (std::size_t k = 0; turns && !four.is_alone && k < four.size; ++k) {
      Ready& ready = ready_[four.ready[k]];
      Aim<S, N, Ready> rows(ready, supports[ready.a], supports[ready.b]);
      joints[ready.joint].joint.visit([&](const auto& joint) { rows.aim_turns(joint); });
      for (std::size_t i = 0; i < ready.turn.size(); ++i) {
        const auto& from = ready.turn[i];
        auto& to = four.turn[i];
        for (std::size_t c = 0; c < 3; ++c) {
          to.axis[c][k] = from.axis[c];
          to.on_a[c][k] = from.on_a[c];
          to.on_b[c][k] = from.on_b[c];
        }
        to.gap[k] = from.gap;
      }
    }
  }

  /// A joint before its rows are aimed.
  template <class Bodies>
  static constexpr Ready ready_of(const Record& record, std::uint32_t joint, const Bodies& bodies,
                                  int rate) noexcept {
    const auto pair = record.bodies();
    const auto &a = bodies[pair.a], &b = bodies[pair.b];
    Ready ready;
    ready.joint = joint;
    ready.a = pair.a;
    ready.b = pair.b;
    const auto [share_a, share_b] = mass_shares<S>(a, b);
    ready.share_a = share_a;
    ready.share_b = share_b;
    record.joint.visit(LayOut<S, N, Ready, std::remove_cvref_t<decltype(a)>>(ready, a, b, rate));
    return ready;
  }

  /// f(ready, aim) for a joint whose rows are aimed at the current poses of its bodies.
  template <class Bodies, class F>
  static constexpr auto aimed(const Record& record, const Bodies& bodies, int rate,
                              const F& f) noexcept {
    Ready ready = ready_of(record, 0, bodies, rate);
    const auto a = support_of<S, N>(bodies[ready.a]), b = support_of<S, N>(bodies[ready.b]);
    Aim<S, N, Ready> rows(ready, a, b);
    record.joint.visit(rows);
    return f(ready, rows);
  }
  static constexpr auto load_of(const Ready& ready, const Record& record) noexcept {
    using Length = typename Formats<S>::Length;
    return make_vec<N>([&](int i) {
      Length sum{};
      for (std::size_t k = 0; k < record.push.size(); ++k) {
        if (ready.push[k].terms.law == Law::none) continue;
        sum = saturate_to<Length>(
            sum + nearest_to<Length>(ready.push[k].thrust.along[i] * record.push[k]));
      }
      return sum;
    });
  }
  /// Whether the sum of all pushes is longer than the strength of the joint.
  static constexpr bool is_overloaded(const Ready& ready, const Record& record) noexcept {
    return squared_length(load_of(ready, record)) > square(ready.strength);
  }

  typename Storage::template List<Ready, room> ready_;
  typename Storage::template List<BodyPair, room> apart_;
  typename Storage::template List<std::uint8_t, Storage::capacity> joined_;

  // Only for growing worlds, on machines with long lanes.
  typename Storage::template List<FourOf, 0> fours_;
  typename Storage::template List<Place, 0> turns_;
  typename Storage::template List<Line, 0> lines_;
  typename Storage::template List<std::uint32_t, 0> depth_;
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
  template <class Movings, class Supports>
  static constexpr void warm_start(const List&, const Movings&, const Supports&) noexcept {}
  template <Pass, class Movings, class Supports>
  static constexpr void solve_all(const List&, const Movings&, const Supports&) noexcept {}
  static constexpr void finish(const List&) noexcept {}
  template <class F>
  static constexpr void for_each_broken(const F&) noexcept {}
};

}  // namespace detent::detail
