// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/cull/long_lanes.hpp"
#include "detent/dynamics/row.hpp"

namespace detent::detail {

using detent::narrow;  // the overload below would hide it

/// Whether a world can process four contacts, joints or bodies at once, if `runs_vectors()`:
/// growing worlds in 3D. Its steps have the same bits in either case.
template <class Storage, Scalar S, int N>
inline constexpr bool uses_long_lanes = may_run_vectors&& is_fixed<S>&& N == 3 && requires {
  Storage::is_growing;
};

/// Four numbers of type T in memory, one for each of four contacts or joints.
template <class T>
using Quad = std::array<T, long_lane_count>;

DETENT_BEGIN_LONG_LANES

/// Four numbers of type T in lanes, with the arithmetic of `Fixed`. Sums and products have 62 bits;
/// the caller must prove that they fit.
template <class T, class L>
struct Four {
  using Number = T;
  L raw;

  constexpr Four() noexcept : raw() {}  // not defaulted: GCC would not compile it for AVX2
  explicit constexpr Four(const L& lanes) noexcept : raw(lanes) {}
  explicit constexpr Four(const Quad<T>& numbers) noexcept requires(T::bits <= 31)
      : raw(std::bit_cast<std::array<std::int32_t, long_lane_count>>(numbers)) {}
  explicit constexpr Four(const Quad<T>& numbers) noexcept requires(T::bits > 31)
      : raw(std::bit_cast<LongWords>(numbers)) {}
  /// The same number in all lanes.
  explicit constexpr Four(const T& number) noexcept : raw(LongWord{number.raw()}) {}

  constexpr void store(Quad<T>& numbers) const noexcept {
    if constexpr (T::bits <= 31) {
      numbers = std::bit_cast<Quad<T>>(raw.halves());
    } else {
      numbers = std::bit_cast<Quad<T>>(raw.words());
    }
  }
};

template <int A, int B, int F, class L>
[[nodiscard]] constexpr auto operator+(const Four<Fixed<A, F>, L>& a,
                                       const Four<Fixed<B, F>, L>& b) noexcept {
  return Four<Fixed<62, F>, L>(a.raw + b.raw);
}
template <int A, int B, int F, class L>
[[nodiscard]] constexpr auto operator-(const Four<Fixed<A, F>, L>& a,
                                       const Four<Fixed<B, F>, L>& b) noexcept {
  return Four<Fixed<62, F>, L>(a.raw - b.raw);
}
template <int A, int FA, int B, int FB, class L>
[[nodiscard]] constexpr auto operator*(const Four<Fixed<A, FA>, L>& a,
                                       const Four<Fixed<B, FB>, L>& b) noexcept {
  static_assert(A <= 31 && B <= 31);
  return Four<Fixed<62, FA + FB>, L>(L::product(a.raw, b.raw));
}
/// The same numbers in fewer bits. The caller must prove that they fit.
template <int Bits, int B, int F, class L>
[[nodiscard]] constexpr auto narrow(const Four<Fixed<B, F>, L>& x) noexcept {
  return Four<Fixed<Bits, F>, L>(x.raw);
}
/// The union of the bits of both.
template <class T, class L>
[[nodiscard]] constexpr Four<T, L> operator|(const Four<T, L>& a, const Four<T, L>& b) noexcept {
  return Four<T, L>(a.raw | b.raw);
}
/// All bits of the lanes in which a > b.
template <int A, int B, int F, class L>
[[nodiscard]] constexpr L above(const Four<Fixed<A, F>, L>& a,
                                const Four<Fixed<B, F>, L>& b) noexcept {
  return L::above(a.raw, b.raw);
}
template <class T, class L>
[[nodiscard]] constexpr Four<T, L> select(const L& marks, const Four<T, L>& a,
                                          const Four<T, L>& b) noexcept {
  return Four<T, L>(L::select(marks, a.raw, b.raw));
}
template <class T, class L>
[[nodiscard]] constexpr Four<T, L> larger(const Four<T, L>& a, const Four<T, L>& b) noexcept {
  return select(above(a, b), a, b);
}
template <class T, class L>
[[nodiscard]] constexpr Four<T, L> smaller(const Four<T, L>& a, const Four<T, L>& b) noexcept {
  return select(above(a, b), b, a);
}

/// Long numbers, of at most 52 bits, are split in two: u 2^22 + l with 0 <= l < 2^22.
inline constexpr int long_cut = 22;
template <class T, class L>
struct FourLong {
  L upper, lower;

