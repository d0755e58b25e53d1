// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include "detent/number/filter/leading.hpp"
#include "detent/number/filter/unit_length.hpp"
#include "detent/number/next_up.hpp"

namespace detent {

namespace detail {

/// The sign of a t^2 + 2 b t + c.
template <class A, class B, class C, class T>
[[nodiscard]] constexpr int sign_of_quadratic(const A& a, const B& b, const C& c,
                                              const T& t) noexcept {
  const auto rising = (a * t + b + b) * t;
  const auto level = -c;
  return (rising > level) - (rising < level);
}

}  // namespace detail

/// Where the line of a ray meets a sphere: the roots of a t^2 + 2 b t + c = 0 with a > 0.
///
/// The caller must prove that |a c| fits twice the bits of b (for a ray, Cauchy-Schwarz: b is a dot
/// product of vectors whose squared lengths bound a and c).
template <Number A, Number B, Number C>
class Quadratic {
 public:
  static constexpr int product_bits = 2 * bits_of<B>;

  /// The polynomial a t^2 + 2 b t + c.
  constexpr Quadratic(const A& a, const B& b, const C& c) noexcept
      : a_(a), b_(b), c_(c), square_(b * b), product_(narrow_product<product_bits>(a, c)) {}

  /// Whether a t^2 + 2 b t + c is 0 anywhere.
  [[nodiscard]] constexpr bool has_roots() const noexcept { return square_ >= product_; }

  /// b^2 - a c, which is not negative if there are roots.
  [[nodiscard]] constexpr auto discriminant() const noexcept {
    return narrow_difference<product_bits>(square_, product_);
  }

  /// The lesser root rounded down, or nothing if the exact root is greater than `limit`. Requires
  /// b < 0 < c, so that both roots are positive, and -b within the range of b.
  ///
  /// The leading bits of sqrt(D) decide, or else all of its bits and the sign of the polynomial
  /// (docs/filters.md, lemma 3).
  template <Scalar T>
  [[nodiscard]] constexpr std::optional<T> first_root(const T& limit) const noexcept {
    if constexpr (is_fixed<T> && !has_filters) {
      return first_root_by_digits<T>(limit);
    } else {
      T t;
      if (!find_first_root(limit, t)) return std::nullopt;
      return t;
    }
  }
  /// The same, written to `t`; returns false if there is none. Faster for callers that store the
  /// root: reading an optional that was just written stalls.
  template <Scalar T>
  [[nodiscard]] constexpr bool find_first_root(const T& limit, T& t) const noexcept {
    if constexpr (is_fixed<T> && !has_filters) {
      const auto root = first_root_by_digits<T>(limit);
      if (root) t = *root;
      return root.has_value();
    } else if constexpr (is_fixed<T>) {
      const auto root = sqrt_leading<B>(discriminant());
      const Approximate numerator{first_numerator(root.value), root.error};
      t = or_exact(decide_quotient_floor<T>(numerator, a_), [&] { return exact_first_root<T>(); });
      return !(t >= limit && !(t == limit && sign_at(t) == 0));
    } else {
      t = first_numerator(root()) / a_;
      return !(t > limit);
    }
  }

  /// `first_root` one binary digit at a time, without a quotient or a square root: slower, in less
  /// than a third of the code.
  ///
  /// With the polynomial p and the digits so far t, p(t + s) = p(t) + s p'(t) + s^2 a and s
  /// p'(t + s) = s p'(t) + 2 s^2 a. The digit s belongs to the root if neither passes 0.
  template <Scalar T>
  [[nodiscard]] constexpr std::optional<T> first_root_by_digits(const T& limit) const noexcept {
    // For a ray p(t) = |m + t d|^2 - r^2: for a scalar t, one bit more than b^2 needs.
    using Integer = IntegerFor<product_bits + 1>;
    using Raw = typename T::raw_type;
    const auto scaled = [](const auto& x, int shift) {
      return shift_left(integer_cast<Integer>(x.raw()), shift);
    };
    auto value = scaled(c_, A::frac + 2 * T::frac - C::frac);
    auto slope = scaled(b_, A::frac + T::frac - B::frac + T::bits);  // 2 s b
    auto bend = scaled(a_, 2 * (T::bits - 1));                       // s^2 a
    Raw t = 0;
    for (auto digit = static_cast<Raw>(Raw{1} << (T::bits - 1)); digit != 0; digit >>= 1) {
      const auto half_way = wrapping_add<Integer>(slope, bend);
      const auto next = wrapping_add<Integer>(value, half_way);
      const auto next_slope = wrapping_add<Integer>(half_way, bend);
      if (next >= Integer(0) && next_slope <= Integer(0)) {
        value = next;
        slope = next_slope;
        t = static_cast<Raw>(t | digit);
      }
      slope = shift_right_by<1>(slope);
      bend = shift_right_by<2>(bend);
    }
    const T root = T::assume_raw(t);
    if (root > limit || (root == limit && value != Integer(0))) return std::nullopt;
    return root;
  }

  /// The greater root rounded down, or `limit` if it is greater. There must be roots, and the
  /// greater must not be negative.
  template <Scalar T>
  [[nodiscard]] constexpr T last_root(const T& limit) const noexcept {
    const bool is_falling = a_ * limit + b_ < 0;  // the greater root, or both, are beyond
    if (is_falling || sign_at(limit) <= 0) return limit;
    T t = quotient_floor<T>(root() - b_, a_);
    if constexpr (is_fixed<T>) {
      const T after = detail::next_raw(t);
      if (sign_at(after) <= 0) t = after;
    }
    return t;
  }

 private:
  [[nodiscard]] constexpr auto root() const noexcept { return sqrt_floor<B>(discriminant()); }

  /// -b - s, where 0 <= s <= -b because the product a c is positive.
  [[nodiscard]] constexpr auto first_numerator(const B& root) const noexcept {
    return narrow<bits_of<B>>(narrow_negative(b_) - root);
  }

  template <Scalar T>
  [[nodiscard]] constexpr T exact_first_root() const noexcept {
    const T t = quotient_floor<T>(first_numerator(root()), a_);
    return sign_at(t) < 0 ? detail::previous_raw(t) : t;
  }

  /// The sign of the polynomial at t.
  template <Scalar T>
  [[nodiscard]] constexpr int sign_at(const T& t) const noexcept {
    return detail::sign_of_quadratic(a_, b_, c_, t);
  }

  using Square = decltype(std::declval<B>() * std::declval<B>());
  using Product = decltype(narrow_product<product_bits>(std::declval<A>(), std::declval<C>()));

  A a_;
  B b_;
  C c_;
  Square square_;
  Product product_;
};

}  // namespace detent
