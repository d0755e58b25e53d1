// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/long_dot.hpp"
#include "detent/dynamics/spin.hpp"

namespace detent::detail {

/// The state of a body that the solver changes.
template <Scalar S, int N>
struct Moving {
  using F = Formats<S>;

  Vec<typename F::Speed, N> velocity{};
  Axial<typename F::Spin, N> spin{};
  Vec<typename F::Speed, N> shift{};  // since it was held, or the start of the tick; clamped
  Axial<typename F::Spin, N> turn{};
};

/// One direction in which two bodies push each other, except for its unit vector n.
template <Scalar S, int N>
struct Row {
  using F = Formats<S>;

  Axial<typename F::Moment, N> moment_a{}, moment_b{};        // r x n
  Axial<typename F::Response, N> response_a{}, response_b{};  // change of spin by an impulse of 1
  typename F::Ratio mass{};                                   // effective, in (0, 1]
};

/// A unit vector and the changes of velocity by an impulse of 1 along it.
template <Scalar S, int N>
struct Thrust {
  using Ratio = typename Formats<S>::Ratio;

  Vec<Ratio, N> along{};  // from a to b
  Vec<Ratio, N> on_a{}, on_b{};
};

/// The rate at which b moves away from a along a row: n . (dv_b - dv_a) + c_b . dw_b - c_a . dw_a.
///
/// |n . dv| <= 2^31 sqrt(3) 2^30 (1 + 2^-28) and c . dw <= 2^29 sqrt(3) 2^30 sqrt(3), with both
/// bodies, fit 62 bits. The first is rounded to the grid of the second, the sum once more.
template <Scalar S, int N, class F = Formats<S>>
[[nodiscard]] constexpr typename F::Speed rate_along(
    const Vec<typename F::Ratio, N>& n, const Row<S, N>& row, const Vec<typename F::Speed, N>& va,
    const Axial<typename F::Spin, N>& wa, const Vec<typename F::Speed, N>& vb,
    const Axial<typename F::Spin, N>& wb, const typename F::Speed& start = {}) noexcept {
  auto sum = nearest_to<typename F::Sum>(narrow_dot<62>(n, vb - va));
  for (std::size_t i = 0; i < wa.size(); ++i) {
    sum = narrow_sum<62>(sum, narrow_difference<62>(narrow_product<62>(row.moment_b[i], wb[i]),
                                                    narrow_product<62>(row.moment_a[i], wa[i])));
  }
  return saturate_to<typename F::Speed>(start + saturate_to<typename F::Speed>(sum));
}

/// The same without a unit vector: c_b . dw_b - c_a . dw_a.
template <Scalar S, int N, class F = Formats<S>>
[[nodiscard]] constexpr typename F::Speed turning_along(
    const Row<S, N>& row, const Axial<typename F::Spin, N>& wa,
    const Axial<typename F::Spin, N>& wb) noexcept {
  typename F::Sum sum{};
  for (std::size_t i = 0; i < wa.size(); ++i) {
    sum = narrow_sum<62>(sum, narrow_difference<62>(narrow_product<62>(row.moment_b[i], wb[i]),
                                                    narrow_product<62>(row.moment_a[i], wa[i])));
  }
  return saturate_to<typename F::Speed>(sum);
}

/// Detects numbers outside the range of T, which has at most 62 bits, with one addition and one OR
/// per number and a single comparison.
template <class T>
class Spill {
 public:
  template <class X>
  constexpr void note(const X& x) noexcept {
    bits_ |= static_cast<std::uint64_t>(x.raw()) + (std::uint64_t{1} << T::bits);
  }
  [[nodiscard]] constexpr bool any() const noexcept { return bits_ >> T::bits >> 1 != 0; }

