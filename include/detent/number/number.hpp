// SPDX-License-Identifier: MIT
#pragma once

// The number layer: exact fixed point, rounding by name, angles, text and digests.

#include "detent/number/along.hpp"
#include "detent/number/angle.hpp"
#include "detent/number/arc.hpp"
#include "detent/number/assert.hpp"
#include "detent/number/bins.hpp"
#include "detent/number/coarse.hpp"
#include "detent/number/culling.hpp"
#include "detent/number/digest.hpp"
#include "detent/number/divide.hpp"
#include "detent/number/fixed.hpp"
#include "detent/number/integer.hpp"
#include "detent/number/leading.hpp"
#include "detent/number/leg.hpp"
#include "detent/number/long_quadratic.hpp"
#include "detent/number/near_half.hpp"
#include "detent/number/near_one.hpp"
#include "detent/number/next_up.hpp"
#include "detent/number/plane_grid.hpp"
#include "detent/number/products.hpp"
#include "detent/number/ratio.hpp"
#include "detent/number/root.hpp"
#include "detent/number/root_ratio.hpp"
#include "detent/number/rough.hpp"
#include "detent/number/rounding.hpp"
#include "detent/number/scalar.hpp"
#include "detent/number/short_words.hpp"
#include "detent/number/slab_times.hpp"
#include "detent/number/text.hpp"
#include "detent/number/unit.hpp"
#include "detent/number/wide.hpp"
#include "detent/number/words.hpp"
#if __STDC_HOSTED__
#include "detent/number/floating.hpp"
#endif
