// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <type_traits>

#include "detent/math/lens.hpp"
#include "detent/math/rotation.hpp"
#include "detent/math/width.hpp"
#include "detent/number/filter/aim.hpp"
#include "detent/number/filter/product_quotient.hpp"

// Filters for cameras: directions of pick rays and projected points, from words of 64 bits.

namespace detent::detail {

/// Whether to try `guess_direction` first: if words are long and hold products with X.
template <Scalar S, Number X>
[[nodiscard]] constexpr bool has_guess() noexcept {
  if constexpr (is_fixed<S> && is_fixed<X> && has_filters && has_long_registers) {
    return X::frac > 0 && X::frac <= 16;
  } else {
    return false;
  }
}

/// Filter: as `decide_direction`, where `unit` is 1 and the point is in the image; faster, and less
/// often sure (docs/filters.md, lemma 45).
template <Scalar S, Number X>
[[nodiscard]] constexpr auto guess_direction(const Rotation<S, 3>& frame, const Lens<S>& lens,
                                             const X& x, const X& y) noexcept {
  using Component = direction_component<S>;
  using Sum = Fixed<63, 58>;
  if (!fits<X::frac>(Vec{x, y})) return UnitFilter<Component>{{}, false};
  const auto part = [&](const X& at, int i, int j) {
    const auto side = lens.slope(i) * frame.axis(i)[j];  // at most 8
    constexpr int frac = (std::min)(decltype(side)::frac, Sum::frac - X::frac);
    return Fixed<62, 58>(narrow_floor<Fixed<frac + 3, frac>>(side) * at_most<X::frac>(at));
  };
  return decide_opposite_of_short<Component, (1 << 15), false>(to_array(make_vec<3>([&](int j) {
    return narrow_difference<63>(Sum(frame.axis(2)[j]),
                                 narrow_sum<62>(part(x, 0, j), part(y, 1, j)));
  })));
}

/// Filter: the unit vector along x w axis(0) + y h axis(1) - unit axis(2), where w and h are the
/// slopes of `lens` (docs/filters.md, lemma 38). With `OnlyShort` it takes less time, and is unsure
/// about vectors more than 2 to 4 times as long as `unit` (lemma 45).
template <bool OnlyShort = false, Scalar S, Number X, Number Unit>
[[nodiscard]] constexpr auto decide_direction(const Rotation<S, 3>& frame, const Lens<S>& lens,
                                              const X& x, const X& y, const Unit& unit) noexcept {
  using Component = direction_component<S>;
  using Sum = Fixed<62, 58>;
  const UnitFilter<Component> unknown{{}, false};
  // `ahead` returns a component of unit axis(2).
  const auto decide = [&](const auto& right, const auto& up, const auto& ahead) {
    const auto back = to_array(make_vec<3>([&](int j) {
      const auto across = narrow_sum<62>(floor_product<Sum>(right, frame.axis(0)[j]),
                                         floor_product<Sum>(up, frame.axis(1)[j]));
      return of_unknown_size(narrow_difference<62>(ahead(frame.axis(2)[j]), across));
    }));
    if constexpr (OnlyShort) {
      return decide_opposite_of_short<Component, (1 << 12), true>(back);
    } else {
      return decide_opposite<Component>(back);
    }
  };
  if constexpr (Unit::bits == 1 && Unit::frac == 0) {
    // `unit` is 1, and most of what is seen is at most 4 times as far from the axis as from the eye.
    const auto right = x * lens.slope(0), up = y * lens.slope(1);
    constexpr int frac = decltype(right)::frac;
    // Products with components of 15 bits fit a word.
    constexpr int weight_frac = Component::frac == 14 && frac <= 44 ? 44 : 60;
    if constexpr (frac <= weight_frac) {
      using Weight = Fixed<weight_frac + 2, weight_frac>;
      if (!fits<frac + 2>(Vec{right, up})) return unknown;
      return decide(Weight(at_most<frac + 2>(right)), Weight(at_most<frac + 2>(up)),
                    [](const Component& c) { return Sum(c); });
    } else {
      return unknown;
    }
  } else {
    if (!fits<30>(Vec{x, y}) || !fits<30>(unit)) return unknown;
    using Product = Fixed<62, Lens<S>::Slope::frac>;
    const auto weights = in_units(Product(at_most<30>(x) * lens.slope(0)),
                                  Product(at_most<30>(y) * lens.slope(1)), at_most<30>(unit));
    if (!weights.is_sure) return unknown;
    return decide(weights.value[0], weights.value[1],
                  [&](const Component& c) { return floor_product<Sum>(weights.value[2], c); });
  }
}

/// Screen coordinates and depth, if `is_seen` is sure. GCC 12 would combine shorter numbers in
/// memory.
template <class T, class S>
struct SeenPoint {
  Filtered is_seen = Filtered::unsure;
  Fixed<62, T::frac> x{}, y{};
  Fixed<62, S::frac> depth{};
};

/// Whether the filter below can compute screen coordinates of type T.
template <class T, Scalar S>
inline constexpr bool filters_projection = false;
template <int B, int F, Scalar S>
inline constexpr bool filters_projection<Fixed<B, F>, S> =
    is_fixed<S>&& filter_pays<S>&& B <= 31 && F <= 24;

/// Filter: where a camera sees the point at `offset` from its eye: middle.x + half_size.x x and
/// middle.y +- half_size.y y, where x and y are in [-1, 1] inside the image, and half_size > 0. It is
/// unsure unless the axes are perpendicular up to rounding (docs/filters.md, lemma 40).
template <class T, bool IsDown, Scalar S, Number Offset, Number Size>
[[nodiscard]] constexpr SeenPoint<T, S> decide_project(const Rotation<S, 3>& frame,
                                                       const Lens<S>& lens,
                                                       const Vec<Offset, 3>& offset,
                                                       const Vec<Size, 2>& half_size,
                                                       const Vec<Size, 2>& middle) noexcept {
  static_assert(direction_component<S>::frac == 30);
  using Value = Fixed<62, S::frac + 29>;
  using Screen = Fixed<62, T::frac + 14>;
  SeenPoint<T, S> result;
  const auto back = cross(frame.axis(0), frame.axis(1).vec());
  const auto excess = dot(frame.axis(2), back) - Fixed<91, 90>(1);
  if (!fits<0>(narrow_floor<Fixed<31, 28>>(excess))) return result;
  const auto side = cross(frame.axis(2), offset);
  const auto component = [&](const auto& a, const auto& b) {
    return narrow_floor<Value>(narrow_dot<95>(a, b));
  };
  const auto right = component(frame.axis(1).vec(), side);
  const auto down = component(frame.axis(0).vec(), side);
  const auto depth = narrow_negative(component(offset, back));

  // 1 / (1 + e) = 1 - (e - e^2) up to e^3.
  const auto e = narrow<63>(excess);
  const auto share = narrow_difference<63>(e, narrow_floor<Fixed<63, 90>>(e * e));
  const auto over_whole = [&](const Value& x) {
    return narrow_difference<62>(x, narrow_floor<Value>(x * share));
  };
  const auto finish = [&](const auto& width, const auto& height, const Value& distance,
                          const Value& x, const Value& y) {
    const ProductQuotient quotient(width * height, distance);
    const auto plus = [](const auto& from, const Screen& shift) {
      return Approximate{narrow_sum<63>(from.value, shift), from.error};
    };
    const auto across = decide_nearest<Fixed<62, T::frac>>(
        plus(quotient.template over<T>(x, half_size.x * height), Screen(middle.x)));
    const auto along = decide_nearest<Fixed<62, T::frac>>(
        plus(quotient.template over<T>(y, half_size.y * width), Screen(middle.y)));
    const auto forward =
        decide_nearest<Fixed<62, S::frac>>(Approximate{over_whole(depth), Steps<4>()});
    result.x = across.value;
    result.y = along.value;
    result.depth = forward.value;
    bool is_sure = across.is_sure & along.is_sure & forward.is_sure;
    is_sure &= fits<T::bits - 1>(Vec{across.value, along.value});
    is_sure &= fits<S::bits - 1>(forward.value);
    if (is_sure) result.is_seen = Filtered::yes;
  };
  const auto signed_y = [&](const Value& y) { return IsDown ? y : narrow_negative(y); };
  if (lens.has_perspective()) {
    if (depth < 0) {
      result.is_seen = Filtered::no;
    } else {
      finish(lens.slope(0), lens.slope(1), depth, right, signed_y(down));
    }
  } else {
    finish(lens.extent(0), lens.extent(1), Value(1), over_whole(right), signed_y(over_whole(down)));
  }
  return result;
}

}  // namespace detent::detail
