// SPDX-License-Identifier: MIT
#include "detent/number/filter/long_quadratic.hpp"

#include <cstdint>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

/// 5 (t - first) (t - last), whose discriminant is (5 (last - first) / 2)^2 for even roots.
constexpr auto with_roots(std::int64_t first, std::int64_t last) {
  constexpr auto number = [](std::int64_t x) { return Fixed<34, 0>(x); };
  constexpr auto five = Fixed<3, 0>(5);
  const auto middle = Fixed<120, 0>(five * number((first + last) / -2));
  const auto half = five * number((last - first) / 2);
  return LongQuadratic(five, middle, five * number(first) * number(last), half, half);
}

static_assert(with_roots(2, 8).first_root(Fixed<31, 0>(100)) == Fixed<31, 0>(2));
static_assert(with_roots(2, 8).last_root(Fixed<31, 0>(100)) == Fixed<31, 0>(8));

TEST_CASE("long quadratic: integer roots are found to the step at every size", "[number]") {
  using T = Fixed<31, 0>;
  Random random(0x10264);
  INFO(random);
  long wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto reach = std::int64_t{1} << random.between(2, 30);
    const auto first = 2 * random.between(1, reach / 2);
    const auto last = first + 2 * random.between(0, reach / 2 - 1);
    const auto quadratic = with_roots(first, last);
    const auto number = [](std::int64_t x) { return T(x); };
    const bool right = quadratic.first_root(T::max()) == number(first) &&
                       quadratic.first_root(number(first)) == number(first) &&
                       !quadratic.first_root(number(first - 1)) &&
                       quadratic.last_root(T::max()) == number(last) &&
                       quadratic.last_root(number(first)) == number(first) &&
                       with_roots(-first, last).last_root(T::max()) == number(last) &&
                       with_roots(-last, first).last_root(T::max()) == number(first);
    wrong += right ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("leading root: below the root by less than 2^-61 of it", "[number]") {
  using Long = Fixed<254, 0>;
  Random random(0x1ead);
  INFO(random);
  long wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto leading =
        integer_cast<Long::raw_type>(static_cast<std::int64_t>(random.next() >> 1));
    const auto x = Long::assume_raw(
        shift_right_floor(shift_left(leading, static_cast<int>(random.below(190))), 30));
    const auto [root, scale] = leading_root(x);
    const BigInteger exact = big_raw(x) << (2 * scale), given = big_raw(root);
    const BigInteger least = given + (given >> 61) + 1;
    wrong += given * given <= exact && exact < least * least ? 0 : 1;
    wrong += x == 0 || given >= power_of_two(62) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(leading_root(Long(0)).root == 0);
  CHECK(leading_root(2.25).root == 1.5);
}

}  // namespace
}  // namespace detent::test
