// SPDX-License-Identifier: MIT
#include "detent/query/kernel/rounded_point.hpp"

#include "detent/query/kernel/length.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

TEST_CASE("points between two others: the filter never contradicts the exact quotient", "[query]") {
  Random random(0x5b3d);
  using Far = detail::Length<q16_16>;
  using From = Fixed<63, 46>;
  using Part = Fixed<90, 60>;
  int unsure = 0;
  constexpr int asked = 20000;
  for (int i = 0; i < asked; ++i) {
    CAPTURE(i);
    const int shift = static_cast<int>(random.below(31));
    const auto number = [&](std::int64_t limit) { return random.between(-limit, limit) >> shift; };
    // On the grid, or between its points.
    const bool is_whole = random.coin();
    const auto from =
        From::from_raw(number(std::int64_t{1} << 61) & (is_whole ? ~0LL << 30 : ~0LL));
    const auto step = Fixed<34, 16>::from_raw(number(std::int64_t{1} << 33));
    // Powers of two and small numbers make ties.
    auto under = random.coin() ? std::int64_t{1} << (1 + random.below(40))
                               : random.between(2, std::int64_t{1} << (2 + random.below(58)));
    const auto over = random.between(1, under - 1);
    const Part part = Part::from_raw(over), whole = Part::from_raw(under);
    const auto ratio = make_ratio_below_one(part, whole);
    const auto exact = quotient_nearest<Far>(from * whole + step * part, whole);
    const auto decided = decide_between<Far>(from, step, ratio);
    unsure += decided.is_sure ? 0 : 1;
    if (decided.is_sure) REQUIRE(decided.value == exact);
    REQUIRE(detail::nearest_between<Far>(from, step, ratio) == exact);
    REQUIRE(detail::nearest_between<q16_16>(from, step, ratio) ==
            quotient_nearest<q16_16>(from * whole + step * part, whole));
  }
  CHECK(unsure > 0);
  CHECK(unsure < asked / 4);
}

}  // namespace
}  // namespace detent::test
