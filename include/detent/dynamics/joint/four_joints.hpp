// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/four_flight.hpp"
#include "detent/dynamics/joint/aim.hpp"

namespace detent::detail {

/// Up to four joints that share no body that can move, side by side. They keep two points together
/// along the world's axes, and have the same laws of turns; other joints are solved alone.
template <Scalar S, std::size_t Turns>
struct FourJoints {
  using F = Formats<S>;
  template <class T>
  using Vector = std::array<Quad<T>, 3>;
  using Anchor = Fixed<31, S::frac>;

  struct Turning {
    Law law = Law::none;
    Vector<typename F::Ratio> axis{};
    Vector<typename F::TurnShare> on_a{}, on_b{};
    Quad<typename F::Spin> gap{};
    Quad<typename F::Turn> total{};
  };

  std::uint8_t size = 0;
  bool is_alone = false;        // some number is clamped: each is solved by itself
  Quad<std::uint32_t> ready{};  // indices in the list of ready joints
  Quad<std::uint32_t> a{}, b{};
  Quad<bool> moves_a{}, moves_b{};
  Vector<Anchor> anchor_a{}, anchor_b{};
  Quad<typename F::Ratio> share_a{}, share_b{};
  Vector<typename F::Arm> arm_a{}, arm_b{};
  std::array<Vector<typename F::Response>, 3> response_a{}, response_b{};  // by rows
  Vector<typename F::Ratio> mass{};
  Vector<typename F::Speed> gap{};
  Vector<typename F::Impulse> total{};
  std::array<Turning, Turns> turn{};
};

/// The number of a kind of joints that may be side by side, of the same laws; 0: alone.
template <Scalar S, class Joint, class Ready>
[[nodiscard]] constexpr std::uint32_t kind_of(const Joint& joint, const Ready& ready) noexcept {
  std::uint32_t kind = 1;
  if constexpr (requires { joint.length; } || !(requires { joint.anchor_a.z; })) {
    return 0;  // along no axes, or in 2D
  } else {
    if (ready.breaks) return 0;
    for (std::size_t i = 0; i < ready.push.size(); ++i) {
      const auto& terms = ready.push[i].terms;
      if (terms.law != (i < 3 ? Law::equal : Law::none) || terms.is_capped) return 0;
    }
    for (const auto& row : ready.turn) {
      const auto law = row.terms.law;
      if (law != Law::none && law != Law::equal && law != Law::limit) return 0;
      kind = 4 * kind + static_cast<std::uint32_t>(law);
    }
    return kind;
  }
}

DETENT_BEGIN_LONG_LANES

/// The passes over four joints at once, with the bits of one after another. Each returns false, and
/// has changed nothing, if some number left its range and must be clamped.
template <class L, Scalar S, std::size_t Turns>
class FourJointsSolver : FourPairs<L, S> {
  using F = Formats<S>;
  using Speed = typename F::Speed;
  using Spin = typename F::Spin;
  using Sum = typename F::Sum;
  using Ratio = typename F::Ratio;
  using Impulse = typename F::Impulse;
  using Turn = typename F::Turn;
  using Joints = FourJoints<S, Turns>;
  using Turning = typename Joints::Turning;
  using Pairs = FourPairs<L, S>;
  using Pairs::a_, Pairs::b_, Pairs::round_;
  template <class T>
  using Side = Four<T, L>;

 public:
  FourJointsSolver(Joints& joints, Moving<S, 3>* bodies) noexcept
      : Pairs(bodies, joints.a, joints.b), joints_(joints) {}

  [[nodiscard]] bool warm_start() noexcept {
    for (const auto& row : joints_.turn) {
      if (row.law != Law::none) apply(row, Side<Turn>(row.total));
    }
    for (std::size_t i = 0; i < 3; ++i) apply(i, Side<Impulse>(joints_.total[i]));
    return store();
  }

