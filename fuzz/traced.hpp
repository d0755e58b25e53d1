// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "detent/number/filter/components.hpp"
#include "detent/number/filter/long_quadratic.hpp"
#include "detent/number/unit.hpp"

namespace detent::fuzz {

/// A number that computes as F (`float` or `double`) does, to the bit, and tracks a bound on its
/// difference from the same formula in real arithmetic.
///
/// `error` is a bound by running error analysis (Wilkinson; Higham, Accuracy and Stability of
/// Numerical Algorithms, 3.3). X, Y are the exact operands, |x - X| <= e and |y - Y| <= f. h bounds
/// the rounding of the result z: half the distance between the neighbours of z, or 0 if an
/// error-free transformation shows that z is exact:
///
///   x + y, x - y   e + f + h
///   x * y          |x| f + |y| e + e f + h        XY - xy = x (Y - y) + y (X - x) + (X - x)(Y - y)
///   x / y          (e + |x / y| f) / (|y| - f) + h     X/Y - x/y = ((X - x) - (x/y)(Y - y)) / Y
///   sqrt(x)        sqrt(x) - sqrt(x - e) + h, for the root is concave; sqrt(x + e) + h if e > x
///   an input       h
///
/// No constant is fitted to observations. A comparison is decided if the difference exceeds the sum
/// of both bounds, or if both sides are the same expression; `all_decided` records it.
///
/// `exact` follows the same path in long double. If that has more bits than F, it is the real
/// number up to a small share of the bound.
template <class F>
struct Traced {
  using Wide = long double;

  F value = 0;
  Wide exact = 0;
  Wide error = 0;
  std::uint64_t expression = 0;  // equal if the same operations were applied to the same inputs

  static inline bool all_decided = true;

  constexpr Traced() noexcept = default;
  constexpr Traced(int x) noexcept : Traced(static_cast<F>(x), 0) {}  // NOLINT: as for F

  /// A caller's number, rounded to an F.
  static Traced input(double x) noexcept {
    Traced result(static_cast<F>(x), 0);
    result.exact = x;
    if (static_cast<double>(result.value) != x) {
      result.error = rounding(result.value);
      result.expression = mixed(0, std::bit_cast<std::uint64_t>(x), 1);
    }
    return result;
  }
  /// A number that F represents.
  constexpr Traced(F x, int) noexcept : value(x), exact(x), expression(of_value(x)) {}

  friend constexpr Traced operator-(const Traced& x) noexcept {
    Traced result = x;
    result.value = -x.value;
    result.exact = -x.exact;
    result.expression = x.error == 0 ? of_value(result.value) : mixed(1, x.expression, 0);
    return result;
  }
  friend Traced operator+(const Traced& x, const Traced& y) noexcept {
    const F z = x.value + y.value;
    const F part = z - x.value;  // Knuth's error-free sum
    const bool is_exact = (x.value - (z - part)) + (y.value - part) == 0;
    return made(2, x, y, z, x.exact + y.exact, x.error + y.error, is_exact);
  }
  friend Traced operator-(const Traced& x, const Traced& y) noexcept {
    if (x.expression == y.expression) return Traced();
    const F z = x.value - y.value;
    const F part = z - x.value;
    const bool is_exact = (x.value - (z - part)) - (y.value + part) == 0;
    return made(3, x, y, z, x.exact - y.exact, x.error + y.error, is_exact);
  }
  friend Traced operator*(const Traced& x, const Traced& y) noexcept {
    const F z = x.value * y.value;
    const Wide a = magnitude(x), b = magnitude(y);
    return made(4, x, y, z, x.exact * y.exact, a * y.error + b * x.error + x.error * y.error,
                std::fma(x.value, y.value, -z) == 0 && is_safe(z, x.value, y.value));
  }
  friend Traced operator/(const Traced& x, const Traced& y) noexcept {
    const F z = x.value / y.value;
    const Wide a = magnitude(x), b = magnitude(y);
    const Wide bound = b > y.error ? (x.error + a / b * y.error) / (b - y.error) : unbounded();
    return made(5, x, y, z, x.exact / y.exact, bound,
                std::fma(z, y.value, -x.value) == 0 && is_safe(x.value, z, y.value));
  }
  friend Traced root(const Traced& x) noexcept {
    const F z = std::sqrt(x.value);
    const Wide v = x.value, e = x.error;
    const Wide bound = v >= e ? std::sqrt(v) - std::sqrt(v - e) : std::sqrt(v + e);
    return made(6, x, Traced(), z, std::sqrt(std::max(x.exact, Wide(0))), bound,
                std::fma(z, z, -x.value) == 0 && is_safe(x.value, z, z));
  }

