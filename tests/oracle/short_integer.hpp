// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>

namespace detent::oracle {

/// A 128-bit integer for the oracles of small worlds: checked, so an overflow throws, and much
/// faster than one of 512 bits.
class ShortInteger {
  __extension__ using Value = __int128;

 public:
  constexpr ShortInteger() = default;
  constexpr ShortInteger(std::int64_t value) : value_(value) {}

  explicit constexpr operator std::int64_t() const { return static_cast<std::int64_t>(value_); }

  [[nodiscard]] constexpr bool is_zero() const { return value_ == 0; }
  [[nodiscard]] constexpr int sign() const { return (value_ > 0) - (value_ < 0); }
  [[nodiscard]] std::string str() const {
    std::string digits;
    Value rest = value_;
    do {
      digits += static_cast<char>('0' + static_cast<int>(rest < 0 ? -(rest % 10) : rest % 10));
      rest /= 10;
    } while (rest != 0);
    if (value_ < 0) digits += '-';
    return {digits.rbegin(), digits.rend()};
  }
  friend std::ostream& operator<<(std::ostream& out, const ShortInteger& x) {
    return out << x.str();
  }

  friend constexpr ShortInteger operator+(const ShortInteger& a, const ShortInteger& b) {
    ShortInteger sum;
    if (__builtin_add_overflow(a.value_, b.value_, &sum.value_)) overflow();
    return sum;
  }
  friend constexpr ShortInteger operator-(const ShortInteger& a, const ShortInteger& b) {
    ShortInteger difference;
    if (__builtin_sub_overflow(a.value_, b.value_, &difference.value_)) overflow();
    return difference;
  }
  friend constexpr ShortInteger operator*(const ShortInteger& a, const ShortInteger& b) {
    ShortInteger product;
    if (__builtin_mul_overflow(a.value_, b.value_, &product.value_)) overflow();
    return product;
  }
  friend constexpr ShortInteger operator/(const ShortInteger& a, const ShortInteger& b) {
    ShortInteger quotient;
    quotient.value_ = a.value_ / b.value_;
    return quotient;
  }
  friend constexpr ShortInteger operator%(const ShortInteger& a, const ShortInteger& b) {
    ShortInteger rest;
    rest.value_ = a.value_ % b.value_;
    return rest;
  }
  friend constexpr ShortInteger operator<<(const ShortInteger& a, unsigned count) {
    ShortInteger power;
    power.value_ = Value{1} << std::min(count, 126u);
    if (count > 126) overflow();
    return a * power;
  }
  constexpr ShortInteger operator-() const { return ShortInteger() - *this; }
  constexpr ShortInteger& operator+=(const ShortInteger& b) { return *this = *this + b; }
  constexpr ShortInteger& operator-=(const ShortInteger& b) { return *this = *this - b; }
  constexpr ShortInteger& operator*=(const ShortInteger& b) { return *this = *this * b; }
  constexpr ShortInteger& operator--() { return *this -= 1; }
  constexpr ShortInteger& operator++() { return *this += 1; }

  /// The least common multiple of positive numbers.
  friend constexpr ShortInteger lcm(const ShortInteger& a, const ShortInteger& b) {
    ShortInteger x = a, y = b;
    while (!y.is_zero()) {
      const ShortInteger rest = x % y;
      x = y;
      y = rest;
    }
    return a / x * b;
  }

  friend constexpr bool operator==(const ShortInteger& a, const ShortInteger& b) = default;
  friend constexpr auto operator<=>(const ShortInteger& a, const ShortInteger& b) = default;

 private:
  [[noreturn]] static void overflow() { throw std::overflow_error("oracle: 128 bits do not do"); }

  Value value_ = 0;
};

}  // namespace detent::oracle
