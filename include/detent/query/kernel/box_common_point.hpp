// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/number/filter/ratio.hpp"
#include "detent/query/kernel/argument.hpp"
#include "detent/query/kernel/box_witness.hpp"
#include "detent/shape/obb.hpp"

// A common point of two oriented boxes, chosen as in common_point.hpp, by a filter in words
// (docs/filters.md, lemma 23).

namespace detent::detail {

/// The corners of an oriented box in the frame of another one, `frame`: the coordinates
/// normal[k].(corner - center) for the normals of the frame's faces, which are the cross products of
/// its axes. A point is in the frame's box if each coordinate is at most its half extent times the
/// frame's determinant.
///
/// The coordinates are truncated to words of 2^-61 of a number of 123 bits and are off by less than
/// 4 steps. A corner with an unsure side may be outside or inside.
template <Scalar S>
class CornersInFrame {
 public:
  /// `apart` leads from the center of the frame to that of the box. All must fit.
  template <Number T>
  constexpr CornersInFrame(const SpannedBox<S>& box, const SpannedBox<S>& frame,
                           const Vec<T, 3>& apart) noexcept
      : box_(box) {
    for (int i = 0; i < 3; ++i) {
      edges_[at(i)] = make_vec<3>(
          [&](int j) { return edge_of<Edge>(box.half_extents[i], box.rotation.axis(i)[j]); });
    }
    for (int k = 0; k < 3; ++k) {
      const auto normal = narrow_cross<61>(frame.rotation.axis((k + 1) % 3).vec(),
                                           frame.rotation.axis((k + 2) % 3).vec());
      auto& row = places_[at(k)];
      row[3] =
          narrow_dot<123>(normal, make_vec<3>([&](int i) { return Edge(narrow<32>(apart[i])); }));
      for (std::size_t i = 0; i < 3; ++i) row[i] = narrow_dot<123>(normal, edges_[i]);
      if (k == 0) volume_ = abs(narrow_dot<92>(normal, frame.rotation.axis(0).vec()));
      reaches_[at(k)] =
          narrow_floor<Reach>(narrow_product<123>(frame.half_extents[k], volume_));  // exact
      auto& words = words_[at(k)];
      for (std::size_t i = 0; i < 4; ++i) words[i] = floor_to<Word>(row[i]);
      reach_words_[at(k)] = floor_to<Word>(reaches_[at(k)]);
    }
    for (std::size_t c = 0; c < 8; ++c) classify(c);
  }

  /// Whether a corner is in the frame's box.
  [[nodiscard]] constexpr Filtered is_inside(std::size_t c) const noexcept {
    if (outside_[c] != 0) return Filtered::no;
    return unsure_[c] != 0 ? Filtered::unsure : Filtered::yes;
  }
  /// The corner, rounded to nearest.
  [[nodiscard]] constexpr Vec<S, 3> rounded_corner(std::size_t c) const noexcept {
    return nearest_to<S>(corner(c));
  }

  /// Whether the segment between two corners that are outside meets the frame's box.
  [[nodiscard]] constexpr Filtered meets(std::size_t from, std::size_t to) noexcept {
    if ((outside_[from] & outside_[to]) != 0) return Filtered::no;
    bool is_sure = (unsure_[from] | unsure_[to]) == 0;
    // It enters the slab of each axis k with `from` outside at (start - reach) / whole, and leaves
    // that of each axis l with `to` outside at 1 - (end - reach) / whole.
    const auto is_out = [&](std::size_t c, int k) { return (outside_[c] >> (2 * k) & 3) != 0; };
    entry_ = -1;
    for (int k = 0; k < 3; ++k) {
      if (!is_out(from, k)) continue;
      const auto enter = beyond(from, k), whole = length(from, to, k);
      for (int l = 0; l < 3; ++l) {
        if (!is_out(to, l) || k == l) continue;
        const auto leave = beyond(to, l), whole_l = length(from, to, l);
        const auto error = error_of(whole, whole_l);
        const auto slack = narrow<126>(whole * whole_l - enter * whole_l - leave * whole);
        if (slack <= -error) return Filtered::no;
        is_sure = is_sure && slack >= error;
      }
      if (entry_ >= 0) {
        const auto best = beyond(from, entry_), best_whole = length(from, to, entry_);
        const auto later = narrow<126>(enter * best_whole - best * whole);
        const auto error = error_of(whole, best_whole);
        is_sure = is_sure && abs(later) >= error;
        if (later < 0) continue;
      }
      entry_ = k;
    }
    return is_sure && entry_ >= 0 ? Filtered::yes : Filtered::unsure;
  }
  /// Where that segment, for which `meets` returned `yes`, enters the box, rounded to nearest.
  [[nodiscard]] constexpr Decided<Vec<S, 3>> entry(std::size_t from,
                                                   std::size_t to) const noexcept {
    const auto start = place(from, entry_), end = place(to, entry_);
    const auto over = narrow<124>(abs(start) - reaches_[at(entry_)]);
    const auto under = narrow<124>(abs(end - start));
    const auto ratio = make_ratio_below_one(over, under);
    const auto p = corner(from), q = corner(to);
    return decide_each<S, 3>(
        [&](int i) { return decide_between<S>(p[i], narrow_difference<63>(q[i], p[i]), ratio); });
  }

