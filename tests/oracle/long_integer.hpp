// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>

namespace detent::oracle {

/// An integer of any length, up to 512 bits without the heap: Boost's, compiled once in
/// long_integer.cpp, because its templates take most of the time to compile an oracle.
class LongInteger {
 public:
  LongInteger() noexcept : LongInteger(std::int64_t{0}) {}
  LongInteger(std::signed_integral auto value) noexcept
      : LongInteger(Signed{static_cast<std::int64_t>(value)}) {
    static_assert(sizeof(value) <= sizeof(std::int64_t));
  }
  LongInteger(std::unsigned_integral auto value) noexcept
      : LongInteger(Unsigned{static_cast<std::uint64_t>(value)}) {
    static_assert(sizeof(value) <= sizeof(std::uint64_t));
  }
  explicit LongInteger(const char* digits);
  LongInteger(const LongInteger& other);
  LongInteger(LongInteger&& other) noexcept;
  ~LongInteger();
  LongInteger& operator=(const LongInteger& other);
  LongInteger& operator=(LongInteger&& other) noexcept;

  /// These throw std::range_error if the value does not fit.
  explicit operator std::int64_t() const;
  explicit operator int() const;
  explicit operator double() const;

  [[nodiscard]] bool is_zero() const { return sign() == 0; }
  [[nodiscard]] int sign() const;
  [[nodiscard]] std::string str() const;
  friend std::ostream& operator<<(std::ostream& out, const LongInteger& x);

  LongInteger& operator+=(const LongInteger& b);
  LongInteger& operator-=(const LongInteger& b);
  LongInteger& operator*=(const LongInteger& b);
  /// The quotient is rounded towards zero.
  LongInteger& operator/=(const LongInteger& b);
  LongInteger& operator%=(const LongInteger& b);
  LongInteger& operator<<=(unsigned count);
  LongInteger& operator>>=(unsigned count);
  LongInteger& operator++() { return *this += 1; }
  LongInteger& operator--() { return *this -= 1; }

  friend LongInteger operator+(const LongInteger& a, const LongInteger& b);
  friend LongInteger operator-(const LongInteger& a, const LongInteger& b);
  friend LongInteger operator*(const LongInteger& a, const LongInteger& b);
  friend LongInteger operator/(const LongInteger& a, const LongInteger& b);
  friend LongInteger operator%(const LongInteger& a, const LongInteger& b);
  friend LongInteger operator<<(const LongInteger& a, unsigned count);
  friend LongInteger operator>>(const LongInteger& a, unsigned count);
  friend LongInteger operator-(const LongInteger& a);
  friend LongInteger abs(const LongInteger& a);
  /// The root, rounded down.
  friend LongInteger sqrt(const LongInteger& a);
  friend LongInteger gcd(const LongInteger& a, const LongInteger& b);
  /// The least common multiple.
  friend LongInteger lcm(const LongInteger& a, const LongInteger& b);

  friend bool operator==(const LongInteger& a, const LongInteger& b);
  friend std::strong_ordering operator<=>(const LongInteger& a, const LongInteger& b);

 private:
  struct Signed {
    std::int64_t value;
  };
  struct Unsigned {
    std::uint64_t value;
  };
  explicit LongInteger(Signed value) noexcept;
  explicit LongInteger(Unsigned value) noexcept;

  template <class Owner, class Number>
  friend struct HiddenNumber;
  alignas(16) std::array<std::byte, 80> number_;
};

}  // namespace detent::oracle
