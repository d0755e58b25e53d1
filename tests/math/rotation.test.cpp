// SPDX-License-Identifier: MIT
#include "detent/math/rotation.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/number/text.hpp"
#include "number/real.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using Flat = Rotation<q16_16, 2>;
using Solid = Rotation<q16_16, 3>;
using A = Angle<q16_16>;
using D = Direction<q16_16, 3>;
constexpr A right_angle = A::turn(1, 4);

static_assert(std::is_trivially_copyable_v<Solid> && sizeof(Solid) == 36);
static_assert(sizeof(Rotation<q8_8, 2>) == 8);
static_assert(Solid().axis(0) == D::along(0) && Solid().axis(2) == D::along(2));
static_assert(Flat::from_angle(A()) == Flat());
static_assert(Flat::from_angle(right_angle).axis(0) == Direction<q16_16, 2>::along(1));
static_assert(Flat::from_angle(right_angle).axis(1) == -Direction<q16_16, 2>::along(0));
static_assert(angle_of(Flat()) == A() && angle_of(Flat::from_angle(right_angle)) == right_angle);
static_assert(angle_of(Flat::from_angle(A::turn(1, 2))) == A::turn(1, 2));
static_assert(angle_of(Flat::from_angle(A::turn(5, 8))) == A::turn(-3, 8));
static_assert(Solid::from_axis_angle(D::along(1), A()) == Solid());
static_assert(Solid::from_axis_angle(D::along(2), right_angle).axis(0) == D::along(1));
static_assert(Solid::from_axis_angle(-D::along(2), right_angle).axis(0) == -D::along(1));
static_assert(Solid::from_euler(A(), A(), A()) == Solid());
static_assert(!Solid::from_quaternion(q16_16(), q16_16(), q16_16(), q16_16()));
static_assert(Solid::from_quaternion(q16_16(), q16_16(), q16_16(), q16_16(-7)) == Solid());

// A third of a turn about the diagonal maps x to y to z to x.
constexpr auto cycle = *Solid::from_quaternion(q16_16(1), q16_16(1), q16_16(1), q16_16(1));
static_assert(cycle == Solid::from_axes({D::along(1), D::along(2), D::along(0)}));
static_assert(rotate(cycle, Vec<q16_16, 3>{q16_16(1), q16_16(2), q16_16(3)}) ==
              Vec<q16_16, 3>{q16_16(3), q16_16(1), q16_16(2)});
static_assert(inverse_rotate(cycle, Vec<q16_16, 3>{q16_16(1), q16_16(2), q16_16(3)}) ==
              Vec<q16_16, 3>{q16_16(2), q16_16(3), q16_16(1)});

template <class T, int N>
using Matrix = std::array<std::array<T, N>, N>;

template <int N, class T>
Matrix<T, N> product(const Matrix<T, N>& a, const Matrix<T, N>& b) {
  Matrix<T, N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      for (std::size_t k = 0; k < N; ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

/// The rotation about one of the axes.
Matrix<Real, 3> turn_about(std::size_t axis, const Real& radians) {
  const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
  Matrix<Real, 3> m{};
  m[axis][axis] = 1;
  m[j][j] = m[k][k] = cos(radians);
  m[k][j] = sin(radians);
  m[j][k] = -sin(radians);
  return m;
}

/// source: Rodrigues' formula, I + sin [u] + (1 - cos) [u]^2 for the unit vector u
template <class T>
Matrix<T, 3> rodrigues(const std::array<T, 3>& u, const T& sine, const T& one_minus_cosine) {
  const Matrix<T, 3> cross = {{{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}}};
  const Matrix<T, 3> square = product<3>(cross, cross);
  Matrix<T, 3> m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      m[i][j] = (i == j ? 1 : 0) + sine * cross[i][j] + one_minus_cosine * square[i][j];
    }
  }
  return m;
}

template <Scalar S>
Real radians(Angle<S> angle) {
  if constexpr (is_fixed<S>) {
    return radians_of(angle.raw());
  } else {
    return Real(angle.raw());
  }
}

