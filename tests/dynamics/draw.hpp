// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/dynamics/spin.hpp"
#include "support/random.hpp"

namespace detent::test {

/// A number of up to `bits` bits.
template <class T>
T draw(Random& random, int bits) {
  return T::assume_raw(static_cast<typename T::raw_type>(random.edgy(bits)));
}

/// A unit vector; one in four is along an axis.
template <class T, int N>
Vec<T, N> draw_unit(Random& random) {
  std::array<T, static_cast<std::size_t>(N)> v{};
  for (auto& x : v) x = draw<T>(random, 30);
  const auto unit = unit_vector<T>(v);
  if (unit && !random.one_in(4)) return from_array(*unit);
  v = {};
  v[static_cast<std::size_t>(random.below(N))] = T(random.coin() ? 1 : -1);
  return from_array(v);
}

/// Numbers within 4 units or, if `wild`, any.
template <Scalar S, int N>
struct Numbers {
  Random& random;
  bool wild;

  S any() const { return draw<S>(random, S::bits); }
  S operator()() const {
    return wild ? any() : quotient_nearest<S>(static_cast<int>(random.between(-1000, 1000)), 250);
  }
  /// Not negative, except for the lowest number.
  S size() const {
    const auto x = (*this)();
    return x < 0 && x > S::lowest() ? saturate_to<S>(-x) : x;
  }
  Vec<S, N> point() const {
    return make_vec<N>([&](int) { return (*this)(); });
  }
};

}  // namespace detent::test
