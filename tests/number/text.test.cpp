// SPDX-License-Identifier: MIT
#include "detent/number/text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "detent/number/literals.hpp"
#include "detent/number/rounding.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::literals;
using namespace detent::test;

namespace {

constexpr q16_16 raw(std::int32_t bits) { return q16_16::from_raw(bits); }

template <class F>
constexpr bool text_is(const F& x, std::string_view expected) {
  std::array<char, max_text_length<F>> text{};
  const char* end = to_chars(text.data(), text.data() + text.size(), x);
  return end != nullptr &&
         std::string_view(text.data(), static_cast<std::size_t>(end - text.data())) == expected;
}

constexpr bool refuses(std::string_view text) { return !q16_16::parse(text); }

constexpr bool parses(std::string_view text, std::int32_t bits) {
  const std::optional<q16_16> value = q16_16::parse(text);
  return value && value->raw() == bits;
}

static_assert(parses("0", 0) && parses("-0", 0) && parses("+0.000", 0) && parses("-.0e7", 0));
static_assert(parses("1", 65536) && parses("1.25", 81920) && parses("-1.25", -81920));
static_assert(parses(".5", 32768) && parses("5.", 5 * 65536) && parses("+5", 5 * 65536));
static_assert(parses("00012.5", 12 * 65536 + 32768));
static_assert(parses("125e-2", 81920) && parses("0.0125E+2", 81920) && parses("12500.e-4", 81920));
static_assert(parses("1e0", 65536) && parses("1e-0", 65536) &&
              parses("1e0000000000000000001", 655360));
static_assert(parses("32767.9999847412109375", std::numeric_limits<std::int32_t>::max()));
static_assert(parses("-32768", std::numeric_limits<std::int32_t>::min()));

// Ties to even, in both directions and signs; the smallest change next to a tie decides.
static_assert(parses("0.00000762939453125", 0) && parses("0.00002288818359375", 2));
static_assert(parses("-0.00000762939453125", 0) && parses("-0.00002288818359375", -2));
static_assert(parses("0.000007629394531250000000000000000000000000000000000000001", 1));
static_assert(parses("0.000022888183593749999999999999999999999999999999999999999", 1));

// The range is checked after rounding: the last tie goes to the even neighbour, which is outside.
static_assert(parses("32767.99999237060546874999", std::numeric_limits<std::int32_t>::max()));
static_assert(refuses("32767.99999237060546875") && refuses("32768") && refuses("99999999999999"));
static_assert(parses("-32768.00000762939453125", std::numeric_limits<std::int32_t>::min()));
static_assert(refuses("-32768.000007629394531250001") && refuses("-32769"));

// Exponents far out of range of any number.
static_assert(parses("1e-99999999999", 0) && parses("-1e-99999999999999999999999999999", 0));
static_assert(refuses("1e99999999999") && refuses("-1e99999999999999999999999999999999999999"));
static_assert(parses("0e99999999999999999999999999", 0) && parses("0.000e-9999999999999999999", 0));
static_assert(parses("1e-9223372036854775808", 0) && refuses("1e9223372036854775807"));
static_assert(parses("0.00000000000000000000000000000000000000000001e44", 65536));
static_assert(parses("100000000000000000000000000000000000000000000e-44", 65536));

static_assert(refuses("") && refuses("+") && refuses("-") && refuses(".") && refuses("-."));
static_assert(refuses("e5") && refuses(".e5") && refuses("1e") && refuses("1e+") && refuses("1e-"));
static_assert(refuses("1e5.") && refuses("1e1e1") && refuses("1.2.3") && refuses("..5"));
static_assert(refuses("--1") && refuses("+-1") && refuses("1-") && refuses("1+1"));
static_assert(refuses(" 1") && refuses("1 ") && refuses("1\n") && refuses("1 000") &&
              refuses("1,5"));
static_assert(refuses("0x10") && refuses("1f") && refuses("1_000") && refuses("1'000"));
static_assert(refuses("inf") && refuses("nan") && refuses("-inf") && refuses("NaN"));
static_assert(refuses(std::string_view("1\0", 2)) && refuses(std::string_view("\0", 1)));
static_assert(refuses("\xef\xbc\x91") && refuses("\xe2\x88\x92"
                                                 "1"),
              "ASCII only");

static_assert(text_is(raw(0), "0") && text_is(raw(65536), "1") && text_is(raw(-32768), "-0.5"));
static_assert(text_is(raw(-1), "-0.0000152587890625") && text_is(raw(1), "0.0000152587890625"));
static_assert(text_is(q16_16::max(), "32767.9999847412109375") &&
              text_is(q16_16::lowest(), "-32768"));
static_assert(text_is(raw(655360), "10") && text_is(raw(655360 + 6554), "10.100006103515625"));
static_assert(text_is(q8_8::lowest(), "-128") && text_is(q8_8::max(), "127.99609375"));
static_assert(text_is(Fixed<14, 14>(-1), "-1") && text_is(Fixed<31, 0>::max(), "2147483647"));
static_assert(text_is(-q14_16::lowest(), "8192"), "a result beyond max() is written too");
static_assert(text_is(Fixed<15, 30>::from_raw(-1), "-0.000000000931322574615478515625"));

// The length bound is attained: the number closest to lowest() has both parts at full length.
static_assert(max_text_length<q16_16> == 23 &&
              text_is(raw(-2147483647), "-32767.9999847412109375"));
static_assert(max_text_length<q8_8> == 13 && text_is(q8_8::from_raw(-32767), "-127.99609375"));
static_assert(max_text_length<Fixed<31, 0>> == 11 &&
              text_is(Fixed<31, 0>::lowest(), "-2147483648"));

static_assert(1.25_q16_16 == raw(81920) && 0_q16_16 == raw(0) && .5_q16_16 == raw(32768));
static_assert(5._q16_16 == raw(5 * 65536) && 125e-2_q16_16 == raw(81920));
static_assert(32'767.999'984_q16_16 == q16_16::max() && -1.25_q16_16 == raw(-81920));
static_assert(8191.5_q14_16 == q14_16(8191) + 0.5_q14_16 && 8388607.996_q24_8 == q24_8::max());
static_assert(127.5_q8_8 == q8_8::from_raw(32640) && 1e2_q8_8 == q8_8(100));
static_assert(std::is_same_v<std::remove_cvref_t<decltype(1_q14_16)>, q14_16> &&
              std::is_same_v<std::remove_cvref_t<decltype(1_q24_8)>, q24_8>);

// A minus sign keeps the type of a literal, so that it reaches lowest(); for other values it
// widens.
template <class Literal, class Negative>
inline constexpr bool keeps_type = std::is_same_v<std::remove_cv_t<Literal>, Negative>;
static_assert(keeps_type<decltype(2_q16_16), decltype(-2_q16_16)> &&
              keeps_type<decltype(2_q14_16), decltype(-2_q14_16)> &&
              keeps_type<decltype(2_q24_8), decltype(-2_q24_8)> &&
              keeps_type<decltype(2_q8_8), decltype(-2_q8_8)> &&
              keeps_type<decltype(2_q16_16), decltype(-(2_q16_16))>);
static_assert(-32768_q16_16 == q16_16::lowest() && -8192_q14_16 == q14_16::lowest() &&
              -8'388'608_q24_8 == q24_8::lowest() && -128_q8_8 == q8_8::lowest());
static_assert(std::is_same_v<decltype(-32768_q16_16), q16_16> && -32768.0_q16_16 == -32768 &&
              -32767.999999_q16_16 == q16_16::lowest() && -3.2768e4_q16_16 == q16_16::lowest());
static_assert(std::is_same_v<decltype(-q16_16(2)), Fixed<32, 16>> &&
              std::is_same_v<decltype(-std::declval<q16_16&>()), Fixed<32, 16>> &&
              std::is_same_v<decltype(-std::declval<const q16_16&>()), Fixed<32, 16>> &&
              std::is_same_v<decltype(-(-2_q16_16)), Fixed<32, 16>> && -(-2_q16_16) == 2);

// Literals behave like other numbers wherever a type is deduced from them.
static_assert([] {
  struct Point {
    q16_16 x, y;
  };
  const Point point{-10_q16_16, 0.5_q16_16};
  q16_16 sum = -0.25_q16_16;
  auto copy = 1.5_q16_16;  // not const
  copy += sum;
  const std::array values{-1_q16_16, 2_q16_16, copy};
  const std::optional<q16_16> maybe = -1_q16_16;
  const std::optional deduced{3_q16_16};
  const std::tuple tuple{-1_q16_16, 1_q16_16};
  sum = 2_q16_16;
  sum = copy > 1 ? point.y : -1_q16_16;
  const auto negative = [](auto x) { return -x; };
  return std::is_same_v<decltype(values), const std::array<q16_16, 3>> &&
         std::is_same_v<decltype(deduced), const std::optional<q16_16>> &&
         std::is_same_v<decltype(tuple), const std::tuple<q16_16, q16_16>> &&
         std::is_same_v<decltype(negative(1_q16_16)), Fixed<32, 16>> && point.x == -10 &&
         *maybe == -1 && sum == point.y && std::max(copy, 1_q16_16) == 1.25_q16_16 &&
         std::clamp(copy, -1_q16_16, 1_q16_16) == 1 && abs(-3_q16_16) == 3 &&
         square(-3_q16_16) == 9 && 1.5_q16_16 * copy == 1.875_q16_16 && -1_q16_16 < 1_q8_8;
}());

/// A decimal text and the exact number it denotes.
struct Sample {
  std::string text;
  BigRational value;
};

BigInteger power_of_ten(unsigned exponent) { return pow(BigInteger(10), exponent); }

/// digits * 10^-decimals, written with a random decimal point and exponent.
Sample spell(Random& random, const BigInteger& magnitude, unsigned decimals, bool negative) {
  std::string digits = magnitude.str();
  const auto exponent = static_cast<int>(random.one_in(2) ? 0 : random.between(-40, 40));
  // The point goes `decimals + exponent` digits from the right.
  const int places = static_cast<int>(decimals) + exponent;
  if (places <= 0) {
    digits += std::string(static_cast<std::size_t>(-places), '0');
    if (random.one_in(3)) digits += ".";
  } else {
    const auto width = static_cast<std::size_t>(places) + (random.one_in(3) ? 0u : 1u);
    if (digits.size() < width) digits.insert(0, width - digits.size(), '0');
    digits.insert(digits.size() - static_cast<std::size_t>(places), ".");
    if (random.one_in(4)) digits += "000";
  }
  if (random.one_in(5)) digits.insert(0, "00");
  std::string text = (negative ? "-" : random.one_in(5) ? "+" : "") + digits;
  if (exponent != 0) {
    text += random.coin() ? "e" : "E";
    if (exponent > 0 && random.coin()) text += "+";
    text += std::to_string(exponent);
  }
  const BigRational value(magnitude, power_of_ten(decimals));
  return {text, negative ? BigRational(-value) : value};
}

/// The raw integer of the nearest F, or nothing when it is out of range.
template <class F>
std::optional<BigInteger> nearest_in_range(const BigRational& value) {
  const BigInteger nearest = nearest_of(value * power_of_two(F::frac));
  if (nearest > big_raw(F::max()) || nearest < big_raw(F::lowest())) return std::nullopt;
  return nearest;
}

}  // namespace

