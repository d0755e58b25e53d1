// SPDX-License-Identifier: MIT
// Quotients and roots of four numbers at once are those of one after another.
#include "detent/dynamics/four.hpp"

#include "detent/number/root.hpp"
#include "detent/number/unit.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using detail::long_lane_count;
using detail::LongWords;
using Ratio = detail::Formats<q16_16>::Ratio;

DETENT_BEGIN_LONG_LANES

template <class L>
void find_ratios(const LongWords& a, const LongWords& b, LongWords& result) noexcept {
  result = detail::nearest_ratio(L(a), L(b)).words();
}
template <class L>
void find_means(const LongWords& sums, const LongWords& counts, LongWords& result) noexcept {
  const L sum(sums), count(counts), q = L::near_ratio(sum, count << 30);
  result = detail::nearest_to_quotient(q, sum - L::product(q, count), count).words();
}
template <class L>
void find_roots(const LongWords& x, LongWords& result) noexcept {
  result = detail::root_floor_of(L(x)).words();
}
/// Whether the parts of all four lengths are decided.
template <class L>
bool find_parts(const LongWords& a, const LongWords& b, LongWords& result) noexcept {
  detail::FourRounder<L> round;
  const L x(a), y(b);
  result = round.part_of_length(x, L::product(x, x) + L::product(y, y)).words();
  return !round.is_beyond();
}

DETENT_END_LONG_LANES

template <class Draw>
LongWords four(const Draw& draw) {
  return {draw(0), draw(1), draw(2), draw(3)};
}
std::int64_t up_to(Random& random, int bits) {
  return random.between(0, (std::int64_t{1} << random.between(1, bits)) - 1);
}

}  // namespace

TEMPLATE_TEST_CASE("four numbers: quotients are rounded to nearest, ties to even", "",
                   detail::ArrayLongLanes, detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  Random random(0x4a1);
  LongWords found{};
  for (int i = 0; i < 100'000; ++i) {
    const auto b = four([&](std::size_t) { return 1 + up_to(random, i % 2 == 0 ? 30 : 50); });
    const auto a = four([&](std::size_t k) {
      const auto x = random.coin() ? up_to(random, 50) : b[k] - up_to(random, 8);
      return x < 0 ? 0 : x > b[k] ? b[k] : x;
    });
    find_ratios<TestType>(a, b, found);
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      using Wide = Fixed<52, 0>;
      CAPTURE(a[k], b[k]);
      REQUIRE(found[k] ==
              quotient_nearest<Ratio>(Wide::assume_raw(a[k]), Wide::assume_raw(b[k])).raw());
    }
    const auto one = four([](std::size_t) { return std::int64_t{1} << 30; });
    const auto whole = four([&](std::size_t) { return one[0] + up_to(random, 50); });
    find_ratios<TestType>(one, whole, found);
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      const auto mass = quotient_nearest<Ratio>(Ratio(1), Fixed<62, 30>::assume_raw(whole[k]));
      REQUIRE(found[k] == mass.raw());
    }
  }
}

TEMPLATE_TEST_CASE("four numbers: means are rounded to nearest, ties to even", "",
                   detail::ArrayLongLanes, detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  const auto counts = four([](std::size_t k) { return static_cast<std::int64_t>(k) + 1; });
  LongWords found{};
  for (const std::int64_t middle :
       {std::int64_t{0}, std::int64_t{1} << 31, std::int64_t{1} << 20}) {
    for (const std::int64_t sign : {1, -1}) {
      for (std::int64_t rest = -40; rest <= 40; ++rest) {
        const auto sums =
            four([&](std::size_t k) { return sign * middle * (counts[k] - 1) + rest; });
        find_means<TestType>(sums, counts, found);
        for (std::size_t k = 0; k < long_lane_count; ++k) {
          CAPTURE(sums[k], counts[k]);
          REQUIRE(found[k] == quotient_nearest<Fixed<62, 0>>(Fixed<62, 0>::assume_raw(sums[k]),
                                                             Fixed<62, 0>::assume_raw(counts[k]))
                                  .raw());
        }
      }
    }
  }
}

TEMPLATE_TEST_CASE("four numbers: roots are rounded down", "", detail::ArrayLongLanes,
                   detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  Random random(0x4a2);
  LongWords found{};
  for (int i = 0; i < 100'000; ++i) {
    const auto x = four([&](std::size_t) {
      if (random.coin()) return up_to(random, 62);
      const auto root = up_to(random, 31), square = root * root + random.between(-2, 2);
      return square < 0 ? 0 : square;
    });
    find_roots<TestType>(x, found);
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      CAPTURE(x[k]);
      REQUIRE(found[k] == square_root_floor(static_cast<std::uint64_t>(x[k])));
    }
  }
}

TEMPLATE_TEST_CASE("four numbers: parts of lengths are rounded to nearest, or undecided", "",
                   detail::ArrayLongLanes, detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  Random random(0x4a3);
  LongWords found{};
  int undecided = 0;
  const int rounds = 200'000;
  for (int i = 0; i < rounds; ++i) {
    const auto b = four([&](std::size_t) {
      const auto x = up_to(random, 31);
      return random.coin() ? -x : x;
    });
    const auto a = four([&](std::size_t k) {
      if (random.one_in(16)) return std::int64_t{0};
      if (random.one_in(8)) return b[k];
      const auto x = up_to(random, 31);
      return random.coin() ? -x : x;
    });
    if (!find_parts<TestType>(a, b, found)) {
      ++undecided;
      continue;
    }
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      using Part = Fixed<31, 30>;
      const auto unit =
          unit_vector<Ratio>(std::array{Part::assume_raw(static_cast<Part::raw_type>(a[k])),
                                        Part::assume_raw(static_cast<Part::raw_type>(b[k]))});
      CAPTURE(a[k], b[k]);
      REQUIRE(found[k] == (unit ? (*unit)[0].raw() : 0));
    }
  }
  CAPTURE(undecided);
  CHECK(undecided < rounds / 1000);
}

}  // namespace detent::test
