// SPDX-License-Identifier: MIT
#include "detent/math/lens.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "math/decimals.hpp"
#include "math/frames.hpp"
#include "number/real.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using S = q16_16;
using A = Angle<S>;
using L = Lens<S>;
constexpr auto slope = [](double value) { return L::Slope::from_double(value); };

constexpr auto square = *L::perspective(A::turn(1, 4), n(1), n(1), n(3));
static_assert(square.slope(0) == 1 && square.slope(1) == 1 && square.has_perspective());
static_assert(square.extent(0) == 0 && square.extent(1) == 0);
static_assert(square.near_distance() == 1 && square.far_distance() == 3);
constexpr auto wide = *L::perspective(A::turn(1, 4), n(2.5), n(1), n(3));
static_assert(wide.slope(0) == slope(2.5) && wide.slope(1) == 1);
static_assert(projection_matrix(wide) == perspective(A::turn(1, 4), n(2.5), n(1), n(3)));

static_assert(!L::perspective(A(), n(1), n(1), n(2)) &&
              !L::perspective(A::turn(1, 2), n(1), n(1), n(2)) &&
              !L::perspective(A::turn(3, 4), n(1), n(1), n(2)));
static_assert(!L::perspective(A::turn(1, 4), n(0), n(1), n(2)) &&
              !L::perspective(A::turn(1, 4), n(-1), n(1), n(2)));
static_assert(!L::perspective(A::turn(1, 4), n(1), n(0), n(2)) &&
              !L::perspective(A::turn(1, 4), n(1), n(2), n(2)));
static_assert(!L::perspective(A::from_raw(1), n(1), n(1), n(2)), "a slope of 0");
static_assert(L::perspective(A::from_raw(3), n(1), n(1), n(2))->slope(1).raw() == 1);
static_assert(!L::perspective(A::from_raw(3), n(0.25), n(1), n(2)));
static_assert(!L::perspective(A::turn(1, 4), n(8), n(1), n(2)), "a slope of 8");
static_assert(L::perspective(A::turn(1, 4), S::from_raw(n(8).raw() - 1), n(1), n(2)));
static_assert(L::perspective(A::from_degrees(n(165.7)), n(1), n(1), n(2)));
static_assert(!L::perspective(A::from_degrees(n(165.8)), n(1), n(1), n(2)));

constexpr auto box = *L::orthographic(n(4), n(2), n(-1), n(3));
static_assert(!box.has_perspective() && box.slope(0) == 0 && box.extent(0) == 4);
static_assert(projection_matrix(box) == orthographic(n(-4), n(4), n(-2), n(2), n(-1), n(3)));
static_assert(!L::orthographic(n(0), n(2), n(1), n(3)) &&
              !L::orthographic(n(4), n(-2), n(1), n(3)));
static_assert(!L::orthographic(n(4), n(2), n(3), n(3)));

/// tan(fov / 2) in units of 2^-28.
Real tangent(std::uint32_t fov) {
  const Real half = radians_of(fov) / 2;
  return ldexp(sin(half) / cos(half), 28);
}

}  // namespace

TEMPLATE_TEST_CASE("lens: slopes are rounded once each", "", q16_16, q14_16, q24_8, q8_8) {
  using T = TestType;
  Random random(0x1e45);
  int wrong = 0, lenses = 0;
  for (int k = 0; k < 6'000; ++k) {
    const auto fov = static_cast<std::uint32_t>(random.edgy(31) & INT32_MAX);
    const auto near = random_fixed<T>(random), far = random_fixed<T>(random);
    const T aspect = random.coin() ? nearest_to<T>(abs(random_fixed<T>(random)))
                                   : T::from_raw(static_cast<typename T::raw_type>(
                                         random.between(1, 3 * std::int64_t{T(1).raw()})));
    const auto found = Lens<T>::perspective(Angle<T>::from_raw(fov), aspect, near, far);
    const Real exact = tangent(fov);
    const bool in_view = fov != 0 && exact <= Real(INT32_MAX);
    const std::int64_t high = in_view ? nearest_integer(exact) : 0;
    const BigRational product = rational(aspect) * BigRational(high);
    const BigInteger across = nearest_of(product);
    const bool valid = high > 0 && across > 0 && product <= INT32_MAX && near > 0 && near < far;
    if (found.has_value() != valid) ++wrong;
    if (!valid || !found) continue;
    ++lenses;
    if (big_raw(found->slope(1)) != high || big_raw(found->slope(0)) != across) ++wrong;
    const auto m = projection_matrix(*found);
    const BigRational cotangent = BigRational(power_of_two(28)) / BigRational(high);
    if (big_raw(m(1, 1)) != clamped<T>(nearest_of(on_grid<T>(cotangent)))) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
  CHECK(lenses > 200);
}

// The library's quotient is off by less than 10 units of 2^-58: sine and cosine are off by less
// than 2^-61, the sine relatively, and the cosine is above 1/8.1. So only a tangent within 16 such
// units of a tie can be rounded wrongly, and MPFR decides those. Takes three minutes.
TEST_CASE("lens: the slope of every field of view is correctly rounded", "[.demand]") {
  using Fine = Fixed<62, 58>;
  std::uint64_t lenses = 0, near_ties = 0, wrong = 0;
  for (std::uint32_t fov = 1; fov < std::uint32_t{1} << 31; ++fov) {
    const auto [sine, cosine] = half_tangent(A::from_raw(fov));
    if (sine > cosine * largest<L::Slope>) break;
    ++lenses;
    const auto rest = quotient_floor<Fine>(sine, cosine).raw() & ((std::int64_t{1} << 30) - 1);
    if (std::abs(rest - (std::int64_t{1} << 29)) > 16) continue;
    ++near_ties;
    const auto found = quotient_nearest<L::Slope>(sine, cosine);
    if (found.raw() != nearest_integer(tangent(fov))) ++wrong;
  }
  CAPTURE(lenses, near_ties);
  CHECK(wrong == 0);
  CHECK(lenses > std::uint64_t{1} << 30);
  CHECK(near_ties > 20);
  CHECK(!L::perspective(A::from_raw(static_cast<std::uint32_t>(lenses + 1)), n(1), n(1), n(2)));
  CHECK(L::perspective(A::from_raw(static_cast<std::uint32_t>(lenses)), n(1), n(1), n(2)));
}

TEMPLATE_TEST_CASE("lens: float and double have the same lenses", "", float, double) {
  using F = TestType;
  const auto lens = Lens<F>::perspective(Angle<F>::turn(1, 4), F(2), F(1), F(3));
  REQUIRE(lens);
  CHECK(lens->slope(0) == Approx(2));
  CHECK(lens->slope(1) == Approx(1));
  CHECK(!Lens<F>::perspective(Angle<F>::turn(1, 2), F(1), F(3), F(1)));
  CHECK(!Lens<F>::perspective(Angle<F>(), F(1), F(1), F(3)));
  CHECK(Lens<F>::orthographic(F(4), F(2), F(-1), F(3))->extent(1) == 2);
}
