// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <optional>

#include "detent/number/filter/leading.hpp"
#include "detent/number/quadratic.hpp"

namespace detent {

/// The leading bits of a square root: `root` * 2^-scale, rounded down.
template <Number T>
struct LeadingRoot {
  T root;
  int scale;
};

/// The square root of x >= 0 rounded down to 62 bits or more, with a relative error below 2^-61;
/// for numbers too wide for `sqrt_floor`. `scale` is at most 63.
template <int B, int F>
[[nodiscard]] constexpr auto leading_root(const Fixed<B, F>& x) noexcept {
  static_assert(F % 2 == 0);
  using Root = Fixed<(std::max)((B + 1) / 2, 63), F / 2>;
  using Raw = typename Root::raw_type;
  using Long = Wide<(std::max)(4, static_cast<int>(sizeof(x.raw()) / 8))>;
  // Shifted by an even count, x has 125 or 126 bits, and its root has 63.
  int excess = bit_length(x.raw()) - 126;
  excess += excess & 1;
  const auto raw = integer_cast<Long>(x.raw());
  const Long leading = excess < 0 ? raw << -excess : raw >> excess;
  const Wide<2> root(square_root_floor(leading.word(1), leading.word(0)));
  return LeadingRoot<Root>{
      Root::assume_raw(shift_left(integer_cast<Raw>(root), (std::max)(excess, 0) / 2)),
      (std::max)(-excess, 0) / 2};
}
template <std::floating_point T>
[[nodiscard]] constexpr auto leading_root(T x) noexcept {
  return LeadingRoot<T>{sqrt_floor<T>(x), 0};
}

/// The roots of a t^2 + 2 b t + c = 0 with a > 0, for numbers too wide for `Quadratic`. The caller
/// supplies b^2 - a c >= 0 as a product d e.
///
/// The leading bits of a root decide its rounding, or else the sign of the polynomial does
/// (docs/filters.md, lemma 4).
template <Number A, Number B, Number C, Number D, Number E>
class LongQuadratic {
 public:
  constexpr LongQuadratic(const A& a, const B& b, const C& c, const D& d, const E& e) noexcept
      : a_(a), b_(b), c_(c), d_(d), e_(e) {
    if constexpr (is_fixed<D>) root_ = sqrt(Leading(d) * Leading(e));
  }

  /// The error of the next two functions, which involve a square root.
  static constexpr Relative error{42};

  /// The leading bits of the root that `first_root` rounds.
  [[nodiscard]] constexpr Leading leading_first() const noexcept {
    return Leading(c_) / (Leading(-b_) + root_);
  }
  /// The leading bits of the root that `last_root` rounds.
  [[nodiscard]] constexpr Leading leading_last() const noexcept {
    if (b_ <= 0) return (Leading(-b_) + root_) / Leading(a_);
    return Leading(-c_) / (Leading(b_) + root_);
  }

  /// The lesser root rounded down, or nothing if the exact root is greater than `limit`. Requires
  /// b < 0 < c, so that both roots are positive.
  template <Scalar T>
  [[nodiscard]] constexpr std::optional<T> first_root(const T& limit) const noexcept {
    if constexpr (is_fixed<T>) {
      if (const auto [root, is_sure] = decide_floor<T>(Approximate{leading_first(), error});
          is_sure) {
        if (root >= limit) return std::nullopt;
        return root;
      }
    }
    if (sign_at(limit) > 0 && slope_at(limit) < 0) return std::nullopt;
    const auto [root, scale] = leading_root(d_ * e_);
    T t = quotient_floor<T>(scaled(c_, scale), root - scaled(b_, scale));
    if constexpr (is_fixed<T>) {
      if (sign_at(t) < 0 || slope_at(t) > 0) t = detail::previous_raw(t);
      DETENT_ASSERT(sign_at(t) >= 0 && slope_at(t) <= 0);
    }
    return t;
  }

  /// The greater root rounded down, or `limit` if the root is greater. The root must not be
  /// negative.
  template <Scalar T>
  [[nodiscard]] constexpr T last_root(const T& limit) const noexcept {
    if constexpr (is_fixed<T>) {
      if (const auto [root, is_sure] = decide_floor<T>(Approximate{leading_last(), error});
          is_sure) {
        return (std::min)(root, limit);
      }
    }
    if (!is_beyond(limit)) return limit;
    const auto [root, scale] = leading_root(d_ * e_);
    T t = b_ <= 0 ? quotient_floor<T>(root - scaled(b_, scale), scaled(a_, scale))
                  : quotient_floor<T>(-scaled(c_, scale), root + scaled(b_, scale));
    if constexpr (is_fixed<T>) {
      if (is_beyond(t)) {
        t = detail::previous_raw(t);
      } else if (const T after = detail::next_raw(t); !is_beyond(after)) {
        t = after;
      }
      DETENT_ASSERT(!is_beyond(t) && is_beyond(detail::next_raw(t)));
    }
    return t;
  }

 private:
  /// x * 2^scale.
  template <Number T>
  [[nodiscard]] static constexpr auto scaled(const T& x, int scale) noexcept {
    return scale_up<bits_of<T> + 63>(x, scale);
  }

  /// The sign of the polynomial at t.
  template <Number T>
  [[nodiscard]] constexpr int sign_at(const T& t) const noexcept {
    return detail::sign_of_quadratic(a_, b_, c_, t);
  }
  /// The sign of the polynomial's slope at t.
  template <Number T>
  [[nodiscard]] constexpr int slope_at(const T& t) const noexcept {
    const auto slope = a_ * t + b_;
    return (slope > 0) - (slope < 0);
  }
  template <Number T>
  [[nodiscard]] constexpr bool is_beyond(const T& t) const noexcept {
    return sign_at(t) > 0 && slope_at(t) > 0;
  }

  A a_;
  B b_;
  C c_;
  D d_;
  E e_;
  Leading root_;  // sqrt(d e)
};

}  // namespace detent
