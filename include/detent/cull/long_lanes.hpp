// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#if __STDC_HOSTED__
#include <cmath>
#endif

#include "detent/cull/simd128_long_lanes.hpp"
#include "detent/number/require_cxx20.hpp"

// Four integers of 64 bits, one per lane, with a product of 32 by 32 bits: one vector with AVX2,
// two with WebAssembly's simd128, elsewhere an array with the same operations.
//                                                           (tests/cull/long_lanes.test.cpp)
//
// On x86-64 the vectors exist even without -mavx2: functions between DETENT_BEGIN_LONG_LANES and
// DETENT_END_LONG_LANES are compiled for AVX2, and callers must test `runs_vectors()` first. Other
// functions must not take or return lanes by value. (Not on Windows, where GCC does not align
// vectors on the stack.)
//
// GCC has __builtin_shufflevector since version 12.
#if defined(__AVX2__) && (defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 12))
#define DETENT_LONG_LANES 2
#elif defined(__wasm_simd128__) && defined(__clang__)
#define DETENT_LONG_LANES 2
#elif defined(__x86_64__) && __STDC_HOSTED__ && !defined(_WIN32) && \
    (defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 12))
#define DETENT_LONG_LANES 1
#else
#define DETENT_LONG_LANES 0
#endif
#if DETENT_LONG_LANES != 1
#define DETENT_BEGIN_LONG_LANES
#define DETENT_END_LONG_LANES
#elif defined(__clang__)
#define DETENT_BEGIN_LONG_LANES \
  _Pragma("clang attribute push(__attribute__((target(\"avx2\"))), apply_to = function)")
#define DETENT_END_LONG_LANES _Pragma("clang attribute pop")
#else
#define DETENT_BEGIN_LONG_LANES _Pragma("GCC push_options") _Pragma("GCC target(\"avx2\")")
#define DETENT_END_LONG_LANES _Pragma("GCC pop_options")
#endif

namespace detent::detail {

inline constexpr std::size_t long_lane_count = 4;
using LongWord = std::int64_t;
using LongWords = std::array<LongWord, long_lane_count>;

/// All operations are modulo 2^64.
class ArrayLongLanes {
 public:
  constexpr ArrayLongLanes() noexcept = default;
  explicit constexpr ArrayLongLanes(std::int64_t x) noexcept { words_.fill(x); }
  explicit constexpr ArrayLongLanes(const LongWords& words) noexcept : words_(words) {}
  explicit constexpr ArrayLongLanes(const std::array<std::int32_t, long_lane_count>& x) noexcept {
    for (std::size_t k = 0; k < long_lane_count; ++k) words_[k] = x[k];
  }

  [[nodiscard]] constexpr LongWords words() const noexcept { return words_; }
  /// The lower halves.
  [[nodiscard]] constexpr std::array<std::int32_t, long_lane_count> halves() const noexcept {
    std::array<std::int32_t, long_lane_count> result{};
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      result[k] = static_cast<std::int32_t>(words_[k]);
    }
    return result;
  }

