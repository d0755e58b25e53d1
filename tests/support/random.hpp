// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace detent::test {

/// A seeded generator that gives the same integers on every machine.
///
/// The standard library fixes its engines but not its distributions, so the distributions are here.
/// Uniform inputs rarely reach the ends of a domain or the neighbourhood of zero: `wide` draws the
/// magnitude's bit length first, and `edgy` mixes in corner values.
///
/// source: splitmix64, Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, 2014
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) noexcept : seed_(seed), state_(seed) {}

  [[nodiscard]] constexpr std::uint64_t seed() const noexcept { return seed_; }

  /// 64 independent bits.
  constexpr std::uint64_t next() noexcept {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// Uniform in [0, count); the bias of the remainder is below 2^-32 for counts up to 2^32.
  constexpr std::uint64_t below(std::uint64_t count) noexcept { return next() % count; }

  /// Uniform in [low, high], both ends included.
  constexpr std::int64_t between(std::int64_t low, std::int64_t high) noexcept {
    const auto span = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    const auto offset = span == 0 ? next() : below(span);
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + offset);
  }

  /// A number whose raw bits are uniform in [low, high].
  template <class S>
  constexpr S number(std::int64_t low, std::int64_t high) noexcept {
    return S::from_raw(static_cast<typename S::raw_type>(between(low, high)));
  }

  constexpr bool coin() noexcept { return (next() >> 63) != 0; }

  /// True once in `count` calls.
  constexpr bool one_in(std::uint64_t count) noexcept { return below(count) == 0; }

  /// Signed, |result| < 2^bits; every bit length of the magnitude from 0 to `bits` (at most 63) is
  /// equally likely.
  constexpr std::int64_t wide(int bits) noexcept {
    const int length = static_cast<int>(below(static_cast<std::uint64_t>(bits) + 1));
    if (length == 0) return 0;
    const auto top = std::uint64_t{1} << (length - 1);
    const auto magnitude = static_cast<std::int64_t>(top | (next() & (top - 1)));
    return coin() ? magnitude : -magnitude;
  }

  /// Signed in [-2^bits, 2^bits - 1] (bits up to 62): one in four is an end of the range, a power
  /// of two or one off, or near zero; the rest is half uniform, half `wide`.
  constexpr std::int64_t edgy(int bits) noexcept {
    const auto limit = std::int64_t{1} << bits;
    if (!one_in(4)) return coin() ? between(-limit, limit - 1) : wide(bits);
    const auto near = between(-2, 2);
    const auto power = std::int64_t{1} << below(static_cast<std::uint64_t>(bits) + 1);
    const auto corner = one_in(3) ? near : (coin() ? power : -power) + near;
    return corner < -limit ? -limit : corner >= limit ? limit - 1 : corner;
  }

 private:
  std::uint64_t seed_;
  std::uint64_t state_;
};

}  // namespace detent::test
