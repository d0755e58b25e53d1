// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include "detent/query/kernel/common_point.hpp"
#include "detent/query/kernel/directions.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "detent/query/kernel/least_common_point.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/query/kernel/touch_witness.hpp"
#include "detent/query/kernel/weights.hpp"

namespace detent::detail {

/// The points of a and b, in that order.
template <Scalar S, int N>
using PointPair = std::pair<Vec<S, N>, Vec<S, N>>;

/// The closest points of two bodies, each grown by a radius; both radii are 0 unless `AreRound`.
template <Scalar S, bool AreRound, class A, class B, int N = A::dimension>
class ClosestPoints {
 public:
  constexpr ClosestPoints(const A& a, const B& b, const S& radius_a, const S& radius_b) noexcept
      : a_(a), b_(b), radius_a_(radius_a), radius_b_(radius_b) {}

  [[nodiscard]] constexpr PointPair<S, N> find() const noexcept {
    if constexpr (witness_pays<A, B>) {
      auto witness = still_witness(b_, a_);
      const auto overlap = witness.overlap_or_closest();
      if (overlap == Filtered::yes) return common();
      if (overlap == Filtered::no) {
        const auto feature = witness.found().simplex();
        return with_gjk(a_, b_, [&](auto search) {
          search.start_at(feature);
          return apart(search.closest_feature());
        });
      }
    }
    return find_exactly();
  }

  /// The same without a filter.
  [[nodiscard]] constexpr PointPair<S, N> find_exactly() const noexcept {
    return with_gjk(a_, b_, [&](auto search) {
      return search.touches() ? common() : apart(search.closest_feature());
    });
  }

 private:
  [[nodiscard]] constexpr PointPair<S, N> common() const noexcept {
    const auto point = common_point<S>(a_, b_);
    return {point, point};
  }

  /// The bodies are apart; `feature` has the closest difference of their points.
  template <Number T>
  [[nodiscard]] constexpr PointPair<S, N> apart(const Simplex<T, N>& feature) const noexcept {
    using V = typename Directions<T, N>::type;
    const auto v = with_direction(feature, [](const auto& u) { return on_grid_of<V>(u); });
    if constexpr (!is_fixed<S>) {
      Vec<S, N> p, q;
      find_by_weights(a_, b_, feature, p, q);
      return surface_points(RationalPoint{p, S(1)}, RationalPoint{q, S(1)}, v, feature);
    } else {
      // Differences between a and b fit T, and those within a body twice as much.
      using Corner = std::remove_cvref_t<decltype(T() + T())>;
      const auto& origin = finer_origin();
      const auto features = with_direction(feature, [&](const auto& u) {
        return std::pair{extreme_corners<Corner>(a_, u, v, false, origin),
                         extreme_corners<Corner>(b_, u, v, true, origin)};
      });
      return least_common_point(features.first, features.second, [&](const auto& p, const auto& q) {
        return surface_points(from(origin, p), from(origin, q), v, feature);
      });
    }
  }

  /// The points on the surfaces, given those of the bodies; v leads from q towards p.
  template <class P, Number V, Number T>
  [[nodiscard]] constexpr PointPair<S, N> surface_points(
      const P& p, const P& q, const Vec<V, N>& v, const Simplex<T, N>& feature) const noexcept {
    if constexpr (!AreRound) {
      return {rounded<S>(p), rounded<S>(q)};
    } else {
      using Squared = std::remove_cvref_t<decltype(squared_distance_of_none<T, N>())>;
      const auto gap = detail::squared_distance<Squared>(feature);
      if (gap <= square(radius_a_)) return {rounded<S>(q), rounded<S>(q)};
      const auto on_a = rounded_beyond(p, radius_a_, narrow_negative(v));
      if (gap <= square(radius_a_ + radius_b_)) return {on_a, on_a};
      return {on_a, rounded_beyond(q, radius_b_, v)};
    }
  }

  [[nodiscard]] constexpr auto finer_origin() const noexcept {
    using CornerA = std::remove_cvref_t<decltype(a_.some().x)>;
    using CornerB = std::remove_cvref_t<decltype(b_.some().x)>;
    if constexpr (bits_of<CornerB> < bits_of<CornerA>) {
      return a_.some();
    } else {
      return b_.some();
    }
  }

  template <Number O, class Offset>
  [[nodiscard]] static constexpr auto from(const Vec<O, N>& origin, const Offset& offset) noexcept {
    return RationalPoint{origin * offset.under + offset.over, offset.under};
  }

  A a_;
  B b_;
  S radius_a_, radius_b_;
};

}  // namespace detent::detail
