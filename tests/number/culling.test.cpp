// SPDX-License-Identifier: MIT

#include "detent/number/culling.hpp"

#include <cstdint>

#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

using namespace detent;

TEMPLATE_TEST_CASE("culling: numbers lie between the steps of the grid beside them", "[culling]",
                   q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  using Grid = detail::Culling<S>;
  test::Random random(0xc011);
  for (int i = 0; i < 10'000; ++i) {
    const auto raw =
        random.between(std::int64_t{S::lowest().raw()} + 1, std::int64_t{S::max().raw()} - 1);
    const auto x = S::from_raw(static_cast<typename S::raw_type>(raw));
    const std::int64_t below = Grid::below(x), above = Grid::above(x);
    REQUIRE(below * (1 << Grid::shift) <= raw);
    REQUIRE(raw <= above * (1 << Grid::shift));
    REQUIRE(above - below <= 1);
  }
}

TEMPLATE_TEST_CASE("culling: the ends of the range have no end, and are enclosed", "[culling]",
                   q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  using Grid = detail::Culling<S>;
  // While compiling, an overflow would be an error.
  constexpr auto lowest_above = Grid::above(S::lowest());
  constexpr auto greatest_below = Grid::below(S::max());
  STATIC_REQUIRE(lowest_above == S::lowest().raw() >> Grid::shift);
  STATIC_REQUIRE(greatest_below == S::max().raw() >> Grid::shift);
  STATIC_REQUIRE(Grid::below(S::lowest()) == -Grid::far);
  STATIC_REQUIRE(Grid::above(S::max()) == Grid::far);
}

}  // namespace