  friend constexpr bool operator<(const Traced& x, const Traced& y) noexcept {
    note(x, y);
    return x.value < y.value;
  }
  friend constexpr bool operator>(const Traced& x, const Traced& y) noexcept { return y < x; }
  friend constexpr bool operator<=(const Traced& x, const Traced& y) noexcept {
    note(x, y);
    return x.value <= y.value;
  }
  friend constexpr bool operator>=(const Traced& x, const Traced& y) noexcept { return y <= x; }
  friend constexpr bool operator==(const Traced& x, const Traced& y) noexcept {
    note(x, y);
    return x.value == y.value;
  }

 private:
  static Wide magnitude(const Traced& x) noexcept { return std::abs(Wide(x.value)); }
  static constexpr Wide unbounded() noexcept { return std::numeric_limits<Wide>::infinity(); }
  static constexpr std::uint64_t mixed(int operation, std::uint64_t a, std::uint64_t b) noexcept {
    std::uint64_t x = (a * 0x9e3779b97f4a7c15 + b) ^ static_cast<std::uint64_t>(operation) << 56;
    x = (x ^ x >> 32) * 0xd6e8feb86659fd93;
    return (x ^ x >> 32) * 0xd6e8feb86659fd93;
  }
  static constexpr std::uint64_t of_value(F x) noexcept {
    if (x == 0) return 0;  // -0 is 0
    return mixed(7, std::bit_cast<std::uint64_t>(static_cast<double>(x)), 0);
  }
  /// Half the distance between neighbours of z; at a power of two, the larger one.
  static Wide rounding(F z) noexcept {
    if (!std::isfinite(z)) return unbounded();
    int exponent = 0;
    std::frexp(z, &exponent);
    exponent = std::max(exponent, std::numeric_limits<F>::min_exponent);
    return std::ldexp(Wide(1), exponent - std::numeric_limits<F>::digits - 1);
  }
  /// Whether the remainder of a product z = x y does not underflow.
  static bool is_safe(F z, F x, F y) noexcept {
    return x == 0 || y == 0 ||
           std::abs(z) > std::ldexp(F(1), std::numeric_limits<F>::min_exponent + 60);
  }
  static Traced made(int operation, const Traced& x, const Traced& y, F z, Wide real, Wide bound,
                     bool is_exact) noexcept {
    Traced result(z, 0);
    result.exact = real;
    // The bound is itself rounded, by less than 2^-40 in all.
    result.error = (bound + (is_exact ? 0 : rounding(z))) * (1 + 0x1p-40L);
    if (result.error == 0) {
      result.exact = z;
      return result;
    }
    auto a = x.expression, b = y.expression;
    if ((operation == 2 || operation == 4) && a > b) std::swap(a, b);  // they commute
    result.expression = mixed(operation, a, b);
    return result;
  }
  static constexpr void note(const Traced& x, const Traced& y) noexcept {
    const Wide apart = std::abs(Wide(x.value) - Wide(y.value)), bound = x.error + y.error;
    if (!(apart > bound) && !(bound == 0 && apart == 0) && x.expression != y.expression) {
      all_decided = false;
    }
  }
};

// The functions that number/floating.hpp and similar headers have for float and double.
template <class T, class F>
[[nodiscard]] T floor_to(const Traced<F>& x) noexcept {
  return x;
}
template <class T, class F>
[[nodiscard]] T ceil_to(const Traced<F>& x) noexcept {
  return x;
}
template <class T, class F>
[[nodiscard]] T nearest_to(const Traced<F>& x) noexcept {
  return x;
}
template <int Bits, class F>
[[nodiscard]] Traced<F> narrow(const Traced<F>& x) noexcept {
  return x;
}
template <class F>
[[nodiscard]] Traced<F> narrow_negative(const Traced<F>& x) noexcept {
  return -x;
}
template <int Bits, class F>
[[nodiscard]] Traced<F> narrow_product(const Traced<F>& a, const Traced<F>& b) noexcept {
  return a * b;
}
template <int Bits, class F>
[[nodiscard]] Traced<F> narrow_sum(const Traced<F>& a, const Traced<F>& b) noexcept {
  return a + b;
}
template <int Bits, class F>
[[nodiscard]] Traced<F> narrow_difference(const Traced<F>& a, const Traced<F>& b) noexcept {
  return a - b;
}
template <int Bits, class F>
[[nodiscard]] Traced<F> scale_up(const Traced<F>& x, int) noexcept {
  return x;
}
template <class F>
[[nodiscard]] int headroom(const Traced<F>&) noexcept {
  return 0;
}
template <class T, class F>
[[nodiscard]] T quotient_floor(const Traced<F>& n, const Traced<F>& d) noexcept {
  return n / d;
}
template <class T, class F>
[[nodiscard]] T quotient_nearest(const Traced<F>& n, const Traced<F>& d) noexcept {
  return n / d;
}
template <class T, class F>
[[nodiscard]] T sqrt_floor(const Traced<F>& x) noexcept {
  return root(x);
}
template <class F>
[[nodiscard]] Traced<F> half(const Traced<F>& x) noexcept {
  return x / 2;
}
/// |x| has the error of x, whatever its sign.
template <class F>
[[nodiscard]] Traced<F> abs(const Traced<F>& x) noexcept {
  return std::signbit(x.value) ? -x : x;
}
template <class F>
[[nodiscard]] LeadingRoot<Traced<F>> leading_root(const Traced<F>& x) noexcept {
  return {root(x), 0};
}
template <class F, std::size_t N>
[[nodiscard]] bool is_unit(const std::array<Traced<F>, N>&) noexcept {
  return true;
}
template <class Component, class F, std::size_t N>
[[nodiscard]] std::optional<std::array<Component, N>> unit_vector(
    const std::array<Traced<F>, N>& v) noexcept {
  Traced<F> squared = 0;
  for (const auto& c : v) squared = squared + c * c;
  if (!(squared > 0) || !std::isfinite(squared.value)) return std::nullopt;
  const auto norm = root(squared);
  std::array<Component, N> unit;
  for (std::size_t i = 0; i < N; ++i) unit[i] = v[i] / norm;
  return unit;
}

}  // namespace detent::fuzz

template <class F>
struct std::numeric_limits<detent::fuzz::Traced<F>> : std::numeric_limits<F> {
  static constexpr detent::fuzz::Traced<F> max() noexcept {
    return {std::numeric_limits<F>::max(), 0};
  }
  static constexpr detent::fuzz::Traced<F> lowest() noexcept {
    return {std::numeric_limits<F>::lowest(), 0};
  }
};

namespace detent {

template <class F>
inline constexpr bool is_floating<fuzz::Traced<F>> = true;

template <class T, class F, class Length>
class RootRatio<T, fuzz::Traced<F>, Length> {
 public:
  RootRatio(const fuzz::Traced<F>& d, const Length& length) noexcept
      : root_(root(d)), length_(length) {}
  [[nodiscard]] Decided<T> decide_nearest(const T& x, const T& y) const noexcept {
    return {(x - root_ * y) / length_, true};
  }

 private:
  fuzz::Traced<F> root_;
  Length length_;
};

}  // namespace detent
