// SPDX-License-Identifier: MIT
#include "detent/shape/ray.hpp"
using namespace detent;

Ray<q16_16, 3> look(const Vec<q16_16, 3>& eye, const Vec<q16_16, 3>& way) { return Ray{eye, way}; }
