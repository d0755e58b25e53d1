// SPDX-License-Identifier: MIT
#include "decimal.hpp"

#include <limits>

#include "support/catch.hpp"

using detent::q16_16;
using detent::q8_8;
using detent::cli::Decimal;

namespace {

std::string read(const char* text) {
  const auto value = Decimal::parse(text);
  return value ? value->text() : "refused";
}

std::string sum(const char* a, const char* b) {
  return (Decimal::parse(a).value() + Decimal::parse(b).value()).text();
}

template <class S>
std::optional<S> as(const char* text) {
  return Decimal::parse(text).value().to<S>();
}

}  // namespace

TEST_CASE("decimal: prints without exponent or needless zeros") {
  CHECK(read("0") == "0");
  CHECK(read("-0.000") == "0");
  CHECK(read("007.50") == "7.5");
  CHECK(read("-12.5") == "-12.5");
  CHECK(read("1e3") == "1000");
  CHECK(read("1.25E+2") == "125");
  CHECK(read("-5e-3") == "-0.005");
  CHECK(read(".5") == "0.5");
  CHECK(read("123456789012345678901234567890.125") == "123456789012345678901234567890.125");
}

TEST_CASE("decimal: anything that is not one of our numbers is refused") {
  for (const char* const text : {"", "-", ".", "1x", "1e", "1e+", "e3", "1.2.3", "0x10", "nan"}) {
    CHECK(read(text) == "refused");
  }
  CHECK(read("1e1001") == "refused");
  CHECK(read("1e99999999999999999999") == "refused");
  CHECK_FALSE(Decimal::parse(std::string(1001, '1')));
  CHECK(read("1e-99999999999999999999") == "0");
  CHECK(read("0e99999999999999999999") == "0");
}

TEST_CASE("decimal: sums are exact") {
  CHECK(sum("0.1", "28000") == "28000.1");
  CHECK(sum("-0.1", "28000") == "27999.9");
  CHECK(sum("0.1", "-28000") == "-27999.9");
  CHECK(sum("1.5", "-1.5") == "0");
  CHECK(sum("999.999", "0.001") == "1000");
  CHECK(sum("1e20", "1e-20") == "100000000000000000000.00000000000000000001");
}

TEST_CASE("decimal: becomes the nearest scalar, or nothing if out of range") {
  CHECK(as<q16_16>("32767.9999847412109375") == q16_16::max());
  CHECK(as<q16_16>("-32768") == q16_16::lowest());
  CHECK_FALSE(as<q16_16>("32768"));
  CHECK(as<q8_8>("0.001953125") == q8_8(0));  // half a step: to even
  CHECK_FALSE(as<q8_8>("128"));
  CHECK(as<float>("0.1") == 0.1f);
  CHECK(as<float>("16777217") == 16777216.0f);
  CHECK_FALSE(as<float>("1e39"));
  CHECK(as<double>("1e-400") == 0.0);
  CHECK_FALSE(as<double>("1e400"));
}
