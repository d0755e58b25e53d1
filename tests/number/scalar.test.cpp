// SPDX-License-Identifier: MIT
#include "detent/number/scalar.hpp"

#include <concepts>
#include <cstdint>

#include "support/catch.hpp"

using namespace detent;

namespace {

static_assert(Scalar<q16_16> && Scalar<q14_16> && Scalar<q24_8> && Scalar<q8_8>);
static_assert(Scalar<float> && Scalar<double>);

// From 1 to 31 bits, with 0 to all but one of them fractional.
static_assert(Scalar<Fixed<1, 0>> && Scalar<Fixed<2, 1>> && Scalar<Fixed<31, 0>>);
static_assert(Scalar<Fixed<31, 30>> && Scalar<Fixed<30, 29>> && Scalar<Fixed<14, 13>>);
static_assert(!Scalar<Fixed<32, 16>> && !Scalar<Fixed<62, 32>> && !Scalar<int> && !Scalar<bool>);
static_assert(!Scalar<Fixed<31, 31>> && !Scalar<Fixed<31, 32>> && !Scalar<Fixed<1, 1>>);
static_assert(!Scalar<Fixed<31, -1>> && !Scalar<Fixed<8, -8>> && !Scalar<Fixed<15, 40>>);
static_assert(!Scalar<long double> && !Scalar<q16_16&> && !Scalar<const q16_16> && !Scalar<void>);

static_assert(Number<Fixed<32, 16>> && Number<Fixed<319, 0>> && Number<q8_8> && Number<float>);
static_assert(!Number<int> && !Number<std::int64_t> && !Number<Int128> && !Number<long double>);

static_assert(bits_of<q16_16> == 31 && bits_of<Fixed<126, 92>> == 126 && bits_of<double> == 0);

// A direction's component has the size of a coordinate, and represents 1 and -1 exactly.
static_assert(sizeof(direction_component<q16_16>) == 4 && sizeof(direction_component<q8_8>) == 2);
static_assert(direction_component<q16_16>::frac == 30 && direction_component<q8_8>::frac == 14);
static_assert(std::same_as<direction_component<q14_16>, direction_component<q16_16>>);
static_assert(std::same_as<direction_component<q24_8>, direction_component<q16_16>>);
static_assert(std::same_as<direction_component<float>, float>);
static_assert(std::same_as<direction_component<double>, double>);
static_assert(direction_component<q16_16>(1) == 1 && direction_component<q16_16>(-1) == -1);
static_assert(direction_component<q8_8>(1) == 1 && direction_component<q8_8>(1).raw() == 1 << 14);

static_assert(square(q16_16::lowest()) == 1 << 30 && square(-1.5f) == 2.25f);

}  // namespace

TEST_CASE("scalar: the concepts hold at compile time", "[number]") { SUCCEED(); }