  template <Pass P>
  [[nodiscard]] bool solve() noexcept {
    std::array<Side<Turn>, Turns> turns;
    std::array<Side<Impulse>, 3> pushes;
    for (std::size_t k = 0; k < Turns; ++k) {
      const auto& row = joints_.turn[k];
      if (row.law == Law::none) continue;
      const Side<Turn> before(row.total);
      turns[k] = next<P, Spin>(row.law, Side<Ratio>(Ratio(1)), turning_rate(row),
                               Side<Spin>(row.gap), before);
      apply(row, round_.template checked<Turn>(turns[k] - before));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Side<Impulse> before(joints_.total[i]);
      pushes[i] = next<P, Speed>(Law::equal, Side<Ratio>(joints_.mass[i]), rate(i),
                                 Side<Speed>(joints_.gap[i]), before);
      apply(i, round_.template checked<Impulse>(pushes[i] - before));
    }
    if (!store()) return false;
    for (std::size_t k = 0; k < Turns; ++k) {
      if (joints_.turn[k].law != Law::none) turns[k].store(joints_.turn[k].total);
    }
    for (std::size_t i = 0; i < 3; ++i) pushes[i].store(joints_.total[i]);
    return true;
  }

 private:
  static constexpr std::size_t after(std::size_t i) noexcept { return (i + 1) % 3; }

  /// `rate_along` axis i of the world, without its products by 0 and 1.
  [[nodiscard]] Side<Speed> rate(std::size_t i) noexcept {
    const auto j = after(i), k = after(j);
    const auto turning = [&](const auto& arm, const auto& spin) {
      using Arm = Side<typename F::Arm>;
      return Arm(arm[k]) * spin[j] - Arm(arm[j]) * spin[k];
    };
    const auto moving = b_.velocity[i] - a_.velocity[i];
    const Side<Sum> along(moving.raw << (Sum::frac - Speed::frac));
    return round_.template nearest<Speed>(
        along + (turning(joints_.arm_b, b_.spin) - turning(joints_.arm_a, a_.spin)));
  }
  [[nodiscard]] Side<Spin> turning_rate(const Turning& row) noexcept {
    Side<Fixed<62, Ratio::frac + Spin::frac>> sum;
    for (std::size_t i = 0; i < 3; ++i) {
      sum = sum + Side<Ratio>(row.axis[i]) * narrow<31>(b_.spin[i] - a_.spin[i]);
    }
    return round_.template nearest<Spin>(sum);
  }
  void apply(std::size_t i, const Side<Impulse>& impulse) noexcept {
    Pairs::push(i, joints_.share_a, joints_.share_b, impulse);
    Pairs::template turn<typename F::Response>(joints_.response_a[i], joints_.response_b[i],
                                               impulse);
  }
  void apply(const Turning& row, const Side<Turn>& turn) noexcept {
    Pairs::template turn<typename F::TurnShare>(row.on_a, row.on_b, turn);
  }

  /// `next_total` of the laws `equal` and `limit`.
  template <Pass P, class Rate, class Total>
  [[nodiscard]] Side<Total> next(Law law, const Side<Ratio>& mass, const Side<Rate>& rate,
                                 const Side<Rate>& gap, const Side<Total>& before) noexcept {
    const Side<Rate> zero;
    auto excess = mass * rate;
    if constexpr (P == Pass::biased) {
      const auto& soft = joint_softness<S>;
      const auto wanted = round_.template nearest<Rate>(Side<Ratio>(soft.rigid) * rate +
                                                        Side<Ratio>(soft.pull) * gap);
      excess = mass * wanted + Side<Ratio>(soft.loss) * before;
    }
    if (law == Law::limit) {
      const auto is_apart = above(gap, zero);
      const auto to_gap = narrow<31>(rate + select(is_apart, gap, zero));
      excess = select(is_apart, mass * to_gap, excess);
    }
    const auto sum = round_.minus_nearest(before, excess);
    return law == Law::limit ? larger(sum, Side<Total>()) : sum;
  }

