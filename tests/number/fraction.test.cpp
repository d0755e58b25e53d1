// SPDX-License-Identifier: MIT
#include "detent/number/fraction.hpp"

#include "support/catch.hpp"

namespace detent {
namespace {

using Over = Fixed<31, 8>;
using Under = Fixed<20, 4>;

TEST_CASE("fraction: compared without a division", "[number]") {
  const Fraction third{Over(1), Under(3)};
  CHECK(third <= Over::from_raw(86));
  CHECK_FALSE(third <= Over::from_raw(85));  // 85 / 256 < 1 / 3
  CHECK(Fraction{Over(-1), Under(3)} <= Over(0));
  CHECK(Fraction{Over(6), Under(3)} <= Over(2));
  CHECK(Fraction{1.0, 4.0} <= 0.25);
}

TEST_CASE("fraction: two are compared by whole parts, then by remainders", "[number]") {
  for (int a = -30; a < 30; ++a) {
    for (int b = 1; b < 12; ++b) {
      for (int c = -30; c < 30; ++c) {
        for (int d = 1; d < 12; ++d) {
          const Fraction left{Over::from_raw(a), Under::from_raw(b)};
          const Fraction right{Over::from_raw(c), Under::from_raw(d)};
          REQUIRE((left < right) == (a * d < c * b));
        }
      }
    }
  }
  // 2^300 / 3 and its neighbours: cross-multiplying needs more than the widest integer.
  using Vast = Fixed<310, 0>;
  using Large = Fixed<60, 0>;
  const auto vast = Vast::from_raw(Wide<5>(1) << 300);
  const Fraction third{vast, Large(3)};
  CHECK_FALSE(third < third);
  CHECK(third < Fraction{vast, Large(2)});
  CHECK(third < Fraction{Vast::from_raw((Wide<5>(1) << 300) + Wide<5>(1)), Large(3)});
  CHECK(Fraction{1.0, 4.0} < Fraction{1.0, 3.0});
}

TEST_CASE("fraction: its root is the greatest number on the grid that does not exceed it",
          "[number]") {
  using Root = Fixed<20, 6>;
  for (int n = 0; n < 400; ++n) {
    for (int d = 1; d < 40; ++d) {
      const Fraction x{Over::from_raw(n), Under::from_raw(d)};
      const auto root = sqrt_floor<Root>(x);
      const auto after = Root::from_raw(root.raw() + 1);
      INFO(n << " / " << d);
      REQUIRE(root * root * x.denominator <= x.numerator);
      REQUIRE(after * after * x.denominator > x.numerator);
    }
  }
  CHECK(sqrt_floor<Fixed<8, 4>>(Fraction{Over(100000), Under(1)}) == Fixed<8, 4>::max());
}

}  // namespace
}  // namespace detent
