// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include "detent/query/kernel/pivot.hpp"

namespace detent::detail {

/// The differences b - a of the corners of two bodies, whose hull is the bodies' Minkowski
/// difference: points for `Stab`. Corner i of `a` and corner j of `b` give point i + j * count,
/// where count is the number of corners of `a`.
template <class CornersA, class CornersB>
class Differences {
 public:
  constexpr Differences(const CornersA& a, const CornersB& b) noexcept : a_(a), b_(b) {}

  [[nodiscard]] constexpr std::size_t size() const noexcept { return a_.size() * b_.size(); }
  [[nodiscard]] constexpr auto operator[](std::size_t i) const noexcept {
    return b_[i / a_.size()] - a_[i % a_.size()];
  }

  /// The same as for a list of all points; without `first` it uses the extreme corners of each
  /// body.
  template <class V, class From>
  [[nodiscard]] friend constexpr PointIndex entering_point(const Differences& points, const V& v,
                                                           const From& from, bool first) noexcept {
    const auto is_against = [&](std::size_t i) { return dot(v, points[i] - from) < 0; };
    if (first) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (is_against(i)) return static_cast<PointIndex>(i);
      }
      return no_point;
    }
    const auto i = extreme(points.a_, [&](const auto& x) { return dot(v, x) > 0; });
    const auto j = extreme(points.b_, [&](const auto& x) { return dot(v, x) < 0; });
    const auto best = i + j * points.a_.size();
    return is_against(best) ? static_cast<PointIndex>(best) : no_point;
  }

 private:
  /// The first corner such that leads(other - corner) for no other one.
  template <class Corners, class Leads>
  [[nodiscard]] static constexpr std::size_t extreme(const Corners& corners,
                                                     const Leads& leads) noexcept {
    std::size_t best = 0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      if (leads(corners[i] - corners[best])) best = i;
    }
    return best;
  }

  CornersA a_;
  CornersB b_;
};

/// The differences b - a of the corners of two bodies.
template <class A, class B>
[[nodiscard]] constexpr auto differences(const A& a, const B& b) noexcept {
  using CornersA = std::remove_cvref_t<decltype(a.corners())>;
  using CornersB = std::remove_cvref_t<decltype(b.corners())>;
  return Differences<CornersA, CornersB>(a.corners(), b.corners());
}

}  // namespace detent::detail
