// SPDX-License-Identifier: MIT
#include "detent/number/grid.hpp"

#include "support/catch.hpp"

namespace detent::test {
namespace {

using X = Fixed<30, 28>;
using detail::from_low_bits;
using detail::low_bits;
using detail::of_steps;
using detail::steps_nearest;

}  // namespace

TEST_CASE("number/grid: steps are the nearest ones, in a tie an even number") {
  for (int exponent = 0; exponent <= 3; ++exponent) {
    const int step = 1 << exponent;
    for (int n = -64; n <= 64; ++n) {
      const int k = static_cast<int>(steps_nearest(X::from_raw(n), exponent).raw());
      const int off = std::abs(2 * (n - k * step));
      CAPTURE(exponent, n, k);
      CHECK((off < step || (off == step && k % 2 == 0)));
    }
  }
  // At the ends of the range, where the nearest one may be beyond.
  const auto most = (X::max)(), least = X::lowest();
  CHECK(steps_nearest(most, 29).raw() == 2);
  CHECK(steps_nearest(least, 29).raw() == -2);
  CHECK(of_steps<Fixed<31, 28>>(steps_nearest(most, 29), 29) > most);
  CHECK(of_steps<X>(steps_nearest(least, 29), 29) == least);
}

TEST_CASE("number/grid: low bits hold a number and its sign") {
  for (const int n : {0, 1, -1, 31, -32, 17, -18}) {
    const auto bits = low_bits(X::from_raw(n), 6);
    CHECK(bits < 64);
    CHECK(from_low_bits<X>(bits, 6).raw() == n);
    CHECK(from_low_bits<X>(bits | 0xabcd00u, 6).raw() == n);  // higher ones do not count
  }
  CHECK(from_low_bits<Fixed<4, 0>>(0x1f, 6).raw() == 15);  // clamped
  CHECK(from_low_bits<Fixed<4, 0>>(0x20, 6).raw() == -16);
  CHECK(from_low_bits<Fixed<27, 20>>(std::uint64_t{1} << 40, 44) == (Fixed<27, 20>::max)());
}

}  // namespace detent::test
