// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/number/require_cxx20.hpp"

// Eight numbers, one per lane. If the machine has vector instructions, they are a vector type of
// the compiler (an extension of GCC and Clang). Otherwise, and in constant expressions, they are an
// array with the same operations and results. (tests/cull/lanes.test.cpp)
//
// Only this header and long_lanes.hpp depend on the machine's vectors.

namespace detent::detail {

inline constexpr std::size_t lane_count = 8;

template <class T>
class ArrayLanes {
 public:
  explicit constexpr ArrayLanes(T x) noexcept { numbers_.fill(x); }
  explicit constexpr ArrayLanes(const std::array<T, lane_count>& numbers) noexcept
      : numbers_(numbers) {}

  /// first + step * bytes[k] in lane k.
  constexpr ArrayLanes(T first, T step,
                       const std::array<std::uint8_t, lane_count>& bytes) noexcept {
    for (std::size_t k = 0; k < lane_count; ++k) {
      numbers_[k] = static_cast<T>(first + static_cast<T>(bytes[k]) * step);
    }
  }

  /// For integers: complements each lane in which all bits of x are set, and keeps those in which
  /// none are.
  constexpr void flip(const ArrayLanes& x) noexcept {
    for (std::size_t k = 0; k < lane_count; ++k) numbers_[k] ^= x.numbers_[k];
  }
  constexpr void add(const ArrayLanes& x) noexcept {
    for (std::size_t k = 0; k < lane_count; ++k) numbers_[k] += x.numbers_[k];
  }
  constexpr void subtract(const ArrayLanes& x) noexcept {
    for (std::size_t k = 0; k < lane_count; ++k) numbers_[k] -= x.numbers_[k];
  }
  /// For non-negative 32-bit integers: (lane * factor) >> shift, which fits 31 bits.
  constexpr void scale(std::uint32_t factor, int shift) noexcept {
    for (std::size_t k = 0; k < lane_count; ++k) {
      const auto product = static_cast<std::uint64_t>(numbers_[k]) * factor;
      numbers_[k] = static_cast<T>(product >> shift);
    }
  }
  constexpr void raise(const ArrayLanes& x) noexcept {
    for (std::size_t k = 0; k < lane_count; ++k) {
      numbers_[k] = x.numbers_[k] > numbers_[k] ? x.numbers_[k] : numbers_[k];
    }
  }
  constexpr void lower(const ArrayLanes& x) noexcept {
    for (std::size_t k = 0; k < lane_count; ++k) {
      numbers_[k] = x.numbers_[k] < numbers_[k] ? x.numbers_[k] : numbers_[k];
    }
  }
  /// A bit for each lane that is not above the same lane of x.
  [[nodiscard]] constexpr std::uint32_t up_to(const ArrayLanes& x) const noexcept {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < lane_count; ++k) {
      bits |= numbers_[k] <= x.numbers_[k] ? std::uint32_t{1} << k : 0;
    }
    return bits;
  }
  constexpr void store(std::array<T, lane_count>& to) const noexcept { to = numbers_; }
  /// Writes the lanes whose bits are set in `mask`, in order, and returns how many there are. `to`
  /// has room for all lanes; the elements after those written are unspecified.
  constexpr std::size_t pack(std::uint32_t mask, T* to) const noexcept {
    std::size_t count = 0;
    for (; mask != 0; mask &= mask - 1) {
      to[count++] = numbers_[static_cast<std::size_t>(std::countr_zero(mask))];
    }
    return count;
  }

  /// A mark for each lane.
  class Marks {
   public:
    /// Marks the lanes of a that are above the same lanes of b.
    constexpr void add_above(const ArrayLanes& a, const ArrayLanes& b) noexcept {
      for (std::size_t k = 0; k < lane_count; ++k) {
        marks_[k] |= a.numbers_[k] > b.numbers_[k] ? -1 : 0;
      }
    }
    /// A bit for each lane without a mark.
    [[nodiscard]] constexpr std::uint32_t unmarked() const noexcept {
      std::int32_t bits = 0;
      for (std::size_t k = 0; k < lane_count; ++k) bits |= ~marks_[k] & (1 << k);
      return static_cast<std::uint32_t>(bits);
    }

   private:
    std::array<std::int32_t, lane_count> marks_{};
  };

 private:
  std::array<T, lane_count> numbers_{};
};

