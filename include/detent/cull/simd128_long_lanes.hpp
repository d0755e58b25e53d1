// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/number/require_cxx20.hpp"

// The long lanes of WebAssembly with simd128 (clang only).   (tests/cull/simd128.sh)
#if defined(__wasm_simd128__) && defined(__clang__)

namespace detent::detail {

/// Two vectors of two words, and the lower halves of all words in a third, for products. Numbers of
/// 32 bits have the third from the start. Optimizers drop the part that is not used.
///
/// Products and extensions are written in assembly: clang 14 selects the instruction only if it
/// sees both extensions in the same block, and otherwise multiplies 64 bits, which takes three
/// times as long.
class Simd128LongLanes {
  typedef std::uint64_t Words __attribute__((vector_size(16)));
  typedef std::int64_t Signed __attribute__((vector_size(16)));
  typedef std::int32_t Halves __attribute__((vector_size(16)));
  typedef double Doubles __attribute__((vector_size(16)));
  typedef std::int8_t Bytes __attribute__((vector_size(16)));
  typedef std::uint64_t AnyWords __attribute__((vector_size(16), aligned(1), may_alias));
  static constexpr std::size_t count = 4;

 public:
  Simd128LongLanes() noexcept : low_{}, high_{}, halves_{} {}
  explicit Simd128LongLanes(std::int64_t x) noexcept
      : Simd128LongLanes(static_cast<std::uint64_t>(x) - Words{},
                         static_cast<std::uint64_t>(x) - Words{}) {}
  explicit Simd128LongLanes(const std::array<std::int64_t, count>& words) noexcept
      : Simd128LongLanes(__builtin_bit_cast(Words, std::array{words[0], words[1]}),
                         __builtin_bit_cast(Words, std::array{words[2], words[3]})) {}
  explicit Simd128LongLanes(const std::array<std::int32_t, count>& x) noexcept
      : Simd128LongLanes(__builtin_bit_cast(Halves, x)) {}

  [[nodiscard]] std::array<std::int64_t, count> words() const noexcept {
    return std::bit_cast<std::array<std::int64_t, count>>(std::array{low_, high_});
  }
  [[nodiscard]] std::array<std::int32_t, count> halves() const noexcept {
    return std::bit_cast<std::array<std::int32_t, count>>(halves_);
  }

  [[nodiscard]] friend Simd128LongLanes operator+(const Simd128LongLanes& a,
                                                  const Simd128LongLanes& b) noexcept {
    return {a.low_ + b.low_, a.high_ + b.high_};
  }
  [[nodiscard]] friend Simd128LongLanes operator-(const Simd128LongLanes& a,
                                                  const Simd128LongLanes& b) noexcept {
    return {a.low_ - b.low_, a.high_ - b.high_};
  }
  [[nodiscard]] friend Simd128LongLanes operator&(const Simd128LongLanes& a,
                                                  const Simd128LongLanes& b) noexcept {
    return {a.low_ & b.low_, a.high_ & b.high_};
  }
  [[nodiscard]] friend Simd128LongLanes operator|(const Simd128LongLanes& a,
                                                  const Simd128LongLanes& b) noexcept {
    return {a.low_ | b.low_, a.high_ | b.high_};
  }
  [[nodiscard]] friend Simd128LongLanes operator>>(const Simd128LongLanes& a, int shift) noexcept {
    return {a.low_ >> shift, a.high_ >> shift};
  }
  [[nodiscard]] friend Simd128LongLanes operator<<(const Simd128LongLanes& a, int shift) noexcept {
    return {a.low_ << shift, a.high_ << shift};
  }
  [[nodiscard]] static Simd128LongLanes product(const Simd128LongLanes& a,
                                                const Simd128LongLanes& b) noexcept {
    Words low, high;
    asm("local.get %1\n local.get %2\n i64x2.extmul_low_i32x4_s\n local.set %0"
        : "=r"(low)
        : "r"(a.halves_), "r"(b.halves_));
    asm("local.get %1\n local.get %2\n i64x2.extmul_high_i32x4_s\n local.set %0"
        : "=r"(high)
        : "r"(a.halves_), "r"(b.halves_));
    return {low, high};
  }
  [[nodiscard]] Simd128LongLanes lower() const noexcept { return Simd128LongLanes(halves_); }
  [[nodiscard]] Simd128LongLanes upper() const noexcept {
    return Simd128LongLanes(__builtin_shufflevector(__builtin_bit_cast(Halves, low_),
                                                    __builtin_bit_cast(Halves, high_), 1, 3, 5, 7));
  }
  [[nodiscard]] Simd128LongLanes magnitudes() const noexcept {
    const auto magnitudes = __builtin_bit_cast(Halves, __builtin_wasm_abs_i32x4(halves_));
    const Halves zero{};
    return {__builtin_bit_cast(Words, __builtin_shufflevector(magnitudes, zero, 0, 4, 1, 5)),
            __builtin_bit_cast(Words, __builtin_shufflevector(magnitudes, zero, 2, 6, 3, 7))};
  }
  [[nodiscard]] static Simd128LongLanes above(const Simd128LongLanes& a,
                                              const Simd128LongLanes& b) noexcept {
    const auto part = [](const Words& x, const Words& y) {
      return __builtin_bit_cast(Words,
                                __builtin_bit_cast(Signed, x) > __builtin_bit_cast(Signed, y));
    };
    return {part(a.low_, b.low_), part(a.high_, b.high_)};
  }
  [[nodiscard]] static Simd128LongLanes select(const Simd128LongLanes& marks,
                                               const Simd128LongLanes& a,
                                               const Simd128LongLanes& b) noexcept {
    const auto part = [](const Words& m, const Words& x, const Words& y) {
      return (x & m) | (y & ~m);
    };
    return {part(marks.low_, a.low_, b.low_), part(marks.high_, a.high_, b.high_)};
  }
  [[nodiscard]] static Simd128LongLanes near_ratio(const Simd128LongLanes& a,
                                                   const Simd128LongLanes& b) noexcept {
    return {rounded(real(a.low_) * 0x1p30 / real(b.low_)),
            rounded(real(a.high_) * 0x1p30 / real(b.high_))};
  }
  [[nodiscard]] static Simd128LongLanes near_root(const Simd128LongLanes& a) noexcept {
    return {rounded(root(a.low_)), rounded(root(a.high_))};
  }
  [[nodiscard]] static Simd128LongLanes near_part(const Simd128LongLanes& a,
                                                  const Simd128LongLanes& m) noexcept {
    return {rounded(real(a.low_) * 0x1p50 / root(m.low_)),
            rounded(real(a.high_) * 0x1p50 / root(m.high_))};
  }
  [[nodiscard]] Simd128LongLanes least() const noexcept {
    const auto lesser = [](const Simd128LongLanes& a, const Simd128LongLanes& b) {
      return select(above(a, b), b, a);
    };
    const auto swapped = [](const Words& x) { return __builtin_shufflevector(x, x, 1, 0); };
    const auto two = lesser(*this, Simd128LongLanes(high_, low_));
    return lesser(two, Simd128LongLanes(swapped(two.low_), swapped(two.high_)));
  }
  [[nodiscard]] std::uint32_t signs() const noexcept {
    const auto part = [](const Words& x) {
      return static_cast<std::uint32_t>(
          __builtin_wasm_bitmask_i64x2(__builtin_bit_cast(Signed, x)));
    };
    return part(low_) | part(high_) << 2;
  }
  [[nodiscard]] bool any() const noexcept {
    return __builtin_wasm_any_true_v128(__builtin_bit_cast(Bytes, low_ | high_)) != 0;
  }

