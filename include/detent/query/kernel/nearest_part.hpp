// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"
#include "detent/shape/compound.hpp"

namespace detent::detail {

/// Calls visit(part) for each part of `compound` that is nearer to `shape` than all before it. The
/// last one is the nearest; of parts with equal distances it is the first.
template <Scalar S, class... Shapes, class Shape, class Visit>
constexpr void visit_nearer_parts(const Compound<Shapes...>& compound, const Shape& shape,
                                  const Visit& visit) noexcept {
  S least = largest<S>;
  bool is_first = true;
  for_each_part(compound, [&](const auto& part) {
    const S to_part = distance(part, shape);
    if (!is_first && to_part >= least) return;
    is_first = false;
    least = to_part;
    visit(part);
  });
}

}  // namespace detent::detail