  constexpr FourLong() noexcept : upper(), lower() {}
  explicit constexpr FourLong(const Four<T, L>& x) noexcept
      : upper(x.raw >> long_cut), lower(x.raw & L((LongWord{1} << long_cut) - 1)) {
    static_assert(T::bits <= 52);
  }
};
/// A sum of up to three products of short numbers and long ones, in steps of 2^-F, as in
/// `nearest_dot`. The product reads the lower 32 bits of `upper`, which hold all of it, with its
/// sign.
template <int F, class L>
struct FourLongSum {
  L upper, lower;

  constexpr FourLongSum() noexcept : upper(), lower() {}

  template <class A, class B>
  constexpr void add(const Four<A, L>& a, const FourLong<B, L>& b) noexcept {
    static_assert(A::frac + B::frac == F && A::bits <= 31);
    upper = upper + L::product(a.raw, b.upper);
    lower = lower + L::product(a.raw, b.lower);
  }
  template <class A, class B>
  constexpr void subtract(const Four<A, L>& a, const FourLong<B, L>& b) noexcept {
    static_assert(A::frac + B::frac == F && A::bits <= 31);
    upper = upper - L::product(a.raw, b.upper);
    lower = lower - L::product(a.raw, b.lower);
  }
  /// The sum rounded down to steps of 2^(cut - F), with the last bit set if there is a remainder.
  [[nodiscard]] constexpr L whole() const noexcept {
    const L mask((LongWord{1} << long_cut) - 1), raise(LongWord{1} << 60);
    const L carried = ((lower + raise) >> long_cut) - L(LongWord{1} << (60 - long_cut));
    return (upper + carried) | (((lower & mask) + mask) >> long_cut);
  }
};

/// n / b rounded to nearest, ties to even, given q: it or a neighbour. `rest` is n - q b; b > 0 and
/// `rest` are below 2^61.
template <class L>
[[nodiscard]] constexpr L nearest_to_quotient(const L& q, const L& rest, const L& b) noexcept {
  const L twice = rest + rest, odd = q & L(LongWord{1});
  // |2 rest| > b, or = b with an odd q.
  const L up = L::above(twice + odd, b), down = L::above(L(LongWord{0}) - b, twice - odd);
  return (q - up) + down;
}
/// 2^30 a / b rounded to nearest, for 0 <= a <= b < 2^51; 0 / 0 is unspecified.
template <class L>
[[nodiscard]] L nearest_ratio(const L& a, const L& b) noexcept {
  const L q = L::near_ratio(a, b);  // at most 2^30 + 1
  const L whole = (L::product(q, b >> 31) << 31) + L::product(q, b & L(LongWord{0x7fffffff}));
  return nearest_to_quotient(q, (a << 30) - whole, b);
}
/// The effective mass of a row to which its bodies contribute a and b: 1 / (1 + a + b), as
/// `effective_mass` without locked axes. What `nearest_long` returns is below 2^50, so the sum is
/// below 2^51.
template <class Ratio, class Give, class L>
[[nodiscard]] Four<Ratio, L> mass_of(const Four<Give, L>& a, const Four<Give, L>& b) noexcept {
  static_assert(Ratio::frac == 30 && Give::frac == 30);
  const L one(LongWord{1} << 30);
  return Four<Ratio, L>(nearest_ratio(one, one + (a.raw + b.raw)));
}
/// floor(sqrt(x)) for 0 <= x < 2^62.
template <class L>
[[nodiscard]] L root_floor_of(const L& x) noexcept {
  const L root = L::near_root(x);
  const L rest = x - L::product(root, root);
  return (root + L::above(L(LongWord{0}), rest)) - L::above(rest, root + root);
}

/// Rounds, and notes whether any number is outside the range of its type. If so, the caller must
/// discard everything computed and use the slower functions that clamp.
template <class L>
class FourRounder {
 public:
  constexpr FourRounder() noexcept : beyond_(), beyond_30_(), beyond_31_() {}

