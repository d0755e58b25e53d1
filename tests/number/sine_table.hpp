// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "number/real.hpp"

namespace detent::test {

__extension__ typedef unsigned __int128 Word128;

/// Sines and cosines of binary angles in the first quarter turn within 2^-120, fast enough to check
/// all of them: MPFR tables for the upper and lower halves of the angle, and the addition theorems.
/// It shares no polynomial with the library.
class SineTable {
 public:
  /// In units of 2^-127.
  struct Pair {
    Word128 sine;
    Word128 cosine;
  };

  static const SineTable& instance() {
    static const SineTable table;
    return table;
  }

  /// angle in [0, 2^30), in units of 2^-32 turn.
  Pair operator()(std::uint32_t angle) const {
    return sum(upper_[angle >> 15], lower_[angle % 32768]);
  }

  /// The sum of two angles that stays within the quarter turn.
  static Pair sum(const Pair& a, const Pair& b) {
    return {product(a.sine, b.cosine) + product(a.cosine, b.sine),
            product(a.cosine, b.cosine) - product(a.sine, b.sine)};
  }

  static Pair pair_of(const Real& radians) {
    return {to_word(sin(radians)), to_word(cos(radians))};
  }

 private:
  SineTable() {
    for (int i = 0; i < 32768; ++i) {
      upper_.push_back(pair_of(ldexp(pi() * i, -16)));
      lower_.push_back(pair_of(ldexp(pi() * i, -31)));
    }
  }

  static Word128 to_word(const Real& x) {
    return static_cast<Word128>(static_cast<BigInteger>(ldexp(x, 127) + Real(0.5)));
  }

  static Word128 product(Word128 a, Word128 b) {
    const auto a0 = static_cast<std::uint64_t>(a), a1 = static_cast<std::uint64_t>(a >> 64);
    const auto b0 = static_cast<std::uint64_t>(b), b1 = static_cast<std::uint64_t>(b >> 64);
    const Word128 low = static_cast<Word128>(a0) * b0, high = static_cast<Word128>(a1) * b1;
    const Word128 left = static_cast<Word128>(a1) * b0, right = static_cast<Word128>(a0) * b1;
    const Word128 middle =
        (low >> 64) + static_cast<std::uint64_t>(left) + static_cast<std::uint64_t>(right);
    const Word128 upper = high + (left >> 64) + (right >> 64) + (middle >> 64);
    return (upper << 1) | (static_cast<std::uint64_t>(middle) >> 63);
  }

  std::vector<Pair> upper_, lower_;
};

}  // namespace detent::test
