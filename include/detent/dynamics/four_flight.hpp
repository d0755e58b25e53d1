// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include "detent/dynamics/flight.hpp"
#include "detent/dynamics/four.hpp"

namespace detent::detail {

/// The axes of four bodies.
template <Scalar S, class L>
using FourAxes = std::array<std::array<Four<typename Formats<S>::Ratio, L>, 3>, 3>;

DETENT_BEGIN_LONG_LANES

/// Four words of each of four objects, starting at `offset` bytes.
template <class L, class T>
[[nodiscard]] std::array<L, 4> words_at(const Quad<const T*>& objects,
                                        std::size_t offset) noexcept {
  const auto at = [&](std::size_t k) -> const void* {
    return reinterpret_cast<const unsigned char*>(objects[k]) + offset;
  };
  return L::load({at(0), at(1), at(2), at(3)});
}
/// Number i of an array of T that starts with these words: half a word each, or a whole one. A
/// coordinate of a center is either, depending on the scalar.
template <class T, class L>
[[nodiscard]] Four<T, L> number_of(const std::array<L, 4>& words, std::size_t i) noexcept {
  static_assert(sizeof(T) == 4 || sizeof(T) == 8);
  if constexpr (sizeof(T) == 8) {
    return Four<T, L>(words[i]);
  } else {
    const L& word = words[i / 2];
    return Four<T, L>(i % 2 == 0 ? word.lower() : word.upper());
  }
}
/// The same for one of six numbers of 64 bits, of which `rest` starts with the third.
template <class T, class L>
[[nodiscard]] Four<T, L> number_of(const std::array<L, 4>& first, const std::array<L, 4>& rest,
                                   std::size_t i) noexcept {
  static_assert(sizeof(T) == 8);
  return i < 4 ? number_of<T>(first, i) : number_of<T>(rest, i - 2);
}

template <class L, Scalar S>
[[nodiscard]] FourAxes<S, L> load_axes(const Quad<const Axes<S, 3>*>& axes) noexcept {
  static_assert(!is_fixed<S> || sizeof(Axes<S, 3>) == 36);
  const auto some = words_at<L>(axes, 0), last = words_at<L>(axes, 4);
  const auto at = [&](std::size_t i) {
    using Ratio = typename Formats<S>::Ratio;
    return i == 8 ? number_of<Ratio>(last, 7) : number_of<Ratio>(some, i);
  };
  return {{{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, {at(6), at(7), at(8)}}};
}
template <class L, Scalar S>
void store_axes(const FourAxes<S, L>& axes, const Quad<Axes<S, 3>*>& to) noexcept {
  const auto joined = [&](std::size_t i) {
    const L &low = axes[i / 3][i % 3].raw, &high = axes[(i + 1) / 3][(i + 1) % 3].raw;
    return (low & L(LongWord{0xffffffff})) | (high << 32);
  };
  Quad<typename Formats<S>::Ratio> last;
  axes[2][2].store(last);
  L::store({joined(0), joined(2), joined(4), joined(6)}, {to[0], to[1], to[2], to[3]});
  for (std::size_t k = 0; k < long_lane_count; ++k) (*to[k])[2].z = last[k];
}

/// `axes_of` for four orientations. With squared lengths of 1 + e, quotients are n - n e; if
/// further terms may change the rounding, the number counts as out of range: see
/// `quotient_of_near_one`.
template <Scalar S, class L>
[[nodiscard]] FourAxes<S, L> axes_of_four(
    const std::array<Four<typename Formats<S>::Ratio, L>, 4>& q, FourRounder<L>& round) noexcept {
  using Exact = Four<Fixed<62, 60>, L>;
  const L one(LongWord{1} << 60), half(LongWord{1} << 29), doubt(LongWord{1} << 5);
  const auto down = [](const L& x) {  // x / 2^30, rounded down
    return ((x + L(LongWord{1} << 62)) >> 30) - L(LongWord{1} << 32);
  };
  const Exact xx = q[0] * q[0], yy = q[1] * q[1], zz = q[2] * q[2], ww = q[3] * q[3];
  const L e = (xx + yy + zz + ww).raw - one;
  round.template checked<Fixed<31, 60>>(Exact(e));
  const auto quotient = [&](const Exact& n) {
    const L raised = n.raw - down(L::product(n.raw >> 30, e)) + half;
    const L left = raised & L((LongWord{1} << 30) - 1);
    round.refuse_negative((left - doubt) | (half + half - doubt - left));
    return Four<typename Formats<S>::Ratio, L>(down(raised));
  };
  const auto twice = [](const Exact& x) { return x + x; };
  const Exact xy = q[0] * q[1], yz = q[1] * q[2], zx = q[2] * q[0];
  const Exact xw = q[0] * q[3], yw = q[1] * q[3], zw = q[2] * q[3];
  return {{{quotient((ww + xx) - (yy + zz)), quotient(twice(xy + zw)), quotient(twice(zx - yw))},
           {quotient(twice(xy - zw)), quotient((ww + yy) - (zz + xx)), quotient(twice(yz + xw))},
           {quotient(twice(zx + yw)), quotient(twice(yz - xw)), quotient((ww + zz) - (xx + yy))}}};
}

/// `turned` for four orientations and spins below 1 / 16. Other spins, and numbers too close to a
/// tie, count as out of range.
///
/// n = q + angle q has 59 + Halvings fractional bits, s more than its rounded value h: n = 2^s h +
/// l. |n|^2 = 1 + e is known within 2 steps of 2^-60, and |e| < 2^-11. The result is n - n d, where
/// d = 1 - (1 + e)^(-1/2) = e (1/2 - e (3/8 - 5/16 e)), off by e^4 35/128 < 2^-45. Steps of 2^-42
/// for e and d, and h in place of n in the product, which changes it by less than 2^-43, add up to
/// less than 2^-41.
template <int Halvings, Scalar S, class L>
[[nodiscard]] std::array<Four<typename Formats<S>::Ratio, L>, 4> turned_four(
    const std::array<Four<typename Formats<S>::Ratio, L>, 4>& q,
    const std::array<Four<typename Formats<S>::Spin, L>, 3>& spin, FourRounder<L>& round) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  constexpr int s = 29 + Halvings;
  const auto power = [](int bits) { return L(LongWord{1} << bits); };
  const auto down = [&](const L& x, int shift) {  // x / 2^shift, rounded down, for |x| <= 2^62
    return ((x + power(62)) >> shift) - power(62 - shift);
  };
  for (const auto& w : spin) round.template checked<Fixed<24, 28>>(Four<Fixed<62, 28>, L>(w.raw));
  const auto& [x, y, z] = spin;
  const std::array<L, 4> n{(q[0].raw << s) + (x * q[3] + y * q[2] - z * q[1]).raw,
                           (q[1].raw << s) + (y * q[3] + z * q[0] - x * q[2]).raw,
                           (q[2].raw << s) + (z * q[3] + x * q[1] - y * q[0]).raw,
                           (q[3].raw << s) - (x * q[0] + y * q[1] + z * q[2]).raw};
  std::array<L, 4> h;
  L squares = L(LongWord{0}) - power(60), mixed(LongWord{0});
  for (std::size_t i = 0; i < 4; ++i) {
    h[i] = down(n[i] + power(s - 1), s);
    squares = squares + L::product(h[i], h[i]);
    mixed = mixed + L::product(h[i], n[i] - (h[i] << s));
  }
  const L e = down(squares + down(mixed, s - 1) + power(17), 18);  // in steps of 2^-42
  round.template checked<Fixed<31, 42>>(Four<Fixed<62, 42>, L>(e));
  const L slope = L(LongWord{3} << 28) - down((e << 2) + e, 15);  // in steps of 2^-31
  const L part = power(30) - down(L::product(e, slope), 42);
  const L d = down(L::product(e, part) + power(30), 31);
  std::array<Four<Ratio, L>, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const L raised = n[i] - down(L::product(h[i], d), 13 - Halvings) + power(s - 1);
    const L left = raised & (power(s) - L(LongWord{1})), doubt = power(18 + Halvings);
    round.refuse_negative((left - doubt) | (power(s) - doubt - left));
    result[i] = Four<Ratio, L>(down(raised, s));
  }
  return result;
}