 private:
  std::uint64_t bits_ = 0;
};

/// Adds `sign` times share * impulse, each product rounded to nearest and clamped, to each component
/// of a velocity or spin, and clamps the sum. `share` and `velocity` have the same number of
/// components.
///
/// Clamping is rare. |share| |impulse| <= 2^62 is rounded off by at least 22 bits, so sums with
/// numbers of 30 bits fit 62 bits.
template <int Sign, int Count, class V, class Shares, class Velocity, class Impulse>
constexpr void push_each(const Shares& share, const Impulse& impulse, Velocity& velocity) noexcept {
  const auto at = [](auto& v, int i) -> auto& {
    if constexpr (requires { v.x; }) {
      return v[i];
    } else {
      return v[static_cast<std::size_t>(i)];
    }
  };
  if constexpr (is_fixed<V>) {
    using Wide = Fixed<62, V::frac>;
    Spill<V> spill;
    std::array<Wide, std::size_t{Count}> sum;
    for (int i = 0; i < Count; ++i) {
      const auto part = nearest_to<Wide>(at(share, i) * impulse);
      const auto whole = Sign > 0 ? narrow_sum<62>(at(velocity, i), part)
                                  : narrow_difference<62>(at(velocity, i), part);
      spill.note(part);
      spill.note(whole);
      sum[static_cast<std::size_t>(i)] = whole;
    }
    if (!spill.any()) {
      for (int i = 0; i < Count; ++i) {
        at(velocity, i) = narrow<V::bits>(sum[static_cast<std::size_t>(i)]);
      }
      return;
    }
  }
  for (int i = 0; i < Count; ++i) {
    auto& v = at(velocity, i);
    const auto part = nearest_to<V>(at(share, i) * impulse);
    v = Sign > 0 ? saturate_to<V>(v + part) : saturate_to<V>(v - part);
  }
}

/// Which bodies of a row an impulse changes; the shares of the other are all 0.
struct Pushed {
  bool a = true, b = true;
};

/// Turns b along the row by `impulse`, and a by the opposite. Products are rounded, spins clamped.
template <Scalar S, int N, class F = Formats<S>>
constexpr void turn_both(const Row<S, N>& row, const typename F::Impulse& impulse, Moving<S, N>& a,
                         Moving<S, N>& b, const Pushed& pushed = {}) noexcept {
  constexpr int turns = N == 2 ? 1 : 3;
  using Spin = typename F::Spin;
  if (impulse == 0) return;
  if (pushed.a) push_each<-1, turns, Spin>(row.response_a, impulse, a.spin);
  if (pushed.b) push_each<1, turns, Spin>(row.response_b, impulse, b.spin);
}

/// Pushes b along the row by `impulse`, and a by the opposite. Products are rounded, velocities
/// clamped.
template <Scalar S, int N, class F = Formats<S>>
constexpr void apply(const Thrust<S, N>& push, const Row<S, N>& row,
                     const typename F::Impulse& impulse, Moving<S, N>& a, Moving<S, N>& b,
                     const Pushed& pushed = {}) noexcept {
  using Speed = typename F::Speed;
  if (impulse == 0) return;
  if (pushed.a) push_each<-1, N, Speed>(push.on_a, impulse, a.velocity);
  if (pushed.b) push_each<1, N, Speed>(push.on_b, impulse, b.velocity);
  turn_both<S, N>(row, impulse, a, b, pushed);
}

/// The change of spin by an impulse of 1 with this moment: `spread` is the inverse squared gyration
/// in the world times the body's share.
template <Scalar S, int N, class F = Formats<S>>
[[nodiscard]] constexpr Axial<typename F::Response, N> response(
    const Spread<typename F::Gyration, N>& spread,
    const Axial<typename F::Moment, N>& moment) noexcept {
  using Response = typename F::Response;
  if constexpr (N == 2) {
    return {nearest_to<Response>(spread[0] * moment[0])};
  } else {
    Axial<Response, N> result;
    for (int i = 0; i < 3; ++i) {
      result[static_cast<std::size_t>(i)] = nearest_dot<Response>(
          from_array(moment), make_vec<3>([&](int j) { return spread[entry<3>(i, j)]; }));
    }
    return result;
  }
}

/// moment . response, rounded to nearest, at least 0.
template <Scalar S, int N, class F = Formats<S>>
[[nodiscard]] constexpr auto give(const Axial<typename F::Moment, N>& moment,
                                  const Axial<typename F::Response, N>& response) noexcept {
  using Give = typename F::Give;
  Give sum{};
  if constexpr (N == 2) {
    sum = nearest_to<Give>(moment[0] * response[0]);
  } else {
    sum = nearest_to<Give>(dot(from_array(moment), from_array(response)));
  }
  return sum < 0 ? Give{} : sum;
}

/// raw / 2^30.
template <Scalar S>
[[nodiscard]] constexpr typename Formats<S>::Ratio dyadic(int raw) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  return quotient_nearest<Ratio>(as_operand<Ratio>(raw), as_operand<Ratio>(1 << 30));
}
/// 1 / (1 - lost + given), rounded to nearest; `lost` is the part of the motion along the row that
/// locked axes remove, and `given` the sum of what both bodies give. 0 if the denominator is less
/// than 1 / 64: then nothing can push along the row.
template <Scalar S, class Given, class F = Formats<S>>
[[nodiscard]] constexpr typename F::Ratio effective_mass(const typename F::Give& lost,
                                                         const Given& given) noexcept {
  using Ratio = typename F::Ratio;
  const auto whole = Ratio(1) - lost + given;
  constexpr auto least = dyadic<S>(1 << 24);
  return whole < least ? Ratio{} : quotient_nearest<Ratio>(Ratio(1), whole);
}

