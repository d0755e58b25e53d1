// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include "detent/number/fixed.hpp"
#include "detent/number/words.hpp"

namespace detent {

/// A running XXH64 over the values added so far.
///
/// Every value contributes its canonical bytes: numbers in little-endian order at their own width,
/// members in declaration order, no padding. So the digest depends neither on byte order nor on
/// struct layout.
///
/// source: Yann Collet, xxHash fast digest algorithm, XXH64                  (tests/number/digest)
class Digest {
 public:
  constexpr Digest() noexcept : Digest(0) {}
  /// A digest that starts from `seed`; 0 by default.
  explicit constexpr Digest(std::uint64_t seed) noexcept
      : seed_(seed), lanes_{seed + p1 + p2, seed + p2, seed, seed - p1} {}

  /// Appends each value in turn, with its `append(digest, value)`.
  template <class... Values>
  constexpr void add(const Values&... values) noexcept {
    (append(*this, values), ...);
  }

  /// Appends the low `count` bytes of a word, lowest first; the others must be 0. `count` <= 8.
  constexpr void add_low_bytes(std::uint64_t word, int count) noexcept {
    const int used = static_cast<int>(length_ % 8);
    const auto lane = static_cast<std::size_t>(length_ / 8 % 4);
    length_ += static_cast<std::uint64_t>(count);
    partial_ |= word << (8 * used);
    if (used + count < 8) return;
    stripe_[lane] = partial_;
    partial_ = used == 0 ? 0 : word >> (8 * (8 - used));
    if (lane == 3) mix_stripe();
  }

  /// Appends bytes as they are.
  constexpr void add_bytes(std::span<const std::byte> bytes) noexcept {
    if (length_ % 32 == 0) {
      // Whole stripes at once.
      for (; bytes.size() >= 32; bytes = bytes.subspan(32), length_ += 32) {
        for (std::size_t i = 0; i < 4; ++i) {
          lanes_[i] = mixed(lanes_[i], detail::load_word<std::uint64_t>(bytes.data() + 8 * i));
        }
      }
    }
    for (const std::byte byte : bytes) add_low_bytes(std::to_integer<std::uint64_t>(byte), 1);
  }

  /// The digest of everything added so far; more may be added afterwards.
  [[nodiscard]] constexpr std::uint64_t value() const noexcept {
    std::uint64_t hash = seed_ + p5;
    if (length_ >= 32) {
      hash = std::rotl(lanes_[0], 1) + std::rotl(lanes_[1], 7) + std::rotl(lanes_[2], 12) +
             std::rotl(lanes_[3], 18);
      for (const std::uint64_t lane : lanes_) hash = (hash ^ mixed(0, lane)) * p1 + p4;
    }
    hash += length_;
    for (std::size_t i = 0; i < length_ / 8 % 4; ++i) {
      hash = std::rotl(hash ^ mixed(0, stripe_[i]), 27) * p1 + p4;
    }
    std::uint64_t rest = partial_;
    auto left = length_ % 8;
    if (left >= 4) {
      hash = std::rotl(hash ^ ((rest & 0xffffffffu) * p1), 23) * p2 + p3;
      rest >>= 32;
      left -= 4;
    }
    for (; left > 0; --left, rest >>= 8) {
      hash = std::rotl(hash ^ ((rest & 0xffu) * p5), 11) * p1;
    }
    hash = (hash ^ (hash >> 33)) * p2;
    hash = (hash ^ (hash >> 29)) * p3;
    return hash ^ (hash >> 32);
  }

 private:
  static constexpr std::uint64_t p1 = 0x9e3779b185ebca87u, p2 = 0xc2b2ae3d27d4eb4fu,
                                 p3 = 0x165667b19e3779f9u, p4 = 0x85ebca77c2b2ae63u,
                                 p5 = 0x27d4eb2f165667c5u;

  static constexpr std::uint64_t mixed(std::uint64_t lane, std::uint64_t word) noexcept {
    return std::rotl(lane + word * p2, 31) * p1;
  }

  constexpr void mix_stripe() noexcept {
    for (std::size_t i = 0; i < 4; ++i) lanes_[i] = mixed(lanes_[i], stripe_[i]);
  }

  std::uint64_t seed_;
  std::uint64_t length_ = 0;   // bytes added
  std::uint64_t partial_ = 0;  // the last length_ % 8 of them
  std::uint64_t stripe_[4] = {};
  std::uint64_t lanes_[4];
};

/// An integer contributes the bytes of its own type. For a digest that two platforms share, name a
/// fixed width (`std::uint64_t` rather than `std::size_t`). A bool is one byte, 0 or 1.
template <std::integral Int>
requires(sizeof(Int) <= 8) constexpr void append(Digest& digest, Int value) noexcept {
  if constexpr (std::same_as<Int, bool>) {
    digest.add_low_bytes(value ? 1 : 0, 1);
  } else {
    digest.add_low_bytes(static_cast<std::make_unsigned_t<Int>>(value), sizeof(Int));
  }
}

template <class E>
requires(std::is_enum_v<E>) constexpr void append(Digest& digest, E value) noexcept {
  append(digest, static_cast<std::underlying_type_t<E>>(value));
}

/// The IEEE 754 bits: 0.0 and -0.0 differ, and so may two NaNs.
constexpr void append(Digest& digest, float value) noexcept {
  append(digest, std::bit_cast<std::uint32_t>(value));
}

constexpr void append(Digest& digest, double value) noexcept {
  append(digest, std::bit_cast<std::uint64_t>(value));
}

/// The raw integer at the width of its container: 2, 4 or 8 bytes, then whole 64-bit words.
template <int Bits, int Frac>
constexpr void append(Digest& digest, const Fixed<Bits, Frac>& value) noexcept {
  const auto raw = value.raw();
  if constexpr (sizeof(raw) <= 8) {
    append(digest, raw);
  } else {
    for (int bit = 0; bit < 8 * static_cast<int>(sizeof(raw)); bit += 64) {
      append(digest, static_cast<std::uint64_t>(raw >> bit));
    }
  }
}

/// One byte, 0 or 1, then the value if there is one.
template <class T>
constexpr void append(Digest& digest, const std::optional<T>& value) noexcept {
  digest.add(value.has_value());
  if (value) digest.add(*value);
}

/// The elements in order, without their count, which is part of the type.
template <class T, std::size_t Size>
constexpr void append(Digest& digest, const std::array<T, Size>& values) noexcept {
  for (const T& value : values) digest.add(value);
}

/// A type with a function `append(digest, value)`, found by argument-dependent lookup, that appends
/// the value to the digest. An aggregate lists its fields:
///
///     template <class D, Scalar S, int N>
///     constexpr void append(D& digest, const Ray<S, N>& ray) noexcept {
///       digest.add(ray.origin, ray.direction, ray.max_distance);
///     }
///
/// `D` is a template parameter so that the header of the type need not include this one.
template <class T>
concept Digestible = requires(Digest& digest, const T& value) {
  append(digest, value);
};

/// XXH64 (seed 0) of the canonical bytes of `value`: equal on every platform for equal values.
template <Digestible T>
[[nodiscard]] constexpr std::uint64_t digest(const T& value) noexcept {
  Digest running;
  running.add(value);
  return running.value();
}

}  // namespace detent