/// The largest error of a component, in units in the last place; for float and double in 2^-24 and
/// 2^-53.
template <Scalar S, int N>
double worst_ulps(const Rotation<S, N>& rotation,
                  const std::type_identity_t<Matrix<Real, N>>& exact) {
  int frac = std::is_same_v<S, float> ? 24 : 53;
  if constexpr (is_fixed<S>) frac = direction_component<S>::frac;
  double worst = 0;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      const Real& entry = exact[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
      worst = std::max(worst, ulps(real(rotation.axis(i)[j]), entry, frac));
    }
  }
  return worst;
}

/// Whether every axis is a valid Direction.
template <Scalar S, int N>
bool has_unit_axes(const Rotation<S, N>& rotation) {
  for (int i = 0; i < N; ++i) {
    std::array<typename Direction<S, N>::Raw, N> raw;
    for (int j = 0; j < N; ++j) {
      if constexpr (is_fixed<S>) {
        raw[static_cast<std::size_t>(j)] = rotation.axis(i)[j].raw();
      } else {
        raw[static_cast<std::size_t>(j)] = rotation.axis(i)[j];
      }
    }
    if (!Direction<S, N>::from_raw(raw)) return false;
  }
  return true;
}

template <Scalar S>
Angle<S> random_angle(Random& random) {
  const auto raw = random.one_in(4) ? static_cast<std::uint32_t>(random.below(8)) << 29
                                    : static_cast<std::uint32_t>(random.edgy(31));
  if constexpr (is_fixed<S>) {
    return Angle<S>::from_raw(raw);
  } else {
    return Angle<S>::turn(static_cast<int>(raw >> 8), 1 << 24);
  }
}

template <Scalar S>
S random_scalar(Random& random) {
  if constexpr (is_fixed<S>) {
    return random_fixed<S>(random);
  } else {
    return static_cast<S>(random.wide(20)) / 1024;
  }
}

template <Scalar S, int N>
Vec<S, N> random_vec(Random& random) {
  return make_vec<N>([&random](int) { return random_scalar<S>(random); });
}

/// A normalised direction, or one whose length is only nearly 1.
template <Scalar S>
Direction<S, 3> random_direction(Random& random) {
  while (true) {
    const auto direction = normalize(random_vec<S, 3>(random));
    if (!direction) continue;
    if constexpr (is_fixed<S>) {
      auto raw = std::array{(*direction)[0].raw(), (*direction)[1].raw(), (*direction)[2].raw()};
      for (auto& r : raw) {
        r = static_cast<std::remove_reference_t<decltype(r)>>(r + random.between(-1, 1));
      }
      if (const auto nearly = Direction<S, 3>::from_raw(raw)) return *nearly;
    }
    return *direction;
  }
}

template <Scalar S>
constexpr bool is_exact = is_fixed<S>;
constexpr double half_unit = 0.5 + 1.0 / (1 << 27);

}  // namespace

TEMPLATE_TEST_CASE("rotation: a 2D rotation has the rounded sine and cosine as its axes", "",
                   q16_16, q14_16, q24_8, q8_8, float, double) {
  using S = TestType;
  Random random(40);
  double worst = 0;
  for (int i = 0; i < 10'000; ++i) {
    const auto angle = random_angle<S>(random);
    const auto rotation = Rotation<S, 2>::from_angle(angle);
    const Real sine = sin(radians(angle)), cosine = cos(radians(angle));
    worst = std::max(worst, worst_ulps(rotation, {{{cosine, -sine}, {sine, cosine}}}));
    if (!has_unit_axes(rotation)) FAIL("axes are not of unit length: " << random);
  }
  INFO(random);
  CHECK(worst <= (is_exact<S> ? 0.5 : 1.5));
}

