// SPDX-License-Identifier: MIT
#include "detent/number/root.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

constexpr std::uint64_t ones = ~std::uint64_t{0};

static_assert(square_root_floor(0) == 0 && square_root_floor(1) == 1 && square_root_floor(3) == 1);
static_assert(square_root_floor(4) == 2 && square_root_floor(ones) == 0xffffffff);
static_assert(square_root_floor(0xfffffffe00000001) == 0xffffffff, "the largest square");
static_assert(square_root_floor(0xfffffffe00000000) == 0xfffffffe);
static_assert(square_root_floor(0, 0) == 0 && square_root_floor(0, 99) == 9);
static_assert(square_root_floor(1, 0) == 0x100000000 && square_root_floor(ones, ones) == ones);
static_assert(square_root_floor(ones - 1, 1) == ones, "the largest square");
static_assert(square_root_floor(ones - 1, 0) == ones - 1);

// root^2 <= n < (root + 1)^2, without computing a root.
bool is_root(std::uint64_t root, std::uint64_t n) {
  const std::uint64_t square = root * root;
  return root <= 0xffffffff && square <= n && n - square <= 2 * root;
}

bool is_root(std::uint64_t root, const Wide<2>& n) {
  const BigInteger square = BigInteger(root) * root, next = square + root + root + 1;
  const BigInteger value = big(Wide<3>::from_words({n.word(0), n.word(1), 0}));
  return square <= value && value < next;
}

// Asserts only on a fault, because millions of assertions would take longer than the roots.
class Examiner {
 public:
  void check(std::uint64_t n) {
    if (!is_root(square_root_floor(n), n)) FAIL("n = " << n);
    ++count_;
  }
  void check(std::uint64_t high, std::uint64_t low) {
    if (!is_root(square_root_floor(high, low), Wide<2>::from_words({low, high}))) {
      FAIL("n = " << high << " * 2^64 + " << low);
    }
    ++count_;
  }
  [[nodiscard]] int count() const { return count_; }

 private:
  int count_ = 0;
};

}  // namespace

TEST_CASE("root: 64-bit roots are the floor of the exact ones", "[number]") {
  Examiner exam;
  for (std::uint64_t n = 0; n < (1u << 22); ++n) exam.check(n);
  for (std::uint64_t n = ones; n > ones - (1u << 20); --n) exam.check(n);
  for (int k = 0; k < 64; ++k) {
    for (std::uint64_t distance = 0; distance < 10'000; ++distance) {
      exam.check((std::uint64_t{1} << k) + distance);
      exam.check((std::uint64_t{1} << k) - distance);
    }
  }
  Random random(0x5007);
  INFO(random);
  for (int i = 0; i < 5'000'000; ++i) exam.check(random_integer<std::uint64_t>(random));
  for (int i = 0; i < 2'000'000; ++i) {
    const std::uint64_t root = random.next() >> (32 + random.below(32));
    for (std::uint64_t n : {root * root - 1, root * root, root * root + 1, root * root + 2 * root,
                            root * root + 2 * root + 1}) {
      exam.check(n);
    }
  }
  CHECK(exam.count() >= 1'000'000);
}

TEST_CASE("root: 64-bit roots are correct at both ends of every chord", "[number]") {
  Examiner exam;
  // The first guess is worst at the ends of the table's steps, for every shift.
  for (std::uint64_t entry = 64; entry <= 256; ++entry) {
    for (int shift = 0; shift < 56; ++shift) {
      for (std::int64_t distance = -200; distance <= 200; ++distance) {
        exam.check((entry << shift) + static_cast<std::uint64_t>(distance));
      }
    }
  }
  CHECK(exam.count() >= 1'000'000);
}

