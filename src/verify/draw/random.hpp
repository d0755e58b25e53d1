// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace detent::verify {

/// A seeded generator of integers, cheap on 32-bit chips without division.
///
/// source: splitmix64, Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators (2014)
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) noexcept : state_(seed) {}

  constexpr std::uint64_t next() noexcept {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// In [0, count), for counts up to 2^32.
  constexpr std::uint64_t below(std::uint64_t count) noexcept {
    return ((next() >> 32) * count) >> 32;
  }

  /// In [low, high], both ends included, for spans up to 2^32; `low` when they are swapped.
  constexpr std::int64_t between(std::int64_t low, std::int64_t high) noexcept {
    if (high < low) return low;
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }

  constexpr bool one_in(std::uint64_t count) noexcept { return below(count) == 0; }
  constexpr bool coin() noexcept { return one_in(2); }
  constexpr std::int64_t sign() noexcept { return coin() ? 1 : -1; }

  /// In (-2^bits, 2^bits), with every bit length of the magnitude equally likely.
  constexpr std::int64_t wide(int bits) noexcept {
    // One draw per statement, here and everywhere: the order within a statement is up to the
    // compiler.
    const auto length = below(static_cast<std::uint64_t>(bits) + 1);
    const auto size = static_cast<std::int64_t>(below(std::uint64_t{1} << length));
    return coin() ? size : -size;
  }

  /// In [-2^bits, 2^bits - 1]: a quarter at or next to an end of the range, a power of two or 0; of
  /// the rest half uniform and half `wide`.
  constexpr std::int64_t edgy(int bits) noexcept {
    const auto limit = std::int64_t{1} << bits;
    if (!one_in(4)) return coin() ? between(-limit, limit - 1) : wide(bits);
    const auto beside = between(-2, 2);
    const auto power = std::int64_t{1} << below(static_cast<std::uint64_t>(bits) + 1);
    const auto value = one_in(3) ? beside : beside + power * sign();
    return value < -limit ? -limit : value >= limit ? limit - 1 : value;
  }

 private:
  std::uint64_t state_;
};

}  // namespace detent::verify
