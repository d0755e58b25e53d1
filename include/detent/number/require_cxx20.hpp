// SPDX-License-Identifier: MIT
#pragma once

// Every header includes this one first, so an older standard gives a single error. Compilers
// continue after an #error but stop at a missing file.
#if defined(_MSVC_LANG) ? _MSVC_LANG < 202002L : __cplusplus < 202002L
#error "detent needs C++20: compile with -std=c++20 (/std:c++20 for MSVC)"
#include <stop here>
#endif