  [[nodiscard]] bool store() noexcept { return Pairs::store(joints_.moves_a, joints_.moves_b); }

  Joints& joints_;
};

/// Computes the rows of pushes of four joints for where their bodies are now, as `Aim`. Returns false
/// if some number must be clamped.
template <class L, Scalar S, std::size_t Turns>
[[nodiscard]] bool aim_points(FourJoints<S, Turns>& joints,
                              const Support<S, 3>* supports) noexcept {
  using F = Formats<S>;
  using Arm = typename F::Arm;
  using Give = typename F::Give;
  using Gyration = typename F::Gyration;
  using Moment = typename F::Moment;
  using Ratio = typename F::Ratio;
  using Reach = typename F::Reach;
  using Response = typename F::Response;
  using Anchor = typename FourJoints<S, Turns>::Anchor;
  FourRounder<L> round;

  // The anchors from the center, and what responds to a push there.
  const auto prepare = [&](const FourSupports<S, L>& support, const auto& anchor,
                           const Quad<Ratio>& share, std::array<Four<Reach, L>, 3>& from, auto& arm,
                           auto& response, std::array<Four<Give, L>, 3>& gives) {
    std::array<Four<Arm, L>, 3> arms;
    for (std::size_t k = 0; k < 3; ++k) {
      Four<Fixed<62, Ratio::frac + Anchor::frac>, L> sum;
      for (std::size_t i = 0; i < 3; ++i) {
        sum = sum + support.axes[i][k] * Four<Anchor, L>(anchor[i]);
      }
      from[k] = round.template nearest<Reach>(sum);
      arms[k] = round.template nearest<Arm>(from[k]);
      arms[k].store(arm[k]);
    }
    const Four<Ratio, L> part(share);
    const auto spread = [&](std::size_t e) {
      FourLongSum<Gyration::frac + Ratio::frac, L> scaled;
      scaled.add(part, FourLong<Gyration, L>(support.spread[e]));
      return FourLong<Gyration, L>(round.template nearest<Gyration>(scaled));
    };
    const std::array<FourLong<Gyration, L>, 6> g{spread(0), spread(1), spread(2),
                                                 spread(3), spread(4), spread(5)};
    for (std::size_t i = 0; i < 3; ++i) {  // the moment of axis i is (arm k, - arm j) at j and k
      const auto j = (i + 1) % 3, k = (i + 2) % 3;
      std::array<Four<Response, L>, 3> change;
      for (std::size_t r = 0; r < 3; ++r) {
        const auto at = [&](std::size_t c) -> const auto& {
          return g[entry<3>(static_cast<int>(r), static_cast<int>(c))];
        };
        FourLongSum<Gyration::frac + Moment::frac, L> sum;
        sum.add(arms[k], at(j));
        sum.subtract(arms[j], at(k));
        change[r] = round.template nearest<Response>(sum);
        change[r].store(response[i][r]);
      }
      const auto whole = arms[k] * change[j] - arms[j] * change[k];
      gives[i] = larger(round.template nearest_long<Give>(whole), Four<Give, L>());
    }
  };
  std::array<Four<Reach, L>, 3> from_a, from_b;
  std::array<Four<Give, L>, 3> give_a, give_b;
  const FourSupports<S, L> a(supports, joints.a), b(supports, joints.b);
  prepare(a, joints.anchor_a, joints.share_a, from_a, joints.arm_a, joints.response_a, give_a);
  prepare(b, joints.anchor_b, joints.share_b, from_b, joints.arm_b, joints.response_b, give_b);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto between =
        round.template checked<Reach>((b.place[i] - a.place[i]) + (from_b[i] - from_a[i]));
    round.template checked<typename F::Speed>(between).store(joints.gap[i]);
    mass_of<Ratio>(give_a[i], give_b[i]).store(joints.mass[i]);
  }
  return !round.is_beyond();
}

DETENT_END_LONG_LANES

}  // namespace detent::detail
