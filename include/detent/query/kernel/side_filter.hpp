// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/math/width.hpp"
#include "detent/number/filter/filtered.hpp"

namespace detent::detail {

/// The signs of products of one long vector with several of at most 62 bits: from its leading 61
/// bits, or exactly.
///
/// Each component drops less than one step, so a sum of three products is off by less than three
/// times 2^62 (docs/filters.md, lemma 31).
template <Number T>
class SideFilter {
 public:
  explicit constexpr SideFilter(const Vec<T, 3>& normal) noexcept : normal_(normal) {
    if constexpr (is_long) {
      leading_ = without_low_bits<Word>(normal, (std::max)(longest_bits(normal) - Word::bits, 0));
    }
  }

  /// The sign of dot(normal, v).
  template <int B, int F>
  [[nodiscard]] constexpr int sign(const Vec<Fixed<B, F>, 3>& v) const noexcept {
    const auto exact = [&] {
      const auto along = dot(normal_, v);
      return (along > 0) - (along < 0);
    };
    if constexpr (is_long && B <= 62) {
      Sum sum;
      for (int i = 0; i < 3; ++i) {
        sum = narrow_sum<Sum::bits>(
            sum, narrow_product<Sum::bits>(leading_[i], Fixed<B, 0>::assume_raw(v[i].raw())));
      }
      return sign_or_exact(decide(Approximate{sum, error}), exact);
    } else {
      return exact();
    }
  }

 private:
  static constexpr bool is_long = is_fixed<T> && has_filters && bits_of<T> > 64;
  using Word = Fixed<61, 0>;
  using Sum = Fixed<125, 0>;  // three products below 2^123
  static constexpr auto error = scale_up<Sum::bits>(Fixed<2, 0>(3), 62);

  Vec<T, 3> normal_;
  Vec<Word, 3> leading_{};
};

}  // namespace detent::detail
