// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>

#include "oracle/long_integer.hpp"

namespace detent::oracle {

/// A fraction of integers of any length: Boost's, compiled once like LongInteger.
class Rational {
 public:
  Rational() : Rational(LongInteger()) {}
  Rational(std::integral auto value) : Rational(LongInteger(value)) {}
  Rational(const LongInteger& value);
  Rational(std::int64_t over, std::int64_t under) : Rational(over) { *this /= Rational(under); }
  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  ~Rational();
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;

  [[nodiscard]] bool is_zero() const { return sign() == 0; }
  [[nodiscard]] int sign() const;
  [[nodiscard]] std::string str() const;

  Rational& operator+=(const Rational& b);
  Rational& operator-=(const Rational& b);
  Rational& operator*=(const Rational& b);
  Rational& operator/=(const Rational& b);

  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend Rational operator-(const Rational& a) { return 0 - a; }
  friend Rational abs(const Rational& a) { return a.sign() < 0 ? -a : a; }

  friend bool operator==(const Rational& a, const Rational& b);
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

 private:
  template <class Owner, class Number>
  friend struct HiddenNumber;
  alignas(16) std::array<std::byte, 64> number_;
};

}  // namespace detent::oracle
