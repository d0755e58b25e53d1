// SPDX-License-Identifier: MIT
#include "detent/math/project.hpp"

#include <cstdint>

#include "detent/math/rotation.hpp"
#include "number/big_integer.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using V2 = Vec<q16_16, 2>;
using V3 = Vec<q16_16, 3>;
using D = Direction<q16_16, 3>;
constexpr auto v3 = [](int x, int y, int z) { return V3{q16_16(x), q16_16(y), q16_16(z)}; };
constexpr q16_16 low = q16_16::lowest(), high = q16_16::max();

static_assert(project(v3(3, 4, 5), v3(0, -7, 0)) == v3(0, 4, 0));
static_assert(reject(v3(3, 4, 5), v3(0, -7, 0)) == v3(3, 0, 5));
static_assert(project(v3(2, 0, 0), v3(1, 1, 0)) == v3(1, 1, 0));
static_assert(reject(v3(2, 0, 0), v3(1, 1, 0)) == v3(1, -1, 0));
static_assert(project(v3(3, 4, 5), V3{}) == V3{});
static_assert(reject(v3(3, 4, 5), V3{}) == v3(3, 4, 5));
static_assert(project(V3{low, low, low}, V3{low, low, low}) == V3{low, low, low});
static_assert(project(V3{low, low, low}, D::along(1)) == V3{q16_16(), low, q16_16()});
static_assert(reflect(v3(1, -2, 3), D::along(1)) == v3(1, 2, 3));
static_assert(reflect(V3{low, high, low}, -D::along(0)) == V3{high, high, low}, "clamped");
static_assert(perpendicular(V2{q16_16(3), low}).x == -low && perpendicular(V2{low, high}).y == low);
static_assert(perpendicular(Direction<q16_16, 2>::along(0)) == Direction<q16_16, 2>::along(1));
static_assert(perpendicular(Direction<q16_16, 2>::along(1)) == -Direction<q16_16, 2>::along(0));
static_assert(lerp(v3(0, 10, -4), v3(4, 20, 4), q16_16::from_double(0.25)) ==
              V3{q16_16(1), q16_16::from_double(12.5), q16_16(-2)});
static_assert(lerp(V3{low, low, low}, V3{high, high, high}, q16_16(1)) == V3{high, high, high});
static_assert(lerp(V3{low, low, low}, V3{high, high, high}, high) == V3{high, high, high});

template <class T, int N>
BigRational dot_of(const Vec<T, N>& a, const auto& b) {
  BigRational sum = 0;
  for (int i = 0; i < N; ++i) sum += rational(a[i]) * rational(b[i]);
  return sum;
}

template <Scalar S>
bool is_nearest(S found, const BigRational& exact) {
  return big_raw(found) == clamped<S>(nearest_of(on_grid<S>(exact)));
}

}  // namespace

TEMPLATE_TEST_CASE("project, reject, reflect, lerp: the exact quotient rounded to nearest even", "",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(61);
  int wrong = 0;
  for (int i = 0; i < 1'500; ++i) {
    const auto draw = [&] {
      const int bits = static_cast<int>(random.below(S::bits + 1));  // tiny ones are often ties
      return make_vec<N>(
          [&](int) { return S::from_raw(static_cast<typename S::raw_type>(random.edgy(bits))); });
    };
    const auto v = draw(), onto = draw();
    const S t = v[0];
    const auto along = project(v, onto), across = reject(v, onto), between = lerp(v, onto, t);
    const BigRational squared = dot_of(onto, onto);
    const BigRational factor = squared == 0 ? BigRational(0) : dot_of(v, onto) / squared;
    for (int k = 0; k < N; ++k) {
      const BigRational part = factor * rational(onto[k]), whole = rational(v[k]);
      if (!is_nearest(along[k], part)) ++wrong;
      if (!is_nearest(across[k], whole - part)) ++wrong;
      if (!is_nearest(between[k], whole * (1 - rational(t)) + rational(onto[k]) * rational(t))) {
        ++wrong;
      }
    }
    const auto normal = normalize(onto);
    if (!normal) continue;
    const auto n_along = project(v, *normal), n_across = reject(v, *normal),
               mirrored = reflect(v, *normal);
    const BigRational n_factor = dot_of(v, *normal) / dot_of(normal->vec(), *normal);
    for (int k = 0; k < N; ++k) {
      const BigRational part = n_factor * rational((*normal)[k]), whole = rational(v[k]);
      if (!is_nearest(n_along[k], part)) ++wrong;
      if (!is_nearest(n_across[k], whole - part)) ++wrong;
      if (!is_nearest(mirrored[k], whole - 2 * part)) ++wrong;
    }
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("perpendicular: the rotation by a quarter turn", "", q16_16, q14_16, q24_8,
                   q8_8) {
  using S = TestType;
  const auto quarter = Rotation<S, 2>::from_angle(Angle<S>::turn(1, 4));
  Random random(62);
  for (int i = 0; i < 1'000; ++i) {
    const Vec<S, 2> v{random_fixed<S>(random), random_fixed<S>(random)};
    REQUIRE(nearest_to<S>(perpendicular(v)) == rotate(quarter, v));
    REQUIRE(dot(perpendicular(v), v) == 0);
    const auto d = normalize(v);
    if (d) REQUIRE(dot(perpendicular(*d), *d) == 0);
  }
}

TEMPLATE_TEST_CASE("project, reject, reflect, lerp: float and double have the same interface", "",
                   float, double) {
  using V = Vec<TestType, 3>;
  CHECK(project(V{3, 4, 5}, V{0, -7, 0}) == V{0, 4, 0});
  CHECK(project(V{3, 4, 5}, V{}) == V{});
  CHECK(reject(V{2, 0, 0}, V{1, 1, 0}) == V{1, -1, 0});
  CHECK(reflect(V{1, -2, 3}, Direction<TestType, 3>::along(1)) == V{1, 2, 3});
  CHECK(perpendicular(Vec<TestType, 2>{1, 2}) == Vec<TestType, 2>{-2, 1});
  CHECK(lerp(V{0, 10, -4}, V{4, 20, 4}, TestType(0.25)) == V{1, 12.5, -2});
}