TEMPLATE_TEST_CASE("text: a random decimal gives the nearest number", "[number]", q8_8, q14_16,
                   q16_16, q24_8, (Fixed<14, 14>), (Fixed<30, 30>), (Fixed<31, 0>), (Fixed<20, 29>),
                   (Fixed<63, 32>), (Fixed<62, 60>), (Fixed<63, 63>), (Fixed<100, 32>),
                   (Fixed<127, 63>), (Fixed<200, 90>), (Fixed<255, 130>), (Fixed<300, 0>)) {
  using F = TestType;
  Random random(0x7e87);
  INFO(random);
  HitRate in_range;
  for (int i = 0; i < 20'000; ++i) {
    // A multiple of half a step (so ties are frequent), plus something far below it.
    const BigInteger half_steps = big(random_wide<5>(random) >> (319 - F::bits - 2));
    const auto decimals = static_cast<unsigned>(F::frac + 1);
    BigInteger magnitude = abs(half_steps) * pow(BigInteger(5), decimals);
    unsigned extra = 0;
    switch (random.below(4)) {
      case 0:
        break;
      case 1:  // next to a tie, at a far digit
        extra = 1 + static_cast<unsigned>(random.below(60));
        magnitude = magnitude * power_of_ten(extra) + random.between(-2, 2);
        break;
      case 2:  // any digits
        magnitude = magnitude * power_of_ten(20) + random.next();
        extra = 20;
        break;
      default:  // few digits
        magnitude = abs(half_steps) % power_of_ten(static_cast<unsigned>(random.below(12)));
        extra = static_cast<unsigned>(random.below(8)) - decimals;
        break;
    }
    if (magnitude < 0) magnitude = -magnitude;
    const Sample sample = spell(random, magnitude, decimals + extra, half_steps < 0);
    const std::optional<BigInteger> expected = nearest_in_range<F>(sample.value);
    const std::optional<F> parsed = F::parse(sample.text);
    const bool right = parsed ? expected && big_raw(*parsed) == *expected : !expected;
    if (!right) FAIL(sample.text);
    in_range.count(parsed.has_value());
  }
  INFO(in_range);
  CHECK(in_range.percent() >= 30);
  CHECK(in_range.percent() < 100);
}

