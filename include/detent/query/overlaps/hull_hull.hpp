// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/gjk.hpp"

namespace detent {

/// Whether two hulls share a point.
///
/// domain: every input; a hull without points is empty and overlaps nothing
/// exact:  yes or no exact; touching counts                     (tests/oracle/hull_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const ConvexHull<S, N>& a,
                                      const ConvexHull<S, N>& b) noexcept {
  if (is_empty(a) || is_empty(b)) return false;
  return detail::bodies_overlap(detail::HullBody(a), detail::HullBody(b));
}

}  // namespace detent
