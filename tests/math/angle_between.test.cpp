// SPDX-License-Identifier: MIT
#include "detent/math/angle_between.hpp"

#include <algorithm>
#include <cstdint>

#include "math/frames.hpp"
#include "number/real.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using V2 = Vec<q16_16, 2>;
using V3 = Vec<q16_16, 3>;
using A = Angle<q16_16>;
constexpr q16_16 one(1), none, low = q16_16::lowest(), high = q16_16::max();
constexpr auto unit = q16_16::from_raw(1);

static_assert(angle_between(V3{one, none, none}, V3{none, unit, none}) == A::turn(1, 4));
static_assert(angle_between(V3{low, low, low}, V3{high, high, high}) == A::turn(1, 2));
static_assert(angle_between(V3{unit, unit, none}, V3{none, low, none}) == A::turn(3, 8));
static_assert(angle_between(V3{low, low, none}, V3{none, low, low}) == A::turn(1, 6));
static_assert(angle_between(V2{one, none}, V2{one, one}) == A::turn(1, 8));
static_assert(angle_between(V3{}, V3{one, one, one}) == A(), "no direction, no angle");
static_assert(angle_between(V3{}, V3{}) == A());
static_assert(angle_between(V3{low, none, none}, V3{low, unit, none}) == A(), "2^-31: below half");
static_assert(angle_between(V2{one, unit}, V2{one, none}) == A::from_raw(10430));
static_assert(angle_between(Direction<q16_16, 3>::along(0), -Direction<q16_16, 3>::along(0)) ==
              A::turn(1, 2));

/// The error of `angle` in units of 2^-32 turn.
template <class T, int N, Scalar S>
double error(const Vec<T, N>& u, const Vec<T, N>& v, Angle<S> angle) {
  BigInteger uu = 0, vv = 0, uv = 0;
  for (int i = 0; i < N; ++i) {
    uu += big_raw(u[i]) * big_raw(u[i]);
    vv += big_raw(v[i]) * big_raw(v[i]);
    uv += big_raw(u[i]) * big_raw(v[i]);
  }
  if (uu == 0 || vv == 0) return angle == Angle<S>() ? 0 : 1;
  const Real exact = atan2(sqrt(Real(BigInteger(uu * vv - uv * uv))), Real(uv)) / (2 * pi());
  return ulps(ldexp(Real(angle.raw()), -32), exact, 32);
}

}  // namespace

TEMPLATE_TEST_CASE("angle_between: off by less than 0.5 + 2^-28 units", "", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(60);
  double worst = 0;
  for (int i = 0; i < 4'000; ++i) {
    const auto u = random_vec<S, N>(random);
    auto v = random_vec<S, N>(random);
    if (random.one_in(3)) v = u;
    if (random.coin()) v[1] = S::from_raw(static_cast<typename S::raw_type>(~v[1].raw()));
    const auto angle = angle_between(u, v);
    worst = std::max(worst, error(u, v, angle));
    REQUIRE(angle == angle_between(v, u));
    const auto d = normalize(u), e = normalize(v);
    if (d && e) worst = std::max(worst, error(d->vec(), e->vec(), angle_between(*d, *e)));
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(worst < 0.5 + 1.0 / (1 << 28));
  CHECK(worst > 0.499);
}

TEMPLATE_TEST_CASE("angle_between: float and double never give NaN for equal directions", "", float,
                   double) {
  using V = Vec<TestType, 3>;
  const V u{1, TestType(0.1), 3};
  CHECK(angle_between(u, u).raw() == 0);
  CHECK(angle_between(V{}, u).raw() == 0);
  CHECK(angle_between(V{1, 0, 0}, V{0, 2, 0}).degrees() == Approx(90));
  CHECK(angle_between(V{1, 0, 0}, V{-1, 1, 0}).degrees() == Approx(135));
}
