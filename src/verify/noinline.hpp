// SPDX-License-Identifier: MIT
#pragma once

// Called in several places and compiled once; and a small stack wants the variables of one at a time.
#if defined(__GNUC__)
#define DETENT_VERIFY_NOINLINE [[gnu::noinline]]
#else
#define DETENT_VERIFY_NOINLINE
#endif
