// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/require_cxx20.hpp"

namespace detent {

/// Changes whenever the result of any query changes in any bit for any input. Then, and only then,
/// recorded matches and golden digests of an older library no longer hold.
inline constexpr int results_version = 2;

}  // namespace detent