/// The orientations of four bodies, `turned` by their spins. Returns false, and changes nothing, if
/// a number needs exact rounding or clamping.
template <class L, int Halvings, Scalar S>
[[nodiscard]] bool turn_four(const Quad<const BodyState<S, 3>*>& states, Moving<S, 3>* moving,
                             const Quad<std::uint32_t>& indices,
                             Quad<Vec<typename Formats<S>::Ratio, 4>>& result) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  using State = BodyState<S, 3>;
  const auto words = words_at<L>(states, offsetof(State, orientation));
  std::array<Four<Ratio, L>, 4> q;
  for (std::size_t i = 0; i < 4; ++i) q[i] = number_of<Ratio>(words, i);
  FourRounder<L> round;
  const auto motions = FourBodies<S, L>(moving, indices).motions();
  const auto turned = turned_four<Halvings, S, L>(q, motions.spin, round);
  if (round.is_beyond()) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    Quad<Ratio> parts;
    turned[i].store(parts);
    for (std::size_t k = 0; k < long_lane_count; ++k) result[k][static_cast<int>(i)] = parts[k];
  }
  return true;
}

/// A column of a matrix of long numbers.
template <class T, class L>
using FourLongs = std::array<FourLong<T, L>, 3>;
template <class T, class L>
[[nodiscard]] FourLongs<T, L> long_of(const std::array<Four<T, L>, 3>& v) noexcept {
  return {FourLong<T, L>(v[0]), FourLong<T, L>(v[1]), FourLong<T, L>(v[2])};
}

