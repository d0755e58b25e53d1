// SPDX-License-Identifier: MIT
#include "detent/cull/long_lanes.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using detail::ArrayLongLanes;
using detail::LongLanes;
using detail::LongWords;

constexpr std::size_t count = detail::long_lane_count;

LongWords draw(Random& random) {
  LongWords words{};
  for (auto& word : words) word = random.wide(1 + static_cast<int>(random.below(63)));
  return words;
}

/// Everything that lanes compute from two numbers a lane.
template <class L>
auto results(const LongWords& x, const LongWords& y, int shift) {
  const L a(x), b(y);
  const auto marks = L::above(a, b);
  return std::array{
      (a + b).words(),          (a - b).words(),        (a & b).words(),
      (a | b).words(),          (a >> shift).words(),   (a << shift).words(),
      L::product(a, b).words(), marks.words(),          L::select(marks, a, b).words(),
      L(a.halves()).words(),    L(x[0]).words(),        a.lower().words(),
      a.upper().words(),        a.magnitudes().words(), L::product(a.lower(), b.upper()).words()};
}

}  // namespace

TEST_CASE("long lanes: vectors of the machine hold the words that arrays do") {
  Random random(0x10a6);
  for (int i = 0; i < 20'000; ++i) {
    const auto x = draw(random);
    auto y = draw(random);
    for (auto& word : y) word = random.coin() ? x[0] : word;
    const int shift = static_cast<int>(random.below(63));
    REQUIRE(results<LongLanes>(x, y, shift) == results<ArrayLongLanes>(x, y, shift));
    LongWords one{};
    one[random.below(count)] = std::int64_t{1} << shift;
    REQUIRE(LongLanes(one).any());
    REQUIRE(!LongLanes(std::int64_t{0}).any());
    REQUIRE(ArrayLongLanes(one).any());
  }
}

TEST_CASE("long lanes: products and shifts are those of integers") {
  Random random(0x10a7);
  for (int i = 0; i < 20'000; ++i) {
    const auto x = draw(random), y = draw(random);
    const auto product = LongLanes::product(LongLanes(x), LongLanes(y)).words();
    const auto above = LongLanes::above(LongLanes(x), LongLanes(y)).words();
    for (std::size_t k = 0; k < count; ++k) {
      const auto half = [](std::int64_t word) { return static_cast<std::int32_t>(word); };
      REQUIRE(product[k] == std::int64_t{half(x[k])} * half(y[k]));
      REQUIRE(above[k] == (x[k] > y[k] ? -1 : 0));
    }
  }
}

TEMPLATE_TEST_CASE("long lanes: the least lane, and the signs", "", ArrayLongLanes, LongLanes) {
  Random random(0x10aa);
  for (int i = 0; i < 5'000; ++i) {
    auto x = draw(random);
    for (auto& word : x) word = random.one_in(4) ? x[1] : random.coin() ? -word : word;
    const auto least = *std::min_element(x.begin(), x.end());
    for (const auto word : TestType(x).least().words()) REQUIRE(word == least);
    for (std::size_t k = 0; k < count; ++k) {
      REQUIRE((TestType(x).signs() >> k & 1) == (x[k] < 0 ? 1 : 0));
    }
    REQUIRE(TestType(x).signs() < 16);
  }
}

TEST_CASE("long lanes: records are read and written word by word") {
  Random random(0x10a8);
  std::array<LongWords, count> records{}, copy{};
  for (auto& record : records) record = draw(random);
  const auto lanes = LongLanes::load({&records[0], &records[1], &records[2], &records[3]});
  for (std::size_t w = 0; w < 4; ++w) {
    for (std::size_t k = 0; k < count; ++k) CHECK(lanes[w].words()[k] == records[k][w]);
  }
  LongLanes::store(lanes, {&copy[0], &copy[1], &copy[2], &copy[3]});
  CHECK(copy == records);
}

}  // namespace detent::test