  [[nodiscard]] friend constexpr ArrayLongLanes operator+(const ArrayLongLanes& a,
                                                          const ArrayLongLanes& b) noexcept {
    return each(a, b, [](std::uint64_t x, std::uint64_t y) { return x + y; });
  }
  [[nodiscard]] friend constexpr ArrayLongLanes operator-(const ArrayLongLanes& a,
                                                          const ArrayLongLanes& b) noexcept {
    return each(a, b, [](std::uint64_t x, std::uint64_t y) { return x - y; });
  }
  [[nodiscard]] friend constexpr ArrayLongLanes operator&(const ArrayLongLanes& a,
                                                          const ArrayLongLanes& b) noexcept {
    return each(a, b, [](std::uint64_t x, std::uint64_t y) { return x & y; });
  }
  [[nodiscard]] friend constexpr ArrayLongLanes operator|(const ArrayLongLanes& a,
                                                          const ArrayLongLanes& b) noexcept {
    return each(a, b, [](std::uint64_t x, std::uint64_t y) { return x | y; });
  }
  /// Shifts zeros in.
  [[nodiscard]] friend constexpr ArrayLongLanes operator>>(const ArrayLongLanes& a,
                                                           int shift) noexcept {
    return each(a, a, [&](std::uint64_t x, std::uint64_t) { return x >> shift; });
  }
  [[nodiscard]] friend constexpr ArrayLongLanes operator<<(const ArrayLongLanes& a,
                                                           int shift) noexcept {
    return each(a, a, [&](std::uint64_t x, std::uint64_t) { return x << shift; });
  }
  /// The product of the lower halves, with their signs.
  [[nodiscard]] static constexpr ArrayLongLanes product(const ArrayLongLanes& a,
                                                        const ArrayLongLanes& b) noexcept {
    return each(a, b, [](std::uint64_t x, std::uint64_t y) {
      return static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(x)} *
                                        static_cast<std::int32_t>(y));
    });
  }
  /// The lower or the upper halves, with their signs.
  [[nodiscard]] constexpr ArrayLongLanes lower() const noexcept { return ArrayLongLanes(halves()); }
  [[nodiscard]] constexpr ArrayLongLanes upper() const noexcept { return (*this >> 32).lower(); }
  /// The magnitudes of the lower halves.
  [[nodiscard]] constexpr ArrayLongLanes magnitudes() const noexcept {
    ArrayLongLanes result = lower();
    for (auto& word : result.words_) word = word < 0 ? -word : word;
    return result;
  }
  /// All bits of the lanes of a that are above those of b.
  [[nodiscard]] static constexpr ArrayLongLanes above(const ArrayLongLanes& a,
                                                      const ArrayLongLanes& b) noexcept {
    return each(a, b, [](std::uint64_t x, std::uint64_t y) {
      return static_cast<std::int64_t>(x) > static_cast<std::int64_t>(y) ? ~std::uint64_t{0} : 0;
    });
  }
  /// The lanes of a where `marks` has all bits, and those of b where it has none.
  [[nodiscard]] static constexpr ArrayLongLanes select(const ArrayLongLanes& marks,
                                                       const ArrayLongLanes& a,
                                                       const ArrayLongLanes& b) noexcept {
    ArrayLongLanes result;
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      result.words_[k] = marks.words_[k] != 0 ? a.words_[k] : b.words_[k];
    }
    return result;
  }
#if __STDC_HOSTED__
  /// The integer nearest to 2^30 a / b or a neighbour of it: computed in `double`, so the caller
  /// must decide by the remainder. All three are below 2^51 in magnitude; n / 0 is unspecified.
  [[nodiscard]] static ArrayLongLanes near_ratio(const ArrayLongLanes& a,
                                                 const ArrayLongLanes& b) noexcept {
    ArrayLongLanes result;
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      const auto x = static_cast<double>(a.words_[k]), y = static_cast<double>(b.words_[k]);
      result.words_[k] = rounded(x * 0x1p30 / y);
    }
    return result;
  }
  /// The same for sqrt(a), 0 <= a < 2^62.
  [[nodiscard]] static ArrayLongLanes near_root(const ArrayLongLanes& a) noexcept {
    ArrayLongLanes result;
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      result.words_[k] = rounded(std::sqrt(static_cast<double>(a.words_[k])));
    }
    return result;
  }
  /// An integer within 2 of 2^50 a / sqrt(m), for a^2 <= m < 2^63 and m > 0: m, its root and the
  /// quotient lose less than 2.5 2^-52 of it, less than 0.7, and rounding at most 1.
  [[nodiscard]] static ArrayLongLanes near_part(const ArrayLongLanes& a,
                                                const ArrayLongLanes& m) noexcept {
    ArrayLongLanes result;
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      const auto root = std::sqrt(static_cast<double>(m.words_[k]));
      result.words_[k] = rounded(static_cast<double>(a.words_[k]) * 0x1p50 / root);
    }
    return result;
  }
