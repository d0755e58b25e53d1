// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/number/rounding.hpp"

// Define DETENT_SMALL_CODE to choose between speed and size; results are the same. 0 is faster, 1
// needs less code, because it omits filters that add code to the exact computation. The default is
// 1 for -Os with 32-bit registers, otherwise 0.
#ifndef DETENT_SMALL_CODE
#if DETENT_SHORT_WORDS && defined(__OPTIMIZE_SIZE__)
#define DETENT_SMALL_CODE 1
#else
#define DETENT_SMALL_CODE 0
#endif
#endif

namespace detent {

// Filtered predicates: a cheap value with a proved error decides, or the exact number does.
// docs/filters.md describes the protocol and every filter.
//
// source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
//         Predicates (1997); the name is CGAL's

/// The answer of a filter: to a yes-or-no question, or the sign of a number.
enum class Filtered : int { no = -1, unsure = 0, yes = 1 };

/// Whether to filter where the exact number alone would need less code.
inline constexpr bool has_filters = DETENT_SMALL_CODE == 0;

/// Whether a filter pays off before the full products of coordinates in this scalar.
template <Scalar S>
inline constexpr bool filter_pays = bits_of<S> > 15 && has_filters;

/// A cheap approximation of an exact number: they differ by less than `error`. In an array or a
/// vector, each component does.
template <class T, class Error = T>
struct Approximate {
  T value;
  Error error;
};

template <class T, class Error>
Approximate(T, Error) -> Approximate<T, Error>;

/// An error known at compile time, in steps of the value's grid.
template <std::int64_t Count>
struct Steps {
  [[nodiscard]] static constexpr std::int64_t raw() noexcept { return Count; }
};

/// The result of a filter: `value`, valid if `is_sure`.
template <class T>
struct Decided {
  T value;
  alignas(std::uintptr_t) bool is_sure;  // packed with a short value, GCC 12 masks it out again
};

/// Whether the exact number is positive; `no` if it is negative.
template <Number T, Number Error>
[[nodiscard]] constexpr Filtered decide(const Approximate<T, Error>& x) noexcept {
  // Branchless: the answer is unpredictable.
  return static_cast<Filtered>(int{x.value >= x.error} - int{x.value <= narrow_negative(x.error)});
}

/// The exact number rounded down to the grid of `T`, which must be able to hold it. If unsure, the
/// result is `value` or the step below it, provided that the error is at most half a step.
template <class T, int B, int F, class Error>
[[nodiscard]] constexpr Decided<T> decide_floor(const Approximate<Fixed<B, F>, Error>& x) noexcept {
  constexpr int shift = F - T::frac;
  static_assert(0 < shift && shift < 63 && B <= 63);
  const std::int64_t highest = std::int64_t{x.value.raw()} + x.error.raw();
  const std::int64_t fraction = highest & ((std::int64_t{1} << shift) - 1);
  return {T::assume_raw(static_cast<typename T::raw_type>(shift_right_floor(highest, shift))),
          fraction >= 2 * std::int64_t{x.error.raw()}};
}

/// The exact number rounded to nearest on the grid of `T`, which must be able to hold it. If
/// unsure, it is so close to the midpoint below `value` that the error may move it across.
template <class T, int B, int F, class Error>
[[nodiscard]] constexpr Decided<T> decide_nearest(
    const Approximate<Fixed<B, F>, Error>& x) noexcept {
  constexpr int shift = F - T::frac;
  const std::int64_t raised = std::int64_t{x.value.raw()} + (std::int64_t{1} << (shift - 1));
  return decide_floor<T>(Approximate{Fixed<63, F>::assume_raw(raised), x.error});
}

namespace detail {

/// x. GCC 12 would otherwise round two words in vector registers, and move them there and back.
template <class Int>
[[nodiscard]] constexpr Int in_register(Int x) noexcept {
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
  if (!std::is_constant_evaluated()) asm("" : "+r"(x));
#endif
  return x;
}

}  // namespace detail

/// all(f(0), f(1), ...), or otherwise() as soon as one of these is unsure. Recursive, because in a
/// loop GCC 12 would keep `is_sure` in a register and test it.
template <std::size_t N, class F, class All, class Otherwise, class... Before>
[[nodiscard]] constexpr auto when_all_sure(const F& f, const All& all, const Otherwise& otherwise,
                                           const Before&... before) noexcept {
  if constexpr (sizeof...(before) == N) {
    return all(before...);
  } else {
    const auto next = f(sizeof...(before));
    if (!next.is_sure) [[unlikely]]
      return otherwise();
    return when_all_sure<N>(f, all, otherwise, before..., next.value);
  }
}

/// The `Result` of f(0), f(1), ...; sure if all of these are.
template <class Result, std::size_t N, class F>
[[nodiscard]] constexpr Decided<Result> decide_all(const F& f) noexcept {
  const auto all = [](const auto&... x) { return Decided<Result>{{x...}, true}; };
  return when_all_sure<N>(f, all, [] { return Decided<Result>{{}, false}; });
}

/// all(x...) with the numbers of `values`, which are off by less than `error`, rounded to nearest,
/// or otherwise() if one is unsure. T must hold them.
template <class T, int B, int F, std::size_t N, class Error, class All, class Otherwise>
[[nodiscard]] constexpr auto when_all_nearest(const std::array<Fixed<B, F>, N>& values,
                                              const Error& error, const All& all,
                                              const Otherwise& otherwise) noexcept {
  const auto nearest = [&](std::size_t i) {
    return decide_nearest<T>(Approximate{values[i], error});
  };
  const auto finish = [&](const auto&... x) {
    return all(T::assume_raw(detail::in_register(x.raw()))...);
  };
  return when_all_sure<N>(nearest, finish, otherwise);
}

/// The midpoint between `x` and the step below it.
template <class T>
[[nodiscard]] constexpr auto midpoint_below(const T& x) noexcept {
  using Middle = Fixed<T::bits + 1, T::frac + 1>;
  const std::int64_t raw = 2 * std::int64_t{x.raw()} - 1;
  return Middle::assume_raw(static_cast<typename Middle::raw_type>(raw));
}

/// A number near the midpoint below `x`, rounded to nearest, ties to even. `sign` is that of the
/// number minus the midpoint.
template <class T>
[[nodiscard]] constexpr T nearest_at_midpoint(const T& x, int sign) noexcept {
  const bool is_up = sign > 0 || (sign == 0 && (x.raw() & 1) == 0);
  return T::assume_raw(static_cast<typename T::raw_type>(x.raw() - (is_up ? 0 : 1)));
}

/// The filter's answer, or else that of `exact()`, which may take the unsure value as an argument.
template <class Exact>
[[nodiscard]] constexpr bool or_exact(Filtered filtered, const Exact& exact) noexcept {
  if (filtered != Filtered::unsure) return filtered == Filtered::yes;
  return exact();
}
template <class T, class Exact>
[[nodiscard]] constexpr T or_exact(Decided<T> decided, const Exact& exact) noexcept {
  if (decided.is_sure) return decided.value;
  if constexpr (std::is_invocable_v<const Exact&, const T&>) {
    const T value = decided.value;
    return exact(value);
  } else {
    return exact();
  }
}

/// The filter's sign, or else that of `exact()`, which may be 0.
template <class Exact>
[[nodiscard]] constexpr int sign_or_exact(Filtered filtered, const Exact& exact) noexcept {
  if (filtered != Filtered::unsure) return static_cast<int>(filtered);
  return exact();
}

}  // namespace detent
