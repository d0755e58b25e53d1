// SPDX-License-Identifier: MIT
#include "detent/math/quat.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "detent/number/digest.hpp"
#include "math/frames.hpp"
#include "math/quaternions.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using Q = Quat<q16_16>;
using R = Rotation<q16_16, 3>;
using A = Angle<q16_16>;
using D = Direction<q16_16, 3>;
using V = Vec<q16_16, 3>;
constexpr std::int32_t one = std::int32_t{1} << 30;
constexpr q16_16 low = q16_16::lowest(), high = q16_16::max();
constexpr auto number = [](int value) { return q16_16(value); };

static_assert(std::is_trivially_copyable_v<Q> && sizeof(Q) == 16 && sizeof(Quat<q8_8>) == 8);
static_assert(Q().w() == 1 && Q().x() == 0 && Q::from_raw({0, 0, 0, one}) == Q());
static_assert(!Q::from_raw({0, 0, 0, one + 1}) && !Q::from_raw({0, 0, 0, one - 3}));
static_assert(!Q::from_raw({0, 0, 0, 0}) && Q::from_raw({one / 2, one / 2, one / 2, one / 2}));
static_assert(!Q::normalize(number(0), number(0), number(0), number(0)));
static_assert(Q::normalize(low, low, low, low) ==
              Q::from_raw({-one / 2, -one / 2, -one / 2, -one / 2}));
static_assert(Q::from_axis_angle(D::along(1), A()) == Q());
static_assert(Q::from_axis_angle(D::along(1), A::turn(1, 2)) == Q::from_raw({0, one, 0, 0}));
static_assert(Q::from_euler(A(), A(), A()) == Q());

constexpr Q cycle = *Q::normalize(number(1), number(1), number(1), number(1));
constexpr V v{number(1), number(2), number(3)};
static_assert(rotate(cycle, v) == V{number(3), number(1), number(2)});
static_assert(inverse_rotate(cycle, v) == V{number(2), number(3), number(1)});
static_assert(to_rotation(cycle) == R::from_axes({D::along(1), D::along(2), D::along(0)}));
static_assert(Q::from_rotation(to_rotation(-cycle)) == cycle);
static_assert(compose(cycle, cycle) == -conjugate(cycle) &&
              compose(cycle, conjugate(cycle)) == Q());
static_assert(angle_of(Q()) == A() && !axis_of(Q()) && !axis_of(-Q()));
static_assert(axis_of(cycle) == normalize(V{number(1), number(1), number(1)}));
static_assert(angle_of(cycle) == A::turn(1, 3) && angle_of(-cycle) == A::turn(2, 3));
static_assert(rotate(Q::from_axis_angle(D::along(2), A::turn(1, 8)), V{high, low, low}).x == high,
              "clamped");

/// q p q* / |q|^2.
template <Scalar S>
Four<BigRational> turned(const Quat<S>& q, const Four<BigRational>& p) {
  const auto r = four<BigRational>(q);
  auto result = product(product(r, p), {-r[0], -r[1], -r[2], r[3]});
  const BigRational norm = r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3];
  for (auto& component : result) component /= norm;
  return result;
}

}  // namespace

