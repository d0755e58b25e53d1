// SPDX-License-Identifier: MIT
#include "detent/number/filter/shared_quotient.hpp"

#include <cstdlib>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using Over = Fixed<63, 46>;
using Under = Fixed<62, 60>;

TEST_CASE("SharedQuotient: quotients are within 64 steps") {
  Random random(0x94c);
  int sure = 0, wrong = 0;
  constexpr int count = 60'000;
  constexpr std::int64_t one = std::int64_t{1} << 60;
  for (int k = 0; k < count; ++k) {
    auto raw = random.one_in(4) ? one + random.wide(30) : random.edgy(60);
    if (random.one_in(16)) raw = (std::int64_t{1} << 53) + random.wide(31);
    if (random.coin()) raw = -raw;
    const auto under = Under::from_raw(raw);
    const SharedQuotient quotient(under);
    const bool is_long = std::abs(raw >> 29) > (std::int64_t{1} << 24) + 1;
    if (quotient.is_sure != is_long) ++wrong;
    if (!is_long) continue;
    const auto over = Over::from_raw(random.edgy(62));
    // |found / 2^38 - over 2^14 / under| < 64 / 2^38.
    const auto found = quotient(over);
    if (std::abs(found.raw()) >= std::int64_t{1} << 52) continue;
    ++sure;
    const BigInteger away = big_raw(found) * big_raw(under) - (big_raw(over) << 52);
    if (abs(away) >= BigInteger(64) * abs(big_raw(under))) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
  CHECK(sure > count / 4);
}

}  // namespace
}  // namespace detent::test