  [[nodiscard]] static std::array<Simd128LongLanes, 4> load(
      const std::array<const void*, count>& records) noexcept {
    const auto two = [&](std::size_t half) -> std::array<Simd128LongLanes, 2> {
      const auto at = [&](std::size_t k) -> Words {
        return static_cast<const AnyWords*>(records[k])[half];
      };
      const Words a = at(0), b = at(1), c = at(2), d = at(3);
      return {Simd128LongLanes(first_of(a, b), first_of(c, d)),
              Simd128LongLanes(second_of(a, b), second_of(c, d))};
    };
    const auto begin = two(0), end = two(1);
    return {begin[0], begin[1], end[0], end[1]};
  }
  static void store(const std::array<Simd128LongLanes, 4>& lanes,
                    const std::array<void*, count>& records) noexcept {
    const auto put = [&](std::size_t k, const auto& part_of, const auto& of) {
      for (std::size_t half = 0; half < 2; ++half) {
        static_cast<AnyWords*>(records[k])[half] =
            of(part_of(lanes[2 * half]), part_of(lanes[2 * half + 1]));
      }
    };
    const auto low = [](const Simd128LongLanes& x) { return x.low_; };
    const auto high = [](const Simd128LongLanes& x) { return x.high_; };
    put(0, low, first_of);
    put(1, low, second_of);
    put(2, high, first_of);
    put(3, high, second_of);
  }

 private:
  Simd128LongLanes(const Words& low, const Words& high) noexcept
      : low_(low),
        high_(high),
        halves_(__builtin_shufflevector(__builtin_bit_cast(Halves, low),
                                        __builtin_bit_cast(Halves, high), 0, 2, 4, 6)) {}
  // cppcheck-suppress uninitMemberVarPrivate  // the instructions set them
  explicit Simd128LongLanes(const Halves& x) noexcept : halves_(x) {
    asm("local.get %1\n i64x2.extend_low_i32x4_s\n local.set %0" : "=r"(low_) : "r"(x));
    asm("local.get %1\n i64x2.extend_high_i32x4_s\n local.set %0" : "=r"(high_) : "r"(x));
  }

  // Conversions as in `VectorLongLanes`.
  static constexpr std::uint64_t converter = 0x4338000000000000;
  static Doubles real(const Words& x) noexcept {
    return __builtin_bit_cast(Doubles, x + converter) - 0x1.8p52;
  }
  static Words rounded(const Doubles& x) noexcept {
    return __builtin_bit_cast(Words, x + 0x1.8p52) - converter;
  }
  static Doubles root(const Words& a) noexcept {
    const Doubles x = real(a >> 31) * 0x1p31 + real(a & 0x7fffffff);
#if __has_builtin(__builtin_elementwise_sqrt)
    return __builtin_elementwise_sqrt(x);
#else
    return __builtin_wasm_sqrt_f64x2(x);
#endif
  }

  static Words first_of(const Words& a, const Words& b) noexcept {
    return __builtin_shufflevector(a, b, 0, 2);
  }
  static Words second_of(const Words& a, const Words& b) noexcept {
    return __builtin_shufflevector(a, b, 1, 3);
  }

  Words low_, high_;
  Halves halves_;
};

}  // namespace detent::detail

#endif
