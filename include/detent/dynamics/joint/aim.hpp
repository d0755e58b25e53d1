// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/joint/ready.hpp"
#include "detent/number/angle.hpp"

namespace detent::detail {

/// The angle in [-pi, pi) of a vector: rounded to nearest in steps of 2^-32 turn, then in radians.
template <Scalar S, class F = Formats<S>>
[[nodiscard]] constexpr typename F::Spin angle_of_vector(const typename F::Ratio& x,
                                                         const typename F::Ratio& y) noexcept {
  if constexpr (is_fixed<S>) {
    const auto half_turns = static_cast<std::int32_t>(binary_angle(y.raw(), x.raw()));
    return nearest_to<typename F::Spin>(times_pi(Fixed<31, 31>::assume_raw(half_turns)));
  } else {
    return (atan2(y, x).radians)();
  }
}

/// A vector of a body's frame, in the world.
///
/// |row of axes| |v| < 2^30 2^31 sqrt(3) (1 + 2^-28) fits 62 bits.
template <class T, Scalar S, int N, Number V>
[[nodiscard]] constexpr Vec<T, N> out_of(const Axes<S, N>& axes, const Vec<V, N>& v) noexcept {
  return make_vec<N>([&](int k) {
    const auto row = make_vec<N>([&](int i) { return axes[static_cast<std::size_t>(i)][k]; });
    return nearest_to<T>(narrow_dot<62>(row, v));
  });
}

/// Computes the rows of a joint for the current poses of its bodies.
template <Scalar S, int N, class Ready>
class Aim {
 public:
  using F = Formats<S>;
  using Arm = typename F::Arm;
  using Ratio = typename F::Ratio;
  using Reach = typename F::Reach;
  using Speed = typename F::Speed;
  using Spin = typename F::Spin;
  using TurnShare = typename F::TurnShare;

  constexpr Aim(Ready& ready, const Support<S, N>& a, const Support<S, N>& b) noexcept
      : ready_(ready), a_(a), b_(b), spread_a_(a.spread), spread_b_(b.spread) {
    for (auto& x : spread_a_) x = nearest_to<typename F::Gyration>(x * ready.share_a);
    for (auto& x : spread_b_) x = nearest_to<typename F::Gyration>(x * ready.share_b);
  }

  constexpr void operator()(const DistanceJoint<S, N>& joint) noexcept {
    find_points(joint);
    const auto length = sqrt_floor<Reach>(squared_length(between_));
    const auto along =
        from_array(unit_vector<Ratio>(to_array(between_)).value_or(to_array(unit_axis(0))));
    push(0, along, length - joint.length);
    push(1, along, length - (joint.least < joint.most ? joint.least : joint.most));
    push(2, narrow_negative(along), joint.most - length);
  }
  constexpr void operator()(const BallJoint<S, N>& joint) noexcept { point(joint); }
  constexpr void operator()(const ConeJoint<S, 3>& joint) noexcept {
    point(joint);
    aim_turns(joint);
  }
  constexpr void operator()(const HingeJoint<S, N>& joint) noexcept {
    point(joint);
    aim_turns(joint);
  }
  constexpr void operator()(const WeldJoint<S, N>& joint) noexcept {
    point(joint);
    aim_turns(joint);
  }
  constexpr void operator()(const SliderJoint<S, N>& joint) noexcept {
    find_axes(joint);
    line(joint);
    stiff();
  }
  constexpr void operator()(const WheelJoint<S, N>& joint) noexcept {
    find_axes(joint);
    line(joint);
    turning();
  }

  /// Computes only the rows of turns, for joints that keep two points together.
  template <class Joint>
  constexpr void aim_turns(const Joint&) noexcept {}
  constexpr void aim_turns(const ConeJoint<S, 3>& joint) noexcept {
    find_axes(joint);
    if (ready_.turn[0].terms.law != Law::none) swinging(joint);
    if (ready_.turn[1].terms.law != Law::none) twisting(joint);
  }
  constexpr void aim_turns(const HingeJoint<S, N>& joint) noexcept {
    find_axes(joint);
    const bool is_spring = ready_.turn[0].terms.law == Law::spring;
    const bool is_limited = ready_.turn[1].terms.law != Law::none;
    const auto angle =
        is_spring || is_limited ? angle_of_vector<S>(cosine(0, 0), cosine(1, 0)) : Spin{};
    turning(is_spring ? saturate_to<Spin>(angle - joint.angle) : Spin{});
    if (!is_limited) return;
    turn(1, hinge_axis(), saturate_to<Spin>(angle - joint.lower));
    turn_back(2, 1, saturate_to<Spin>(joint.upper - angle));
  }
  constexpr void aim_turns(const WeldJoint<S, N>& joint) noexcept {
    find_axes(joint);
    stiff();
  }

  /// The angular impulse of turn i about its axis, over the masses; 0 if neither body can turn.
  [[nodiscard]] constexpr typename F::Torque turned(std::size_t i,
                                                    const typename F::Turn& by) const noexcept {
    auto row = ready_.turn[i];
    const auto whole = share_out(row, spread_a_, spread_b_);
    return whole > 0 ? quotient_nearest<typename F::Torque>(by, whole) : typename F::Torque{};
  }

