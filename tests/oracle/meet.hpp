// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/solid.hpp"

namespace detent::oracle {

/// Whether two shapes share a point.
[[nodiscard]] bool meet(const Solid<2>& a, const Solid<2>& b);
[[nodiscard]] bool meet(const Solid<3>& a, const Solid<3>& b);

}  // namespace detent::oracle
