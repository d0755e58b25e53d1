// SPDX-License-Identifier: MIT
#include "oracle/long_integer.hpp"

#include <memory>
#include <ostream>
#include <type_traits>
#include <utility>

#include "oracle/boost_integer.hpp"
#include "oracle/hidden_number.hpp"

namespace detent::oracle {

using Number = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::checked,
                                           std::allocator<boost::multiprecision::limb_type>>,
    boost::multiprecision::et_off>;
static_assert(std::is_nothrow_move_constructible_v<Number> &&
              std::is_nothrow_move_assignable_v<Number>);

using Hidden = HiddenNumber<LongInteger, Number>;

namespace {

template <class Integer>
auto& number(Integer& x) {
  return Hidden::of(x);
}

}  // namespace

LongInteger::LongInteger(Signed value) noexcept { Hidden::make(*this, value.value); }
LongInteger::LongInteger(Unsigned value) noexcept { Hidden::make(*this, value.value); }
LongInteger::LongInteger(const char* digits) { Hidden::make(*this, digits); }
LongInteger::LongInteger(const LongInteger& other) { Hidden::make(*this, number(other)); }
LongInteger::LongInteger(LongInteger&& other) noexcept {
  Hidden::make(*this, std::move(number(other)));
}
LongInteger::~LongInteger() { std::destroy_at(&number(*this)); }
LongInteger& LongInteger::operator=(const LongInteger& other) {
  number(*this) = number(other);
  return *this;
}
LongInteger& LongInteger::operator=(LongInteger&& other) noexcept {
  number(*this) = std::move(number(other));
  return *this;
}

LongInteger::operator std::int64_t() const { return static_cast<std::int64_t>(number(*this)); }
LongInteger::operator int() const { return static_cast<int>(number(*this)); }
LongInteger::operator double() const {
  // Boost scales and adds all words, which takes most programs that convert longer than the rest.
  const auto& words = number(*this).backend();
  if (words.size() > 1) return static_cast<double>(number(*this));
  const auto magnitude = static_cast<double>(*words.limbs());
  return words.sign() ? -magnitude : magnitude;
}

int LongInteger::sign() const { return number(*this).sign(); }
std::string LongInteger::str() const { return number(*this).str(); }
std::ostream& operator<<(std::ostream& out, const LongInteger& x) { return out << x.str(); }

LongInteger& LongInteger::operator+=(const LongInteger& b) {
  number(*this) += number(b);
  return *this;
}
LongInteger& LongInteger::operator-=(const LongInteger& b) {
  number(*this) -= number(b);
  return *this;
}
LongInteger& LongInteger::operator*=(const LongInteger& b) {
  number(*this) *= number(b);
  return *this;
}
LongInteger& LongInteger::operator/=(const LongInteger& b) {
  number(*this) /= number(b);
  return *this;
}
LongInteger& LongInteger::operator%=(const LongInteger& b) {
  number(*this) %= number(b);
  return *this;
}
LongInteger& LongInteger::operator<<=(unsigned count) {
  number(*this) <<= count;
  return *this;
}
LongInteger& LongInteger::operator>>=(unsigned count) {
  number(*this) >>= count;
  return *this;
}

LongInteger operator+(const LongInteger& a, const LongInteger& b) {
  LongInteger sum = a;
  number(sum) += number(b);
  return sum;
}
LongInteger operator-(const LongInteger& a, const LongInteger& b) {
  LongInteger difference = a;
  number(difference) -= number(b);
  return difference;
}
LongInteger operator*(const LongInteger& a, const LongInteger& b) {
  LongInteger product;
  number(product) = number(a) * number(b);
  return product;
}
LongInteger operator/(const LongInteger& a, const LongInteger& b) {
  LongInteger quotient = a;
  number(quotient) /= number(b);
  return quotient;
}
LongInteger operator%(const LongInteger& a, const LongInteger& b) {
  LongInteger rest = a;
  number(rest) %= number(b);
  return rest;
}
LongInteger operator<<(const LongInteger& a, unsigned count) {
  LongInteger power = a;
  number(power) <<= count;
  return power;
}
LongInteger operator>>(const LongInteger& a, unsigned count) {
  LongInteger rest = a;
  number(rest) >>= count;
  return rest;
}
LongInteger operator-(const LongInteger& a) {
  LongInteger negative = a;
  number(negative).backend().negate();
  return negative;
}
LongInteger abs(const LongInteger& a) { return a.sign() < 0 ? -a : a; }
LongInteger sqrt(const LongInteger& a) {
  LongInteger root;
  number(root) = sqrt(number(a));
  return root;
}
LongInteger gcd(const LongInteger& a, const LongInteger& b) {
  LongInteger result;
  number(result) = gcd(number(a), number(b));
  return result;
}
LongInteger lcm(const LongInteger& a, const LongInteger& b) {
  LongInteger result;
  number(result) = lcm(number(a), number(b));
  return result;
}

bool operator==(const LongInteger& a, const LongInteger& b) { return number(a) == number(b); }
std::strong_ordering operator<=>(const LongInteger& a, const LongInteger& b) {
  return number(a).compare(number(b)) <=> 0;
}

boost::multiprecision::cpp_int boost_integer(const LongInteger& x) {
  return boost::multiprecision::cpp_int(number(x));
}
LongInteger long_integer(const boost::multiprecision::cpp_int& x) {
  LongInteger result;
  number(result) = Number(x);
  return result;
}

}  // namespace detent::oracle
