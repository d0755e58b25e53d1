// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/spin.hpp"

namespace detent::detail {

/// What the solver changes of a body.
template <Scalar S, int N>
struct Moving {
  using F = Formats<S>;

  Vec<typename F::Speed, N> velocity{};
  Axial<typename F::Spin, N> spin{};
  Vec<typename F::Speed, N> shift{};  // since the start of the tick; clamped
  Axial<typename F::Spin, N> turn{};
};

/// One direction in which two bodies push each other, without its unit vector n.
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

/// How fast b leaves a along a row: n . (dv_b - dv_a) + c_b . dw_b - c_a . dw_a.
///
/// |n . dv| <= 2^31 sqrt(3) 2^30 (1 + 2^-28) and c . dw <= 2^29 sqrt(3) 2^30 sqrt(3), all with two
/// bodies, fit 62 bits; the first is rounded to the grid of the second, the sum once more.
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

/// Pushes b along the row by `impulse` and a against it. A product is rounded, a velocity clamped.
template <Scalar S, int N, class F = Formats<S>>
constexpr void apply(const Thrust<S, N>& push, const Row<S, N>& row,
                     const typename F::Impulse& impulse, Moving<S, N>& a,
                     Moving<S, N>& b) noexcept {
  using Speed = typename F::Speed;
  using Spin = typename F::Spin;
  for (int i = 0; i < N; ++i) {
    a.velocity[i] = saturate_to<Speed>(a.velocity[i] - nearest_to<Speed>(push.on_a[i] * impulse));
    b.velocity[i] = saturate_to<Speed>(b.velocity[i] + nearest_to<Speed>(push.on_b[i] * impulse));
  }
  for (std::size_t i = 0; i < a.spin.size(); ++i) {
    a.spin[i] = saturate_to<Spin>(a.spin[i] - nearest_to<Spin>(row.response_a[i] * impulse));
    b.spin[i] = saturate_to<Spin>(b.spin[i] + nearest_to<Spin>(row.response_b[i] * impulse));
  }
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
      result[static_cast<std::size_t>(i)] = nearest_to<Response>(
          dot(make_vec<3>([&](int j) { return spread[entry<3>(i, j)]; }), from_array(moment)));
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
/// 1 / (1 - lost + c_a j_a + c_b j_b), rounded to nearest; `lost` is the part of the motion along the
/// row that locked axes take. Less than 1 / 64 counts as none: then nothing can push along the row.
template <Scalar S, int N, class F = Formats<S>>
constexpr void complete(Row<S, N>& row, const Spread<typename F::Gyration, N>& spread_a,
                        const Spread<typename F::Gyration, N>& spread_b,
                        const typename F::Give& lost = {}) noexcept {
  using Ratio = typename F::Ratio;
  row.response_a = response<S, N>(spread_a, row.moment_a);
  row.response_b = response<S, N>(spread_b, row.moment_b);
  const auto whole =
      Ratio(1) - lost +
      (give<S, N>(row.moment_a, row.response_a) + give<S, N>(row.moment_b, row.response_b));
  constexpr auto least = dyadic<S>(1 << 24);
  row.mass = whole < least ? Ratio{} : quotient_nearest<Ratio>(Ratio(1), whole);
}

}  // namespace detent::detail
