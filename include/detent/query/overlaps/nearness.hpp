// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"

namespace detent::detail {

/// What numbers cut off after some bits tell of an answer.
enum class Nearness { apart, unknown, meeting };

/// Whether a look at cut-off numbers pays before products of 32-bit coordinates are taken whole:
/// it is more code.
template <Scalar S>
inline constexpr bool looks_first = bits_of<S> > 15 && DETENT_SMALL_CODE == 0;

}  // namespace detent::detail