TEMPLATE_TEST_CASE("text: output is exact and shortest, and reads back", "[number]", q8_8, q14_16,
                   q16_16, q24_8, (Fixed<14, 14>), (Fixed<30, 30>), (Fixed<31, 0>), (Fixed<1, 40>),
                   (Fixed<63, 32>), (Fixed<62, 60>), (Fixed<63, 63>), (Fixed<64, 32>),
                   (Fixed<127, 64>), (Fixed<200, 90>), (Fixed<319, 319>)) {
  using F = TestType;
  Random random(0x7e88);
  INFO(random);
  for (int i = 0; i < 20'000; ++i) {
    const F x = i == 0   ? F::lowest()
                : i == 1 ? F::max()
                         : F::from_raw(random_fixed<F>(random).raw());
    const std::string text = to_string(x);
    const std::optional<F> back = F::parse(text);

    const bool negative = text.front() == '-';
    const std::string magnitude = text.substr(negative ? 1 : 0);
    const auto point = magnitude.find('.');
    const std::string whole = magnitude.substr(0, point);
    const std::string fraction = point == std::string::npos ? "" : magnitude.substr(point + 1);
    const bool shortest = text.size() <= max_text_length<F> &&
                          magnitude.find_first_not_of(".0123456789") == std::string::npos &&
                          (whole == "0" || (!whole.empty() && whole.front() != '0')) &&
                          (point == std::string::npos || !fraction.empty()) &&
                          (fraction.empty() || fraction.back() != '0');
    // Read as an integer after a 1, so that leading zeros do not mean octal.
    const auto digits = static_cast<unsigned>(whole.size() + fraction.size());
    const BigInteger units = BigInteger("1" + whole + fraction) - power_of_ten(digits);
    const BigRational value(negative ? BigInteger(-units) : units,
                            power_of_ten(static_cast<unsigned>(fraction.size())));
    if (!shortest || value != rational(x) || negative != (x < 0)) FAIL(text);
    if (!back || back->raw() != x.raw()) FAIL(text << " read back");
  }
}

