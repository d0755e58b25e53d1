// SPDX-License-Identifier: MIT
#include "detent/math/width.hpp"

#include "support/catch.hpp"

namespace detent::test {
namespace {

using Narrow = Fixed<20, 8>;
using Broad = Fixed<40, 8>;

template <int Bits>
constexpr int width_taken(const Broad& x, const Vec<Broad, 3>& v) {
  return by_width<Bits>(
      [](const auto& number, const auto& vector) {
        static_assert(bits_of<decltype(number * vector.x)> > 0);
        return std::max(bits_of<std::remove_cvref_t<decltype(number)>>,
                        bits_of<std::remove_cvref_t<decltype(vector.x)>>);
      },
      x, v);
}

constexpr Broad raw(std::int64_t value) { return Broad::from_raw(value); }

static_assert(fits<20>(raw(1 << 20)) && !fits<20>(raw((1 << 20) + 1)));
static_assert(fits<20>(raw(-(1 << 20))) && !fits<20>(raw(-(1 << 20) - 1)));
static_assert(fits<31>(raw(-(std::int64_t{1} << 31))) && !fits<31>(raw(std::int64_t{1} << 31)));
static_assert(fits<1>(1e30f));

TEST_CASE("by_width: takes the narrow path exactly when every operand fits", "[width]") {
  const Vec<Broad, 3> small{raw(1 << 20), raw(-5), raw(0)};
  CHECK(width_taken<20>(raw(7), small) == 20);
  CHECK(width_taken<20>(raw((1 << 20) + 1), small) == 40);
  CHECK(width_taken<20>(raw(7), Vec<Broad, 3>{raw(0), raw(0), raw(-(1 << 20) - 1)}) == 40);
  CHECK(width_taken<40>(raw(7), small) == 40);
}

TEST_CASE("by_width: passes float and narrow operands unchanged", "[width]") {
  const auto sum = [](const auto& a, const auto& b) { return a + b; };
  CHECK(by_width<20>(sum, 1.5f, 2.25f) == 3.75f);
  const auto is_narrow = [](const auto& x) {
    return bits_of<std::remove_cvref_t<decltype(x)>> == 20;
  };
  CHECK(by_width<30>(is_narrow, Narrow(3)));
}

}  // namespace
}  // namespace detent::test