/// Computes the responses and the mass of a row from its moments.
template <Scalar S, int N, class F = Formats<S>>
constexpr void complete(Row<S, N>& row, const Spread<typename F::Gyration, N>& spread_a,
                        const Spread<typename F::Gyration, N>& spread_b,
                        const typename F::Give& lost = {}) noexcept {
  row.response_a = response<S, N>(spread_a, row.moment_a);
  row.response_b = response<S, N>(spread_b, row.moment_b);
  row.mass = effective_mass<S>(
      lost, give<S, N>(row.moment_a, row.response_a) + give<S, N>(row.moment_b, row.response_b));
}

// A push along axis I of the world, in fixed point: the same bits as above, without the products
// with the zeros of the unit vector and the moment. Products with 1 are exact.

/// Sets the moment of a push along axis I at `arm` and the response to it; returns what it gives.
template <int I, Scalar S, class F = Formats<S>>
[[nodiscard]] constexpr typename F::Give turn_about_axis(
    const Vec<typename F::Arm, 3>& arm, const Spread<typename F::Gyration, 3>& spread,
    Axial<typename F::Moment, 3>& moment, Axial<typename F::Response, 3>& response) noexcept {
  using Moment = typename F::Moment;
  using Response = typename F::Response;
  using Give = typename F::Give;
  constexpr int j = (I + 1) % 3, k = (I + 2) % 3;
  const Vec<Moment, 2> turns{nearest_to<Moment>(arm[k]),
                             narrow_negative(nearest_to<Moment>(arm[j]))};
  moment[std::size_t{j}] = turns.x;
  moment[std::size_t{k}] = turns.y;
  for (int i = 0; i < 3; ++i) {
    response[static_cast<std::size_t>(i)] = nearest_dot<Response>(
        turns, Vec<typename F::Gyration, 2>{spread[entry<3>(i, j)], spread[entry<3>(i, k)]});
  }
  const auto sum = nearest_to<Give>(
      dot(turns, Vec<Response, 2>{response[std::size_t{j}], response[std::size_t{k}]}));
  return sum < 0 ? Give{} : sum;
}

/// As `rate_along`.
template <int I, Scalar S, class F = Formats<S>>
[[nodiscard]] constexpr typename F::Speed rate_along_axis(const Row<S, 3>& row,
                                                          const Moving<S, 3>& a,
                                                          const Moving<S, 3>& b) noexcept {
  const auto turning = [&](std::size_t i) {
    return narrow_difference<62>(narrow_product<62>(row.moment_b[i], b.spin[i]),
                                 narrow_product<62>(row.moment_a[i], a.spin[i]));
  };
  const auto moving = nearest_to<typename F::Sum>(b.velocity[I] - a.velocity[I]);
  return saturate_to<typename F::Speed>(
      narrow_sum<62>(narrow_sum<62>(moving, turning((I + 1) % 3)), turning((I + 2) % 3)));
}

/// As `apply`.
template <int I, Scalar S, class F = Formats<S>>
constexpr void apply_along_axis(const Thrust<S, 3>& push, const Row<S, 3>& row,
                                const typename F::Impulse& impulse, Moving<S, 3>& a,
                                Moving<S, 3>& b) noexcept {
  using Speed = typename F::Speed;
  if (impulse == 0) return;
  auto &va = a.velocity[I], &vb = b.velocity[I];
  va = saturate_to<Speed>(va - nearest_to<Speed>(push.on_a[I] * impulse));
  vb = saturate_to<Speed>(vb + nearest_to<Speed>(push.on_b[I] * impulse));
  turn_both<S, 3>(row, impulse, a, b);
}

}  // namespace detent::detail