#if defined(__GNUC__)
#if __has_builtin(__builtin_shufflevector)
#define DETENT_HAS_SHUFFLES 1
#else
#define DETENT_HAS_SHUFFLES 0
#endif
#if defined(__AVX2__)
inline constexpr std::size_t vector_bytes = 32;
#else
inline constexpr std::size_t vector_bytes = 16;  // SSE, NEON, simd128
#endif

template <class T, std::size_t Bytes>
struct VectorOf {
  typedef T type __attribute__((vector_size(Bytes)));
};

#if defined(__AVX2__)
/// For each mask, the positions of its bits, lowest first, one per byte.
inline constexpr auto places_of_bits = [] {
  std::array<std::uint64_t, 256> table{};
  for (std::size_t mask = 0; mask < table.size(); ++mask) {
    int count = 0;
    for (std::uint64_t i = 0; i < lane_count; ++i) {
      if ((mask >> i & 1) != 0) table[mask] |= i << (8 * count++);
    }
  }
  return table;
}();
#endif

/// Lanes in as many vectors as they need: compilers are poor at splitting larger ones. The vector
/// size is part of the type, for programs whose sources are compiled for several machines.
template <class T, std::size_t Bytes = vector_bytes>
class VectorLanes {
  static constexpr std::size_t part_lanes = Bytes / sizeof(T);
  static constexpr std::size_t part_count = lane_count / part_lanes;
  using Part = typename VectorOf<T, Bytes>::type;
  struct Parts {
    Part at[part_count];
    Part& operator[](std::size_t i) noexcept { return at[i]; }
    const Part& operator[](std::size_t i) const noexcept { return at[i]; }
  };
  using Ints = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
  using PartMarks = typename VectorOf<Ints, Bytes>::type;

 public:
  explicit VectorLanes(T x) noexcept {
    for (auto& part : parts_.at) part = x - Part{};
  }
  explicit VectorLanes(const std::array<T, lane_count>& numbers) noexcept
      : parts_(std::bit_cast<Parts>(numbers)) {}
  VectorLanes(T first, T step, const std::array<std::uint8_t, lane_count>& bytes) noexcept {
    if constexpr (unpacks_bytes) {
      multiply(first, step, bytes);
      return;
    }
    const auto count = [&](std::size_t k) { return static_cast<T>(bytes[k]); };
    for (std::size_t i = 0; i < part_count; ++i) {
      const std::size_t k = i * part_lanes;
      if constexpr (part_lanes == 8) {
        parts_[i] =
            Part{count(0), count(1), count(2), count(3), count(4), count(5), count(6), count(7)};
      } else if constexpr (part_lanes == 4) {
        parts_[i] = Part{count(k), count(k + 1), count(k + 2), count(k + 3)};
      } else {
        parts_[i] = Part{count(k), count(k + 1)};
      }
      parts_[i] = first + step * parts_[i];
    }
  }

  /// The box around the first three points of a record of at least 40 bytes; a point is three
  /// 32-bit integers. Lanes 0 to 2 are the least coordinates, lanes 4 to 6 the complements of the
  /// greatest.
  [[nodiscard]] static VectorLanes around_three(const void* record) noexcept {
    using Quarters = typename VectorOf<T, 16>::type;
    const auto row = [&](std::size_t i) {
      Quarters x;
      __builtin_memcpy(&x, static_cast<const char*>(record) + 12 * i, sizeof x);
      return x;
    };
    const Quarters a = row(0), b = row(1), c = row(2);
    Quarters least = b < a ? b : a, greatest = b > a ? b : a;
    least = c < least ? c : least;
    greatest = c > greatest ? c : greatest;
    VectorLanes result(0);
    if constexpr (part_count == 1) {
#if DETENT_HAS_SHUFFLES
      result.parts_[0] = __builtin_shufflevector(least, ~greatest, 0, 1, 2, 3, 4, 5, 6, 7);
#else
      const Quarters both[2] = {least, ~greatest};
      __builtin_memcpy(&result.parts_[0], both, sizeof both);
#endif
    } else {
      result.parts_[0] = least;
      result.parts_[1] = ~greatest;
    }
    return result;
  }
  /// The middle of a box of `around_three`, within one step, in the same form: the coordinates and
  /// their complements.
  [[nodiscard]] VectorLanes middle() const noexcept {
    VectorLanes result(0);
    if constexpr (part_count == 1) {
      // With halves rounded down, and ~x = -x - 1: the middle is least / 2 - complement / 2 - 1, and
      // its own complement is complement / 2 - least / 2.
      const Part half = parts_[0] >> 1;
#if DETENT_HAS_SHUFFLES
      const Part other = __builtin_shufflevector(half, half, 4, 5, 6, 7, 0, 1, 2, 3);
#else
      const Part other = {half[4], half[5], half[6], half[7], half[0], half[1], half[2], half[3]};
#endif
      result.parts_[0] = half - other + Part{-1, -1, -1, -1, 0, 0, 0, 0};
    } else {
      result.parts_[0] = (parts_[0] >> 1) + (~parts_[1] >> 1);
      result.parts_[1] = ~result.parts_[0];
    }
    return result;
  }