#endif
  /// The least lane, in every lane.
  [[nodiscard]] constexpr ArrayLongLanes least() const noexcept {
    auto least = words_[0];
    for (const auto word : words_) least = word < least ? word : least;
    return ArrayLongLanes(least);
  }
  /// A bit for each negative lane.
  [[nodiscard]] constexpr std::uint32_t signs() const noexcept {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < long_lane_count; ++k) bits |= words_[k] < 0 ? 1u << k : 0u;
    return bits;
  }
  /// Whether a bit is set.
  [[nodiscard]] constexpr bool any() const noexcept {
    return (words_[0] | words_[1] | words_[2] | words_[3]) != 0;
  }

  /// Word w of record k in lane k of element w, for the first four words of four records.
  [[nodiscard]] static std::array<ArrayLongLanes, 4> load(
      const std::array<const void*, long_lane_count>& records) noexcept {
    std::array<ArrayLongLanes, 4> result{};
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      LongWords words;
      std::memcpy(&words, records[k], sizeof words);
      for (std::size_t w = 0; w < 4; ++w) result[w].words_[k] = words[w];
    }
    return result;
  }
  /// The reverse of `load`. The records are stored in order of lanes.
  static void store(const std::array<ArrayLongLanes, 4>& lanes,
                    const std::array<void*, long_lane_count>& records) noexcept {
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      LongWords words{};
      for (std::size_t w = 0; w < 4; ++w) words[w] = lanes[w].words_[k];
      std::memcpy(records[k], &words, sizeof words);
    }
  }

 private:
  template <class F>
  static constexpr ArrayLongLanes each(const ArrayLongLanes& a, const ArrayLongLanes& b,
                                       const F& f) noexcept {
    ArrayLongLanes result;
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      result.words_[k] = static_cast<std::int64_t>(
          f(static_cast<std::uint64_t>(a.words_[k]), static_cast<std::uint64_t>(b.words_[k])));
    }
    return result;
  }

#if __STDC_HOSTED__
  /// To nearest; 0 for what does not fit.
  static LongWord rounded(double x) noexcept {
    // cppcheck-suppress incorrectLogicOperator  // false positive: hexadecimal exponents
    return x > -0x1p62 && x < 0x1p62 ? static_cast<LongWord>(std::floor(x + 0.5)) : 0;
  }
#endif

  LongWords words_{};
};

#if DETENT_LONG_LANES && defined(__wasm_simd128__)
using VectorLongLanes = Simd128LongLanes;
#elif DETENT_LONG_LANES
DETENT_BEGIN_LONG_LANES
class VectorLongLanes {
  typedef std::uint64_t Words __attribute__((vector_size(32)));
  typedef std::int64_t Signed __attribute__((vector_size(32)));
  typedef std::int32_t Halves __attribute__((vector_size(32)));
  typedef std::int32_t Short __attribute__((vector_size(16)));
  typedef double Doubles __attribute__((vector_size(32)));
  // In memory of any type. GCC copies bytes in halves of a vector, and loading the whole vector
  // then stalls.
  typedef std::uint64_t AnyWords __attribute__((vector_size(32), aligned(1), may_alias));

 public:
  VectorLongLanes() noexcept : words_{} {}
  explicit VectorLongLanes(std::int64_t x) noexcept
      : words_(static_cast<std::uint64_t>(x) - Words{}) {}
  explicit VectorLongLanes(const LongWords& words) noexcept
      : words_(__builtin_bit_cast(Words, words)) {}
  explicit VectorLongLanes(const std::array<std::int32_t, long_lane_count>& x) noexcept
      : words_(__builtin_bit_cast(Words,
                                  __builtin_convertvector(__builtin_bit_cast(Short, x), Signed))) {}

  [[nodiscard]] LongWords words() const noexcept { return std::bit_cast<LongWords>(words_); }
  [[nodiscard]] std::array<std::int32_t, long_lane_count> halves() const noexcept {
    const auto halves = __builtin_bit_cast(Halves, words_);
    return std::bit_cast<std::array<std::int32_t, long_lane_count>>(
        __builtin_shufflevector(halves, halves, 0, 2, 4, 6));
  }

