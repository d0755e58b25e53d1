// SPDX-License-Identifier: MIT
#include "decimal.hpp"

#include <algorithm>
#include <utility>

namespace detent::cli {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// a + b, of digit strings of equal length.
std::string sum(std::string a, const std::string& b) {
  int carry = 0;
  for (std::size_t i = a.size(); i-- > 0;) {
    const int digit = (a[i] - '0') + (b[i] - '0') + carry;
    a[i] = static_cast<char>('0' + digit % 10);
    carry = digit / 10;
  }
  if (carry != 0) a.insert(a.begin(), '1');
  return a;
}

/// a - b, of digit strings of equal length, where a >= b.
std::string difference(std::string a, const std::string& b) {
  int borrow = 0;
  for (std::size_t i = a.size(); i-- > 0;) {
    const int digit = (a[i] - '0') - (b[i] - '0') - borrow;
    borrow = digit < 0 ? 1 : 0;
    a[i] = static_cast<char>('0' + digit + 10 * borrow);
  }
  return a;
}

/// The exponent after 'e', clamped to limits that no accepted number reaches.
std::optional<int> parse_exponent(std::string_view text) {
  const bool negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  if (text.empty() || !std::all_of(text.begin(), text.end(), is_digit)) return std::nullopt;
  int exponent = 0;
  for (const char c : text) exponent = std::min(10 * exponent + (c - '0'), 100'000);
  return negative ? -exponent : exponent;
}

}  // namespace

Decimal::Decimal(bool negative, std::string digits, int places)
    : digits_(std::move(digits)), places_(places), negative_(negative) {
  if (places_ < 0) {
    digits_.append(static_cast<std::size_t>(-places_), '0');
    places_ = 0;
  }
  digits_.erase(0, std::min(digits_.find_first_not_of('0'), digits_.size()));
  while (places_ > 0 && !digits_.empty() && digits_.back() == '0') {
    digits_.pop_back();
    --places_;
  }
  if (digits_.empty()) {
    places_ = 0;
    negative_ = false;
  }
}

std::optional<Decimal> Decimal::parse(std::string_view text) {
  if (text.size() > max_length) return std::nullopt;
  const bool negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);

  int exponent = 0;
  if (const auto e = text.find_first_of("eE"); e != std::string_view::npos) {
    const auto parsed = parse_exponent(text.substr(e + 1));
    if (!parsed) return std::nullopt;
    exponent = *parsed;
    text = text.substr(0, e);
  }

  const auto point = std::min(text.find('.'), text.size());
  std::string digits(text.substr(0, point));
  if (point < text.size()) digits += text.substr(point + 1);
  if (digits.empty() || !std::all_of(digits.begin(), digits.end(), is_digit)) return std::nullopt;

  const int places = static_cast<int>(digits.size() - std::min(point, digits.size())) - exponent;
  if (digits.find_first_not_of('0') == std::string::npos) return Decimal();
  if (places > 3 * max_length) return Decimal();
  if (places < -max_length) return std::nullopt;
  return Decimal(negative, std::move(digits), places);
}

Decimal Decimal::scaled(int power) const { return Decimal(negative_, digits_, places_ - power); }

Decimal operator+(const Decimal& a, const Decimal& b) {
  const int places = std::max(a.places_, b.places_);
  std::string x = a.digits_ + std::string(static_cast<std::size_t>(places - a.places_), '0');
  std::string y = b.digits_ + std::string(static_cast<std::size_t>(places - b.places_), '0');
  const std::size_t length = std::max(x.size(), y.size());
  x.insert(0, length - x.size(), '0');
  y.insert(0, length - y.size(), '0');
  if (a.negative_ == b.negative_) return Decimal(a.negative_, sum(x, y), places);
  return x >= y ? Decimal(a.negative_, difference(x, y), places)
                : Decimal(b.negative_, difference(y, x), places);
}

std::string Decimal::text() const {
  std::string plain = digits_;
  const auto places = static_cast<std::size_t>(places_);
  if (plain.size() <= places) plain.insert(0, places + 1 - plain.size(), '0');
  if (places > 0) plain.insert(plain.size() - places, 1, '.');
  return negative_ ? '-' + plain : plain;
}

}  // namespace detent::cli
