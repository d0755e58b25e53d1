// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>

#include "detent/shape/hull.hpp"

namespace detent::detail {

// The interface of a convex body for GJK: `some()` is one of its corners, all corners lie between
// `low()` and `high()`, and `extreme<Bits>(v, from, farthest)` is a corner that is farthest along
// v, or least far if not `farthest`. A body that scans all of its corners measures them from a
// point `from`; the caller guarantees that no component of a corner minus `from` exceeds `Bits`.

/// The hull of at least one point; `Points` is a span or an array of them.
template <Scalar S, int N, class Points = std::span<const Vec<S, N>>>
class HullBody {
 public:
  static constexpr int dimension = N;

  explicit constexpr HullBody(const ConvexHull<S, N>& hull) noexcept : points_(hull.points) {}
  explicit constexpr HullBody(const Points& points) noexcept
      requires(!std::same_as<Points, std::span<const Vec<S, N>>>)
      : points_(points) {}

  [[nodiscard]] constexpr const Vec<S, N>& some() const noexcept { return points_.front(); }
  [[nodiscard]] constexpr Vec<S, N> low() const noexcept {
    auto bound = some();
    for (const auto& point : points_) {
      for (int i = 0; i < N; ++i) {
        if (point[i] < bound[i]) bound[i] = point[i];
      }
    }
    return bound;
  }
  [[nodiscard]] constexpr Vec<S, N> high() const noexcept {
    auto bound = some();
    for (const auto& point : points_) {
      for (int i = 0; i < N; ++i) {
        if (point[i] > bound[i]) bound[i] = point[i];
      }
    }
    return bound;
  }

  template <int Bits, Number V, Number T>
  [[nodiscard]] constexpr const Vec<S, N>& extreme(const Vec<V, N>& v, const Vec<T, N>& from,
                                                   bool farthest) const noexcept {
    const auto along = [&](const Vec<S, N>& point) { return dot(v, narrow<Bits>(point - from)); };
    const Vec<S, N>* best = &points_.front();
    auto reached = along(*best);
    for (const auto& point : std::span(points_).subspan(1)) {
      const auto place = along(point);
      if (farthest ? place > reached : place < reached) {
        best = &point;
        reached = place;
      }
    }
    return *best;
  }

 private:
  Points points_;
};
template <Scalar S, int N>
HullBody(const ConvexHull<S, N>&) -> HullBody<S, N>;
template <Scalar S, int N, std::size_t Count>
HullBody(const std::array<Vec<S, N>, Count>&) -> HullBody<S, N, std::array<Vec<S, N>, Count>>;

}  // namespace detent::detail
