// SPDX-License-Identifier: MIT
#include "detent/math/mat.hpp"

#include <type_traits>

#include "detent/number/digest.hpp"
#include "math/matrices.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using S = q16_16;
using M2 = Mat<S, 2, 2>;
constexpr auto n = [](int value) { return S(value); };
constexpr M2 m{{{{n(1), n(2)}, {n(3), n(4)}}}};
constexpr Mat<S, 2, 3> wide{{{{n(1), n(2), n(3)}, {n(4), n(5), n(6)}}}};

static_assert(std::is_aggregate_v<M2> && sizeof(Mat<S, 4, 4>) == 64 &&
              sizeof(Mat<q8_8, 2, 3>) == 12);
static_assert(M2{} == M2{{{{n(0), n(0)}, {n(0), n(0)}}}});
static_assert(m(0, 1) == 2 && m(1, 0) == 3 && m.row(1) == Vec<S, 2>{n(3), n(4)});
static_assert(wide.column(2) == Vec<S, 2>{n(3), n(6)});
static_assert(identity<S, 3>()(2, 2) == 1 && identity<S, 3>()(0, 2) == 0);
static_assert(nearest_to<S>(m * identity<S, 2>()) == m &&
              nearest_to<S>(identity<S, 2>() * wide) == wide);
static_assert(nearest_to<S>(m * m) == M2{{{{n(7), n(10)}, {n(15), n(22)}}}});
static_assert(nearest_to<S>(m + m) == nearest_to<S>(m * n(2)) && nearest_to<S>(m - m) == M2{});
static_assert(nearest_to<S>(n(-1) * m) == nearest_to<S>(-m));
static_assert((wide * Vec<S, 3>{n(1), n(0), n(-1)}).x == -2);
static_assert(transpose(wide) == Mat<S, 3, 2>{{{{n(1), n(4)}, {n(2), n(5)}, {n(3), n(6)}}}});
static_assert(to_row_major(m) == std::array{n(1), n(2), n(3), n(4)});
static_assert(to_column_major(m) == std::array{n(1), n(3), n(2), n(4)});
static_assert(from_row_major<2, 3>(to_row_major(wide)) == wide);
static_assert(from_column_major<2, 3>(to_column_major(wide)) == wide);
static_assert(from_column_major<3, 2>(to_row_major(wide)) == transpose(wide));

// Components of products are dot products, with the bits that their worst case needs.
static_assert(std::is_same_v<decltype(m * m), Mat<Fixed<64, 32>, 2, 2>>);
static_assert(std::is_same_v<decltype(m + m), Mat<Fixed<32, 16>, 2, 2>>);
constexpr Mat<S, 4, 4> lowest_4x4 = make_mat<4, 4>([](int, int) { return S::lowest(); });
static_assert((lowest_4x4 * lowest_4x4)(0, 0) == std::int64_t{1} << 32);
static_assert(nearest_to<S>(lowest_4x4 * lowest_4x4)(3, 3) == S::max());

}  // namespace

TEMPLATE_TEST_CASE("mat: products with matrices and vectors are exact", "", q16_16, q14_16, q24_8,
                   q8_8) {
  using T = TestType;
  Random random(70);
  int wrong = 0;
  for (int k = 0; k < 500; ++k) {
    const auto a = random_mat<T, 3, 4>(random);
    const auto b = random_mat<T, 4, 2>(random);
    const auto ab = a * b;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 2; ++j) {
        BigInteger sum = 0;
        for (int l = 0; l < 4; ++l) sum += big_raw(a(i, l)) * big_raw(b(l, j));
        if (big_raw(ab(i, j)) != sum) ++wrong;
      }
    }
    for (int j = 0; j < 2; ++j) {
      if (a * b.column(j) != ab.column(j)) ++wrong;
    }
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("mat: float and double have the same interface", "", float, double) {
  using M = Mat<TestType, 2, 2>;
  const M a{{{{1, 2}, {3, 4}}}};
  CHECK(a * a == M{{{{7, 10}, {15, 22}}}});
  CHECK(a * Vec<TestType, 2>{1, -1} == Vec<TestType, 2>{-1, -1});
  CHECK(nearest_to<TestType>(identity<TestType, 2>() * a) == a);
}

TEST_CASE("digest: a matrix is its rows, in order") {
  Digest parts;
  parts.add(m.row(0), m.row(1));
  CHECK(digest(m) == parts.value());
  CHECK(digest(m) != digest(transpose(m)));
}