  [[nodiscard]] friend VectorLongLanes operator+(const VectorLongLanes& a,
                                                 const VectorLongLanes& b) noexcept {
    return VectorLongLanes(a.words_ + b.words_);
  }
  [[nodiscard]] friend VectorLongLanes operator-(const VectorLongLanes& a,
                                                 const VectorLongLanes& b) noexcept {
    return VectorLongLanes(a.words_ - b.words_);
  }
  [[nodiscard]] friend VectorLongLanes operator&(const VectorLongLanes& a,
                                                 const VectorLongLanes& b) noexcept {
    return VectorLongLanes(a.words_ & b.words_);
  }
  [[nodiscard]] friend VectorLongLanes operator|(const VectorLongLanes& a,
                                                 const VectorLongLanes& b) noexcept {
    return VectorLongLanes(a.words_ | b.words_);
  }
  [[nodiscard]] friend VectorLongLanes operator>>(const VectorLongLanes& a, int shift) noexcept {
    return VectorLongLanes(a.words_ >> shift);
  }
  [[nodiscard]] friend VectorLongLanes operator<<(const VectorLongLanes& a, int shift) noexcept {
    return VectorLongLanes(a.words_ << shift);
  }
  [[nodiscard]] static VectorLongLanes product(const VectorLongLanes& a,
                                               const VectorLongLanes& b) noexcept {
#if defined(__clang__)
    const auto extended = [](const Words& x) { return __builtin_bit_cast(Signed, x << 32) >> 32; };
    return VectorLongLanes(__builtin_bit_cast(Words, extended(a.words_) * extended(b.words_)));
#else  // GCC multiplies all 64 bits
    return VectorLongLanes(
        __builtin_bit_cast(Words, __builtin_ia32_pmuldq256(__builtin_bit_cast(Halves, a.words_),
                                                           __builtin_bit_cast(Halves, b.words_))));
#endif
  }
  [[nodiscard]] VectorLongLanes lower() const noexcept {
    return product(*this, VectorLongLanes(std::int64_t{1}));
  }
  [[nodiscard]] VectorLongLanes upper() const noexcept { return (*this >> 32).lower(); }
  [[nodiscard]] VectorLongLanes magnitudes() const noexcept {
    const auto halves = __builtin_bit_cast(Halves, words_);
    const Halves signs = halves >> 31;
    return VectorLongLanes(__builtin_bit_cast(Words, (halves ^ signs) - signs) & 0xffffffff);
  }
  [[nodiscard]] static VectorLongLanes above(const VectorLongLanes& a,
                                             const VectorLongLanes& b) noexcept {
    return VectorLongLanes(__builtin_bit_cast(
        Words, __builtin_bit_cast(Signed, a.words_) > __builtin_bit_cast(Signed, b.words_)));
  }
  [[nodiscard]] static VectorLongLanes select(const VectorLongLanes& marks,
                                              const VectorLongLanes& a,
                                              const VectorLongLanes& b) noexcept {
    return VectorLongLanes(__builtin_bit_cast(Signed, marks.words_) < 0 ? a.words_ : b.words_);
  }
  [[nodiscard]] static VectorLongLanes near_ratio(const VectorLongLanes& a,
                                                  const VectorLongLanes& b) noexcept {
    return rounded(a.real() * 0x1p30 / b.real());
  }
  [[nodiscard]] static VectorLongLanes near_root(const VectorLongLanes& a) noexcept {
    return rounded(root(a));
  }
  [[nodiscard]] static VectorLongLanes near_part(const VectorLongLanes& a,
                                                 const VectorLongLanes& m) noexcept {
    return rounded(a.real() * 0x1p50 / root(m));
  }
  [[nodiscard]] VectorLongLanes least() const noexcept {
    const auto lesser = [](const VectorLongLanes& a, const VectorLongLanes& b) {
      return select(above(a, b), b, a);
    };
    const VectorLongLanes two =
        lesser(*this, VectorLongLanes(__builtin_shufflevector(words_, words_, 2, 3, 0, 1)));
    return lesser(two,
                  VectorLongLanes(__builtin_shufflevector(two.words_, two.words_, 1, 0, 3, 2)));
  }
  [[nodiscard]] std::uint32_t signs() const noexcept {
    return static_cast<std::uint32_t>(
        __builtin_ia32_movmskpd256(__builtin_bit_cast(Doubles, words_)));
  }
  [[nodiscard]] bool any() const noexcept {
    typedef long long Longs __attribute__((vector_size(32)));
    const auto words = __builtin_bit_cast(Longs, words_);
    return __builtin_ia32_ptestz256(words, words) == 0;
  }

