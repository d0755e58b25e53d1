// SPDX-License-Identifier: MIT
#include "detent/number/filter/filtered.hpp"

#include <cstdint>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using X = Fixed<61, 46>;
using Error = Fixed<40, 46>;

TEST_CASE("decide: the sign of every number within the error, or unsure") {
  Random random(20260712);
  INFO(random);
  int unsure = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::int64_t error = random.between(1, 1 << 20), value = random.edgy(21);
    const auto answer = decide(Approximate{X::from_raw(value), Error::from_raw(error)});
    const std::int64_t least = value - error + 1, most = value + error - 1;
    CHECK(answer == (least > 0 ? Filtered::yes : most < 0 ? Filtered::no : Filtered::unsure));
    unsure += answer == Filtered::unsure ? 1 : 0;
  }
  CHECK(unsure > 5'000);
  CHECK(unsure < 15'000);
}

TEST_CASE("decide: rounding is that of every number within the error, or unsure") {
  Random random(20260713);
  INFO(random);
  int unsure = 0, wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::int64_t whole = random.edgy(30) << 30, error = random.between(1, 1 << 28);
    const std::int64_t edge = random.coin() ? 0 : std::int64_t{1} << 29;
    const auto x = X::from_raw(whole + edge + random.wide(29));
    const auto least = X::from_raw(x.raw() - error + 1), most = X::from_raw(x.raw() + error - 1);
    const auto check = [&](const auto& decided, const auto& round) {
      const auto low = round(least), high = round(most);
      if (decided.is_sure && (decided.value != low || decided.value != high)) ++wrong;
      // If unsure, it returns the upper of two candidates, and only for a reason.
      if (!decided.is_sure && decided.value.raw() != round(X::from_raw(x.raw() + error)).raw()) {
        ++wrong;
      }
      unsure += decided.is_sure ? 0 : 1;
    };
    const Approximate approximate{x, Error::from_raw(error)};
    check(decide_floor<q16_16>(approximate),
          [](const X& exact) { return floor_to<q16_16>(exact); });
    // Halves round up; a tie is never decided.
    check(decide_nearest<q16_16>(approximate),
          [](const X& exact) { return floor_to<q16_16>(exact + half(q16_16::from_raw(1))); });
  }
  CHECK(wrong == 0);
  CHECK(unsure > 10'000);
  CHECK(unsure < 30'000);
}

TEST_CASE("or_exact: the exact number decides where the filter is unsure") {
  Random random(20260714);
  INFO(random);
  int exact = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::int64_t whole = random.edgy(30) << 30;
    const std::int64_t middle = random.coin() ? std::int64_t{1} << 29 : random.between(0, 1 << 30);
    const auto number = X::from_raw(whole + middle + (random.one_in(3) ? 0 : random.wide(18)));
    const auto x = X::from_raw(number.raw() + random.between(-(1 << 18) + 1, (1 << 18) - 1));
    const auto nearest = decide_nearest<q16_16>(Approximate{x, Steps<1 << 18>()});
    const auto rounded = or_exact(nearest, [&](const q16_16& upper) {
      ++exact;
      const auto half_way = midpoint_below(upper);
      return nearest_at_midpoint(upper, (number > half_way) - (number < half_way));
    });
    CHECK(rounded == nearest_to<q16_16>(number));
  }
  CHECK(exact > 5'000);
  CHECK(exact < 15'000);

  static_assert(or_exact(Filtered::yes, [] { return false; }));
  static_assert(!or_exact(Filtered::no, [] { return true; }));
  static_assert(or_exact(Filtered::unsure, [] { return true; }));
  static_assert(or_exact(Decided<int>{3, true}, [] { return 4; }) == 3);
  static_assert(or_exact(Decided<int>{3, false}, [] { return 4; }) == 4);
  static_assert(or_exact(Decided<int>{3, false}, [](int value) { return value - 1; }) == 2);
  static_assert(sign_or_exact(Filtered::yes, [] { return 0; }) == 1);
  static_assert(sign_or_exact(Filtered::no, [] { return 0; }) == -1);
  static_assert(sign_or_exact(Filtered::unsure, [] { return 0; }) == 0);
}

}  // namespace
}  // namespace detent::test
