// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "detent/detent.hpp"

namespace detent::cli {

/// A decimal number of any length, kept as digits: never rounded, never a double.
class Decimal {
 public:
  Decimal() = default;

  /// Parses "-12.5", "1e3" or ".5E-2". Nothing when `text` is not such a number, is longer than
  /// `max_length`, or has a magnitude above 10^`max_length`. A number too small for any scalar
  /// becomes 0.
  [[nodiscard]] static std::optional<Decimal> parse(std::string_view text);

  friend Decimal operator+(const Decimal& a, const Decimal& b);
  friend Decimal operator-(const Decimal& a, const Decimal& b) { return a + -b; }
  [[nodiscard]] Decimal operator-() const { return Decimal(!negative_, digits_, places_); }

  /// This number * 10^power.
  [[nodiscard]] Decimal scaled(int power) const;

  /// The smallest n for which this number is less than 10^n in magnitude; 0 has none.
  [[nodiscard]] int magnitude() const { return static_cast<int>(digits_.size()) - places_; }

  /// Without an exponent: "-12.5".
  [[nodiscard]] std::string text() const;

  [[nodiscard]] bool is_zero() const { return digits_.empty(); }
  [[nodiscard]] bool is_negative() const { return negative_; }

  /// The value of `S` nearest to this number, or nothing when it is out of range.
  template <Number S>
  [[nodiscard]] std::optional<S> to() const {
    const std::string plain = text();
    if constexpr (std::floating_point<S>) {
      S value{};
      const auto [stop, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
      if (error == std::errc()) return value;
      // Too small for `S` becomes 0; too large is an error.
      return magnitude() <= 0 ? std::optional<S>(S(0)) : std::nullopt;
    } else {
      return S::parse(plain);
    }
  }

  static constexpr int max_length = 1000;

 private:
  Decimal(bool negative, std::string digits, int places);

  std::string digits_;  // most significant first, no leading zero; empty for 0
  int places_ = 0;      // how many of them (or of the zeros before them) are after the point
  bool negative_ = false;
};

}  // namespace detent::cli
