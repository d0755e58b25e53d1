// SPDX-License-Identifier: MIT
#include "verify/part_sheets.hpp"

template struct detent::verify::PartSheets<detent::verify::BoxImpacts>;