  void flip(const VectorLanes& x) noexcept {
    for (std::size_t i = 0; i < part_count; ++i) parts_[i] ^= x.parts_[i];
  }
  void add(const VectorLanes& x) noexcept {
    for (std::size_t i = 0; i < part_count; ++i) parts_[i] += x.parts_[i];
  }
  void subtract(const VectorLanes& x) noexcept {
    for (std::size_t i = 0; i < part_count; ++i) parts_[i] -= x.parts_[i];
  }
  void scale(std::uint32_t factor, int shift) noexcept {
    for (std::size_t i = 0; i < part_count; ++i) {
#if DETENT_HAS_SHUFFLES && !defined(__SSE2__)
      if constexpr (Bytes == 16) {  // products of halves of a vector, as in NEON and simd128
        using Quarters = typename VectorOf<std::uint32_t, 16>::type;
        using Half = typename VectorOf<std::uint32_t, 8>::type;
        const auto lanes = std::bit_cast<Quarters>(parts_[i]);
        const Half lower = __builtin_shufflevector(lanes, lanes, 0, 1);
        const Half upper = __builtin_shufflevector(lanes, lanes, 2, 3), by = Half{} + factor;
        const Words words = __builtin_convertvector(by, Words);
        const Words first = (__builtin_convertvector(lower, Words) * words) >> shift;
        const Words second = (__builtin_convertvector(upper, Words) * words) >> shift;
        parts_[i] = std::bit_cast<Part>(__builtin_shufflevector(
            std::bit_cast<Quarters>(first), std::bit_cast<Quarters>(second), 0, 2, 4, 6));
        continue;
      }
#endif
      const auto lanes = std::bit_cast<Words>(parts_[i]);  // the even lane is the lower half
      const Words even = times(lanes, factor) >> shift, odd = times(lanes >> 32, factor) >> shift;
      parts_[i] = std::bit_cast<Part>(even | (odd << 32));
    }
  }
  void raise(const VectorLanes& x) noexcept {
    for (std::size_t i = 0; i < part_count; ++i) {
      parts_[i] = greater(x.parts_[i], parts_[i]);
    }
  }
  void lower(const VectorLanes& x) noexcept {
    for (std::size_t i = 0; i < part_count; ++i) {
      parts_[i] = lesser(x.parts_[i], parts_[i]);
    }
  }
  [[nodiscard]] std::uint32_t up_to(const VectorLanes& x) const noexcept {
#if defined(__AVX512VL__)
    if constexpr (has_masks) return mask_of<less_or_equal>(parts_[0], x.parts_[0]);
#endif
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < part_count; ++i) {
      bits |= bits_of(parts_[i] <= x.parts_[i]) << (i * part_lanes);
    }
    return bits;
  }
  void store(std::array<T, lane_count>& to) const noexcept {
    to = std::bit_cast<std::array<T, lane_count>>(parts_);
  }
  std::size_t pack(std::uint32_t mask, T* to) const noexcept {
#if defined(__AVX2__)
    if constexpr (part_count == 1) {  // without branches, which masks make unpredictable
      const auto lanes = std::bit_cast<Numbers>(parts_);
#if defined(__AVX512VL__)
      const Numbers packed =
          __builtin_ia32_compresssi256_mask(lanes, lanes, static_cast<std::uint8_t>(mask));
#else
      typedef std::uint8_t Places __attribute__((vector_size(8)));
      const auto places =
          __builtin_convertvector(std::bit_cast<Places>(places_of_bits[mask]), Numbers);
      const Numbers packed = __builtin_ia32_permvarsi256(lanes, places);
#endif
      __builtin_memcpy(to, &packed, sizeof packed);
      return static_cast<std::size_t>(std::popcount(mask));
    }
#endif
    std::array<T, lane_count> numbers;
    store(numbers);
    return ArrayLanes<T>(numbers).pack(mask, to);
  }

  class Marks {
   public:
    void add_above(const VectorLanes& a, const VectorLanes& b) noexcept {
#if defined(__AVX512VL__)
      if constexpr (has_masks) {
        marks_[0] |= greater(a.parts_[0], b.parts_[0]) ^ b.parts_[0];
        return;
      }
#endif
      for (std::size_t i = 0; i < part_count; ++i) marks_[i] |= a.parts_[i] > b.parts_[i];
    }
    [[nodiscard]] std::uint32_t unmarked() const noexcept {
#if defined(__AVX512VL__)
      if constexpr (has_masks) return mask_of<equal>(marks_[0], PartMarks{});
#endif
      std::uint32_t bits = 0;
      for (std::size_t i = 0; i < part_count; ++i) bits |= bits_of(marks_[i]) << (i * part_lanes);
      return bits ^ 0xff;
    }

   private:
    PartMarks marks_[part_count] = {};
  };

 private:
  using Numbers = typename VectorOf<int, Bytes>::type;
