// SPDX-License-Identifier: MIT
#include "detent/math/projection.hpp"

#include <algorithm>
#include <cstdint>

#include "detent/math/inverse.hpp"
#include "math/decimals.hpp"
#include "math/frames.hpp"
#include "number/real.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using S = q16_16;
using V = Vec<S, 3>;
using D = Direction<S, 3>;
using A = Angle<S>;
constexpr S low = S::lowest(), high = S::max();
constexpr V up = v3(0, 1, 0);

constexpr auto camera = *look_at(v3(0, 0, 10), v3(0, 0, 0), up);
static_assert(camera == Transform<S, 3>{v3(0, 0, 10), {}, S(1)}, "it looks along -z");
static_assert(look_at(v3(0, 0, 0), v3(5, 0, 0), up)->rotation.axis(0) == D::along(2));
static_assert(inverse_transform_point(camera, v3(1, 2, 3)) == v3(1, 2, -7));
static_assert(nearest_to<S>(view_matrix(camera)).column(3) == Vec<S, 4>{n(0), n(0), n(-10), n(1)});
static_assert(!look_at(v3(1, 2, 3), v3(1, 2, 3), up), "nowhere to look");
static_assert(!look_at(v3(1, 2, 3), v3(1, 9, 3), up), "up is where it looks");
static_assert(!look_at(v3(1, 2, 3), v3(4, 5, 6), V{}));
static_assert(look_at(V{low, low, low}, V{high, high, high}, V{high, low, low}));

constexpr auto lens = *perspective(A::turn(1, 4), n(2), n(1), n(3));
static_assert(lens == Mat<S, 4, 4>{{{{n(0.5), n(0), n(0), n(0)},
                                     {n(0), n(1), n(0), n(0)},
                                     {n(0), n(0), n(-1.5), n(-1.5)},
                                     {n(0), n(0), n(-1), n(0)}}}});
static_assert(project_point(lens, v3(0, 0, -1)) == v3(0, 0, 0), "near is 0");
static_assert(project_point(lens, v3(6, -3, -3)) == v3(1, -1, 1), "far is 1");
static_assert(project_point(lens, v3(1, 1, 1))->z == 3, "behind");
static_assert(!project_point(lens, v3(1, 1, 0)), "beside the eye");
static_assert(!perspective(A(), n(1), n(1), n(2)) && !perspective(A::turn(1, 2), n(1), n(1), n(2)));
static_assert(!perspective(A::turn(3, 4), n(1), n(1), n(2)));
static_assert(!perspective(A::turn(1, 4), n(0), n(1), n(2)) &&
              !perspective(A::turn(1, 4), n(1), n(0), n(2)) &&
              !perspective(A::turn(1, 4), n(1), n(2), n(2)));
static_assert(perspective(A::from_raw(1), n(1), n(1), n(2))->row(0).x == high, "clamped");

constexpr auto flat = *orthographic(n(-2), n(6), n(-1), n(1), n(0), n(4));
static_assert(project_point(flat, v3(6, 1, -4)) == v3(1, 1, 1));
static_assert(project_point(flat, v3(-2, -1, 0)) == v3(-1, -1, 0));
static_assert(project_point(flat, v3(2, 0, -2)) == v3(0, 0, 0.5));
static_assert(!orthographic(n(1), n(1), n(-1), n(1), n(0), n(4)) &&
              !orthographic(n(0), n(1), n(1), n(-1), n(0), n(4)) &&
              !orthographic(n(0), n(1), n(0), n(1), n(4), n(4)));
static_assert(orthographic<Fixed<31, 30>>(n(-1500), n(1500), n(-1), n(1), n(0), n(4))->row(0).x ==
                  Fixed<31, 30>::from_raw(715828),
              "2 / 3000 in a finer type");

template <Scalar T>
bool is_nearest(T found, const BigRational& exact) {
  return big_raw(found) == clamped<T>(nearest_of(on_grid<T>(exact)));
}

}  // namespace