/// The sums over c of at(r, c) v[c], each rounded once.
template <class To, Scalar S, class T, class L, class At>
[[nodiscard]] std::array<Four<To, L>, 3> product_four(const At& at, const FourLongs<T, L>& v,
                                                      FourRounder<L>& round) noexcept {
  std::array<Four<To, L>, 3> result;
  for (std::size_t r = 0; r < 3; ++r) {
    FourLongSum<Formats<S>::Ratio::frac + T::frac, L> sum;
    for (std::size_t c = 0; c < 3; ++c) sum.add(at(r, c), v[c]);
    result[r] = round.template nearest<To>(sum);
  }
  return result;
}
/// The vector whose coordinates along the axes are v, and the coordinates of v along them; each
/// number is rounded once.
template <class To, Scalar S, class T, class L>
[[nodiscard]] std::array<Four<To, L>, 3> out_of_four(const FourAxes<S, L>& axes,
                                                     const FourLongs<T, L>& v,
                                                     FourRounder<L>& round) noexcept {
  const auto at = [&](std::size_t r, std::size_t c) -> const auto& { return axes[c][r]; };
  return product_four<To, S>(at, v, round);
}
template <class To, Scalar S, class T, class L>
[[nodiscard]] std::array<Four<To, L>, 3> into_four(const FourAxes<S, L>& axes,
                                                   const FourLongs<T, L>& v,
                                                   FourRounder<L>& round) noexcept {
  const auto at = [&](std::size_t r, std::size_t c) -> const auto& { return axes[r][c]; };
  return product_four<To, S>(at, v, round);
}