TEMPLATE_TEST_CASE("quat: an axis and an angle are within 0.5 + 2^-27 units, and are recovered", "",
                   q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  Random random(80);
  double worst = 0, worst_angle = 0;
  int wrong = 0;
  for (int i = 0; i < 3'000; ++i) {
    const auto axis = axis_of(random_quat<S>(random)).value_or(Direction<S, 3>::along(0));
    const auto angle = random_angle<S>(random);
    const auto q = Quat<S>::from_axis_angle(axis, angle);
    const Real half = radians_of(angle.raw()) / 2;
    const auto u = unit({real(axis[0]), real(axis[1]), real(axis[2]), Real(0)});
    const Real sine = sin(half);
    worst = std::max(worst, worst_ulps(q, {u[0] * sine, u[1] * sine, u[2] * sine, cos(half)}));
    if (q.w() < 0) ++wrong;
    const auto any = random_quat<S>(random);
    const auto e = four<Real>(any);
    const Real turned_by = 2 * atan2(sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]), e[3]);
    const Real found = ldexp(Real(angle_of(any).raw()) * pi(), -31);
    // A full turn makes no difference.
    worst_angle = std::max(
        worst_angle, std::min(ulps(found, turned_by, 31), ulps(found + 2 * pi(), turned_by, 31)));
  }
  INFO(random);
  CAPTURE(worst, worst_angle);
  CHECK(wrong == 0);
  CHECK(worst < 0.5 + 1.0 / (1 << 27));
  CHECK(worst > 0.49);
  // In units of 2^-32 turn, which are pi steps of 2^-31.
  CHECK(worst_angle / 3.14159265358979324 < 0.5 + 1.0 / (1 << 28));
  CHECK(worst_angle / 3.14159265358979324 > 0.49);
}

