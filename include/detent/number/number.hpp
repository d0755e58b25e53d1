// SPDX-License-Identifier: MIT
#pragma once

// The number layer: exact fixed point, rounding by name, angles, text and digests.

#include "detent/number/angle.hpp"
#include "detent/number/angle_range.hpp"
#include "detent/number/arc.hpp"
#include "detent/number/assert.hpp"
#include "detent/number/decimal.hpp"
#include "detent/number/digest.hpp"
#include "detent/number/divide.hpp"
#include "detent/number/filter/components.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/number/filter/leading.hpp"
#include "detent/number/filter/long_quadratic.hpp"
#include "detent/number/filter/ratio.hpp"
#include "detent/number/filter/unit_length.hpp"
#include "detent/number/fixed.hpp"
#include "detent/number/integer.hpp"
#include "detent/number/literals.hpp"
#include "detent/number/min_max.hpp"
#include "detent/number/mixed.hpp"
#include "detent/number/next_up.hpp"
#include "detent/number/patience.hpp"
#include "detent/number/root.hpp"
#include "detent/number/rounding.hpp"
#include "detent/number/scalar.hpp"
#include "detent/number/short_words.hpp"
#include "detent/number/text.hpp"
#include "detent/number/unit.hpp"
#include "detent/number/wide.hpp"
#include "detent/number/words.hpp"
#if __STDC_HOSTED__
#include "detent/number/floating.hpp"
#endif
