// SPDX-License-Identifier: MIT
#include "detent/math/slerp.hpp"

#include <algorithm>
#include <cstdint>

#include "math/quaternions.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using Q = Quat<q16_16>;
using A = Angle<q16_16>;
using D = Direction<q16_16, 3>;
constexpr auto half = q16_16::from_double(0.5);
constexpr Q turned = Q::from_axis_angle(D::along(2), A::turn(1, 4));
constexpr Q far = Q::from_axis_angle(D::along(2), A::turn(3, 8));

static_assert(slerp(Q(), turned, half) == Q::from_axis_angle(D::along(2), A::turn(1, 8)));
static_assert(nlerp(Q(), turned, half) == slerp(Q(), turned, half));
static_assert(slerp(Q(), far, q16_16()) == Q() && slerp(Q(), far, q16_16(1)) == far);
static_assert(slerp(Q(), far, q16_16(-1)) == Q() && slerp(Q(), far, q16_16(2)) == far);
static_assert(slerp(Q(), -far, q16_16(1)) == far && nlerp(Q(), -far, q16_16(1)) == far);
static_assert(slerp(Q(), -Q(), half) == Q() && nlerp(Q(), -Q(), half) == Q());

template <Scalar S>
Quat<S> near(Random& random, const Quat<S>& q) {
  using Raw = typename Quat<S>::Raw;
  std::array<Raw, 4> raw;
  for (int i = 0; i < 4; ++i) {
    raw[static_cast<std::size_t>(i)] = static_cast<Raw>(q.vec()[i].raw() + random.between(-1, 1));
  }
  return Quat<S>::from_raw(raw).value_or(q);
}

}  // namespace

TEMPLATE_TEST_CASE("nlerp and slerp: correctly rounded, and within 0.5 + 2^-26 units", "", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  Random random(90);
  double worst = 0;
  int wrong = 0;
  for (int i = 0; i < 3'000; ++i) {
    const auto p = random_quat<S>(random);
    const auto q = random.one_in(4) ? near(random, p) : random_quat<S>(random);
    const auto t = random.number<S>(1, std::min<std::int64_t>(S::max().raw(), (1 << S::frac) - 1));
    const bool flipped = dot(p, q) < 0;
    const auto end = flipped ? -q : q;

    Four<BigInteger> chord;
    const BigInteger part = big_raw(t), whole = power_of_two(S::frac);
    const auto first = four<BigInteger>(p), last = four<BigInteger>(end);
    for (std::size_t k = 0; k < 4; ++k) chord[k] = first[k] * (whole - part) + last[k] * part;
    if (!is_nearest_unit(nlerp(p, q, t), chord)) ++wrong;

    const auto a = unit(four<Real>(p)), b = unit(four<Real>(end));
    Real cosine = 0, sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      cosine += a[k] * b[k];
      sum += (a[k] - b[k]) * (a[k] - b[k]);
    }
    const Real angle = 2 * asin(sqrt(sum) / 2), r = real(t);
    Four<Real> exact = a;
    if (sum < ldexp(Real(1), -160)) {  // parallel
      worst = std::max(worst, worst_ulps(slerp(p, q, t), exact));
      continue;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      exact[k] = (sin((1 - r) * angle) * a[k] + sin(r * angle) * b[k]) / sin(angle);
    }
    worst = std::max(worst, worst_ulps(slerp(p, q, t), exact));
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(wrong == 0);
  CHECK(worst < 0.5 + 1.0 / (1 << 26));
  CHECK(worst > 0.49);
}

TEMPLATE_TEST_CASE("slerp: the speed is constant, and float and double have the same interface", "",
                   q16_16, q14_16, q24_8, q8_8, float, double) {
  using S = TestType;
  const auto axis = Direction<S, 3>::along(1);
  const auto end = Quat<S>::from_axis_angle(axis, Angle<S>::turn(1, 3));
  const S step = quotient_nearest<S>(S(1), S(16));
  S t = S(0);
  for (int i = 0; i <= 16; ++i, t += step) {
    const auto found = slerp(Quat<S>(), end, t);
    const auto exact = Quat<S>::from_axis_angle(axis, Angle<S>::turn(i, 48));
    CHECK(abs(static_cast<double>(found.y()) - static_cast<double>(exact.y())) < 1e-4);
    CHECK(abs(static_cast<double>(found.w()) - static_cast<double>(exact.w())) < 1e-4);
  }
}
