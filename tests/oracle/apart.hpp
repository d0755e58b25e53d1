// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "oracle/solid.hpp"

namespace detent::oracle {

/// The distance of two shapes in raw units, rounded down; nothing if one is empty.
[[nodiscard]] std::optional<Integer> distance_floor(const Solid<2>& a, const Solid<2>& b);
[[nodiscard]] std::optional<Integer> distance_floor(const Solid<3>& a, const Solid<3>& b);

}  // namespace detent::oracle
