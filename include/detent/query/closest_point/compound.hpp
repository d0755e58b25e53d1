// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"
#include "detent/query/kernel/nearest_part.hpp"

namespace detent {

/// The closest point of the part of `compound` nearest to `point`; `point` itself if inside. Also
/// include the headers of its parts' own queries, with `distance` among them.
///
/// units:  world units
/// domain: every input; a compound without parts gives `point`
/// result: of parts with equal `distance`s, even if equal only by rounding or clamping, the first
///         that is not empty counts
/// exact:  the part is the nearest within 1 ULP of the scalar; each coordinate is rounded as by its
///         `closest_point`                                          (tests/query/compound.test.cpp)
template <class... Shapes, Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Compound<Shapes...>& compound,
                                                const Vec<S, N>& point) noexcept {
  Vec<S, N> closest = point;
  detail::visit_nearer_parts<S>(compound, point,
                                [&](const auto& part) { closest = closest_point(part, point); });
  return closest;
}

}  // namespace detent