TEST_CASE("text: every q8_8 is written and read back", "[number]") {
  for (int bits = -32768; bits <= 32767; ++bits) {
    const q8_8 x = q8_8::from_raw(static_cast<std::int16_t>(bits));
    if (q8_8::parse(to_string(x)) != x) FAIL(bits);
  }
}

TEST_CASE("text: a digit thousands of places away breaks a tie", "[number]") {
  const std::string tie = "0.00000762939453125";
  const std::string zeros(5'000, '0');
  CHECK(q16_16::parse(tie + zeros) == raw(0));
  CHECK(q16_16::parse(tie + zeros + "1") == raw(1));
  CHECK(q16_16::parse("-" + tie + zeros + "1") == raw(-1));
  CHECK(q16_16::parse(tie + zeros + "1" + zeros + "e-0") == raw(1));
  const std::string below = "0.00002288818359374";
  CHECK(q16_16::parse(below + std::string(5'000, '9')) == raw(1));
  CHECK(q16_16::parse("0.00002288818359375" + zeros) == raw(2));
  // The same numbers, with the opposite sign of the exponent.
  CHECK(q16_16::parse("762939453125" + zeros + "1e-5018") == raw(1));
  CHECK(q16_16::parse("762939453125" + zeros + "0e-5018") == raw(0));
  CHECK(q16_16::parse("0." + zeros + "762939453125e4995") == raw(0));
  CHECK(q16_16::parse("0." + zeros + "762939453125000000001e4995") == raw(1));
}

TEST_CASE("text: long texts are read in one pass", "[number]") {
  const std::string zeros(1'000'000, '0'), nines(1'000'000, '9');
  CHECK(q16_16::parse(zeros + "1" + "." + zeros) == raw(65536));
  CHECK(q16_16::parse("1" + zeros + "e-1000000") == raw(65536));
  CHECK(q16_16::parse("0." + zeros + "1e1000001") == raw(65536));
  CHECK(q16_16::parse("0." + nines) == raw(65536));
  CHECK(q16_16::parse("-0." + nines) == raw(-65536));
  CHECK_FALSE(q16_16::parse(nines));
  CHECK_FALSE(q16_16::parse(nines + "x"));
  CHECK(q16_16::parse("1e-" + nines) == raw(0));
  CHECK_FALSE(q16_16::parse("1e+" + nines));
  CHECK(q16_16::parse(nines + "e-" + nines) == raw(0));
  CHECK(q16_16::parse("1e" + zeros) == raw(65536));
}

TEST_CASE("text: any bytes are read safely", "[number]") {
  // Copies of exact size, so that a sanitizer detects a read past the end.
  static constexpr std::string_view alphabet = "0123456789.eE+-05 x\0\xff";
  Random random(0x7e89);
  INFO(random);
  int accepted = 0;
  for (int i = 0; i < 300'000; ++i) {
    const std::size_t length = random.below(random.one_in(20) ? 200 : 9);
    const auto text = std::make_unique<char[]>(length);
    for (std::size_t k = 0; k < length; ++k) {
      text[k] = random.one_in(100) ? static_cast<char>(random.next())
                                   : alphabet[random.below(random.coin() ? 12 : alphabet.size())];
    }
    const std::string_view view(text.get(), length);
    const auto wide = Fixed<255, 100>::parse(view);
    const auto narrow_one = q8_8::parse(view);
    accepted += wide.has_value() ? 1 : 0;
    if (narrow_one && !wide) FAIL("one grammar for all types: " << std::string(view));
  }
  CHECK(accepted > 10'000);
}

TEST_CASE("text: a buffer that is too short is unchanged", "[number]") {
  for (std::size_t size = 0; size <= max_text_length<q16_16>; ++size) {
    const auto text = std::make_unique<char[]>(size);
    for (std::size_t i = 0; i < size; ++i) text[i] = '#';
    char* const end = to_chars(text.get(), text.get() + size, q16_16::from_raw(-2147483647));
    INFO(size);
    if (size == max_text_length<q16_16>) {
      CHECK(end == text.get() + size);
    } else {
      CHECK(end == nullptr);
      for (std::size_t i = 0; i < size; ++i) REQUIRE(text[i] == '#');
    }
  }
}

TEST_CASE("text: streams write the same text with their width and fill", "[number]") {
  std::ostringstream out;
  out << 1.25_q16_16 << ' ' << q8_8::lowest() << ' ' << std::setw(6) << std::setfill('*')
      << 0.5_q24_8 << ' ' << std::left << std::setw(4) << 1_q14_16;
  CHECK(out.str() == "1.25 -128 ***0.5 1***");
}

TEST_CASE("text: the length bound is the length of the longest number", "[number]") {
  const auto digits_of_power = [](int exponent) { return power_of_two(exponent).str().size(); };
  for (int exponent = 0; exponent <= widest_bits; ++exponent) {
    // The formula of max_text_length for the digits of 2^exponent.
    CHECK(static_cast<std::size_t>(exponent * 30103 / 100000 + 1) == digits_of_power(exponent));
  }
}
