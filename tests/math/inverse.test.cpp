// SPDX-License-Identifier: MIT
#include "detent/math/inverse.hpp"

#include <cstdint>
#include <type_traits>

#include "math/matrices.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using S = q16_16;
constexpr auto n = [](int value) { return S(value); };
constexpr Mat<S, 2, 2> m2{{{{n(4), n(7)}, {n(2), n(6)}}}};
constexpr Mat<S, 3, 3> m3{{{{n(2), n(0), n(1)}, {n(1), n(3), n(2)}, {n(1), n(1), n(1)}}}};

static_assert(determinant(m2) == 10 && determinant(m3) == 0);
static_assert(determinant(identity<S, 4>()) == 1 && determinant(Mat<S, 4, 4>{}) == 0);
static_assert(minor_of(m2, 0, 1) == 2 && cofactor_of(m2, 0, 1) == -2);
static_assert(minor_of(m3, 1, 1) == 1 && minor_of(m3, 0, 0) == 1 && cofactor_of(m3, 0, 1) == 1);
static_assert(minors(m3)(0, 1) == -1 && cofactors(m3)(0, 1) == 1 && adjugate(m3)(1, 0) == 1);
static_assert(inverse(m2) == Mat<S, 2, 2>{{{{S::from_double(0.6), S::from_double(-0.7)},
                                            {S::from_double(-0.2), S::from_double(0.4)}}}});
static_assert(!inverse(m3), "a singular matrix has no inverse, not the identity");
static_assert(inverse(identity<S, 4>()) == identity<S, 4>());
static_assert(inverse(make_mat<2, 2>([](int i, int j) {
                return S::from_raw(i == j ? 1 : 0);
              }))->row(0) == Vec<S, 2>{S::max(), n(0)},
              "clamped");

// Hadamard: 16 * 2^124 for 4x4 of 32-bit scalars, attained by a matrix of signs.
static_assert(std::is_same_v<decltype(determinant(Mat<S, 4, 4>{})), Fixed<128, 64>>);
static_assert(std::is_same_v<decltype(determinant(m3)), Fixed<96, 48>>);
static_assert(std::is_same_v<decltype(determinant(m2)), Fixed<64, 32>>);
constexpr auto signs = make_mat<4, 4>([](int i, int j) {
  const bool odd = ((i & j & 1) ^ (i & j) >> 1) != 0;
  return odd ? Fixed<32, 16>(S::lowest()) : -S::lowest();
});
static_assert(abs(determinant(signs)) == Fixed<128, 0>::assume_raw(shift_left(Wide<4>(1), 64)));

template <class T, int N>
int count_wrong(const Mat<T, N, N>& m) {
  int wrong = 0;
  const auto exact = eliminate(rationals(m));
  if (rational(determinant(m)) != exact.determinant) ++wrong;
  const auto found = inverse(m);
  if (found.has_value() != (exact.determinant != 0)) return wrong + 1;
  if (!found) return wrong;
  const auto numerators = adjugate(m);
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      const BigRational& entry =
          exact.inverse[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      if (big_raw((*found)(i, j)) != clamped<T>(nearest_of(on_grid<T>(entry)))) ++wrong;
      if (rational(numerators(i, j)) != entry * exact.determinant) ++wrong;
    }
  }
  return wrong;
}

}  // namespace

TEMPLATE_TEST_CASE("inverse: correctly rounded, with exact determinant and adjugate", "", q16_16,
                   q14_16, q24_8, q8_8) {
  using T = TestType;
  Random random(71);
  int wrong = 0;
  for (int i = 0; i < 150; ++i) {
    wrong += count_wrong(random_mat<T, 2, 2>(random));
    wrong += count_wrong(random_mat<T, 3, 3>(random));
    wrong += count_wrong(random_mat<T, 4, 4>(random));
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("minor_of: a singular matrix also has cofactors", "", q16_16, q8_8) {
  using T = TestType;
  Random random(72);
  int wrong = 0;
  for (int k = 0; k < 200; ++k) {
    const auto m = random_mat<T, 4, 4>(random);
    const int i = static_cast<int>(random.below(4)), j = static_cast<int>(random.below(4));
    const auto rest =
        make_mat<3, 3>([&](int r, int c) { return m(r < i ? r : r + 1, c < j ? c : c + 1); });
    const BigRational exact = eliminate(rationals(rest)).determinant;
    if (rational(minors(m)(i, j)) != exact) ++wrong;
    if (rational(cofactors(m)(i, j)) != ((i + j) % 2 == 0 ? exact : BigRational(-exact))) ++wrong;
    if (minor_of(transpose(m), j, i) != minor_of(m, i, j)) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEST_CASE("inverse: narrow and wide integers give the same 4x4 inverse") {
  Random random(73);
  int wrong = 0;
  for (int k = 0; k < 500; ++k) {
    const auto m = random_mat<S, 4, 4>(random, 30);
    const auto narrow_path = make_mat<4, 4>([&](int i, int j) { return narrow<30>(m(i, j)); });
    if (detail::inverse_of<S>(m) != detail::inverse_of<S>(narrow_path)) ++wrong;
    if (detail::inverse_of<S>(m) != inverse(m)) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("inverse: float and double have the same interface", "", float, double) {
  using M = Mat<TestType, 2, 2>;
  CHECK(inverse(M{{{{2, 0}, {0, 4}}}}) == M{{{{TestType(0.5), 0}, {0, TestType(0.25)}}}});
  CHECK(!inverse(M{{{{1, 2}, {2, 4}}}}));
  CHECK(determinant(identity<TestType, 4>() * TestType(2)) == 16);
  CHECK(inverse(identity<TestType, 4>() * TestType(2)) == identity<TestType, 4>() * TestType(0.5));
}
