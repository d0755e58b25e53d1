// SPDX-License-Identifier: MIT
#pragma once

// Every header comes here before it says anything, so an older standard gives one error. A compiler
// goes on after that one, but it stops where a file is missing.
#if defined(_MSVC_LANG) ? _MSVC_LANG < 202002L : __cplusplus < 202002L
#error "detent needs C++20: compile with -std=c++20 (/std:c++20 for MSVC)"
#include <stop here>
#endif
