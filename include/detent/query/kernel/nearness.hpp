// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"

namespace detent::detail {

/// The result of a filter on truncated numbers.
enum class Nearness { apart, unknown, meeting };

/// Whether a filter on truncated numbers pays before the full products of 32-bit coordinates; it
/// adds code.
template <Scalar S>
inline constexpr bool looks_first = bits_of<S> > 15 && DETENT_SMALL_CODE == 0;

}  // namespace detent::detail
