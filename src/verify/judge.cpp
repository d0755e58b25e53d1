// SPDX-License-Identifier: MIT
#include <regex>

#include "verify/judge/numbers.hpp"

namespace detent::verify::judge {

const Real& rotation_margin() {
  static const Real value("0.5001");
  return value;
}
const Real& two_pi() {
  static const Real value = 8 * atan(Real(1));
  return value;
}

Integer nearest(const Real& x) {
  return oracle::long_integer(floor(x + Real(0.5)).convert_to<boost::multiprecision::cpp_int>());
}
Real real(const Integer& x) { return Real(oracle::boost_integer(x)); }
Real steps(int frac) { return ldexp(Real(1), frac); }
std::uint32_t wrapped(const Integer& units) {
  const Integer turn = Integer(1) << 32;
  const Integer whole = oracle::floor_quotient(units, turn);
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(units - whole * turn));
}

std::optional<Integer> meaning(const std::string& text, int frac) {
  static const std::regex decimal(R"(([+-]?)(\d*)(?:\.(\d*))?(?:[eE]([+-]?\d+))?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, decimal)) return std::nullopt;
  const std::string whole = parts[2], fraction = parts[3];
  if (whole.empty() && fraction.empty()) return std::nullopt;
  Integer over = 0;
  for (const char digit : whole + fraction) over = over * 10 + (digit - '0');
  Integer under = 1;
  const int exponent =
      (parts[4].length() > 0 ? std::stoi(parts[4]) : 0) - static_cast<int>(fraction.size());
  for (int i = 0; i < exponent; ++i) over *= 10;
  for (int i = 0; i > exponent; --i) under *= 10;
  const Integer rounded = nearest_quotient(scaled(over, frac), under);
  return parts[1] == "-" ? Integer(-rounded) : rounded;
}

std::string spelling(std::int64_t raw, int frac) {
  const auto magnitude = static_cast<std::uint64_t>(raw < 0 ? -raw : raw);
  const auto one = std::uint64_t{1} << frac;
  std::string text = (raw < 0 ? "-" : "") + std::to_string(magnitude / one);
  auto rest = magnitude % one;
  if (rest != 0) text += '.';
  for (; rest != 0; rest = rest * 10 % one) text += static_cast<char>('0' + rest * 10 / one);
  return text;
}

}  // namespace detent::verify::judge
