// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/math/rotation.hpp"
#include "number/big_integer.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {

template <Scalar S, int N>
Vec<S, N> random_vec(Random& random) {
  const int bits = static_cast<int>(random.below(S::bits + 1));
  return make_vec<N>(
      [&](int) { return S::from_raw(static_cast<typename S::raw_type>(random.edgy(bits))); });
}

/// Unrelated axes, sometimes parallel.
template <Scalar S, int N>
Rotation<S, N> random_frame(Random& random) {
  std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
  for (auto& axis : axes) {
    axis = normalize(random_vec<S, N>(random)).value_or(Direction<S, N>::along(N - 1));
  }
  if (random.one_in(8)) axes[1] = random.coin() ? axes[0] : -axes[0];
  return Rotation<S, N>::from_axes(axes);
}

/// A rotation whose axes are correctly rounded.
template <Scalar S, int N>
Rotation<S, N> random_rotation(Random& random) {
  if constexpr (N == 2) {
    return Rotation<S, 2>::from_angle(
        Angle<S>::from_raw(static_cast<std::uint32_t>(random.next())));
  } else {
    const auto draw = [&] { return random_fixed<S>(random); };
    return Rotation<S, 3>::from_quaternion(draw(), draw(), draw(), draw())
        .value_or(Rotation<S, 3>());
  }
}

/// Whether each component of `d` is that of `exact`, normalised and rounded to nearest. For a zero
/// vector any direction is accepted.
template <Scalar S, int N>
bool is_direction_of(const Direction<S, N>& d,
                     const std::array<BigInteger, static_cast<std::size_t>(N)>& exact) {
  BigInteger squared = 0;
  for (const auto& component : exact) squared += component * component;
  if (squared == 0) return true;
  for (int i = 0; i < N; ++i) {
    const BigInteger found = big_raw(d[i]), &x = exact[static_cast<std::size_t>(i)];
    if (found * x < 0) return false;
    const BigInteger twice = 2 * abs(found);
    const BigInteger scaled = 4 * x * x * power_of_two(2 * direction_component<S>::frac);
    if (twice != 0 && scaled <= (twice - 1) * (twice - 1) * squared) return false;
    if (scaled >= (twice + 1) * (twice + 1) * squared) return false;
  }
  return true;
}

}  // namespace detent::test
