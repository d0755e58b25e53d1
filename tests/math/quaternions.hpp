// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "detent/math/quat.hpp"
#include "number/real.hpp"
#include "support/catch.hpp"

namespace detent::test {

/// The oracle for quaternions: x, y, z, w and Hamilton's product, in any number type.
template <class T>
using Four = std::array<T, 4>;

template <class T>
Four<T> product(const Four<T>& p, const Four<T>& q) {
  return {p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1],
          p[3] * q[1] + p[1] * q[3] + p[2] * q[0] - p[0] * q[2],
          p[3] * q[2] + p[2] * q[3] + p[0] * q[1] - p[1] * q[0],
          p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2]};
}

template <class T, Scalar S>
Four<T> four(const Quat<S>& q) {
  if constexpr (std::is_same_v<T, Real>) {
    return {real(q.x()), real(q.y()), real(q.z()), real(q.w())};
  } else {
    return {T(big_raw(q.x())), T(big_raw(q.y())), T(big_raw(q.z())), T(big_raw(q.w()))};
  }
}

inline Four<Real> unit(const Four<Real>& q) {
  const Real length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

/// The largest error of a component in units in the last place; not for float and double.
template <Scalar S>
double worst_ulps(const Quat<S>& q, const Four<Real>& exact) {
  const auto found = four<Real>(q);
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    worst = std::max(worst, ulps(found[i], exact[i], direction_component<S>::frac));
  }
  return worst;
}

/// Whether every component of `q` is that of `exact`, normalised and rounded to nearest.
template <Scalar S>
bool is_nearest_unit(const Quat<S>& q, const Four<BigInteger>& exact) {
  BigInteger squared = 0;
  for (const auto& component : exact) squared += component * component;
  const auto found = four<BigInteger>(q);
  for (std::size_t i = 0; i < 4; ++i) {
    if (found[i] * exact[i] < 0) return false;
    const BigInteger twice = 2 * abs(found[i]);
    const BigInteger x = 4 * exact[i] * exact[i] * power_of_two(2 * direction_component<S>::frac);
    if (twice != 0 && x <= (twice - 1) * (twice - 1) * squared) return false;
    if (x >= (twice + 1) * (twice + 1) * squared) return false;
  }
  return true;
}

template <Scalar S>
Angle<S> random_angle(Random& random) {
  return Angle<S>::from_raw(random.one_in(4) ? static_cast<std::uint32_t>(random.below(8)) << 29
                                             : static_cast<std::uint32_t>(random.edgy(31)));
}

/// Normalised from numbers of any size, or with a length that is only nearly 1.
template <Scalar S>
Quat<S> random_quat(Random& random) {
  using Raw = typename Quat<S>::Raw;
  while (true) {
    const int bits = static_cast<int>(random.below(S::bits)) + 1;
    const auto draw = [&] {
      return S::from_raw(static_cast<typename S::raw_type>(random.edgy(bits)));
    };
    const auto q = Quat<S>::normalize(draw(), draw(), draw(), draw());
    if (!q) continue;
    std::array<Raw, 4> raw = {q->x().raw(), q->y().raw(), q->z().raw(), q->w().raw()};
    for (auto& r : raw) r = static_cast<Raw>(r + random.between(-1, 1));
    return Quat<S>::from_raw(raw).value_or(*q);
  }
}

}  // namespace detent::test
