// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/require_cxx20.hpp"

/// Checks a caller's promise in debug builds. It observes: no result depends on whether it is on.
///
/// A project that has its own handler defines DETENT_ASSERT before it includes detent.
#ifndef DETENT_ASSERT
#if defined(NDEBUG) || !__STDC_HOSTED__
#define DETENT_ASSERT(...) static_cast<void>(0)
#else
#include <cassert>
#define DETENT_ASSERT(...) assert((__VA_ARGS__))
#endif
#endif
