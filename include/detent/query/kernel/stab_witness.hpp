// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/number/fraction.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/differences.hpp"
#include "detent/query/kernel/simplex.hpp"
#include "detent/query/kernel/stab.hpp"
#include "detent/query/kernel/support.hpp"
#include "detent/query/kernel/touch_witness.hpp"

// The first touch of two polytopes by witnesses: a direction along which they stay apart, or the
// face of their Minkowski difference that the motion enters. Both are checked exactly, so a linear
// program over short rounded corners may propose them (docs/filters.md, lemma 18).

namespace detent::detail {

/// The rounded corners of a hull.
template <class Corner>
class ShortCorners {
 public:
  static constexpr std::size_t capacity = 32;

  explicit constexpr ShortCorners(std::size_t count) noexcept : count_(count) {}

  [[nodiscard]] constexpr std::size_t size() const noexcept { return count_; }
  [[nodiscard]] constexpr Corner& operator[](std::size_t i) noexcept { return corners_[i]; }
  [[nodiscard]] constexpr const Corner& operator[](std::size_t i) const noexcept {
    return corners_[i];
  }

 private:
  std::array<Corner, capacity> corners_{};
  std::size_t count_;
};

/// A vector perpendicular to a facet of N corners, along the motion if the line stabs the facet's
/// corners in the order of `Stab`.
template <Number T>
[[nodiscard]] constexpr auto normal_of_face(const std::array<Vec<T, 3>, 3>& corners) noexcept {
  return facet_normal(simplex_of(corners[0], corners[1], corners[2]));
}
template <Number T>
[[nodiscard]] constexpr auto normal_of_face(const std::array<Vec<T, 2>, 2>& corners) noexcept {
  return facet_normal(simplex_of(corners[1], corners[0]));
}

/// Where a ray from 0 along `way` enters the differences of the bodies `a`, moving along `way`, and
/// `b`.
template <class A, class B, Number W, Scalar S>
class StabWitness {
 public:
  static constexpr int dimension = A::dimension;
  using Way = Vec<W, dimension>;
  using Corner = decltype(std::declval<const B&>().some() - std::declval<const A&>().some());
  using Component = std::remove_cvref_t<decltype(Corner().x)>;
  template <class T>
  using Each = std::array<T, static_cast<std::size_t>(dimension)>;
  using Normal = std::remove_cvref_t<decltype(normal_of_face(Each<Corner>()))>;
  using NormalPart = std::remove_cvref_t<decltype(Normal().x)>;

  constexpr StabWitness(const A& a, const B& b, const Way& way) noexcept
      : a_(a), b_(b), way_(way) {}

  struct Entry {
    S distance;
    Normal normal;         // of the face, along the motion
    Each<Corner> corners;  // as many of the differences as axes, on the face
  };

  /// The entry, or nothing if there is none within `limit`. Unsure if the bodies share a point at
  /// the start, if the ray meets no interior point of the face's simplex, or if a hull has too many
  /// corners.
  [[nodiscard]] constexpr Decided<std::optional<Entry>> entry(const S& limit) const noexcept {
    constexpr Decided<std::optional<Entry>> unsure{std::nullopt, false};
    if (!has_few_corners(a_) || !has_few_corners(b_)) return unsure;
    const Corner low = b_.low() - a_.high(), high = b_.high() - a_.low();
    const int dropped = (std::max)((std::max)(longest_bits(low), longest_bits(high)) - end_bits, 0);
    const auto from = a_.some();
    const auto rough_a = rough_corners(a_, dropped, from);
    const auto rough_b = rough_corners(b_, dropped, from);
    const Differences<decltype(rough_a), decltype(rough_b)> points(rough_a, rough_b);
    const auto way = shortened<Rough::bits>(way_);
    using RoughWay = std::remove_cvref_t<decltype(way)>;
    using Point = std::remove_cvref_t<decltype(points[0])>;
    using RoughComponent = std::remove_cvref_t<decltype(Point().x)>;
    Stab<RoughComponent, dimension, std::remove_cvref_t<decltype(points)>, RoughWay> stab(
        Point(), way, points);
    if (!stab.meets()) {
      return are_apart_along(stab.lack(), limit) ? Decided<std::optional<Entry>>{{}, true} : unsure;
    }
    if (!stab.is_face()) return unsure;
    stab.go_to_first();
    Each<Index> indices;
    for (int k = 0; k < dimension; ++k) {
      const auto index = static_cast<std::size_t>(stab.index_of(k));
      indices[static_cast<std::size_t>(k)] = {index % rough_a.size(), index / rough_a.size()};
    }
    // Shorter differences use narrower integers.
    constexpr int bits = bits_of<Component>, few = (std::min)(bits, 61);
    const bool is_short = fits<few>(low) && fits<few>(high);
    const auto found = is_short ? face<few>(indices, limit) : face<bits>(indices, limit);
    if (!found.is_sure && are_apart_along(stab.normal(), limit)) return {std::nullopt, true};
    return found;
  }

 private:
  /// The ends of rounded differences have one bit more than the bodies' corners. The products of
  /// the linear program fit a word.
  static constexpr int end_bits = dimension == 2 ? 26 : 17;
  using Rough = Fixed<end_bits + 2, 0>;
  using RoughCorner = Vec<Fixed<end_bits + 1, 0>, dimension>;