  /// x rounded to nearest, ties to even.
  template <class T, int B, int F>
  [[nodiscard]] constexpr Four<T, L> nearest(const Four<Fixed<B, F>, L>& x) noexcept {
    return Four<T, L>(raised<T>(x) - lift<T>());
  }
  /// The same without a check, for a T that holds all results; |x| <= 2^62 in steps.
  template <class T, int B, int F>
  [[nodiscard]] static constexpr Four<T, L> nearest_long(const Four<Fixed<B, F>, L>& x) noexcept {
    constexpr int shift = F - T::frac;
    static_assert(T::bits >= 62 - shift && shift > 0 && shift < 62);
    return Four<T, L>(shifted<shift>(x.raw, LongWord{1} << 62) - L(LongWord{1} << (62 - shift)));
  }
  /// a + nearest(x) and a - nearest(x), in T.
  template <class T, int B, int F>
  [[nodiscard]] constexpr Four<T, L> plus_nearest(const Four<T, L>& a,
                                                  const Four<Fixed<B, F>, L>& x) noexcept {
    const L sum = a.raw + raised<T>(x);
    note<T>(sum);
    return Four<T, L>(sum - lift<T>());
  }
  template <class T, int B, int F>
  [[nodiscard]] constexpr Four<T, L> minus_nearest(const Four<T, L>& a,
                                                   const Four<Fixed<B, F>, L>& x) noexcept {
    const L rest = (a.raw + L(LongWord{2} << T::bits)) - raised<T>(x);
    note<T>(rest);
    return Four<T, L>(rest - lift<T>());
  }
  /// Adds nearest(x) to b and subtracts it from a.
  template <class T, int B, int F>
  constexpr void exchange_nearest(Four<T, L>& a, Four<T, L>& b,
                                  const Four<Fixed<B, F>, L>& x) noexcept {
    const L part = raised<T>(x);
    const L rest = (a.raw + L(LongWord{2} << T::bits)) - part, sum = b.raw + part;
    note<T>(rest);
    note<T>(sum);
    a = Four<T, L>(rest - lift<T>());
    b = Four<T, L>(sum - lift<T>());
  }
  /// x in T, which has the same grid.
  template <class T, int B>
  constexpr Four<T, L> checked(const Four<Fixed<B, T::frac>, L>& x) noexcept {
    note<T>(x.raw + lift<T>());
    return Four<T, L>(x.raw);
  }

  /// A sum of up to three products of short numbers and long ones, rounded once: see `nearest_dot`.
  template <class T, int F>
  [[nodiscard]] constexpr Four<T, L> nearest(const FourLongSum<F, L>& sum) noexcept {
    return nearest<T>(Four<Fixed<62, F - long_cut>, L>(sum.whole()));
  }