  [[nodiscard]] static std::array<VectorLongLanes, 4> load(
      const std::array<const void*, long_lane_count>& records) noexcept {
    const auto at = [&](std::size_t k) {
      const Words words = *static_cast<const AnyWords*>(records[k]);  // a reference must be aligned
      return VectorLongLanes(words);
    };
    return transposed({at(0), at(1), at(2), at(3)});
  }
  static void store(const std::array<VectorLongLanes, 4>& lanes,
                    const std::array<void*, long_lane_count>& records) noexcept {
    const auto rows = transposed(lanes);
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      *static_cast<AnyWords*>(records[k]) = rows[k].words_;
    }
  }

 private:
  explicit VectorLongLanes(const Words& words) noexcept : words_(words) {}

  // A double in [2^52, 2^53) is its last bits plus 2^52: integers below 2^51 in magnitude are
  // converted by adding 3 2^51.
  static constexpr std::uint64_t converter = 0x4338000000000000;
  Doubles real() const noexcept {
    return __builtin_bit_cast(Doubles, words_ + converter) - 0x1.8p52;
  }
  static VectorLongLanes rounded(const Doubles& x) noexcept {
    return VectorLongLanes(__builtin_bit_cast(Words, x + 0x1.8p52) - converter);
  }
  static Doubles root(const VectorLongLanes& a) noexcept {
    const auto high = (a >> 31).real(), low = (a & VectorLongLanes(0x7fffffff)).real();
    const Doubles x = high * 0x1p31 + low;
#if defined(__clang__) && __has_builtin(__builtin_elementwise_sqrt)
    return __builtin_elementwise_sqrt(x);
#else
    return __builtin_ia32_sqrtpd256(x);
#endif
  }

  static std::array<VectorLongLanes, 4> transposed(
      const std::array<VectorLongLanes, 4>& m) noexcept {
    const auto even = [&](std::size_t i) {
      return __builtin_shufflevector(m[i].words_, m[i + 1].words_, 0, 4, 2, 6);
    };
    const auto odd = [&](std::size_t i) {
      return __builtin_shufflevector(m[i].words_, m[i + 1].words_, 1, 5, 3, 7);
    };
    const auto lower = [](const Words& a, const Words& b) {
      return VectorLongLanes(__builtin_shufflevector(a, b, 0, 1, 4, 5));
    };
    const auto upper = [](const Words& a, const Words& b) {
      return VectorLongLanes(__builtin_shufflevector(a, b, 2, 3, 6, 7));
    };
    const Words a = even(0), b = odd(0), c = even(2), d = odd(2);
    return {lower(a, c), lower(b, d), upper(a, c), upper(b, d)};
  }

  Words words_;
};

DETENT_END_LONG_LANES
#endif

/// Whether vectors can be used without a run-time test, and the lanes to use then.
inline constexpr bool has_long_lanes = DETENT_LONG_LANES == 2;
/// Whether `runs_vectors()` may be true, and the lanes to use if it is.
inline constexpr bool may_run_vectors = DETENT_LONG_LANES != 0;
#if DETENT_LONG_LANES
using LongLanes = std::conditional_t<has_long_lanes, VectorLongLanes, ArrayLongLanes>;
using FastLongLanes = VectorLongLanes;
#else
using LongLanes = ArrayLongLanes;
using FastLongLanes = ArrayLongLanes;
#endif

/// Whether this machine has the vectors of `FastLongLanes`; false in constant expressions.
[[nodiscard]] constexpr bool runs_vectors() noexcept {
  if (std::is_constant_evaluated()) return false;
#if DETENT_LONG_LANES == 1
  return __builtin_cpu_supports("avx2") != 0;
#else
  return has_long_lanes;
#endif
}

}  // namespace detent::detail

#undef DETENT_LONG_LANES
