// SPDX-License-Identifier: MIT
#include "oracle/rational.hpp"

#include <memory>
#include <type_traits>
#include <utility>

#include "oracle/boost_integer.hpp"
#include "oracle/hidden_number.hpp"

namespace detent::oracle {

using Number = boost::multiprecision::number<
    boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
    boost::multiprecision::et_off>;

using Hidden = HiddenNumber<Rational, Number>;

namespace {

template <class Fraction>
auto& number(Fraction& x) {
  return Hidden::of(x);
}

}  // namespace

Rational::Rational(const LongInteger& value) { Hidden::make(*this, boost_integer(value)); }
Rational::Rational(const Rational& other) { Hidden::make(*this, number(other)); }
Rational::Rational(Rational&& other) noexcept { Hidden::make(*this, std::move(number(other))); }
Rational::~Rational() { std::destroy_at(&number(*this)); }
Rational& Rational::operator=(const Rational& other) {
  number(*this) = number(other);
  return *this;
}
Rational& Rational::operator=(Rational&& other) noexcept {
  number(*this) = std::move(number(other));
  return *this;
}

int Rational::sign() const { return number(*this).sign(); }
std::string Rational::str() const { return number(*this).str(); }

Rational& Rational::operator+=(const Rational& b) {
  number(*this) += number(b);
  return *this;
}
Rational& Rational::operator-=(const Rational& b) {
  number(*this) -= number(b);
  return *this;
}
Rational& Rational::operator*=(const Rational& b) {
  number(*this) *= number(b);
  return *this;
}
Rational& Rational::operator/=(const Rational& b) {
  number(*this) /= number(b);
  return *this;
}

bool operator==(const Rational& a, const Rational& b) { return number(a) == number(b); }
std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  return number(a).compare(number(b)) <=> 0;
}

}  // namespace detent::oracle