TEMPLATE_TEST_CASE("angle_of: returns the angle of a 2D rotation", "", q16_16, q14_16, q24_8, q8_8,
                   float, double) {
  using S = TestType;
  Random random(45);
  for (int i = 0; i < 10'000; ++i) {
    const auto angle = random_angle<S>(random);
    const auto found = angle_of(Rotation<S, 2>::from_angle(angle));
    INFO(random);
    if constexpr (is_fixed<S>) {
      const auto off = static_cast<std::int32_t>(found.raw() - angle.raw());
      // 2^-29 and 2^-14 radians in units of 2^-32 turn
      REQUIRE(std::abs(off) <= (direction_component<S>::frac == 30 ? 1 : 41'721));
    } else {
      REQUIRE(abs(sin((found - angle).raw())) < (std::is_same_v<S, float> ? 1e-6 : 1e-15));
      REQUIRE(cos((found - angle).raw()) > 0);
    }
  }
}

TEMPLATE_TEST_CASE("rotation: a quaternion of any length gives correctly rounded axes", "", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  using C = direction_component<S>;
  Random random(41);
  std::uint64_t wrong = 0;
  for (int i = 0; i < 5'000; ++i) {
    std::array<S, 4> q;
    const int bits = static_cast<int>(random.below(S::bits + 1));  // tiny quaternions as well
    for (auto& part : q) {
      part = random.coin() ? random_fixed<S>(random)
                           : S::from_raw(static_cast<typename S::raw_type>(random.edgy(bits)));
    }
    const auto rotation = Rotation<S, 3>::from_quaternion(q[0], q[1], q[2], q[3]);
    const auto [x, y, z, w] =
        std::array{rational(q[0]), rational(q[1]), rational(q[2]), rational(q[3])};
    const BigRational norm = x * x + y * y + z * z + w * w;
    if (norm == 0) {
      if (rotation) ++wrong;
      continue;
    }
    // With u = sin(h) the axis: sin(2h) = 2 w |v| / |q|^2 and 1 - cos(2h) = 2 |v|^2 / |q|^2.
    const auto exact = rodrigues<BigRational>({x, y, z}, 2 * w / norm, 2 / norm);
    for (int a = 0; a < 3; ++a) {
      for (int j = 0; j < 3; ++j) {
        const auto entry = exact[static_cast<std::size_t>(j)][static_cast<std::size_t>(a)];
        if (big_raw(rotation->axis(a)[j]) != nearest_of(on_grid<C>(entry))) ++wrong;
      }
    }
    if (!has_unit_axes(*rotation)) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("rotation: an axis and an angle give axes within 0.5 + 2^-27 units", "", q16_16,
                   q14_16, q24_8, q8_8, float, double) {
  using S = TestType;
  Random random(42);
  double worst = 0;
  std::uint64_t wrong = 0;
  for (int i = 0; i < 10'000; ++i) {
    const auto axis = random_direction<S>(random);
    const auto angle = random_angle<S>(random);
    const auto rotation = Rotation<S, 3>::from_axis_angle(axis, angle);
    std::array<Real, 3> u = {real(axis[0]), real(axis[1]), real(axis[2])};
    const Real length = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    for (Real& component : u) component /= length;
    const Real r = radians(angle);
    worst = std::max(worst, worst_ulps(rotation, rodrigues<Real>(u, sin(r), 1 - cos(r))));
    if (!has_unit_axes(rotation)) ++wrong;
    if (is_exact<S> && rotation != Rotation<S, 3>::from_axis_angle(-axis, -angle)) ++wrong;
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(wrong == 0);
  CHECK(worst < (is_exact<S> ? half_unit : 8));
  CHECK(worst > 0.4999);
}

TEMPLATE_TEST_CASE(
    "rotation: Euler angles rotate about world x, then y, then z, within 0.5 + 2^-27 units", "",
    q16_16, q14_16, q24_8, q8_8, float, double) {
  using S = TestType;
  Random random(43);
  double worst = 0;
  std::uint64_t wrong = 0;
  for (int i = 0; i < 10'000; ++i) {
    const auto x = random_angle<S>(random), y = random_angle<S>(random),
               z = random_angle<S>(random);
    const auto rotation = Rotation<S, 3>::from_euler(x, y, z);
    const auto exact = product<3>(turn_about(2, radians(z)),
                                  product<3>(turn_about(1, radians(y)), turn_about(0, radians(x))));
    worst = std::max(worst, worst_ulps(rotation, exact));
    if (!has_unit_axes(rotation)) ++wrong;
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(wrong == 0);
  CHECK(worst < (is_exact<S> ? half_unit : 4));
  CHECK(worst > 0.4999);
}

TEMPLATE_TEST_CASE("rotation: quarter turns permute the axes exactly", "", q16_16, q14_16, q24_8,
                   q8_8) {
  using S = TestType;
  using R = Rotation<S, 3>;
  using E = Direction<S, 3>;
  const auto quarter = Angle<S>::turn(1, 4), none = Angle<S>();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const auto about = R::from_axis_angle(E::along(i), quarter);
    CHECK(about.axis(i) == E::along(i));
    CHECK(about.axis(j) == E::along(k));
    CHECK(about.axis(k) == -E::along(j));
    CHECK(about ==
          R::from_euler(i == 0 ? quarter : none, i == 1 ? quarter : none, i == 2 ? quarter : none));
    const auto half = R::from_axis_angle(E::along(i), quarter + quarter);
    CHECK(half == R::from_axis_angle(E::along(i), -quarter - quarter));
    CHECK(half.axis(j) == -E::along(j));
  }
  // x first: z goes to -y about x and from there to x about z.
  CHECK(R::from_euler(quarter, none, quarter).axis(2) == E::along(0));
}

TEMPLATE_TEST_CASE("rotation: vectors are rotated to the world and back with one rounding", "",
                   (std::pair<q16_16, std::integral_constant<int, 2>>),
                   (std::pair<q16_16, std::integral_constant<int, 3>>),
                   (std::pair<q14_16, std::integral_constant<int, 3>>),
                   (std::pair<q24_8, std::integral_constant<int, 3>>),
                   (std::pair<q8_8, std::integral_constant<int, 2>>),
                   (std::pair<q8_8, std::integral_constant<int, 3>>)) {
  using S = typename TestType::first_type;
  constexpr int N = TestType::second_type::value;
  Random random(44);
  std::uint64_t wrong = 0;
  for (int i = 0; i < 5'000; ++i) {
    std::array<Direction<S, N>, N> axes;
    for (auto& axis : axes) {  // the axes need not be perpendicular
      const auto direction = normalize(random_vec<S, N>(random));
      axis = direction ? *direction : Direction<S, N>::along(1);
    }
    const auto rotation = Rotation<S, N>::from_axes(axes);
    const auto v = random_vec<S, N>(random);
    const auto world = rotate(rotation, v), local = inverse_rotate(rotation, v);
    for (int a = 0; a < N; ++a) {
      BigRational column = 0, row = 0;
      for (int b = 0; b < N; ++b) {
        column += rational(rotation.axis(b)[a]) * rational(v[b]);
        row += rational(rotation.axis(a)[b]) * rational(v[b]);
      }
      if (big_raw(world[a]) != clamped<S>(nearest_of(on_grid<S>(column)))) ++wrong;
      if (big_raw(local[a]) != clamped<S>(nearest_of(on_grid<S>(row)))) ++wrong;
    }
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("rotation: float and double have the same interface", "", float, double) {
  using S = TestType;
  using R = Rotation<S, 3>;
  const auto third = R::from_quaternion(1, 1, 1, 1);
  REQUIRE(third);
  CHECK(*third == R::from_axes({Direction<S, 3>::along(1), Direction<S, 3>::along(2),
                                Direction<S, 3>::along(0)}));
  CHECK(rotate(*third, Vec<S, 3>{1, 2, 3}) == Vec<S, 3>{3, 1, 2});
  CHECK(inverse_rotate(*third, Vec<S, 3>{1, 2, 3}) == Vec<S, 3>{2, 3, 1});
  CHECK(!R::from_quaternion(0, 0, 0, 0));
}
