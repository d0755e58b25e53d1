// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "detent/number/filter/ratio.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/query/kernel/touch_witness.hpp"

// The closest features of two bodies with few corners, by words: a filter for the exact search
// (docs/filters.md, lemma 24).

namespace detent::detail {

/// Whether a body lists at most three corners, on the grid of a scalar.
template <class Body, class S>
inline constexpr bool lists_corners = false;
template <Scalar S, std::size_t Count>
inline constexpr bool lists_corners<HullBody<S, 3, std::array<Vec<S, 3>, Count>>, S> = Count <= 3;

/// A feature of the differences of the corners of `b` and of `a`, which moves along `way`, at a
/// time and until the next one on the grid of `S`, in 3D.
template <class A, class B, Number W, Scalar S>
class TouchFeature {
 public:
  using Way = Vec<W, 3>;

  /// `feature` has `corners`, differences at the start, and their `count`.
  template <class Feature>
  constexpr TouchFeature(const A& a, const B& b, const Way& way, const S& time,
                         const Feature& feature) noexcept
      : a_(a), b_(b), way_(way), time_(time) {
    is_unique_ = find_corners(feature) && is_closest(feature);
  }

  /// Whether the closest differences are inside the feature all the time, and those of no other
  /// corners are. If not, that is possible, but unsure.
  [[nodiscard]] constexpr bool is_unique() const noexcept { return is_unique_; }

  /// The point of `b` closest to `a`, rounded to nearest, if the feature is unique.
  [[nodiscard]] constexpr Vec<S, 3> point() const noexcept {
    const auto& from = corner_b(0);
    if (count_b_ == 1) return from;
    const auto place = from - corner_a(0) - way_ * time_;
    const auto along = [&](const auto& edge, const auto& over, const auto& under) {
      using Over = std::remove_cvref_t<decltype(over)>;
      const auto ratio = make_ratio_below_one(over, Over(under));
      return make_vec<3>([&](int i) { return add_product(from[i], edge[i], ratio); });
    };
    const auto edge = corner_b(1) - from;
    if (count_b_ == 2 && count_a_ == 1) {
      return along(edge, narrow_negative(dot(edge, place)), squared_length(edge));
    }
    if (count_b_ == 2) {
      const auto other = corner_a(1) - corner_a(0);
      const auto normal = cross(other, edge);
      return along(edge, dot(normal, cross(place, other)), squared_length(normal));
    }
    const auto normal = cross(edge, corner_b(2) - from);
    const auto whole = squared_length(normal);
    return rounded<S>(
        RationalPoint{(way_ * time_ + corner_a(0)) * whole + normal * dot(normal, place), whole});
  }

  /// The same for `b` grown by `radius`, as `nearly_rounded_beyond` rounds it, if both are within its
  /// error of the exact point and no midpoint is.
  [[nodiscard]] constexpr std::optional<Vec<S, 3>> point_beyond(const S& radius) const noexcept {
    if (radius == 0) return point();
    const auto& from = corner_b(0);
    const auto place = from - corner_a(0) - way_ * time_;
    const auto beyond = [&](const auto& p, const auto& v) {
      const auto decided = decide_beyond(p, radius, narrow_negative(v));
      return decided.is_sure ? std::optional(decided.value) : std::nullopt;
    };
    if (count_b_ == 3) return std::nullopt;
    if (count_b_ == 1 && count_a_ == 1) return beyond(from, place);
    const auto edge = corner_b(count_b_ - 1) - from;
    if (count_b_ == 2 && count_a_ == 2) {
      const auto other = corner_a(1) - corner_a(0);
      const auto normal = cross(other, edge);
      const auto over = dot(normal, cross(place, other));
      const auto whole = squared_length(normal);
      return beyond(RationalPoint{from * whole + edge * over, whole},
                    dot(normal, place) < 0 ? narrow_negative(normal) : normal);
    }
    if (count_b_ == 2) {
      const auto whole = squared_length(edge);
      const auto along = dot(edge, place);
      return beyond(RationalPoint{from * whole - edge * along, whole},
                    place * whole - edge * along);
    }
    if (count_a_ == 2) {
      const auto other = corner_a(1) - corner_a(0);
      return beyond(from, place * squared_length(other) - other * dot(other, place));
    }
    const auto normal = cross(corner_a(1) - corner_a(0), corner_a(2) - corner_a(0));
    return beyond(from, dot(normal, place) < 0 ? narrow_negative(normal) : normal);
  }

 private:
  using Corner = decltype(std::declval<const B&>().some() - std::declval<const A&>().some());
  using Place = decltype(Corner() - Way() * S());
  using PlacePart = std::remove_cvref_t<decltype(Place().x)>;
  using Rough = Fixed<28, 0>;
  using Edge = decltype(Vec<S, 3>() - Vec<S, 3>());
  using Slack = Fixed<21, 0>;

  [[nodiscard]] constexpr const Vec<S, 3>& corner_a(int k) const noexcept {
    return a_.corners()[in_a_[static_cast<std::size_t>(k)]];
  }
  [[nodiscard]] constexpr const Vec<S, 3>& corner_b(int k) const noexcept {
    return b_.corners()[in_b_[static_cast<std::size_t>(k)]];
  }

