// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/require_cxx20.hpp"

/// The version of the library, by the rules of Semantic Versioning; CMake reads it here.
#define DETENT_VERSION_MAJOR 0
#define DETENT_VERSION_MINOR 1
#define DETENT_VERSION_PATCH 0

namespace detent {

/// Changes whenever the result of any query changes in any bit for any input. Then, and only then,
/// recorded matches and golden digests of an older library no longer hold.
inline constexpr int results_version = 15;

}  // namespace detent
