// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/joint/kinds.hpp"
#include "detent/dynamics/joint/row.hpp"
#include "detent/dynamics/pairs.hpp"
#include "detent/dynamics/record.hpp"
#include "detent/scene/one_of.hpp"

namespace detent::detail {

/// The number of rows of a joint: pushes and turns.
template <class Joint>
struct RowsOf;
template <Scalar S, int N>
struct RowsOf<DistanceJoint<S, N>> {
  static constexpr std::size_t push = 3, turn = 0;
};
template <Scalar S, int N>
struct RowsOf<BallJoint<S, N>> {
  static constexpr std::size_t push = N, turn = 0;
};
template <Scalar S, int N>
struct RowsOf<ConeJoint<S, N>> {
  static constexpr std::size_t push = N, turn = 3;
};
template <Scalar S, int N>
struct RowsOf<HingeJoint<S, N>> {
  static constexpr std::size_t push = N, turn = N == 2 ? 3 : 5;
};
template <Scalar S, int N>
struct RowsOf<WeldJoint<S, N>> {
  static constexpr std::size_t push = N, turn = N == 2 ? 1 : 3;
};
template <Scalar S, int N>
struct RowsOf<SliderJoint<S, N>> {
  static constexpr std::size_t push = N + 3, turn = N == 2 ? 1 : 3;
};
template <Scalar S, int N>
struct RowsOf<WheelJoint<S, N>> {
  static constexpr std::size_t push = N + 3, turn = N == 2 ? 3 : 5;
};

/// A joint of a world. Its impulses warm-start the next solve.
template <Scalar S, int N, class... Joints>
struct JointRecord {
  using F = Formats<S>;
  static constexpr std::size_t push_room = (std::max)({RowsOf<Joints>::push...});
  static constexpr std::size_t turn_room = (std::max)({RowsOf<Joints>::turn...});

  std::uint32_t generation = 0;  // 0 for an unused index
  OneOf<Joints...> joint{};
  std::array<typename F::Impulse, push_room> push{};
  std::array<typename F::Turn, turn_room> turn{};

  [[nodiscard]] constexpr BodyPair bodies() const noexcept {
    return joint.visit([](const auto& j) { return BodyPair{j.a.index, j.b.index}; });
  }
};

/// A joint, ready to be solved. Impulses are in its record.
template <Scalar S, int N, std::size_t Pushes, std::size_t Turns>
struct ReadyJoint {
  using F = Formats<S>;

  std::uint32_t joint = 0;  // index in the list of joints
  std::uint32_t a = 0, b = 0;
  bool breaks = false, is_broken = false;
  bool is_point = false;           // pushes 0 to 2 are along the axes of the world, in fixed point
  typename F::Impulse strength{};  // the greatest load, if it breaks
  typename F::Torque torque{};     // the greatest of the motor, or of the spring of a hinge
  typename F::Ratio share_a{}, share_b{};
  std::array<PushRow<S, N>, Pushes> push{};
  std::array<TurnRow<S, N>, Turns> turn{};
};

/// x / (m rate^2), summed over the bodies that can move: a force or torque in units of the solver.
template <class T, Scalar S, class Body>
[[nodiscard]] constexpr T over_masses(const S& x, const Body& a, const Body& b, int rate) noexcept {
  const auto over = [&](const Body& body) {
    return body.can_move() ? quotient_nearest<T>(x, body.mass * as_operand<S>(rate * rate)) : T{};
  };
  return saturate_to<T>(over(a) + over(b));
}

/// Sets the laws of a joint's rows, which are constant for a tick.
template <Scalar S, int N, class Ready, class Body>
class LayOut {
 public:
  using F = Formats<S>;
  constexpr LayOut(Ready& ready, const Body& a, const Body& b, int rate) noexcept
      : ready_(ready), a_(a), b_(b), rate_(rate) {}

