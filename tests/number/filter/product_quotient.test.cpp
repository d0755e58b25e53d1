// SPDX-License-Identifier: MIT
#include "detent/number/filter/product_quotient.hpp"

#include <algorithm>
#include <cstdlib>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using X = Fixed<62, 45>;
using T = Fixed<31, 16>;

/// Below 2^bits; every length is equally likely.
std::int64_t positive(Random& random, int bits) {
  return (std::max)(std::abs(random.wide(bits)), std::int64_t{1});
}

template <int BF>
void check_quotients(std::uint64_t seed) {
  using F = Fixed<BF, 28>;
  using G = Fixed<62, 56>;
  Random random(seed);
  int known = 0, wrong = 0;
  constexpr int count = 20'000;
  for (int k = 0; k < count; ++k) {
    const auto g = G::from_raw(positive(random, 62));
    const auto y = X::from_raw(positive(random, 62));
    const auto x = X::from_raw(random.edgy(62));
    const auto f = F::from_raw(static_cast<typename F::raw_type>(positive(random, BF)));
    const ProductQuotient quotient(g, y);
    const auto found = quotient.template over<T>(x, f);
    if (found.error.raw() == 1 << 20) continue;
    ++known;
    if (y.raw() < std::int64_t{1} << 36) ++wrong;
    // x in sixteenths of a step, off by 47, and y, off by 15: |value - x f / (g y)| < error.
    for (const int dx : {-47, 0, 47}) {
      for (const int dy : {-15, 0, 15}) {
        const BigInteger over = (big_raw(x) * 16 + dx) * big_raw(f);
        const BigInteger under = (big_raw(y) * 16 + dy) * big_raw(g);
        // value / 2^30 against over / under 2^(56 - 28).
        const BigInteger left = big_raw(found.value) * under, right = over << (30 + 28);
        const BigInteger difference = left - right;
        if (abs(difference) >= big_raw(found.error) * under) ++wrong;
      }
    }
  }
  CAPTURE(seed);
  CHECK(wrong == 0);
  CHECK(known > count / 20);
  CHECK(known < count);
}

TEST_CASE("ProductQuotient: quotients are within their error") {
  check_quotients<32>(0x9406);
  check_quotients<55>(0x9407);
}

TEST_CASE("ProductQuotient: it does not know quotients of a short denominator") {
  const auto is_known = [](std::int64_t y) {
    const ProductQuotient quotient(Fixed<62, 56>(1), X::from_raw(y));
    return quotient.over<T>(X::from_raw(1), Fixed<31, 28>(1)).error.raw() < 1 << 20;
  };
  CHECK(is_known(std::int64_t{1} << 40));
  CHECK_FALSE(is_known((std::int64_t{1} << 36) - 1));
}

}  // namespace
}  // namespace detent::test
