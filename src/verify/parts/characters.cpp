// SPDX-License-Identifier: MIT
#include "verify/part_sheets.hpp"

// Each scalar has a source of its own: one_space.cpp.in.
namespace detent::verify::detail {

using Group = Walks;
extern template struct GroupSheet<Group, q16_16, 3>;
extern template struct GroupSheet<Group, q14_16, 3>;
extern template struct GroupSheet<Group, q24_8, 3>;
extern template struct GroupSheet<Group, q8_8, 3>;

}  // namespace detent::verify::detail

template struct detent::verify::PartSheets<detent::verify::Characters>;