TEMPLATE_TEST_CASE("quat: Euler angles rotate about world x, then y, then z, within 0.5 + 2^-27",
                   "", q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  Random random(81);
  double worst = 0;
  for (int i = 0; i < 3'000; ++i) {
    const std::array angles = {random_angle<S>(random), random_angle<S>(random),
                               random_angle<S>(random)};
    Four<Real> exact = {0, 0, 0, 1};
    for (std::size_t k = 0; k < 3; ++k) {
      const Real half = radians_of(angles[k].raw()) / 2;
      Four<Real> turn = {0, 0, 0, cos(half)};
      turn[k] = sin(half);
      exact = product(turn, exact);
    }
    worst =
        std::max(worst, worst_ulps(Quat<S>::from_euler(angles[0], angles[1], angles[2]), exact));
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(worst < 0.5 + 1.0 / (1 << 27));
  CHECK(worst > 0.49);
}

TEMPLATE_TEST_CASE("quat: products are correctly rounded and have unit length", "", q16_16, q14_16,
                   q24_8, q8_8) {
  using S = TestType;
  Random random(82);
  int wrong = 0;
  for (int i = 0; i < 3'000; ++i) {
    const auto p = random_quat<S>(random), q = random_quat<S>(random);
    if (!is_nearest_unit(compose(p, q), product(four<BigInteger>(p), four<BigInteger>(q)))) ++wrong;
    if (compose(conjugate(q), conjugate(p)) != conjugate(compose(p, q))) ++wrong;
  }
  auto q = random_quat<S>(random);
  const auto step = Quat<S>::from_axis_angle(Direction<S, 3>::along(2), Angle<S>::turn(1, 1000));
  for (int i = 0; i < 1'000; ++i) q = compose(step, q);
  if (!is_unit(to_array(q.vec()))) ++wrong;
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("quat: vectors and axes are rotated with one rounding", "", q16_16, q14_16,
                   q24_8, q8_8) {
  using S = TestType;
  using C = direction_component<S>;
  Random random(83);
  int wrong = 0;
  for (int i = 0; i < 1'000; ++i) {
    const auto q = random_quat<S>(random);
    const auto v3 = make_vec<3>([&](int) { return random_fixed<S>(random); });
    const auto exact = turned(q, {rational(v3.x), rational(v3.y), rational(v3.z), 0});
    const auto found = rotate(q, v3);
    const auto rotation = to_rotation(q);
    for (int k = 0; k < 3; ++k) {
      const BigRational& component = exact[static_cast<std::size_t>(k)];
      if (big_raw(found[k]) != clamped<S>(nearest_of(on_grid<S>(component)))) ++wrong;
      Four<BigRational> axis = {0, 0, 0, 0};
      axis[static_cast<std::size_t>(k)] = 1;
      axis = turned(q, axis);
      for (int j = 0; j < 3; ++j) {
        const BigRational entry = on_grid<C>(axis[static_cast<std::size_t>(j)]);
        if (big_raw(rotation.axis(k)[j]) != nearest_of(entry)) ++wrong;
      }
    }
    if (inverse_rotate(q, v3) != rotate(conjugate(q), v3)) ++wrong;
    const auto d = axis_of(random_quat<S>(random)).value_or(Direction<S, 3>::along(2));
    const auto r = four<BigInteger>(q);
    const auto way = product(product(r, {big_raw(d[0]), big_raw(d[1]), big_raw(d[2]), 0}),
                             {-r[0], -r[1], -r[2], r[3]});
    if (!is_direction_of(rotate(q, d), {way[0], way[1], way[2]})) ++wrong;
    if (inverse_rotate(q, d) != rotate(conjugate(q), d)) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("quat: a rotation is rounded correctly where an entry is next to a midpoint", "",
                   q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  using C = direction_component<S>;
  using Raw = typename C::raw_type;
  for (const int odd : {1, 3}) {
    // 2 z^2 / |q|^2 is nearly odd^2 / 2 steps: the filter is unsure.
    const auto small = C::from_raw(static_cast<Raw>(odd << (C::frac / 2 - 1)));
    for (const auto& [z, w] : {std::pair{small, C(1)}, std::pair{C(1), small}}) {
      const auto rotation = to_rotation(Quat<S>::assume_unit({C(0), C(0), z, w}));
      const auto norm = w * w + z * z;
      REQUIRE(rotation.axis(0)[0] == quotient_nearest<C>(w * w - z * z, norm));
      REQUIRE(rotation.axis(0)[1] == quotient_nearest<C>(w * z * 2, norm));
      REQUIRE(rotation.axis(1)[0] == quotient_nearest<C>(-(w * z * 2), norm));
      REQUIRE(rotation.axis(2) == Direction<S, 3>::along(2));
    }
  }
}

TEMPLATE_TEST_CASE("quat: is recovered from its rotation within 1.5 units", "", q16_16, q14_16,
                   q24_8, q8_8) {
  using S = TestType;
  Random random(84);
  double worst = 0;
  for (int i = 0; i < 10'000; ++i) {
    const auto q = random_quat<S>(random);
    const auto back = Quat<S>::from_rotation(to_rotation(q));
    const auto exact = unit(four<Real>(q));
    worst = std::max(worst, std::min(worst_ulps(back, exact), worst_ulps(-back, exact)));
    const auto& c = back.vec();
    const auto leading = c.w != 0 ? c.w : c.x != 0 ? c.x : c.y != 0 ? c.y : c.z;
    if (leading < 0) FAIL("the leading component is negative: " << random);
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(worst < 1.5);
  CHECK(worst > 0.75);
}

TEMPLATE_TEST_CASE("quat: float and double agree with their rotations", "", float, double) {
  using S = TestType;
  using T = Vec<S, 3>;
  const auto axis = *normalize(T{1, 2, 3});
  const auto angle = Angle<S>::turn(1, 5);
  const auto q = Quat<S>::from_axis_angle(axis, angle);
  const auto r = Rotation<S, 3>::from_axis_angle(axis, angle);
  const T p = rotate(q, T{1, -2, 5}), s = rotate(r, T{1, -2, 5});
  for (int i = 0; i < 3; ++i) {
    CHECK(p[i] == Approx(s[i]));
    CHECK(q.vec()[i] == Approx(Quat<S>::from_rotation(r).vec()[i]));
    CHECK((*axis_of(q))[i] == Approx(axis[i]));
  }
  CHECK(angle_of(q).degrees() == Approx(72));
  CHECK(compose(q, conjugate(q)).w() == Approx(1));
  CHECK(!Quat<S>::normalize(0, 0, 0, 0));
}

TEST_CASE("digest: a quaternion is x, y, z, w") {
  Digest parts;
  parts.add(cycle.x(), cycle.y(), cycle.z(), cycle.w());
  CHECK(digest(cycle) == parts.value());
  CHECK(digest(cycle) != digest(-cycle));
}
