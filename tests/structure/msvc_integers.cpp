// SPDX-License-Identifier: MIT
//
// Functions that multiply, divide and take roots in 128 bits, for msvc_integers.sh.

#include "detent/number/number.hpp"
#include "detent/query/raycast/sphere.hpp"

#if defined(_MSC_VER)
static_assert(std::is_same_v<detent::Int128, detent::Wide<2>>);
#endif

namespace detent {

template std::optional<q16_16> raycast(const Ray<q16_16, 3>&, const Sphere<q16_16, 3>&) noexcept;

q16_16 quotient(Fixed<100, 32> n, Fixed<90, 30> d) { return quotient_floor<q16_16>(n, d); }

}  // namespace detent
