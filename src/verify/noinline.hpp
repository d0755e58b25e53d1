// SPDX-License-Identifier: MIT
#pragma once

// Compiled once though called several times; and keeps only one callee's variables on a small
// stack.
#if defined(__GNUC__)
#define DETENT_VERIFY_NOINLINE [[gnu::noinline]]
#else
#define DETENT_VERIFY_NOINLINE
#endif
