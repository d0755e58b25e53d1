// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/math/components.hpp"
#include "detent/number/filter/components.hpp"
#include "detent/query/kernel/convex_body.hpp"

namespace detent::detail {

/// A type that holds every number of A and of B.
template <Number A, Number B>
struct holder_of {
  using type = A;
};
template <int BitsA, int FracA, int BitsB, int FracB>
struct holder_of<Fixed<BitsA, FracA>, Fixed<BitsB, FracB>> {
  static constexpr int frac = (std::max)(FracA, FracB);
  using type = Fixed<(std::max)(BitsA - FracA, BitsB - FracB) + frac, frac>;
};
template <Number A, Number B>
using HolderOf = typename holder_of<A, B>::type;

/// Filter: which axes can give the least push of two boxes, and to which side (docs/filters.md,
/// lemma 15). The differences of two boxes are a middle plus up to half of each of six spans. So
/// along v they reach sum |v . span| / 2 - |v . middle| beyond 0 on the nearer side.
template <class A, class B>
class AxisFilter {
 public:
  constexpr AxisFilter(const A& a, const B& b) noexcept {
    const auto middle = a.doubled_middle() - b.doubled_middle();
    using Middle = std::remove_cvref_t<decltype(middle.x)>;
    using SpanA = std::remove_cvref_t<decltype(a.span(0).x)>;
    using SpanB = std::remove_cvref_t<decltype(b.span(0).x)>;
    using Span = Vec<HolderOf<Middle, HolderOf<SpanA, SpanB>>, 3>;
    std::array<Span, 7> spans;
    const auto set = [&](std::size_t k, const auto& v) {
      spans[k] = make_vec<3>([&](int i) { return decltype(Span::x)(v[i]); });
    };
    for (int i = 0; i < 3; ++i) {
      set(static_cast<std::size_t>(i), a.span(i));
      set(static_cast<std::size_t>(i + 3), b.span(i));
    }
    set(6, middle);
    int length = 0;
    for (const auto& span : spans) length = (std::max)(length, length_of(span));
    const int dropped = (std::max)(length - span_bits, 0);
    for (std::size_t k = 0; k < spans.size(); ++k) spans_[k] = cut<span_bits>(spans[k], dropped);
  }

  /// Takes the next axis into account.
  template <Number V>
  constexpr void add(const Vec<V, 3>& v) noexcept {
    auto& axis = axes_[count_++];
    axis.length = largest<Length>;
    const int bits = length_of(v);
    if (bits == 0 || least_ < -error) return;
    const auto across = cut<axis_bits>(v, bits - axis_bits);
    const auto along = dot(across, spans_[6]);
    axis.side = along > product_error ? -1 : along < -product_error ? 1 : 0;
    Sum reach = narrow_negative(abs(along));
    for (std::size_t k = 0; k < 6; ++k) {
      reach = narrow<Sum::bits>(reach + abs(dot(across, spans_[k])));
    }
    axis.length = over_root(reach, squared_length(across));
    least_ = (std::min)(least_, axis.length);
  }

  /// Calls f(sign) for the sides of axis i, in the order of `add`, on which it may give the least
  /// push or prove that the boxes are apart.
  template <class F>
  constexpr void for_each_side(std::size_t i, const F& f) const noexcept {
    const auto& axis = axes_[i];
    if (axis.length == largest<Length> || axis.length > least_ + error + error) return;
    if (axis.side >= 0) f(1);
    if (axis.side <= 0) f(-1);
  }

 private:
  static constexpr int span_bits = 28, axis_bits = 29;
  using Sum = Fixed<62, 0>;
  using Length = Fixed<36, 0>;
  static constexpr Length error{128};
  static constexpr auto product_error = square(Fixed<17, 0>(1 << 16));

  struct Axis {
    Length length;
    int side;
  };

  template <Number V>
  [[nodiscard]] static constexpr int length_of(const Vec<V, 3>& v) noexcept {
    return (std::max)({bit_length(v.x.raw()), bit_length(v.y.raw()), bit_length(v.z.raw())});
  }
  /// v / 2^dropped, rounded down.
  template <int Bits, Number V>
  [[nodiscard]] static constexpr auto cut(const Vec<V, 3>& v, int dropped) noexcept {
    using Cut = Fixed<Bits, 0>;
    return make_vec<3>([&](int i) {
      const auto& raw = v[i].raw();
      if (dropped >= 0) {
        return Cut::assume_raw(integer_cast<std::int32_t>(shift_right_floor(raw, dropped)));
      }
      return Cut::assume_raw(shift_left(integer_cast<std::int32_t>(raw), -dropped));
    });
  }

  std::array<Vec<Fixed<span_bits, 0>, 3>, 7> spans_;  // those of a and b, and the middle
  std::array<Axis, 15> axes_{};
  std::size_t count_ = 0;
  Length least_ = largest<Length>;
};

}  // namespace detent::detail