  /// A sum of up to three products of long numbers, rounded to nearest on the grid of the second
  /// factors. The first factors have 30 fractional bits and are below 2^37 steps, the second below
  /// 2^44 steps; others count as out of range.
  ///
  /// With factors 2^15 u + v and 2^22 y + z a product is the sum of 2^37 u y, which is an even
  /// multiple of 2^30, and of 2^15 u z + 2^22 v y + v z, three of which are below 2^62 in sum.
  template <class T, class A, std::size_t Count>
  [[nodiscard]] constexpr Four<T, L> nearest_long_dot(
      const std::array<Four<A, L>, Count>& stretches,
      const std::array<Four<T, L>, Count>& numbers) noexcept {
    static_assert(A::frac == 30 && Count <= 3);
    L whole(LongWord{0}), rest(LongWord{0});
    for (std::size_t i = 0; i < Count; ++i) {
      checked<Fixed<37, A::frac>>(narrow<62>(stretches[i]));
      checked<Fixed<44, T::frac>>(narrow<62>(numbers[i]));
      const FourLong<T, L> x(numbers[i]);
      const L u = stretches[i].raw >> 15, v = stretches[i].raw & L((LongWord{1} << 15) - 1);
      whole = whole + L::product(u, x.upper);
      rest = rest + (L::product(u, x.lower) << 15) + (L::product(v, x.upper) << 22) +
             L::product(v, x.lower);
    }
    const auto part = nearest_long<Fixed<62, T::frac>>(Four<Fixed<62, T::frac + A::frac>, L>(rest));
    return checked<T>(Four<Fixed<62, T::frac>, L>((whole << 7) + part.raw));
  }
  /// 2^30 a / sqrt(a^2 + b^2) rounded to nearest, for |a|, |b| < 2^31 and `squared`, their sum of
  /// squares; 0 / 0 is 0. What is too close to a midpoint counts as out of range.
  [[nodiscard]] constexpr L part_of_length(const L& a, const L& squared) noexcept {
    const L one(LongWord{1});
    const L m = L::select(L::above(one, squared), one, squared);
    // In steps of 2^-50, with an error of at most 2: positive, and rounded down.
    const L part = L::near_part(a, m) + L((LongWord{1} << 51) + (LongWord{1} << 19));
    refuse_negative(((part + L(LongWord{2})) & L((LongWord{1} << 20) - 1)) - L(LongWord{5}));
    return (part >> 20) - L(LongWord{1} << 31);
  }
  /// Counts a negative number as out of range.
  constexpr void refuse_negative(const L& x) noexcept { beyond_ = beyond_ | (x >> 63); }

  [[nodiscard]] constexpr bool is_beyond() const noexcept {
    return (beyond_ | (beyond_30_ >> 31) | (beyond_31_ >> 32)).any();
  }

 private:
  /// 2^Bits: x is in the range of T if x + lift has no bits above the first Bits + 1.
  template <class T>
  static constexpr L lift() noexcept {
    return L(LongWord{1} << T::bits);
  }
  template <class T>
  constexpr void note(const L& lifted) noexcept {
    if constexpr (T::bits == 30) {
      beyond_30_ = beyond_30_ | lifted;
    } else if constexpr (T::bits == 31) {
      beyond_31_ = beyond_31_ | lifted;
    } else {
      beyond_ = beyond_ | (lifted >> (T::bits + 1));
    }
  }
  /// (x + raise) / 2^Shift rounded to nearest; `raise` is a multiple of 2^(Shift + 1) that makes
  /// the sum positive.
  template <int Shift>
  static constexpr L shifted(const L& x, LongWord raise) noexcept {
    const L odd = (x >> Shift) & L(LongWord{1});
    return (x + L(raise + (LongWord{1} << (Shift - 1)) - 1) + odd) >> Shift;
  }
  /// nearest(x) + 2^Bits, with its range noted. If it is negative, its upper bits are set.
  template <class T, int B, int F>
  constexpr L raised(const Four<Fixed<B, F>, L>& x) noexcept {
    constexpr int shift = F - T::frac;
    static_assert(shift > 0 && shift + T::bits <= 62);
    const L lifted = shifted<shift>(x.raw, LongWord{1} << (shift + T::bits));
    note<T>(lifted);
    return lifted;
  }

  L beyond_, beyond_30_, beyond_31_;
};

/// The velocities and spins of four bodies, or their shifts and turns in this tick.
template <Scalar S, class L>
struct FourMotions {
  using F = Formats<S>;

  std::array<Four<typename F::Speed, L>, 3> velocity{};
  std::array<Four<typename F::Spin, L>, 3> spin{};
};

/// References to the bodies on one side of four contacts.
template <Scalar S, class L>
class FourBodies {
  using Body = Moving<S, 3>;
  using Speed = Four<typename Formats<S>::Speed, L>;
  using Spin = Four<typename Formats<S>::Spin, L>;
  static_assert(!is_fixed<S> || sizeof(Body) == 48, "detent: twelve 32-bit numbers");

 public:
  FourBodies(Body* bodies, const Quad<std::uint32_t>& indices) noexcept : after_() {
    for (std::size_t k = 0; k < long_lane_count; ++k) bodies_[k] = &bodies[indices[k]];
  }