 private:
  static constexpr Vec<Ratio, N> unit_axis(int i) noexcept {
    Vec<Ratio, N> axis{};
    axis[i] = Ratio(1);
    return axis;
  }
  static constexpr Axial<Ratio, N> reversed(Axial<Ratio, N> axis) noexcept {
    for (auto& x : axis) x = narrow_negative(x);
    return axis;
  }

  /// The anchors relative to the centers, and the anchor of b relative to that of a.
  constexpr void find_points(const JointEnds<S, N>& joint) noexcept {
    from_a_ = out_of<Reach, S, N>(a_.axes, joint.anchor_a);
    from_b_ = out_of<Reach, S, N>(b_.axes, joint.anchor_b);
    between_ = make_vec<N>([&](int i) {
      return saturate_to<Reach>((b_.place[i] - a_.place[i]) + (from_b_[i] - from_a_[i]));
    });
  }
  constexpr void find_axes(const FramedEnds<S, N>& joint) noexcept {
    for (int i = 0; i < N; ++i) {
      const auto k = static_cast<std::size_t>(i);
      axes_a_[k] = out_of<Ratio, S, N>(a_.axes, joint.frame_a.axis(i).vec());
      axes_b_[k] = out_of<Ratio, S, N>(b_.axes, joint.frame_b.axis(i).vec());
    }
  }
  /// Axis i of a times axis j of b.
  [[nodiscard]] constexpr Ratio cosine(std::size_t i, std::size_t j) const noexcept {
    return nearest_to<Ratio>(narrow_dot<62>(axes_a_[i], axes_b_[j]));
  }

  /// Removes the locked axes from a push. Returns the part of the motion along it that is lost.
  constexpr typename F::Give lose_locked(PushRow<S, N>& row) const noexcept {
    return lock<S, N>(row.thrust, a_.locked, b_.locked);
  }

  /// A push along `along`, at both anchors or, for a line, at that of b only.
  template <class Gap>
  constexpr void push(std::size_t i, const Vec<Ratio, N>& along, const Gap& gap,
                      bool is_line = false) noexcept {
    auto& row = ready_.push[i];
    if (row.terms.law == Law::none) return;
    row.thrust = push_along<S, N>(along, ready_.share_a, ready_.share_b);
    const auto lost = lose_locked(row);
    row.row = {};
    if (!a_.is_fixed) {
      const auto arm = make_vec<N>([&](int k) {
        return is_line ? saturate_to<Arm>(from_a_[k] + between_[k]) : saturate_to<Arm>(from_a_[k]);
      });
      row.row.moment_a = moment<S, N>(arm, along);
    }
    if (!b_.is_fixed) {
      row.row.moment_b =
          moment<S, N>(make_vec<N>([&](int k) { return saturate_to<Arm>(from_b_[k]); }), along);
    }
    complete<S, N>(row.row, spread_a_, spread_b_, lost);
    row.gap = saturate_to<Speed>(gap);
  }
  constexpr void turn(std::size_t i, const Axial<Ratio, N>& axis, const Spin& gap) noexcept {
    auto& row = ready_.turn[i];
    if (row.terms.law == Law::none) return;
    row.axis = axis;
    const auto whole = share_out(row, spread_a_, spread_b_);
    if (row.terms.is_capped) {
      row.terms.most = nearest_to<typename F::Turn>(ready_.torque * whole);
      if (row.terms.most < 0) row.terms.most = {};
    }
    row.gap = gap;
  }

  /// Makes row i turn about the opposite axis of row j: its shares are negated, or recomputed if
  /// one is at the end of its range.
  constexpr void turn_back(std::size_t i, std::size_t j, const Spin& gap) noexcept {
    auto& row = ready_.turn[i];
    const auto& other = ready_.turn[j];
    if (row.terms.law == Law::none) return;
    const auto copy = [](auto& to, const auto& from) {
      for (std::size_t k = 0; k < from.size(); ++k) {
        if (abs(from[k]) >= TurnShare(64)) return false;
        to[k] = narrow_negative(from[k]);
      }
      return true;
    };
    const bool are_within = copy(row.on_a, other.on_a) && copy(row.on_b, other.on_b);
    if (!are_within) return turn(i, reversed(other.axis), gap);
    row.axis = reversed(other.axis);
    row.gap = gap;
  }

