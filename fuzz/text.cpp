// SPDX-License-Identifier: MIT
//
// Printed numbers parse back to the same bits, and parsed text is the decimal's exact value rounded
// to nearest, ties to even, or is rejected for a reason.

#include <boost/multiprecision/cpp_int.hpp>
#include <string>
#include <string_view>

#include "detent/number/number.hpp"
#include "source.hpp"

namespace detent::fuzz {
namespace {

using Big = boost::multiprecision::cpp_int;

/// A decimal as digits * 10^exponent, parsed without the parser under test.
struct Decimal {
  bool negative = false;
  Big digits = 0;
  long exponent = 0;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// [+-] digits [. digits] [(e|E) [+-] digits] with a digit before the exponent; nothing otherwise.
std::optional<Decimal> read_decimal(std::string_view text) {
  Decimal result;
  bool seen_digit = false, seen_point = false;
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
    result.negative = text[0] == '-';
    text.remove_prefix(1);
  }
  while (!text.empty() && (is_digit(text[0]) || (text[0] == '.' && !seen_point))) {
    if (text[0] == '.') {
      seen_point = true;
    } else {
      seen_digit = true;
      result.digits = result.digits * 10 + (text[0] - '0');
      result.exponent -= seen_point ? 1 : 0;
    }
    text.remove_prefix(1);
  }
  if (!seen_digit) return {};
  if (text.empty()) return result;
  if (text[0] != 'e' && text[0] != 'E') return {};
  text.remove_prefix(1);
  bool negative = false;
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
    negative = text[0] == '-';
    text.remove_prefix(1);
  }
  if (text.empty()) return {};
  long exponent = 0;
  for (const char c : text) {
    if (!is_digit(c)) return {};
    exponent = std::min(exponent * 10 + (c - '0'), 2000L);  // beyond any text of this property
  }
  result.exponent += negative ? -exponent : exponent;
  return result;
}

Big power_of_ten(long exponent) { return pow(Big(10), static_cast<unsigned>(exponent)); }

/// The raw number nearest to the decimal, ties to even.
template <class T>
Big nearest(const Decimal& decimal) {
  Big over = decimal.digits << T::frac, under = 1;
  (decimal.exponent < 0 ? under : over) *= power_of_ten(std::abs(decimal.exponent));
  Big down = over / under;
  const Big twice_rest = 2 * (over - down * under);
  if (twice_rest > under || (twice_rest == under && down % 2 == 1)) ++down;
  return decimal.negative ? Big(-down) : down;
}

template <class T>
void check_parse(std::string_view text) {
  const auto because = [&] { return "parse '" + std::string(text) + "'"; };
  const auto given = T::parse(text);
  const auto decimal = read_decimal(text);
  if (!decimal) return require(!given, because);
  const Big expected = nearest<T>(*decimal);
  const bool fits = expected <= Big(T::max().raw()) && expected >= Big(T::lowest().raw());
  require(given.has_value() == fits, because);
  if (given) require(Big(given->raw()) == expected, because);
}

template <class T>
void check_round_trip(T x) {
  const auto because = [&] { return "print " + std::to_string(x.raw()); };
  const std::string text = to_string(x);
  require(text.size() <= max_text_length<T>, because);
  const auto back = T::parse(text);
  require(back && back->raw() == x.raw(), because);
  // The text is the exact decimal of x, not just one that rounds to it.
  const auto decimal = read_decimal(text);
  require(decimal.has_value() && decimal->exponent <= 0, because);
  require((decimal->digits << T::frac) == abs(Big(x.raw())) * power_of_ten(-decimal->exponent),
          because);
  // A buffer that is one too short stays unchanged.
  std::string buffer(text.size(), '?');
  require(to_chars(buffer.data(), buffer.data() + buffer.size() - 1, x) == nullptr &&
              buffer == std::string(text.size(), '?'),
          because);
}

template <class T>
void check(Source& source) {
  using Raw = typename T::raw_type;
  if (source.below(4) == 0) {
    const auto end = source.below(8);
    const auto raw = static_cast<Raw>(source.bits(T::bits));
    return check_round_trip(end == 0 ? T::lowest() : end == 1 ? T::max() : T::from_raw(raw));
  }
  // Mostly characters of numbers, otherwise any.
  constexpr std::string_view likely = "0123456789012345678905550000.eE+-";
  std::string text;
  const auto length = source.byte();
  for (const auto byte : source.rest()) {
    if (text.size() == (length < 200 ? length / 8 : length)) break;
    text.push_back(byte < 250 ? likely[byte % likely.size()] : static_cast<char>(byte));
  }
  check_parse<T>(text);
  // Values that are hard to round: halfway between two grid points, and next to that.
  const auto half = to_string(Fixed<62, T::frac + 1>::from_raw(source.bits(T::bits + 1)));
  check_parse<T>(half);
  check_parse<T>(half + (half.find('.') == std::string::npos ? ".0001" : "0001"));
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  switch (source.below(4)) {
    case 0:
      return check<q16_16>(source);
    case 1:
      return check<q14_16>(source);
    case 2:
      return check<q24_8>(source);
    default:
      return check<q8_8>(source);
  }
}

}  // namespace detent::fuzz
