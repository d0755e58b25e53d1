// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"
#include "detent/query/kernel/core.hpp"
#include "detent/shape/compound.hpp"

namespace detent::detail {

template <class... Shapes>
[[nodiscard]] constexpr bool has_points(const Compound<Shapes...>& compound) noexcept {
  return any_part(compound, [](const auto& part) { return has_points(part); });
}

/// Calls visit(part) for each part of `compound` that is nearer to `shape` than all before it. The
/// last one is the nearest; of parts with equal distances it is the first, not counting empty ones.
template <Scalar S, class... Shapes, class Shape, class Visit>
constexpr void visit_nearer_parts(const Compound<Shapes...>& compound, const Shape& shape,
                                  const Visit& visit) noexcept {
  S least = largest<S>;
  bool is_first = true, has_found = false;
  for_each_part(compound, [&](const auto& part) {
    const S to_part = distance(part, shape);
    const bool is_found = has_found || has_points(part);
    if (!is_first && (has_found || !is_found) && to_part >= least) return;
    is_first = false;
    has_found = is_found;
    least = to_part;
    visit(part);
  });
}

}  // namespace detent::detail