#if defined(__AVX512VL__)
  // Here comparisons write mask registers, which compilers convert to vectors and back; GCC also
  // compiles maxima and minima to comparisons.
  static constexpr bool has_masks = std::is_same_v<T, std::int32_t> && Bytes == 32;
  static constexpr int equal = 0, less_or_equal = 2;  // as the instruction encodes them
  template <int Relation>
  [[nodiscard]] static std::uint32_t mask_of(const Part& a, const Part& b) noexcept {
    return __builtin_ia32_cmpd256_mask(std::bit_cast<Numbers>(a), std::bit_cast<Numbers>(b),
                                       Relation, 0xff);
  }
#endif
  [[nodiscard]] static Part greater(const Part& a, const Part& b) noexcept {
#if defined(__AVX512VL__) && !defined(__clang__)
    if constexpr (has_masks) {
      return std::bit_cast<Part>(
          __builtin_ia32_pmaxsd256(std::bit_cast<Numbers>(a), std::bit_cast<Numbers>(b)));
    }
#endif
    return a > b ? a : b;
  }
  [[nodiscard]] static Part lesser(const Part& a, const Part& b) noexcept {
#if defined(__AVX512VL__) && !defined(__clang__)
    if constexpr (has_masks) {
      return std::bit_cast<Part>(
          __builtin_ia32_pminsd256(std::bit_cast<Numbers>(a), std::bit_cast<Numbers>(b)));
    }
#endif
    return a < b ? a : b;
  }

  using Words = typename VectorOf<std::uint64_t, Bytes>::type;

#if DETENT_HAS_SHUFFLES
  static constexpr bool unpacks_bytes =
      std::is_same_v<T, std::int32_t> && Bytes == 16 && std::endian::native == std::endian::little;

  /// first + step * bytes[k] in lane k. Written out by hand, because compilers would extract the
  /// bytes one by one, and SSE2 has no 32-bit product: its upper half is that of b low, plus b
  /// high.
  void multiply(T first, T step, const std::array<std::uint8_t, lane_count>& bytes) noexcept {
    if constexpr (unpacks_bytes) {
      using Shorts = typename VectorOf<std::uint16_t, Bytes>::type;
      const Words word{std::bit_cast<std::uint64_t>(bytes), 0};
#if defined(__SSE2__) && !defined(__clang__)  // GCC's shuffle extracts the bytes one by one
      using Chars = typename VectorOf<char, Bytes>::type;
      const auto counts =
          std::bit_cast<Shorts>(__builtin_ia32_punpcklbw128(std::bit_cast<Chars>(word), Chars{}));
#else
      using Octets = typename VectorOf<std::uint8_t, Bytes>::type;
      const auto counts = std::bit_cast<Shorts>(
          __builtin_shufflevector(std::bit_cast<Octets>(word), Octets{}, 0, 16, 1, 16, 2, 16, 3, 16,
                                  4, 16, 5, 16, 6, 16, 7, 16));
#endif
#if defined(__SSE2__)
      using Signed = typename VectorOf<std::int16_t, Bytes>::type;
      const auto bits = static_cast<std::uint32_t>(step);
      const Shorts low = Shorts{} + static_cast<std::uint16_t>(bits & 0xffff);
      const Shorts high = Shorts{} + static_cast<std::uint16_t>(bits >> 16);
      const auto carried = std::bit_cast<Shorts>(
          __builtin_ia32_pmulhuw128(std::bit_cast<Signed>(counts), std::bit_cast<Signed>(low)));
      const Shorts lower = counts * low, upper = carried + counts * high;
#else
      const Shorts lower = counts, upper{};
#endif
      parts_[0] =
          std::bit_cast<Part>(__builtin_shufflevector(lower, upper, 0, 8, 1, 9, 2, 10, 3, 11));
      parts_[1] =
          std::bit_cast<Part>(__builtin_shufflevector(lower, upper, 4, 12, 5, 13, 6, 14, 7, 15));
      for (auto& part : parts_.at) {
#if !defined(__SSE2__)
        part *= step;
#endif
        part += first;
      }
    }
  }