// Each machine uses one of the two.
TEST_CASE("root: by table and by division, the floor or one more, exact for squares", "[number]") {
  const auto is_floor_or_next = [](const BigInteger& root, std::uint64_t a) {
    const BigInteger below = root - 1, above = root + 1;
    return below * below < a && above * above > a;
  };
  int wrong = 0;
  const auto check = [&](std::uint64_t a) {
    wrong += is_floor_or_next(detail::root_by_table(a), a) ? 0 : 1;
    wrong += is_floor_or_next(detail::root_by_division(a), a) ? 0 : 1;
  };
  Random random(0x500a);
  INFO(random);
  for (std::uint64_t chord = 64; chord < 256; ++chord) {
    const std::uint64_t first = chord << 56, last = first + (ones >> 8);
    for (int i = 0; i < 100; ++i) {
      check(first + static_cast<std::uint64_t>(i));
      check(last - static_cast<std::uint64_t>(i));
      check(first + (random.next() >> 8));
      const std::uint64_t root = (std::uint64_t{1} << 31) | (random.next() >> 32);
      check(root * root);
      check(root * root + 1);
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("root: 128-bit roots are the floor of the exact ones", "[number]") {
  Examiner exam;
  Random random(0x5008);
  INFO(random);
  for (int i = 0; i < 1'000'000; ++i) {
    const auto n = random_wide<2>(random);
    exam.check(n.word(1), n.word(0));
  }
  for (int k = 0; k < 128; ++k) {
    const Wide<2> power = Wide<2>(1) << k;
    for (int distance = -500; distance <= 500; ++distance) {
      const Wide<2> n = power + Wide<2>(distance);
      exam.check(n.word(1), n.word(0));
    }
  }
  for (std::uint64_t distance = 0; distance < 10'000; ++distance) {
    exam.check(ones, ones - distance);
    exam.check(ones - 1, distance);
    exam.check(distance, 0);
    exam.check(distance, ones);
  }
  CHECK(exam.count() >= 1'000'000);
}

TEST_CASE("root: 128-bit roots are correct next to squares", "[number]") {
  Examiner exam;
  Random random(0x5009);
  INFO(random);
  for (int i = 0; i < 400'000; ++i) {
    // Also halves of all ones or zeros, for which the trailing half of the root is at its limit.
    std::uint64_t root = random_integer<std::uint64_t>(random);
    if (random.one_in(8)) root |= 0xffffffff;
    if (random.one_in(8)) root &= ones << 32;
    const WordProduct square = multiply_words_portable(root, root);
    const auto n = Wide<2>::from_words({square.low, square.high});
    const auto twice = Wide<2>(root) + Wide<2>(root);
    for (const auto& m : {n - Wide<2>(1), n, n + Wide<2>(1), n + twice, n + twice + Wide<2>(1)}) {
      exam.check(m.word(1), m.word(0));
    }
  }
  CHECK(exam.count() >= 1'000'000);
}

TEST_CASE("root: the reciprocal of a root is off by less than 2^-44 of it", "[number]") {
  Random random(20261131);
  const auto is_close = [](std::uint64_t a) {
    // 2^188 / a (1 - 2^-43) < r^2 < 2^188 / a (1 + 2^-43); its ends are within the bound.
    const BigInteger r = detail::reciprocal_root(a), squared = r * r * a;
    return abs(squared - power_of_two(188)) < power_of_two(188 - 43);
  };
  int wrong = 0;
  for (std::uint64_t chord = 64; chord < 256; ++chord) {  // both ends, and between
    const std::uint64_t first = chord << 56, last = first + ((std::uint64_t{1} << 56) - 1);
    for (int i = 0; i < 300; ++i) {
      if (!is_close(first + (random.next() >> 8))) ++wrong;
    }
    if (!is_close(first) || !is_close(last)) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("root: the first guess of a reciprocal root is within 2^-16") {
  constexpr std::uint64_t first = 63 << 12, end = 256 << 12;
  CHECK(detail::has_reciprocal_root_chord(first));
  CHECK(detail::has_reciprocal_root_chord(end - 1));
  CHECK_FALSE(detail::has_reciprocal_root_chord(first - 1));
  CHECK_FALSE(detail::has_reciprocal_root_chord(end));
  double greatest = 0;
  for (std::uint64_t t = first; t < end; ++t) {
    const double guess = std::ldexp(detail::reciprocal_root_chord(t), -30);
    for (const std::uint64_t end_of_step : {t, t + 1}) {
      const double root = std::sqrt(std::ldexp(static_cast<double>(end_of_step), -20));
      greatest = std::max(greatest, std::abs(guess * root - 1));
    }
  }
  CHECK(greatest < 1.0 / 65536);
  CHECK(greatest > 0.8 / 65536);
}