  /// Finds the corners of the bodies whose differences are all those of the feature.
  template <class Feature>
  [[nodiscard]] constexpr bool find_corners(const Feature& feature) noexcept {
    for (int k = 0; k < feature.count; ++k) {
      if (!find_corner(feature.corners[static_cast<std::size_t>(k)])) return false;
    }
    // A corner and a corner, edge or triangle, or two edges.
    return count_a_ + count_b_ == feature.count + 1;
  }
  template <class Difference>
  [[nodiscard]] constexpr bool find_corner(const Difference& difference) noexcept {
    for (std::size_t j = 0; j < b_.corners().size(); ++j) {
      for (std::size_t i = 0; i < a_.corners().size(); ++i) {
        if (!(b_.corners()[j] - a_.corners()[i] == difference)) continue;
        add(in_a_, count_a_, i);
        add(in_b_, count_b_, j);
        return true;
      }
    }
    return false;
  }
  using Indices = std::array<std::size_t, 3>;
  static constexpr void add(Indices& indices, int& count, std::size_t index) noexcept {
    if (!has(indices, count, index)) indices[static_cast<std::size_t>(count++)] = index;
  }
  [[nodiscard]] static constexpr bool has(const Indices& indices, int count,
                                          std::size_t index) noexcept {
    for (int k = 0; k < count; ++k) {
      if (indices[static_cast<std::size_t>(k)] == index) return true;
    }
    return false;
  }

  /// The leading bits of a vector as integers: only its direction counts.
  template <Number V>
  [[nodiscard]] static constexpr Vec<Rough, 3> leading(const Vec<V, 3>& v) noexcept {
    const auto words = shortened<Rough::bits>(v);
    return make_vec<3>([&](int i) {
      return Rough::assume_raw(integer_cast<typename Rough::raw_type>(words[i].raw()));
    });
  }

  template <class Feature>
  [[nodiscard]] constexpr bool is_closest(const Feature& feature) const noexcept {
    const auto offset = way_ * time_;
    const int length = (std::max)(longest_bits(b_.low() - a_.high() - offset),
                                  longest_bits(b_.high() - a_.low() - offset));
    const int dropped = (std::max)(length - (Rough::bits - 1), 0);
    // How far the components of a place are from the rounded one, until the next time.
    const int finer = W::frac - dropped;
    if (finer > 18) return false;
    const Slack slack = Slack::assume_raw((1 << (std::max)(finer, 0)) + 2);
    std::array<Vec<Rough, 3>, 3> places;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const auto& corner = feature.corners[k < static_cast<std::size_t>(feature.count) ? k : 0];
      places[k] = without_low_bits<Rough>(corner - offset, dropped);
    }
    constexpr Slack one(1);
    constexpr auto unit = Fixed<31, 0>::assume_raw(1 << 30);
    const auto margin = unit * (slack + one);
    if (feature.count == 1) return is_behind(places[0], margin, dropped);
    if (feature.count == 2) {
      const auto edge = leading(feature.corners[1] - feature.corners[0]);
      const auto along = dot(edge, places[0]);
      if (!(narrow_negative(along) > margin) || !(dot(edge, places[1]) > margin)) return false;
      const auto ratio = quotient_floor<Fixed<50, 30>>(along, squared_length(edge));
      const auto across = make_vec<3>([&](int i) {
        return narrow<30>(places[0][i] - narrow_floor<Fixed<32, 0>>(edge[i] * ratio));
      });
      constexpr Slack more(15);
      return is_behind(across, unit * (slack + slack + more), dropped);
    }
    const auto& corners = feature.corners;
    const auto normal = leading(cross(corners[1] - corners[0], corners[2] - corners[0]));
    constexpr auto area = Fixed<62, 0>::assume_raw(Fixed<62, 0>::raw_type{1} << 61);
    const auto least = area * (slack + one);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(dot(normal, cross(places[(k + 1) % 3], places[(k + 2) % 3])) > least)) return false;
    }
    const auto height = dot(normal, places[0]);
    if (height > margin) return is_behind(normal, unit * (one + one), dropped);
    if (!(narrow_negative(height) > margin)) return false;
    return is_behind(narrow_negative(normal), unit * (one + one), dropped);
  }

  /// Whether all other corners are behind those of the feature along v, by more than the margin.
  template <Number V, Number Margin>
  [[nodiscard]] constexpr bool is_behind(const Vec<V, 3>& v, const Margin& margin,
                                         int dropped) const noexcept {
    const auto is_ahead = [&](const Edge& edge) {
      const auto wide = make_vec<3>([&](int i) { return PlacePart(edge[i]); });
      return dot(v, without_low_bits<Fixed<29, 0>>(wide, dropped)) > margin;
    };
    for (std::size_t j = 0; j < b_.corners().size(); ++j) {
      if (!has(in_b_, count_b_, j) && !is_ahead(b_.corners()[j] - corner_b(0))) return false;
    }
    for (std::size_t i = 0; i < a_.corners().size(); ++i) {
      if (!has(in_a_, count_a_, i) && !is_ahead(corner_a(0) - a_.corners()[i])) return false;
    }
    return true;
  }

  const A& a_;
  const B& b_;
  Way way_;
  S time_;
  Indices in_a_{}, in_b_{};
  int count_a_ = 0, count_b_ = 0;
  bool is_unique_ = false;
};

}  // namespace detent::detail