TEMPLATE_TEST_CASE("look_at: the axes are correctly rounded", "", q16_16, q14_16, q24_8, q8_8) {
  using T = TestType;
  Random random(120);
  int wrong = 0;
  for (int k = 0; k < 2'000; ++k) {
    const auto eye = random_vec<T, 3>(random), target = random_vec<T, 3>(random);
    auto above = random_vec<T, 3>(random);
    if (random.one_in(8)) above = nearest_to<T>(eye - target);
    const auto found = look_at(eye, target, above);
    // y is `above` minus its component along z, and x is perpendicular to both.
    std::array<BigInteger, 3> z, u, x, y;
    BigInteger zz = 0, uz = 0;
    for (int i = 0; i < 3; ++i) {
      const auto s = static_cast<std::size_t>(i);
      z[s] = big_raw(eye[i]) - big_raw(target[i]);
      u[s] = big_raw(above[i]);
      zz += z[s] * z[s];
      uz += u[s] * z[s];
    }
    for (std::size_t i = 0; i < 3; ++i) y[i] = u[i] * zz - z[i] * uz;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
      x[i] = y[j] * z[l] - y[l] * z[j];
    }
    const bool degenerate = std::all_of(x.begin(), x.end(), [](auto& c) { return c == 0; });
    if (found.has_value() == degenerate) ++wrong;
    if (!found || degenerate) continue;
    if (!is_direction_of(found->rotation.axis(0), x)) ++wrong;
    if (!is_direction_of(found->rotation.axis(1), y)) ++wrong;
    if (!is_direction_of(found->rotation.axis(2), z)) ++wrong;
    const auto p = random_vec<T, 3>(random);
    const auto there = inverse_transform_point(*found, p);
    if (project_point(view_matrix(*found), p) != there) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("perspective: within 0.5 + 2^-28 units, rational components exactly rounded", "",
                   q16_16, q14_16, q24_8, q8_8) {
  using T = TestType;
  Random random(121);
  double worst = 0;
  int wrong = 0;
  for (int k = 0; k < 3'000; ++k) {
    const auto fov = Angle<T>::from_raw(static_cast<std::uint32_t>(random.edgy(31) & INT32_MAX));
    const auto draw = [&] { return abs(random_fixed<T>(random)); };
    const T aspect = nearest_to<T>(draw()), near = nearest_to<T>(draw()),
            far = nearest_to<T>(draw());
    const auto found = perspective(fov, aspect, near, far);
    const bool valid = fov != Angle<T>() && aspect > 0 && near > 0 && near < far;
    if (found.has_value() != valid) ++wrong;
    if (!valid || !found) continue;
    const Real half = radians_of(fov.raw()) / 2;
    const Real most = real(T::max());
    const Real y = cos(half) / sin(half), x = y / real(aspect);
    if (x < most) worst = std::max(worst, ulps(real((*found)(0, 0)), x, T::frac));
    if (y < most) worst = std::max(worst, ulps(real((*found)(1, 1)), y, T::frac));
    if (x >= most && (*found)(0, 0) != T::max()) ++wrong;
    const BigRational a = rational(near), b = rational(far);
    if (!is_nearest((*found)(2, 2), b / (a - b))) ++wrong;
    if (!is_nearest((*found)(2, 3), a * b / (a - b))) ++wrong;
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(wrong == 0);
  CHECK(worst < 0.5 + 1.0 / (1 << 28));
  CHECK(worst > 0.49);
}

TEMPLATE_TEST_CASE("orthographic, project_point: exact quotients, rounded once", "", q16_16, q14_16,
                   q24_8, q8_8) {
  using T = TestType;
  Random random(122);
  int wrong = 0;
  for (int k = 0; k < 1'000; ++k) {
    const auto a = random_vec<T, 3>(random), b = random_vec<T, 3>(random);
    const auto box = orthographic(a.x, b.x, a.y, b.y, a.z, b.z);
    if (box.has_value() != (a.x < b.x && a.y < b.y && a.z < b.z)) ++wrong;
    const BigRational l = rational(a.x), r = rational(b.x), near = rational(a.z),
                      far = rational(b.z);
    if (box) {
      if (!is_nearest((*box)(0, 0), 2 / (r - l))) ++wrong;
      if (!is_nearest((*box)(0, 3), (l + r) / (l - r))) ++wrong;
      if (!is_nearest((*box)(2, 2), 1 / (near - far))) ++wrong;
      if (!is_nearest((*box)(2, 3), near / (near - far))) ++wrong;
    }

    const auto m = make_mat<4, 4>([&](int, int) { return random_fixed<T>(random); });
    const auto found = project_point(m, a);
    std::array<BigRational, 4> h;
    for (int i = 0; i < 4; ++i) {
      auto& sum = h[static_cast<std::size_t>(i)];
      sum = rational(m(i, 3));
      for (int j = 0; j < 3; ++j) sum += rational(m(i, j)) * rational(a[j]);
    }
    if (found.has_value() != (h[3] != 0)) ++wrong;
    if (!found) continue;
    for (int i = 0; i < 3; ++i) {
      if (!is_nearest((*found)[i], h[static_cast<std::size_t>(i)] / h[3])) ++wrong;
    }
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("projection: float and double agree", "", float, double) {
  using F = TestType;
  const auto eye = look_at(Vec<F, 3>{0, 0, 10}, Vec<F, 3>{}, Vec<F, 3>{0, 1, 0});
  REQUIRE(eye);
  CHECK(!look_at(Vec<F, 3>{}, Vec<F, 3>{}, Vec<F, 3>{0, 1, 0}));
  const auto m = perspective(Angle<F>::turn(1, 4), F(2), F(1), F(3));
  REQUIRE(m);
  const auto seen = project_point(*m, inverse_transform_point(*eye, Vec<F, 3>{6, -3, 7}));
  REQUIRE(seen);
  CHECK(seen->x == Approx(1));
  CHECK(seen->y == Approx(-1));
  CHECK(seen->z == Approx(1));
  const auto flat_lens = orthographic(F(-2), F(6), F(-1), F(1), F(0), F(4));
  REQUIRE(flat_lens);
  CHECK(project_point(*flat_lens, Vec<F, 3>{6, 1, -4}) == Vec<F, 3>{1, 1, 1});
  CHECK(inverse(*m).has_value());
}