  /// The corners of `a` and `b` whose difference is a point.
  struct Index {
    std::size_t a, b;
  };

  template <class Body>
  static constexpr bool is_array = requires(const Body& body) {
    std::tuple_size<std::remove_cvref_t<decltype(body.corners())>>::value;
  };
  template <class Body>
  [[nodiscard]] static constexpr bool has_few_corners(const Body& body) noexcept {
    if constexpr (is_array<Body>) {
      return true;
    } else {
      return body.corners().size() <= ShortCorners<RoughCorner>::capacity;
    }
  }

  /// The corners relative to `from`, in steps of 2^dropped of `Component`.
  template <class Body, class From>
  [[nodiscard]] static constexpr auto rough_corners(const Body& body, int dropped,
                                                    const From& from) noexcept {
    const auto& corners = body.corners();
    auto result = [&] {
      if constexpr (is_array<Body>) {
        return std::array<RoughCorner, std::tuple_size_v<std::remove_cvref_t<decltype(corners)>>>{};
      } else {
        return ShortCorners<RoughCorner>(corners.size());
      }
    }();
    for (std::size_t k = 0; k < result.size(); ++k) {
      const auto offset = corners[k] - from;
      result[k] = make_vec<dimension>([&](int i) {
        using T = std::remove_cvref_t<decltype(RoughCorner().x)>;
        return T::assume_raw(integer_cast<typename T::raw_type>(
            shift_right_floor(Component(offset[i]).raw(), dropped)));
      });
    }
    return result;
  }

  /// Whether all differences lie beyond the ray, or all of it up to `limit`, along `v`, shortened.
  template <Number V>
  [[nodiscard]] constexpr bool are_apart_along(const Vec<V, dimension>& v,
                                               const S& limit) const noexcept {
    constexpr int bits_a = bits_of<std::remove_cvref_t<decltype(a_.some().x)>> + 1;
    constexpr int bits_b = bits_of<std::remove_cvref_t<decltype(b_.some().x)>> + 1;
    const auto across = shortened<24>(v);
    const Corner least = b_.template extreme<bits_b>(across, b_.some(), false) -
                         a_.template extreme<bits_a>(across, a_.some(), true);
    const auto reached = dot(across, least);
    if (!(reached > 0)) return false;
    const auto speed = dot(across, way_);
    return !(speed > 0) || reached > speed * limit;
  }

  /// The entry through the simplex of some differences, if it is a face. All differences have at
  /// most `Bits`.
  template <int Bits>
  [[nodiscard]] constexpr Decided<std::optional<Entry>> face(const Each<Index>& indices,
                                                             const S& limit) const noexcept {
    constexpr Decided<std::optional<Entry>> unsure{std::nullopt, false};
    const auto& corners_a = a_.corners();
    const auto& corners_b = b_.corners();
    Each<Corner> points;
    Each<decltype(narrow<Bits>(Corner()))> corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      points[k] = corners_b[indices[k].b] - corners_a[indices[k].a];
      corners[k] = narrow<Bits>(points[k]);
    }
    const auto normal = normal_of_face(corners);
    const auto speed = dot(normal, way_);
    if (!(speed > 0)) return unsure;
    const auto height = dot(normal, corners[0]);
    if (!(height > 0)) return unsure;
    if (!is_between(corners)) return unsure;
    if (!is_extreme<Bits + 1>(b_, corners_b, indices[0].b, normal, false)) return unsure;
    if (!is_extreme<Bits + 1>(a_, corners_a, indices[0].a, normal, true)) return unsure;
    const auto distance = floor_within(Fraction{height, speed}, limit);
    if (!distance) return {std::nullopt, true};
    return {
        Entry{*distance, make_vec<dimension>([&](int i) { return NormalPart(normal[i]); }), points},
        true};
  }

  /// Whether the line along the motion passes strictly between the corners.
  template <class Corners>
  [[nodiscard]] constexpr bool is_between(const Corners& corners) const noexcept {
    if constexpr (dimension == 2) {
      return cross(way_, corners[0]) > 0 && cross(way_, corners[1]) < 0;
    } else {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!(dot(way_, cross(corners[(k + 1) % 3], corners[(k + 2) % 3])) > 0)) return false;
      }
      return true;
    }
  }

  /// Whether no corner is farther along `v`, or less far if not `farthest`. Differences of corners
  /// have at most `Bits`.
  template <int Bits, class Body, class Corners, Number V>
  [[nodiscard]] static constexpr bool is_extreme(const Body& body, const Corners& corners,
                                                 std::size_t at, const Vec<V, dimension>& v,
                                                 bool farthest) noexcept {
    const auto is_behind = [&](const auto& edge) {
      const auto along = dot(v, at_most<Bits>(edge));
      return farthest ? !(along > 0) : !(along < 0);
    };
    if constexpr (IsBoxBody<Body>) {  // convex: its neighbours suffice
      (void)body;
      for (std::size_t side = 1; side < corners.size(); side *= 2) {
        if (!is_behind(corners[at ^ side] - corners[at])) return false;
      }
    } else {
      for (const auto& corner : corners) {
        if (!is_behind(corner - corners[at])) return false;
      }
    }
    return true;
  }

  const A& a_;
  const B& b_;
  Way way_;
};

}  // namespace detent::detail