#else
  static constexpr bool unpacks_bytes = false;
  void multiply(T, T, const std::array<std::uint8_t, lane_count>&) noexcept {}
#endif

  /// The products of the lower halves.
  [[nodiscard]] static Words times(const Words& x, std::uint32_t factor) noexcept {
#if defined(__clang__) || !defined(__SSE2__)
    return (x & 0xffffffffu) * (Words{} + factor);
#else  // GCC multiplies all 64 bits
    using Halves = typename VectorOf<std::int32_t, Bytes>::type;
    const auto a = std::bit_cast<Halves>(x), b = std::bit_cast<Halves>(Words{} + factor);
#if defined(__AVX2__)
    return std::bit_cast<Words>(__builtin_ia32_pmuludq256(a, b));
#else
    return std::bit_cast<Words>(__builtin_ia32_pmuludq128(a, b));
#endif
#endif
  }

  /// A bit for each lane, for lanes with all bits set or none.
  [[nodiscard]] static std::uint32_t bits_of(const PartMarks& marks) noexcept {
#if defined(__AVX2__)
    if constexpr (sizeof(T) == 4) {
      using Floats = typename VectorOf<float, Bytes>::type;
      return static_cast<std::uint32_t>(__builtin_ia32_movmskps256(std::bit_cast<Floats>(marks)));
    }
#elif defined(__SSE2__)
    if constexpr (sizeof(T) == 4) {
      using Floats = typename VectorOf<float, Bytes>::type;
      return static_cast<std::uint32_t>(__builtin_ia32_movmskps(std::bit_cast<Floats>(marks)));
    }
#elif defined(__wasm_simd128__)
    if constexpr (sizeof(T) == 4) {
      return static_cast<std::uint32_t>(__builtin_wasm_bitmask_i32x4(marks));
    }
#endif
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < part_lanes; ++k) {
      bits |= static_cast<std::uint32_t>(marks[k]) & (std::uint32_t{1} << k);
    }
    return bits;
  }

  Parts parts_;
};
#endif

#undef DETENT_HAS_SHUFFLES

// 32-bit lanes for rays against the nodes of a mesh.
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__))
template <class T>
using Lanes = VectorLanes<T>;
#else
template <class T>
using Lanes = ArrayLanes<T>;
#endif

/// Whether lanes are vectors.
inline constexpr bool has_lanes = !std::is_same_v<Lanes<std::int32_t>, ArrayLanes<std::int32_t>>;

/// Lanes that are only compared, for which every machine with vectors has instructions.
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__))
template <class T>
using ComparedLanes = VectorLanes<T>;
#else
template <class T>
using ComparedLanes = ArrayLanes<T>;
#endif

/// Whether lanes have fast instructions for all 32-bit operations. SSE2 lacks maximum and minimum,
/// and a simd128 product takes many instructions in node: there a ray meets too few nodes to pay
/// for its preparation (docs/scene.md).                                     (tests/platforms/forms)
#if defined(__GNUC__) && (defined(__SSE4_1__) || defined(__aarch64__))
inline constexpr bool has_full_lanes = true;
#else
inline constexpr bool has_full_lanes = false;
#endif

}  // namespace detent::detail
