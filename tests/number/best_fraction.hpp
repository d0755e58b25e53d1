// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "number/sine_table.hpp"

namespace detent::test {

/// The vector (a, b), 0 < a <= 2^31, closest to the ray halfway between the binary angles `whole`
/// and `whole` + 1, both in the first octant.
struct NearTie {
  std::uint64_t a;
  std::uint64_t b;
  /// |b cos - a sin| of that ray, in units of 2^-127 and off by less than 2^-85: the least of all
  /// vectors with components up to 2^31.
  Word128 distance;
  bool above;
};

/// source: the convergents of a continued fraction are the best approximations (of the second
///         kind), Khinchin, Continued Fractions, theorem 17; here by Euclid's algorithm on sin, cos
inline NearTie nearest_tie(std::uint32_t whole) {
  static const SineTable& table = SineTable::instance();
  static const SineTable::Pair half_step = SineTable::pair_of(ldexp(pi(), -32));
  const auto [sine, cosine] = SineTable::sum(table(whole), half_step);
  NearTie previous{0, 1, cosine, true};
  NearTie best{1, 0, sine, false};
  while (best.distance != 0) {
    const Word128 quotient = previous.distance / best.distance;
    if (quotient >> 32 != 0) break;
    const auto q = static_cast<std::uint64_t>(quotient);
    const NearTie next{previous.a + q * best.a, previous.b + q * best.b,
                       previous.distance - quotient * best.distance, previous.above};
    if (next.a >> 31 != 0 && next.a != std::uint64_t{1} << 31) break;
    previous = best;
    best = next;
  }
  return best;
}

}  // namespace detent::test
