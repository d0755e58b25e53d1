// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/math/width.hpp"
#include "detent/number/patience.hpp"
#include "detent/query/kernel/simplex.hpp"
#include "detent/query/kernel/support.hpp"

namespace detent::detail {

/// Whether differences are on the finer grid of the corners of oriented boxes.
template <Number T>
inline constexpr bool is_fine = bits_of<T> > 48;

/// Finds the point closest to the origin among the differences a - b of points of two convex
/// bodies, by GJK. `T` holds the components of such differences.
///
/// It keeps a simplex of differences of corners, reduced to the feature that contains its closest
/// point p. Each step takes the corner w with the least p . w. If p . w >= p . p, no difference is
/// closer than p. Otherwise w is added, and the new simplex reaches closer to the origin than the
/// old one. The search ends, because the distance decreases with every step and the corners have
/// only finitely many simplices. No new corner lies in the span of the feature, where p . x = p .
/// p, so the simplex is never flat. All decisions are signs of integers, which are exact.
///
/// source: Gilbert, Johnson, Keerthi, A Fast Procedure for Computing the Distance Between Complex
///         Objects in Three-Dimensional Space (1988); Ericson, Real-Time Collision Detection, 9.5
template <Number T, class A, class B, int N = A::dimension>
class Gjk {
 public:
  using Difference = T;

  constexpr Gjk(const A& a, const B& b) noexcept : a_(a), b_(b) {
    feature_.add(narrow<bits_of<T>>(a.some() - b.some()));
  }

  /// Starts the search at a feature of corner differences, if it can.
  template <Number Corner>
  constexpr void start_at(const Simplex<Corner, N>& feature) noexcept {
    Simplex<T, N> start;
    for (int k = 0; k < feature.count; ++k) start.add(narrow<bits_of<T>>(feature[k]));
    if (holds_foot(start)) feature_ = start;
  }

  /// Whether the bodies share a point.
  [[nodiscard]] constexpr bool touches() noexcept {
    search(true);
    return touches_;
  }

  /// The square of their distance, as a `Fraction`; `none` if the bodies touch.
  template <class Result>
  [[nodiscard]] constexpr Result squared_distance(const Result& none) noexcept {
    search(false);
    return touches_ ? none : detail::squared_distance<Result>(feature_);
  }

  /// The feature of corner differences that holds the closest one; if the bodies touch, one that
  /// holds the origin, after the first query.
  [[nodiscard]] constexpr const Simplex<T, N>& feature() const noexcept { return feature_; }
  /// The feature of corner differences that holds the closest one. Meaningless if the bodies touch.
  [[nodiscard]] constexpr const Simplex<T, N>& closest_feature() noexcept {
    search(false);
    return feature_;
  }

 private:
  /// With `until_apart`, stops as soon as a separating plane is known.
  constexpr void search(bool until_apart) noexcept {
    // Shorter directions use the next narrower integers.
    constexpr int bits = (is_fine<T> ? 253 : 125) - bits_of<T>;
    const auto advances = [&](const auto& v) {
      return by_width<bits>([&](const auto& u) { return advance(u, until_apart); }, v);
    };
    for (Patience<T> patience; patience.step();) {
      if (!with_direction(feature_, advances)) return;
      feature_ = nearest_feature(feature_);
      if (feature_.count > N) {
        touches_ = true;
        return;
      }
    }
  }

  template <Number V>
  constexpr bool advance(const Vec<V, N>& v, bool until_apart) noexcept {
    if (is_zero(v)) {
      touches_ = true;
      return false;
    }
    constexpr int bits = bits_of<T>;
    const auto next = narrow<bits>(a_.template extreme<bits>(v, b_.some(), false) -
                                   b_.template extreme<bits>(v, a_.some(), true));
    const auto depth = dot(v, next);
    if (until_apart && depth > 0) return false;
    if (!(depth < dot(v, feature_.newest()))) return false;
    feature_.add(next);
    return true;
  }

  A a_;
  B b_;
  Simplex<T, N> feature_;
  bool touches_ = false;
};

/// Whether the box from `low` to `high` holds the origin.
template <Number T, int N>
[[nodiscard]] constexpr bool holds_origin(const Vec<T, N>& low, const Vec<T, N>& high) noexcept {
  for (int i = 0; i < N; ++i) {
    if (low[i] > 0 || high[i] < 0) return false;
  }
  return true;
}

/// Returns f(T()) for the narrowest type T that holds the differences from `low` to `high`: of 128
/// bits instead of 256 in a search for those below 2^29, and on the finer grid of 256 bits instead of
/// 320 for those below 2^61.
template <Number T, int N, class F>
[[nodiscard]] constexpr auto with_differences(const Vec<T, N>& low, const Vec<T, N>& high,
                                              const F& f) noexcept {
  constexpr int bits = is_fine<T> ? 61 : 29;
  return by_width<bits>(
      [&](const auto& narrow_low, const auto&) {
        return f(std::remove_cvref_t<decltype(narrow_low.x)>());
      },
      low, high);
}

/// Returns f(search), with the search in such numbers.
template <class A, class B, Number T, int N, class F>
[[nodiscard]] constexpr auto with_gjk(const A& a, const B& b, const Vec<T, N>& low,
                                      const Vec<T, N>& high, const F& f) noexcept {
  return with_differences(low, high,
                          [&]<Number Narrow>(const Narrow&) { return f(Gjk<Narrow, A, B>(a, b)); });
}
template <class A, class B, class F>
[[nodiscard]] constexpr auto with_gjk(const A& a, const B& b, const F& f) noexcept {
  return with_gjk(a, b, a.low() - b.high(), a.high() - b.low(), f);
}

/// Whether two bodies share a point.
template <class A, class B>
[[nodiscard]] constexpr bool bodies_overlap(const A& a, const B& b) noexcept {
  const auto low = a.low() - b.high(), high = a.high() - b.low();
  if (!holds_origin(low, high)) return false;
  return with_gjk(a, b, low, high, [](auto search) { return search.touches(); });
}

/// The squared distance between two bodies, as a `Fraction`.
template <class A, class B>
[[nodiscard]] constexpr auto squared_distance_between(const A& a, const B& b) noexcept {
  using Difference = std::remove_cvref_t<decltype((a.some() - b.some()).x)>;
  const auto none = squared_distance_of_none<Difference, A::dimension>();
  return with_gjk(a, b, [&](auto search) { return search.squared_distance(none); });
}

}  // namespace detent::detail