 private:
  static constexpr int frac = S::frac + 30;
  using Place = Fixed<123, frac + 60>;
  using Edge = Fixed<61, frac>;
  using Reach = Fixed<122, frac + 60>;
  using Word = Fixed<62, frac - 1>;
  using Row = std::array<Place, 4>;

  [[nodiscard]] static constexpr std::size_t at(int i) noexcept {
    return static_cast<std::size_t>(i);
  }
  template <int Bits, class T>
  [[nodiscard]] static constexpr T sum_of(const std::array<T, 4>& terms, std::size_t c) noexcept {
    auto sum = terms[3];
    for (std::size_t i = 0; i < 3; ++i) {
      sum = (c >> i & 1) != 0 ? narrow_sum<Bits>(sum, terms[i])
                              : narrow_difference<Bits>(sum, terms[i]);
    }
    return sum;
  }
  [[nodiscard]] constexpr Place place(std::size_t c, int k) const noexcept {
    return sum_of<123>(places_[at(k)], c);
  }
  [[nodiscard]] constexpr Vec<Fixed<63, frac>, 3> corner(std::size_t c) const noexcept {
    return make_vec<3>([&](int i) {
      Fixed<63, frac> sum(box_.center[i]);
      for (std::size_t m = 0; m < 3; ++m) {
        sum = (c >> m & 1) != 0 ? narrow_sum<63>(sum, edges_[m][i])
                                : narrow_difference<63>(sum, edges_[m][i]);
      }
      return sum;
    });
  }

  constexpr void classify(std::size_t c) noexcept {
    for (int k = 0; k < 3; ++k) {
      const auto x = corner_words_[c][at(k)] = sum_of<62>(words_[at(k)], c);
      const auto& reach = reach_words_[at(k)];
      constexpr auto error = Word::from_raw(8);
      const bool is_above = x >= reach + error, is_below = -x >= reach + error;
      const bool is_between = x + error <= reach && -x + error <= reach;
      outside_[c] |= (is_above ? 1 : is_below ? 2 : 0) << (2 * k);
      unsure_[c] |= is_above || is_below || is_between ? 0 : 1;
    }
  }

  [[nodiscard]] constexpr auto beyond(std::size_t c, int k) const noexcept {
    return narrow<62>(abs(corner_words_[c][at(k)]) - reach_words_[at(k)]);
  }
  [[nodiscard]] constexpr auto length(std::size_t from, std::size_t to, int k) const noexcept {
    return narrow<62>(abs(corner_words_[to][at(k)] - corner_words_[from][at(k)]));
  }
  template <Number T>
  [[nodiscard]] static constexpr auto error_of(const T& a, const T& b) noexcept {
    using Error = Fixed<126, 2 * Word::frac>;
    constexpr auto steps = Fixed<7, Word::frac>::from_raw(64);
    return narrow<126>((a + b + Word::from_raw(64)) * steps + Error());
  }

  SpannedBox<S> box_;
  std::array<Vec<Edge, 3>, 3> edges_;
  Fixed<92, 90> volume_;
  std::array<Reach, 3> reaches_;
  std::array<Row, 3> places_;  // of the edges, then of the center
  std::array<std::array<Word, 4>, 3> words_;
  std::array<Word, 3> reach_words_;
  std::array<std::array<Word, 3>, 8> corner_words_{};
  std::array<int, 8> outside_{}, unsure_{};  // outside_: two bits per axis
  int entry_ = -1;
};

/// The common point of two boxes that overlap, as `common_point` chooses it.
template <class A, class B>
[[nodiscard]] constexpr auto common_point_by_words(const A& box_a, const B& box_b) noexcept {
  using S = std::remove_cvref_t<decltype(PointOf<A>::type::x)>;
  using Point = Decided<Vec<S, 3>>;
  constexpr Point unsure{{}, false};
  const SpannedBox<S> a(box_a), b(box_b);
  const auto apart = a.center - b.center;
  if (!fit_words(a, b)) return unsure;
  CornersInFrame<S> of_a(a, b, apart);
  for (std::size_t c = 0; c < 8; ++c) {
    const auto is_inside = of_a.is_inside(c);
    if (is_inside == Filtered::yes) return Point{of_a.rounded_corner(c), true};
    if (is_inside == Filtered::unsure) return unsure;
  }
  CornersInFrame<S> of_b(b, a, b.center - a.center);
  for (std::size_t c = 0; c < 8; ++c) {
    const auto is_inside = of_b.is_inside(c);
    if (is_inside == Filtered::yes) return Point{of_b.rounded_corner(c), true};
    if (is_inside == Filtered::unsure) return unsure;
  }
  for (auto* corners : {&of_a, &of_b}) {
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t j = i + 1; j < 8; ++j) {
        const auto meets = corners->meets(i, j);
        if (meets == Filtered::unsure) return unsure;
        if (meets == Filtered::yes) return corners->entry(i, j);
      }
    }
  }
  return unsure;
}

}  // namespace detent::detail
