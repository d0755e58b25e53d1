// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/require_cxx20.hpp"

// DETENT_ASSERTIONS is 1 to check preconditions and proved invariants. Define it to choose; the
// default is 1 in debug builds: not optimised, NDEBUG not defined, on an operating system. It
// changes no result and no type.
#ifndef DETENT_ASSERTIONS
#if defined(NDEBUG) || defined(__OPTIMIZE__) || !__STDC_HOSTED__ || \
    (defined(_MSC_VER) && !defined(_DEBUG))
#define DETENT_ASSERTIONS 0
#else
#define DETENT_ASSERTIONS 1
#endif
#endif

/// Checks a condition if DETENT_ASSERTIONS is 1; a failure aborts the program.
///
/// To use your own handler, define DETENT_ASSERT before you include detent.
#ifndef DETENT_ASSERT
#if !DETENT_ASSERTIONS
#define DETENT_ASSERT(...) static_cast<void>(0)
#elif !__STDC_HOSTED__
#define DETENT_ASSERT(...) ((__VA_ARGS__) ? static_cast<void>(0) : __builtin_trap())
#else
#include <cstdio>
#include <cstdlib>

namespace detent::detail {

// Not assert(), which NDEBUG turns off.
[[noreturn]] inline void report_failed_assertion(const char* promise, const char* file,
                                                 int line) noexcept {
  std::fprintf(stderr, "%s:%d: detent: assertion failed: %s\n", file, line, promise);
  std::abort();
}

}  // namespace detent::detail

#define DETENT_ASSERT(...)              \
  ((__VA_ARGS__) ? static_cast<void>(0) \
                 : ::detent::detail::report_failed_assertion(#__VA_ARGS__, __FILE__, __LINE__))
#endif
#endif
