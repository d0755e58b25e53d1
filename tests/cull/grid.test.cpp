// SPDX-License-Identifier: MIT

#include "detent/cull/grid.hpp"

#include <cstdint>

#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

using namespace detent;

TEMPLATE_TEST_CASE("grid: a number lies between its neighbouring grid steps", "[grid]", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  using Grid = detail::Grid<S>;
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

TEMPLATE_TEST_CASE("grid: the ends of the range are unbounded and enclosed", "[grid]", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  using Grid = detail::Grid<S>;
  // At compile time an overflow is an error.
  constexpr auto lowest_above = Grid::above(S::lowest());
  constexpr auto greatest_below = Grid::below(S::max());
  STATIC_REQUIRE(lowest_above == S::lowest().raw() >> Grid::shift);
  STATIC_REQUIRE(greatest_below == S::max().raw() >> Grid::shift);
  STATIC_REQUIRE(Grid::below(S::lowest()) == -Grid::beyond);
  STATIC_REQUIRE(Grid::above(S::max()) == Grid::beyond);
}

TEMPLATE_TEST_CASE("grid: what extends beyond the range is not cut off there", "[grid]", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  using Grid = detail::Grid<S>;
  test::Random random(0xc012);
  for (int i = 0; i < 10'000; ++i) {
    const auto draw = [&](bool is_length) {
      const auto raw = random.edgy(S::bits);
      return S::from_raw(static_cast<typename S::raw_type>(is_length && raw < 0 ? -1 - raw : raw));
    };
    const auto x = draw(false), length = draw(true);
    const std::int64_t raw = x.raw(), reach = length.raw();
    const detail::Reach<S> padded(length, length);
    constexpr std::int64_t step = std::int64_t{1} << Grid::shift;
    // In 2^-8 of a raw unit: length + 2^-8 length, rounded up by less than a step.
    REQUIRE(256 * step * padded.steps() >= 257 * reach);
    REQUIRE(256 * step * (padded.steps() - 1) < 257 * reach);
    REQUIRE(256 * step * Grid::below(x, padded) <= 256 * raw - 257 * reach);
    REQUIRE(256 * step * (Grid::below(x, padded) + 2) > 256 * raw - 257 * reach);
    REQUIRE(256 * step * Grid::above(x, padded) >= 256 * raw + 257 * reach);
    REQUIRE(256 * step * (Grid::above(x, padded) - 2) < 256 * raw + 257 * reach);
  }
}

}  // namespace