  constexpr void operator()(const DistanceJoint<S, N>& joint) const noexcept {
    spring(ready_.push[0].terms, joint);
    if (joint.least >= joint.most) {
      push(1, Law::equal);
    } else {
      if (joint.least > 0) push(1, Law::limit);
      push(2, Law::limit);
    }
    strength(joint);
  }
  constexpr void operator()(const BallJoint<S, N>& joint) const noexcept {
    ready_.is_point = is_fixed<S> && N == 3;
    const auto most = over_masses<typename F::Impulse>(joint.max_force, a_, b_, rate_);
    for (std::size_t i = 0; i < std::size_t{N}; ++i) {
      push(i, Law::equal);
      auto& terms = ready_.push[i].terms;
      spring(terms, joint);
      terms.is_capped = joint.max_force > 0;
      if (terms.is_capped) terms.most = most;
    }
    strength(joint);
  }
  constexpr void operator()(const ConeJoint<S, 3>& joint) const noexcept {
    point();
    if (joint.cone_angle > 0) turn(0, Law::limit);
    if (joint.has_limits) limit_angle();
    strength(joint);
  }
  constexpr void operator()(const HingeJoint<S, N>& joint) const noexcept {
    point();
    turning(joint, joint.has_limits);
    spring(ready_.turn[0].terms, joint);
    strength(joint);
  }
  constexpr void operator()(const WeldJoint<S, N>& joint) const noexcept {
    point();
    stiff();
    for (std::size_t i = 0; i < RowsOf<WeldJoint<S, N>>::turn; ++i) {
      spring(ready_.turn[i].terms, joint);
    }
    strength(joint);
  }
  constexpr void operator()(const SliderJoint<S, N>& joint) const noexcept {
    line(joint);
    if (joint.motor_force > 0) {
      auto& terms = ready_.push[0].terms;
      motor(terms, joint.motor_speed);
      terms.most = over_masses<typename F::Impulse>(joint.motor_force, a_, b_, rate_);
    }
    stiff();
    strength(joint);
  }
  constexpr void operator()(const WheelJoint<S, N>& joint) const noexcept {
    line(joint);
    turning(joint, false);
    strength(joint);
  }

 private:
  template <class RowTerms>
  static constexpr void set_law(RowTerms& terms, Law law) noexcept {
    terms.law = law;
    terms.soft = joint_softness<S>;
  }
  constexpr void push(std::size_t i, Law law) const noexcept { set_law(ready_.push[i].terms, law); }
  constexpr void turn(std::size_t i, Law law) const noexcept { set_law(ready_.turn[i].terms, law); }
  /// Its greatest force or torque is set by the caller.
  template <class RowTerms>
  constexpr void motor(RowTerms& terms, const S& speed) const noexcept {
    set_law(terms, Law::motor);
    terms.target = quotient_nearest<decltype(terms.target)>(speed, as_operand<S>(rate_));
    terms.is_capped = true;
  }
  /// Makes a row a spring if the joint has one.
  template <class RowTerms, class Joint>
  constexpr void spring(RowTerms& terms, const Joint& joint) const noexcept {
    if (joint.frequency <= 0) return;
    terms.law = Law::spring;
    terms.soft = spring_softness(joint.frequency, joint.damping_ratio, rate_);
  }
  constexpr void point() const noexcept {
    ready_.is_point = is_fixed<S> && N == 3;
    for (std::size_t i = 0; i < std::size_t{N}; ++i) push(i, Law::equal);
  }
  constexpr void stiff() const noexcept {
    for (std::size_t i = 0; i < (N == 2 ? 1 : 3); ++i) turn(i, Law::equal);
  }
  constexpr void limit_angle() const noexcept {
    turn(1, Law::limit);
    turn(2, Law::limit);
  }
  template <class Joint>
  constexpr void line(const Joint& joint) const noexcept {
    spring(ready_.push[1].terms, joint);
    if (joint.has_limits) {
      push(2, Law::limit);
      push(3, Law::limit);
    }
    for (std::size_t i = 4; i < std::size_t{N} + 3; ++i) push(i, Law::equal);
  }
  template <class Joint>
  constexpr void turning(const Joint& joint, bool has_limits) const noexcept {
    if (joint.motor_torque > 0) {
      motor(ready_.turn[0].terms, joint.motor_speed);
      ready_.torque = over_masses<typename F::Torque>(joint.motor_torque, a_, b_, rate_);
    }
    if (has_limits) limit_angle();
    if constexpr (N == 3) {
      turn(3, Law::equal);
      turn(4, Law::equal);
    }
  }
  constexpr void strength(const JointEnds<S, N>& joint) const noexcept {
    ready_.breaks = joint.break_force > 0;
    if (!ready_.breaks) return;
    ready_.strength = over_masses<typename F::Impulse>(joint.break_force, a_, b_, rate_);
  }

  Ready& ready_;
  const Body &a_, &b_;
  int rate_;
};

}  // namespace detent::detail