/// `in_world` for four matrices: R m R^T, rounded after each product.
template <Scalar S, class L>
std::array<Four<typename Formats<S>::Gyration, L>, 6> in_world_four(
    const std::array<Four<typename Formats<S>::Gyration, L>, 6>& m, const FourAxes<S, L>& axes,
    FourRounder<L>& round) noexcept {
  using Gyration = typename Formats<S>::Gyration;
  std::array<std::array<Four<Gyration, L>, 3>, 3> half_way;  // [c][r]: (R m)_rc
  for (std::size_t c = 0; c < 3; ++c) {
    const auto at = [&](int i) {
      return FourLong<Gyration, L>(m[entry<3>(i, static_cast<int>(c))]);
    };
    half_way[c] = out_of_four<Gyration, S, Gyration, L>(axes, {at(0), at(1), at(2)}, round);
  }
  const auto product = [&](std::size_t r, std::size_t c) {
    FourLongSum<Formats<S>::Ratio::frac + Gyration::frac, L> sum;
    for (std::size_t i = 0; i < 3; ++i) {
      sum.add(axes[i][c], FourLong<Gyration, L>(half_way[i][r]));
    }
    return round.template nearest<Gyration>(sum);
  };
  return {product(0, 0), product(1, 1), product(2, 2), product(1, 2), product(2, 0), product(0, 1)};
}

/// Sets the axes and spreads of four bodies without locked axes, as `support_of` does. Returns
/// false, and changes nothing, if a number needs exact rounding or clamping.
template <class L, Scalar S, class Body>
[[nodiscard]] bool support_four(const Quad<Body*>& bodies, const Quad<Support<S, 3>*>& supports,
                                bool has_axes) noexcept {
  using F = Formats<S>;
  using Gyration = typename F::Gyration;
  FourRounder<L> round;
  const auto turned_axes = [&] {
    Quad<const BodyState<S, 3>*> states;
    for (std::size_t k = 0; k < long_lane_count; ++k) states[k] = &bodies[k]->state;
    using State = BodyState<S, 3>;
    const auto words = words_at<L>(states, offsetof(State, orientation));
    std::array<Four<typename F::Ratio, L>, 4> q;
    for (std::size_t i = 0; i < 4; ++i) q[i] = number_of<typename F::Ratio>(words, i);
    return axes_of_four<S, L>(q, round);
  };
  const FourAxes<S, L> axes = has_axes ? load_axes<L, S>({&supports[0]->axes, &supports[1]->axes,
                                                          &supports[2]->axes, &supports[3]->axes})
                                       : turned_axes();
  Quad<const Spread<Gyration, 3>*> inverses;
  for (std::size_t k = 0; k < long_lane_count; ++k) inverses[k] = &bodies[k]->inertia.inverse;
  const auto first = words_at<L>(inverses, 0), rest = words_at<L>(inverses, 16);
  std::array<Four<Gyration, L>, 6> inverse;
  for (std::size_t i = 0; i < 6; ++i) inverse[i] = number_of<Gyration>(first, rest, i);
  const auto spread = in_world_four<S, L>(inverse, axes, round);
  if (round.is_beyond()) return false;
  if (!has_axes) {
    store_axes<L, S>(
        axes, {&supports[0]->axes, &supports[1]->axes, &supports[2]->axes, &supports[3]->axes});
  }
  std::array<void*, 4> to_first, to_rest;
  for (std::size_t k = 0; k < long_lane_count; ++k) {
    to_first[k] = &supports[k]->spread[0];
    to_rest[k] = &supports[k]->spread[2];
  }
  L::store({spread[0].raw, spread[1].raw, spread[2].raw, spread[3].raw}, to_first);
  L::store({spread[2].raw, spread[3].raw, spread[4].raw, spread[5].raw}, to_rest);
  return true;
}

DETENT_END_LONG_LANES

/// Up to four bodies that turn from the axes `from` to those of the orientations, which are written
/// to `to`.
template <Scalar S>
struct FourTurns {
  using Axes = detail::Axes<S, 3>;
  using Orientation = Vec<typename Formats<S>::Ratio, 4>;

