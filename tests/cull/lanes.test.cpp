// SPDX-License-Identifier: MIT
#include "detent/cull/lanes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

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

TEMPLATE_TEST_CASE("lanes: machine vectors hold the same numbers as arrays", "", std::int32_t,
                   float, double) {
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

TEMPLATE_TEST_CASE("lanes: masks are those of every single comparison", "", std::int32_t, float,
                   double) {
  using T = TestType;
  using Numbers = std::array<T, lane_count>;
  Random random(0x3a26);
  for (int i = 0; i < 2'000; ++i) {
    std::array<Numbers, 4> numbers{};
    for (auto& each : numbers) {
      for (auto& x : each) x = static_cast<T>(random.one_in(4) ? 7 : random.wide(30));
    }
    const auto unmarked = [&]<class L>() {
      typename L::Marks marks;
      marks.add_above(L(numbers[0]), L(numbers[1]));
      marks.add_above(L(numbers[2]), L(numbers[3]));
      return marks.unmarked();
    };
    const auto expected = unmarked.template operator()<ArrayLanes<T>>();
    REQUIRE(unmarked.template operator()<VectorLanes<T>>() == expected);
    for (std::size_t k = 0; k < lane_count; ++k) {
      const bool is_above = numbers[0][k] > numbers[1][k] || numbers[2][k] > numbers[3][k];
      REQUIRE((expected >> k & 1) == (is_above ? 0 : 1));
    }
  }
}

TEMPLATE_TEST_CASE("lanes: packing keeps the marked lanes in order", "", ArrayLanes<std::uint32_t>,
                   VectorLanes<std::uint32_t>) {
  Random random(0x9ac4);
  for (std::uint32_t mask = 0; mask < 256; ++mask) {
    std::array<std::uint32_t, lane_count> numbers{}, packed{};
    for (auto& x : numbers) x = static_cast<std::uint32_t>(random.next());
    std::size_t count = 0;
    std::array<std::uint32_t, lane_count> expected{};
    for (std::size_t k = 0; k < lane_count; ++k) {
      if ((mask >> k & 1) != 0) expected[count++] = numbers[k];
    }
    REQUIRE(TestType(numbers).pack(mask, packed.data()) == count);
    for (std::size_t k = 0; k < count; ++k) REQUIRE(packed[k] == expected[k]);
  }
}

#if defined(__GNUC__)
TEST_CASE("lanes: the box around three points, and its middle") {
  Random random(0x3b0c5);
  for (int i = 0; i < 5'000; ++i) {
    std::array<std::int32_t, 10> record{};
    const int bits = i % 2 == 0 ? 32 : 3;
    for (auto& x : record) x = static_cast<std::int32_t>(random.wide(bits));
    std::array<std::int32_t, lane_count> box{}, middle{};
    const auto lanes = VectorLanes<std::int32_t>::around_three(record.data());
    lanes.store(box);
    lanes.middle().store(middle);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [least, greatest] = std::minmax({record[k], record[k + 3], record[k + 6]});
      REQUIRE(box[k] == least);
      REQUIRE(box[k + 4] == ~greatest);
      REQUIRE(middle[k] == (least >> 1) + (greatest >> 1));
      REQUIRE(middle[k + 4] == ~middle[k]);
    }
  }
}
#endif

TEST_CASE("lanes: bytes times a step are exact for every step of a grid") {
  using Numbers = std::array<std::int32_t, lane_count>;
  Random random(0xb17e5);
  constexpr std::int32_t longest = 1 << 21;
  for (int i = 0; i < 20'000; ++i) {
    std::array<std::uint8_t, lane_count> bytes{};
    for (auto& byte : bytes)
      byte = static_cast<std::uint8_t>(random.one_in(4) ? 255 : random.next());
    const auto step =
        static_cast<std::int32_t>(random.one_in(8) ? (random.coin() ? longest : -longest)
                                                   : random.between(-longest, longest));
    const auto first = static_cast<std::int32_t>(random.wide(30));
    Numbers result{};
    VectorLanes<std::int32_t>(first, step, bytes).store(result);
    for (std::size_t k = 0; k < lane_count; ++k) REQUIRE(result[k] == first + bytes[k] * step);
  }
}

TEST_CASE("lanes: integers are complemented, added and scaled") {
  using Numbers = std::array<std::int32_t, lane_count>;
  Random random(0x5ca1e);
  for (int i = 0; i < 2'000; ++i) {
    Numbers numbers{};
    for (auto& x : numbers) x = static_cast<std::int32_t>(random.wide(29));
    const auto factor = static_cast<std::uint32_t>(random.between(1, std::int64_t{1} << 30));
    const int shift = static_cast<int>(random.between(29, 34));
    const auto sum = static_cast<std::int32_t>(random.wide(29));
    const bool flips = random.coin();
    const auto taken = [&]<class L>() {
      L lanes(numbers);
      lanes.flip(L(flips ? -1 : 0));
      lanes.add(L(sum));
      lanes.raise(L(0));
      lanes.scale(factor, shift);
      lanes.subtract(L(sum));
      Numbers result{};
      lanes.store(result);
      return result;
    };
    const auto expected = taken.template operator()<ArrayLanes<std::int32_t>>();
    REQUIRE(taken.template operator()<VectorLanes<std::int32_t>>() == expected);
    for (std::size_t k = 0; k < lane_count; ++k) {
      const std::int64_t x = flips ? ~numbers[k] : numbers[k];
      const auto product = static_cast<std::uint64_t>(std::max<std::int64_t>(x + sum, 0)) * factor;
      REQUIRE(std::int64_t{expected[k]} == static_cast<std::int64_t>(product >> shift) - sum);
    }
  }
}

}  // namespace
}  // namespace detent::test