  constexpr void point(const JointEnds<S, N>& joint) noexcept {
    find_points(joint);
    if constexpr (is_fixed<S> && N == 3) {
      push_along_axis<0>();
      push_along_axis<1>();
      push_along_axis<2>();
    } else {
      for (int i = 0; i < N; ++i) {
        push(static_cast<std::size_t>(i), unit_axis(i), between_[i]);
      }
    }
  }
  /// A push along axis I of the world, as `push` computes it; in fixed point only.
  template <int I>
  constexpr void push_along_axis() noexcept {
    auto& row = ready_.push[std::size_t{I}];
    row.thrust = {unit_axis(I), {}, {}};
    row.thrust.on_a[I] = ready_.share_a;
    row.thrust.on_b[I] = ready_.share_b;
    const auto lost = lose_locked(row);
    row.row = {};
    const auto gives = [](const auto& body, const auto& from, const auto& spread, auto& moment,
                          auto& response) {
      if (body.is_fixed) return typename F::Give{};
      const auto arm = make_vec<3>([&](int k) { return saturate_to<Arm>(from[k]); });
      return turn_about_axis<I, S>(arm, spread, moment, response);
    };
    const auto of_a = gives(a_, from_a_, spread_a_, row.row.moment_a, row.row.response_a);
    const auto of_b = gives(b_, from_b_, spread_b_, row.row.moment_b, row.row.response_b);
    row.row.mass = effective_mass<S>(lost, of_a + of_b);
    row.gap = saturate_to<Speed>(between_[I]);
  }
  template <class Joint>
  constexpr void line(const Joint& joint) noexcept {
    find_points(joint);
    const auto& along = axes_a_[0];
    const auto at = nearest_to<Reach>(dot(along, between_));
    push(0, along, Speed{}, true);
    push(1, along, at - joint.length, true);
    push(2, along, at - joint.lower, true);
    push(3, narrow_negative(along), joint.upper - at, true);
    for (std::size_t i = 1; i < std::size_t{N}; ++i) {
      push(3 + i, axes_a_[i], nearest_to<Reach>(dot(axes_a_[i], between_)), true);
    }
  }
  [[nodiscard]] constexpr Axial<Ratio, N> hinge_axis() const noexcept {
    if constexpr (N == 2) {
      return {Ratio(1)};
    } else {
      return to_array(axes_a_[2]);
    }
  }
  /// The motor of a hinge or a wheel, or a hinge's spring, and the rows that align axes 2.
  constexpr void turning(const Spin& gap = {}) noexcept {
    turn(0, hinge_axis(), gap);
    if constexpr (N == 3) {
      turn(3, to_array(axes_a_[0]), nearest_to<Spin>(narrow_negative(cosine(1, 2))));
      turn(4, to_array(axes_a_[1]), nearest_to<Spin>(cosine(0, 2)));
    }
  }
  /// Keeps axis 2 of b in a cone about axis 2 of a. The angle between them is at least 0, but its
  /// binary form wraps from pi to -pi.
  constexpr void swinging(const ConeJoint<S, 3>& joint) noexcept {
    const auto exact = cross(axes_b_[2], axes_a_[2]);
    const auto back = make_vec<3>([&](int i) { return nearest_to<Ratio>(exact[i]); });
    const auto sine = sqrt_floor<Ratio>(squared_length(back));
    const auto swing = abs(angle_of_vector<S>(cosine(2, 2), sine));
    const auto axis = unit_vector<Ratio>(to_array(back)).value_or(to_array(axes_a_[0]));
    turn(0, axis, saturate_to<Spin>(joint.cone_angle - swing));
  }
  /// The limits of the turn about axis 2 that is left without the shortest turn from axis 2 of a to
  /// that of b. A turn by x about the axis in the middle of both changes it by x / h.
  ///
  /// Each product of axes is at most 2^60 (1 + 2^-28), and a sum of two fits 62 bits.
  constexpr void twisting(const ConeJoint<S, 3>& joint) noexcept {
    const auto times = [&](std::size_t i, std::size_t j) {
      return narrow_dot<62>(axes_a_[i], axes_b_[j]);
    };
    const auto twist = angle_of_vector<S>(nearest_to<Ratio>(half(times(0, 0) + times(1, 1))),
                                          nearest_to<Ratio>(half(times(1, 0) - times(0, 1))));
    const auto both = axes_a_[2] + axes_b_[2];
    const auto h = sqrt_floor<Ratio>(half(half(squared_length(both))));
    const auto gap = [&](const auto& x) { return nearest_to<Spin>(h * saturate_to<Spin>(x)); };
    turn(1, unit_vector<Ratio>(to_array(both)).value_or(to_array(axes_a_[2])),
         gap(twist - joint.lower));
    turn_back(2, 1, gap(joint.upper - twist));
  }
  /// The rows that align the frames. In 3D the gap is half of the sum of all a_i x b_i, which is at
  /// most 3 / 2 (1 + 2^-28).
  constexpr void stiff() noexcept {
    if constexpr (N == 2) {
      turn(0, {Ratio(1)}, angle_of_vector<S>(cosine(0, 0), cosine(1, 0)));
    } else {
      const auto twice = cross(axes_a_[0], axes_b_[0]) + cross(axes_a_[1], axes_b_[1]) +
                         cross(axes_a_[2], axes_b_[2]);
      for (int i = 0; i < 3; ++i) {
        turn(static_cast<std::size_t>(i), to_array(unit_axis(i)), nearest_to<Spin>(half(twice[i])));
      }
    }
  }

  Ready& ready_;
  const Support<S, N>&a_, &b_;
  Spread<typename F::Gyration, N> spread_a_, spread_b_;
  Vec<Reach, N> from_a_{}, from_b_{}, between_{};
  Axes<S, N> axes_a_{}, axes_b_{};
};

}  // namespace detent::detail
