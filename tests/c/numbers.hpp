// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "c/scenes.hpp"
#include "detent/number/fixed.hpp"

// The scalar of the C interface, from the numbers that tests write.

namespace detent::test_c {

using S = q16_16;
using c::id_of;
inline constexpr int one = 65536;

inline S raw(std::int64_t n) { return S::from_raw(static_cast<std::int32_t>(n)); }

}  // namespace detent::test_c
