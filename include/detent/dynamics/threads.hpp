// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>

#include "detent/number/require_cxx20.hpp"

namespace detent {

namespace detail {

/// An example of the callables that a world passes to `Threads`.
struct AnyCall {
  constexpr void operator()(std::size_t) const noexcept {}
};

}  // namespace detail

/// Runs parts of a step in parallel: `threads(count, f)` calls f(i) once for each i below `count`,
/// on any threads in any order, and returns after all calls have, with their writes visible.
/// Usually this is your thread pool. `f` lives until `threads` returns, and throws only if memory
/// runs out.
template <class T>
concept Threads = std::invocable<T&, std::size_t, const detail::AnyCall&>;

namespace detail {

/// Runs everything on the calling thread.
struct OneThread {
  static constexpr bool are_many = false;

  /// Calls f(i) for each i from `first` to before `last`, in order.
  template <class F>
  constexpr void each(std::size_t first, std::size_t last, std::size_t /*a_call*/,
                      const F& f) const {
    for (std::size_t i = first; i < last; ++i) f(i);
  }
};

/// Runs loops of more than `a_call` elements on the caller's threads, in calls of `a_call` elements
/// each, and shorter loops on this thread.
template <Threads T>
struct ManyThreads {
  static constexpr bool are_many = true;
  T& threads;

  template <class F>
  constexpr void each(std::size_t first, std::size_t last, std::size_t a_call, const F& f) const {
    if (last - first <= a_call) return OneThread().each(first, last, a_call, f);
    threads((last - first + a_call - 1) / a_call, [&](std::size_t k) {
      const auto begin = first + k * a_call;
      OneThread().each(begin, (std::min)(begin + a_call, last), a_call, f);
    });
  }
};

}  // namespace detail

}  // namespace detent