  [[nodiscard]] FourMotions<S, L> motions() noexcept {
    const auto words = L::load({bodies_[0], bodies_[1], bodies_[2], bodies_[3]});
    after_ = words[3];
    return {{Speed(lower(words[0])), Speed(upper(words[0])), Speed(lower(words[1]))},
            {Spin(upper(words[1])), Spin(lower(words[2])), Spin(upper(words[2]))}};
  }
  /// Shifts and turns.
  [[nodiscard]] FourMotions<S, L> paths() const noexcept {
    const auto from = [&](std::size_t k) {
      return reinterpret_cast<const unsigned char*>(bodies_[k]) + 16;
    };
    const auto words = L::load({from(0), from(1), from(2), from(3)});
    return {{Speed(lower(words[1])), Speed(upper(words[1])), Speed(lower(words[2]))},
            {Spin(upper(words[2])), Spin(lower(words[3])), Spin(upper(words[3]))}};
  }
  /// Writes the velocities of the marked bodies. `motions` must have been called before.
  void store(const FourMotions<S, L>& m, const Quad<bool>& marks) noexcept {
    std::array<std::byte, 32> unused;
    const auto to = [&](std::size_t k) -> void* {
      return marks[k] ? static_cast<void*>(bodies_[k]) : &unused;
    };
    L::store(
        {joined(m.velocity[0].raw, m.velocity[1].raw), joined(m.velocity[2].raw, m.spin[0].raw),
         joined(m.spin[1].raw, m.spin[2].raw), after_},
        {to(0), to(1), to(2), to(3)});
  }

 private:
  static L lower(const L& x) noexcept { return x.lower(); }
  static L upper(const L& x) noexcept { return x.upper(); }
  static L joined(const L& low, const L& high) noexcept {
    return (low & L(LongWord{0xffffffff})) | (high << 32);
  }

  std::array<Body*, long_lane_count> bodies_;
  L after_;  // the word that follows the velocities
};

/// The two bodies of each of four contacts or joints, for a solver to change their motions.
template <class L, Scalar S>
class FourPairs {
  using Ratio = Four<typename Formats<S>::Ratio, L>;

 protected:
  FourPairs(Moving<S, 3>* bodies, const Quad<std::uint32_t>& a,
            const Quad<std::uint32_t>& b) noexcept
      : bodies_a_(bodies, a),
        bodies_b_(bodies, b),
        a_(bodies_a_.motions()),
        b_(bodies_b_.motions()) {}

  /// Changes component i of the velocities by an impulse times these numbers.
  template <class Times, class Impulse>
  void push(std::size_t i, const Times& on_a, const Times& on_b, const Impulse& by) noexcept {
    a_.velocity[i] = round_.minus_nearest(a_.velocity[i], Ratio(on_a) * by);
    b_.velocity[i] = round_.plus_nearest(b_.velocity[i], Ratio(on_b) * by);
  }
  /// The same for bodies with equal shares.
  template <class Times, class Impulse>
  void push(std::size_t i, const Times& on_both, const Impulse& by) noexcept {
    round_.exchange_nearest(a_.velocity[i], b_.velocity[i], Ratio(on_both) * by);
  }
  /// Changes the spins by an impulse times these vectors of `T`.
  template <class T, class Times, class Impulse>
  void turn(const Times& on_a, const Times& on_b, const Impulse& by) noexcept {
    for (std::size_t i = 0; i < 3; ++i) {
      a_.spin[i] = round_.minus_nearest(a_.spin[i], Four<T, L>(on_a[i]) * by);
      b_.spin[i] = round_.plus_nearest(b_.spin[i], Four<T, L>(on_b[i]) * by);
    }
  }
  /// Writes the velocities of the bodies that have a mark. Returns false, and has changed nothing,
  /// if some number left its range.
  [[nodiscard]] bool store(const Quad<bool>& marks_a, const Quad<bool>& marks_b) noexcept {
    if (round_.is_beyond()) return false;
    bodies_a_.store(a_, marks_a);
    bodies_b_.store(b_, marks_b);
    return true;
  }

  FourBodies<S, L> bodies_a_, bodies_b_;
  FourMotions<S, L> a_, b_;
  FourRounder<L> round_;
};

DETENT_END_LONG_LANES

}  // namespace detent::detail
