// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/filter/leading.hpp"

namespace detent {

/// x y rounded down to steps 2^64 coarser than those of the exact product: the upper word of a
/// product of two words.
template <int BX, int FX, int BY, int FY>
[[nodiscard]] constexpr auto high_product(const Fixed<BX, FX>& x, const Fixed<BY, FY>& y) noexcept {
  static_assert(BX <= 63 && BY <= 63 && BX + BY > 64);
  using High = Fixed<BX + BY - 64, FX + FY - 64>;
  const Wide<2> product(wrapping_multiply<Int128>(x.raw(), y.raw()));
  return High::assume_raw(static_cast<typename High::raw_type>(product.word(1)));
}

/// The greatest even number of doublings for which x > 0 stays within `Bits`.
template <int Bits, int B, int F>
[[nodiscard]] constexpr int even_headroom(const Fixed<B, F>& x) noexcept {
  static_assert(B <= Bits);
  return (Bits - positive_bit_length(x.raw())) & ~1;
}

/// The lesser root of a t^2 + 2 b t + c = 0 for a line and a surface of degree 2, from coefficients
/// truncated to 60 bits and scaled so that a c is not far below b^2. Each is within one step of the
/// exact one (docs/filters.md, lemma 14).
class ShortQuadratic {
 public:
  using Coefficient = Fixed<61, 0>;

  constexpr ShortQuadratic(const Coefficient& a, const Coefficient& b,
                           const Coefficient& c) noexcept
      : b_(b),
        c_(c),
        discriminant_(square(b) - a * c),
        error_(narrow<63>(abs(b) + abs(b) + abs(a) + abs(c) + Coefficient(2))) {}

  /// Whether t = 0 is on the outer side, c > 0, by more than the errors of `first_root` allow for:
  /// `yes` or `unsure`.
  [[nodiscard]] constexpr Filtered starts_outside() const noexcept {
    return c_ >= least ? Filtered::yes : Filtered::unsure;
  }

  /// Whether there are roots t > 0, if t = 0 is outside.
  [[nodiscard]] constexpr Filtered has_roots() const noexcept {
    const bool no = int{b_ > 0} + int{discriminant_ < -error_} != 0;  // branchless
    if (no) return Filtered::no;
    return b_ < 0 && discriminant_ > error_ ? Filtered::yes : Filtered::unsure;
  }

  /// The error of `first_root`.
  static constexpr Relative error{41};

  /// The lesser root, if `has_roots`; unsure if the discriminant is too small.
  [[nodiscard]] constexpr Decided<Leading> first_root() const noexcept {
    using Root = Fixed<62, 0>;
    const auto root = Root::assume_raw(
        sqrt(Leading(narrow_floor<Fixed<63, -58>>(discriminant_))).template scaled<0>());
    const auto behind = narrow_negative(b_);
    const auto denominator = Root(narrow<61>(root + behind));
    constexpr auto least_product = Fixed<60, -64>::assume_raw(std::int64_t{1} << 40);
    return {Leading(c_) / Leading(denominator), high_product(root, Root(behind)) >= least_product};
  }

 private:
  static constexpr auto least = Coefficient::assume_raw(std::int64_t{1} << 45);

  Coefficient b_, c_;
  decltype(square(Coefficient()) - Coefficient() * Coefficient()) discriminant_;
  Fixed<63, 0> error_;
};

}  // namespace detent