  std::size_t size = 0;
  bool are_diagonal = true;  // the frames' axes are the principal axes
  Quad<std::uint32_t> body{};
  Quad<bool> marks{};
  Quad<Orientation> orientation{};
  Quad<const Inertia<S, 3>*> inertia{};
  Quad<const Axes*> from{};
  Quad<Axes*> to{};

  constexpr void add(std::uint32_t index, const Orientation& q, const Inertia<S, 3>& resistance,
                     const Axes& start, Axes& end) noexcept {
    // Lanes without a body compute what the first one does, and write nothing.
    for (std::size_t k = size; k < (size == 0 ? long_lane_count : size + 1); ++k) {
      body[k] = index;
      orientation[k] = q;
      inertia[k] = &resistance;
      from[k] = &start;
      to[k] = &end;
      marks[k] = k == size;
    }
    are_diagonal = (size == 0 || are_diagonal) && resistance.is_diagonal();
    ++size;
  }
};

DETENT_BEGIN_LONG_LANES

/// The supports of four bodies, in lanes.
template <Scalar S, class L>
struct FourSupports {
  using F = Formats<S>;
  using Support = detail::Support<S, 3>;

  FourAxes<S, L> axes;
  std::array<Four<typename F::Place, L>, 3> place;
  std::array<Four<typename F::Gyration, L>, 6> spread;

  FourSupports(const Support* supports, const Quad<std::uint32_t>& indices) noexcept
      : FourSupports({&supports[indices[0]], &supports[indices[1]], &supports[indices[2]],
                      &supports[indices[3]]}) {}

 private:
  explicit FourSupports(const Quad<const Support*>& at) noexcept
      : axes(load_axes<L, S>({&at[0]->axes, &at[1]->axes, &at[2]->axes, &at[3]->axes})) {
    const auto places = words_at<L>(at, offsetof(Support, place));
    const auto first = words_at<L>(at, offsetof(Support, spread));
    const auto rest = words_at<L>(at, offsetof(Support, spread) + 16);
    for (std::size_t i = 0; i < 3; ++i) place[i] = number_of<typename F::Place>(places, i);
    for (std::size_t i = 0; i < 6; ++i) {
      spread[i] = number_of<typename F::Gyration>(first, rest, i);
    }
  }
};

/// Carries spins, as `carried` does. Returns false, and changes nothing, if a number needs exact
/// rounding or clamping.
template <class L, Scalar S>
[[nodiscard]] bool carry_four(const FourTurns<S>& turns, Moving<S, 3>* moving) noexcept {
  using F = Formats<S>;
  using FineSpin = typename F::FineSpin;
  using Ratio = typename F::Ratio;
  FourRounder<L> round;
  std::array<Four<Ratio, L>, 4> q;
  for (int i = 0; i < 4; ++i) {
    q[static_cast<std::size_t>(i)] =
        Four<Ratio, L>(Quad<Ratio>{turns.orientation[0][i], turns.orientation[1][i],
                                   turns.orientation[2][i], turns.orientation[3][i]});
  }
  const auto from = load_axes<L, S>(turns.from), to = axes_of_four<S, L>(q, round);
  FourBodies<S, L> bodies(moving, turns.body);
  auto motions = bodies.motions();
  using Resistance = Inertia<S, 3>;
  const auto shares = words_at<L>(turns.inertia, offsetof(Resistance, share));
  const auto stretches = words_at<L>(turns.inertia, offsetof(Resistance, inverse_share));
  const auto more_stretches = words_at<L>(turns.inertia, offsetof(Resistance, inverse_share) + 16);

  std::array<FourLong<FineSpin, L>, 3> turning;
  for (std::size_t i = 0; i < 3; ++i) {
    Four<Fixed<62, Ratio::frac + F::Spin::frac>, L> sum;
    for (std::size_t k = 0; k < 3; ++k) sum = sum + from[i][k] * motions.spin[k];
    turning[i] = FourLong<FineSpin, L>(round.template nearest_long<FineSpin>(sum));
  }
  std::array<Four<FineSpin, L>, 3> momentum, turning_after;
  for (std::size_t i = 0; i < 3; ++i) {
    FourLongSum<Ratio::frac + FineSpin::frac, L> sum;
    for (std::size_t j = 0; j < 3; ++j) {
      if (turns.are_diagonal && i != j) continue;
      const auto e = entry<3>(static_cast<int>(i), static_cast<int>(j));
      sum.add(number_of<Ratio>(shares, e), turning[j]);
    }
    momentum[i] = round.template nearest<FineSpin>(sum);
  }
  const auto in_space = out_of_four<FineSpin, S, FineSpin, L>(from, long_of(momentum), round);
  const auto after = into_four<FineSpin, S, FineSpin, L>(to, long_of(in_space), round);
  const auto stretch = [&](std::size_t i, std::size_t j) {
    const auto e = entry<3>(static_cast<int>(i), static_cast<int>(j));
    return number_of<typename F::Stretch>(stretches, more_stretches, e);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    turning_after[i] = turns.are_diagonal
                           ? round.nearest_long_dot(std::array{stretch(i, i)}, std::array{after[i]})
                           : round.nearest_long_dot(
                                 std::array{stretch(i, 0), stretch(i, 1), stretch(i, 2)}, after);
  }
  motions.spin = out_of_four<typename F::Spin, S, FineSpin, L>(to, long_of(turning_after), round);
  if (round.is_beyond()) return false;
  store_axes<L, S>(to, turns.to);
  bodies.store(motions, turns.marks);
  return true;
}

