// SPDX-License-Identifier: MIT
#pragma once

// Prevents inlining: the function is compiled once, and a small stack holds the variables of only
// one callee.
#if defined(__GNUC__)
#define DETENT_VERIFY_NOINLINE [[gnu::noinline]]
#else
#define DETENT_VERIFY_NOINLINE
#endif
