// SPDX-License-Identifier: MIT
#include "detent/cull/lanes.hpp"

#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using detail::ArrayLanes;
using detail::lane_count;
#if defined(__GNUC__)
using detail::VectorLanes;
#else
template <class T>
using VectorLanes = detail::Lanes<T>;
#endif

TEMPLATE_TEST_CASE("lanes: vectors of the machine hold the numbers that arrays do", "",
                   std::int32_t, float, double) {
  using T = TestType;
  using Numbers = std::array<T, lane_count>;
  Random random(0x1a9e5);
  const auto number = [&](int bits) { return static_cast<T>(random.wide(bits)); };
  for (int i = 0; i < 2'000; ++i) {
    std::array<std::uint8_t, lane_count> bytes{}, others{};
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.wide(8));
    for (auto& byte : others) byte = static_cast<std::uint8_t>(random.wide(8));
    const T first = number(20), step = number(12), limit = number(21);
    const auto numbers = [&]<class L>() {
      Numbers taken{};
      L low(limit), high(first, step, bytes);
      const L other(first, step, others);
      low.lower(other);
      high.raise(other);
      low.store(taken);
      Numbers raised{};
      high.store(raised);
      return std::tuple(taken, raised, low.up_to(high), high.up_to(low), low.up_to(low));
    };
    const auto expected = numbers.template operator()<ArrayLanes<T>>();
    REQUIRE(numbers.template operator()<VectorLanes<T>>() == expected);
    REQUIRE(std::get<4>(expected) == 0xff);
    for (std::size_t k = 0; k < lane_count; ++k) {
      const T a = first + static_cast<T>(bytes[k]) * step,
              b = first + static_cast<T>(others[k]) * step;
      REQUIRE(std::get<0>(expected)[k] == std::min(limit, b));
      REQUIRE(std::get<1>(expected)[k] == std::max(a, b));
      const bool in_order = std::min(limit, b) <= std::max(a, b);
      REQUIRE((std::get<2>(expected) >> k & 1) == (in_order ? 1 : 0));
    }
  }
}

}  // namespace
}  // namespace detent::test
