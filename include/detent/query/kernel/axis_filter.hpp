// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "detent/number/filter/components.hpp"
#include "detent/query/kernel/box_filter.hpp"
#include "detent/query/kernel/core.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"

namespace detent::detail {

// A box by its center and extents, doubled so that both are on the grid, and its axes.

template <Scalar S, int N>
[[nodiscard]] constexpr auto doubled_center(const Aabb<S, N>& box) noexcept {
  return box.min + box.max;
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto doubled_center(const Obb<S, N>& box) noexcept {
  return box.center + box.center;
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto doubled_extents(const Aabb<S, N>& box) noexcept {
  return box.max - box.min;
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto doubled_extents(const Obb<S, N>& box) noexcept {
  return box.half_extents + box.half_extents;
}
template <Scalar S, int N>
[[nodiscard]] constexpr WorldFrame frame_of(const Aabb<S, N>&) noexcept {
  return {};
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto frame_of(const Obb<S, N>& box) noexcept {
  return AxisFrame(box.rotation);
}

/// Rules out no axis.
struct AnyAxis {
  static constexpr bool are_apart() noexcept { return false; }
  static constexpr bool can_be_least(std::size_t) noexcept { return true; }
  template <class V>
  static constexpr int side_of(const V&) noexcept {
    return 0;
  }
};

/// Filter: which axes can be the least push of two boxes out of each other (docs/filters.md, lemma
/// 15). Axes count as in `AxisPush`: those across two edges of a, two of b, one of each.
template <Scalar S>
class AxisFilter {
 public:
  static constexpr int length_bits = 28;
  /// Doubled lengths, of which the last bits may be dropped.
  using Length = Fixed<length_bits + 1, 0>;
  using Place = Fixed<length_bits + 3, 0>;

  template <class A, class B>
  constexpr AxisFilter(const A& a, const B& b) noexcept
      : apart_(doubled_center(b) - doubled_center(a)) {
    lows_.fill(lowest<Depth>);
    const auto extents_a = doubled_extents(a), extents_b = doubled_extents(b);
    const auto dropped_of = [](const auto&... v) {
      const auto magnitudes = (... | (abs(v.x).raw() | abs(v.y).raw() | abs(v.z).raw()));
      return (std::max)(bit_length(magnitudes) - length_bits, 0);
    };
    dropped_ = dropped_of(extents_a, extents_b, apart_);
    bound(frame_of(a), cut(extents_a, dropped_), frame_of(b), cut(extents_b, dropped_),
          cut(apart_, dropped_));
  }

  [[nodiscard]] constexpr bool are_apart() const noexcept { return are_apart_; }
  [[nodiscard]] constexpr bool can_be_least(std::size_t i) const noexcept {
    return lows_[i] <= least_high_;
  }
  /// The only axis that can be the least push, if that push is positive and no bits of lengths were
  /// dropped.
  [[nodiscard]] constexpr std::optional<std::size_t> only_axis() const noexcept {
    std::uint32_t axes = 0;
    for (std::size_t i = 0; i < lows_.size(); ++i) axes |= std::uint32_t{can_be_least(i)} << i;
    const auto first = static_cast<std::size_t>(std::countr_zero(axes));
    if (!std::has_single_bit(axes) || !(lows_[first] > 0) || dropped_ > 0) return std::nullopt;
    return first;
  }
  // Valid if `only_axis` is known; off by less than a step each.

  /// The cosine of the angle between axis i of a and axis j of b: [i][j].
  [[nodiscard]] constexpr const auto& cosines() const noexcept { return cosines_; }
  /// The way from the center of a to that of b along the axes of a, and along those of b.
  [[nodiscard]] constexpr const auto& along_a() const noexcept { return along_a_; }
  [[nodiscard]] constexpr const auto& along_b() const noexcept { return along_b_; }
  /// The sum of all extents.
  [[nodiscard]] constexpr const Fixed<32, 0>& sum() const noexcept { return sum_; }
  /// On which side of a, along `axis`, b is: 1 or -1, exactly; 0 on neither.
  template <Number V>
  [[nodiscard]] constexpr int side_of(const Vec<V, 3>& axis) const noexcept {
    const auto along = dot(axis, apart_);
    return (along > 0) - (along < 0);
  }

 private:
  static_assert(bits_of<direction_component<S>> > 30, "detent: the lemma is for axes of 32 bits");
  using Slack = Fixed<62, ShortCosine::frac>;
  using Depth = Fixed<42, 0>;
  /// Shorter cross products of two axes may be too inexact.
  static constexpr auto least_square = square(ShortCosine::from_raw(1 << (ShortCosine::frac - 7)));

  template <Number T>
  [[nodiscard]] static constexpr Vec<Length, 3> cut(const Vec<T, 3>& v, int dropped) noexcept {
    return make_vec<3>([&](int i) {
      return Length::assume_raw(
          static_cast<typename Length::raw_type>(shift_right_floor(v[i].raw(), dropped)));
    });
  }
  [[nodiscard]] static constexpr Depth floor_of(const Slack& slack) noexcept {
    return narrow_floor<Depth>(slack);
  }

  /// The push along axis k is off from `depth` by less than `error`.
  constexpr void bound_axis(std::size_t k, const Depth& depth, const Depth& error) noexcept {
    lows_[k] = narrow<Depth::bits>(depth - error);
    least_high_ = (std::min)(least_high_, narrow<Depth::bits>(depth + error));
  }

  /// source: separating axes by cosines, Ericson, Real-Time Collision Detection, 4.4.1
  template <class FrameA, class FrameB>
  constexpr void bound(const FrameA& a, const Vec<Length, 3>& extents_a, const FrameB& b,
                       const Vec<Length, 3>& extents_b, const Vec<Length, 3>& apart) noexcept {
    if (!is_square(a) || !is_square(b)) return;
    using Error = Fixed<32, 0>;
    sum_ = Error(extents_a.x);
    for (const auto& extent : {extents_a.y, extents_a.z, extents_b.x, extents_b.y, extents_b.z}) {
      sum_ = narrow<32>(sum_ + extent);
    }
    const auto error = narrow<32>(scale_down<32>(sum_, 18) + Error(32));
    const auto slack = [](const auto& reach, const auto& place) {
      return narrow_difference<62>(reach, abs(place));
    };
    const auto bound_face = [&](std::size_t k, const Slack& x) {
      const Depth depth = floor_of(x);
      bound_axis(k, depth, error);
      are_apart_ = are_apart_ || depth < -error;
    };
    std::array<Vec<ShortCosine, 3>, 3> cosines, lengths;  // [i][j]: axis i of a, axis j of b
    Vec<Place, 3> along_a;
    for_each_axis([&](auto i) {
      cosines[i] =
          make_vec<3>([&](int j) { return narrow_floor<ShortCosine>(cosine(a, i, b, j)); });
      lengths[i] = make_vec<3>([&](int j) { return abs(cosines[i][j]); });
      along_a[i] = narrow_floor<Place>(a.along(i, apart));
      cosines_[i] = to_array(cosines[i]);
      along_a_[i] = along_a[i];
      bound_face(2 - i, slack(narrow_sum<61>(extents_a[i], narrow_dot<61>(extents_b, lengths[i])),
                              along_a[i]));
    });
    if (are_apart_) return;
    for_each_axis([&](auto j) {
      const Vec column{lengths[0][j], lengths[1][j], lengths[2][j]};
      const auto along_b = narrow_floor<Place>(b.along(j, apart));
      along_b_[j] = along_b;
      bound_face(5 - j,
                 slack(narrow_sum<61>(extents_b[j], narrow_dot<61>(extents_a, column)), along_b));
    });
    if (are_apart_) return;
    for_each_axis([&](auto i) {
      constexpr int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      for_each_axis([&](auto j) {
        constexpr int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        const auto reach_a =
            narrow_dot<61>(Vec{extents_a[i1], extents_a[i2]}, Vec{lengths[i2][j], lengths[i1][j]});
        const auto reach_b =
            narrow_dot<61>(Vec{extents_b[j1], extents_b[j2]}, Vec{lengths[i][j2], lengths[i][j1]});
        const auto place =
            narrow_cross<61>(Vec{cosines[i1][j], cosines[i2][j]}, Vec{along_a[i1], along_a[i2]});
        const auto squared = narrow<58>(square(lengths[i1][j]) + square(lengths[i2][j]));
        bound_edges(6 + 3 * i + j, slack(narrow_sum<61>(reach_a, reach_b), place), squared, error);
      });
    });
  }

  /// Axis k across two edges. The push is x over the length of their cross product, which is at most
  /// 1; x is off by less than `error`.
  template <Number Square, Number Error>
  constexpr void bound_edges(std::size_t k, const Slack& x, const Square& squared,
                             const Error& error) noexcept {
    const Depth least = floor_of(x);
    are_apart_ = are_apart_ || least < -error;
    if (squared < least_square) return;
    lows_[k] = narrow<Depth::bits>(least - error);
    if (lows_[k] > least_high_) return;
    bound_axis(k, over_length(x, squared),
               narrow<Depth::bits>(over_length(Slack(error), squared) + Depth(4)));
  }

  /// Calls f with 0, 1 and 2 as constants, so that compilers make no loop of it.
  template <class F>
  static constexpr void for_each_axis(const F& f) noexcept {
    f(std::integral_constant<std::size_t, 0>());
    f(std::integral_constant<std::size_t, 1>());
    f(std::integral_constant<std::size_t, 2>());
  }
  template <class FrameA, class FrameB>
  [[nodiscard]] static constexpr auto cosine(const FrameA& a, int i, const FrameB& b,
                                             int j) noexcept {
    if constexpr (std::is_same_v<FrameA, WorldFrame>) {
      return b.edge(j)[i];
    } else {
      return b.along(j, a.edge(i).vec());
    }
  }
  template <Number Square>
  [[nodiscard]] static constexpr Depth over_length(const Slack& x, const Square& squared) noexcept {
    return narrow<Depth::bits>(
        over_root(Fixed<62, 0>::assume_raw(x.raw()), Fixed<58, 0>::assume_raw(squared.raw())));
  }

  Vec<decltype((S() + S()) - (S() + S())), 3> apart_;
  std::array<Depth, 15> lows_;
  Depth least_high_ = largest<Depth>;
  std::array<std::array<ShortCosine, 3>, 3> cosines_;  // arrays, for numbers known only at run time
  std::array<Place, 3> along_a_, along_b_;
  Fixed<32, 0> sum_;
  int dropped_ = 0;
  bool are_apart_ = false;
};

template <class Shape>
inline constexpr bool is_box_in_space = false;
template <Scalar S>
inline constexpr bool is_box_in_space<Aabb<S, 3>> = true;
template <Scalar S>
inline constexpr bool is_box_in_space<Obb<S, 3>> = true;

/// Whether there is a filter for two shapes: for boxes in 3D that may be turned, if it pays.
template <class S, class A, class B>
inline constexpr bool has_axis_filter =
    is_fixed<S>&& filter_pays<S>&& is_box_in_space<A>&& is_box_in_space<B> &&
    !(is_kind<A, Aabb> && is_kind<B, Aabb>);

template <Scalar S, class A, class B>
[[nodiscard]] constexpr auto axis_filter(const A& a, const B& b) noexcept {
  if constexpr (has_axis_filter<S, A, B>) {
    return AxisFilter<S>(a, b);
  } else {
    return AnyAxis();
  }
}

}  // namespace detent::detail