DETENT_END_LONG_LANES

/// Finds the supports of bodies, four at once if `HasFours`.
template <bool HasFours, Scalar S, int N, class Bodies, class Supports>
class SupportQueue {
 public:
  constexpr SupportQueue(const Bodies& bodies, Supports& supports) noexcept
      : bodies_(bodies), supports_(supports) {}

  /// Adds a body. `has_axes`: its support has the axes already.
  constexpr void add(std::size_t i, bool has_axes) noexcept {
    if constexpr (HasFours) {
      if (bodies_[i].locked == 0 && runs_vectors()) {
        auto& waiting = waiting_[has_axes ? 1 : 0];
        waiting.body[waiting.size++] = i;
        if (waiting.size == long_lane_count) find(waiting, has_axes);
        return;
      }
    }
    find(i, has_axes);
  }
  constexpr void flush() noexcept {
    if constexpr (HasFours) {
      find(waiting_[0], false);
      find(waiting_[1], true);
    }
  }

 private:
  struct Waiting {
    std::size_t size = 0;
    Quad<std::size_t> body{};
  };

  constexpr void find(std::size_t i, bool has_axes) noexcept {
    supports_[i] =
        has_axes ? support_of<S, N>(bodies_[i], supports_[i].axes) : support_of<S, N>(bodies_[i]);
  }
  constexpr void find(Waiting& waiting, bool has_axes) noexcept {
    if (waiting.size == 0) return;
    Quad<decltype(&bodies_[0])> bodies{};
    Quad<Support<S, N>*> supports{};
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      const auto i = waiting.body[k < waiting.size ? k : 0];
      bodies[k] = &bodies_[i];
      supports[k] = &supports_[i];
    }
    const bool is_done = support_four<FastLongLanes, S>(bodies, supports, has_axes);
    for (std::size_t k = 0; k < waiting.size; ++k) {
      if (is_done) {
        supports[k]->place = bodies[k]->state.place;
        supports[k]->locked = 0;
        supports[k]->is_fixed = bodies[k]->motion == BodyMotion::fixed;
      } else {
        find(waiting.body[k], has_axes);
      }
    }
    waiting.size = 0;
  }

  const Bodies& bodies_;
  Supports& supports_;
  struct Nothing {};
  std::conditional_t<HasFours, std::array<Waiting, 2>, Nothing> waiting_{};
};

}  // namespace detent::detail
