// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "detent/math/vec.hpp"
#include "detent/number/filter/filtered.hpp"

namespace detent::detail {

/// GJK (see gjk.hpp) in the plane, on rounded corners of two bodies with few corners, in words: finds
/// the corners whose differences, b - a, probably contain the closest one to the origin.
class PlanarSearch {
 public:
  static constexpr std::size_t most = 16;  // corners of a body
  using Place = Fixed<29, 0>;
  /// The corners of a body, relative to a point that both bodies share. Differences of two of them
  /// must be below 2^28 + 2^3, and those of two such differences below twice as much.
  class Places {
   public:
    constexpr void add(const Vec<Place, 2>& place) noexcept { places_[size_++] = place; }
    [[nodiscard]] constexpr const Vec<Place, 2>& operator[](std::size_t i) const noexcept {
      return places_[i];
    }
    /// The index of the least place along v, or the greatest. It is packed into the lower bits of
    /// the product: a comparison without a branch, which would be unpredictable.
    template <bool IsGreatest, Number T>
    [[nodiscard]] constexpr std::size_t extreme(const Vec<T, 2>& v) const noexcept {
      auto best = key(v, 0);
      for (std::size_t i = 1; i < size_; ++i) {
        const auto next = key(v, i);
        best = IsGreatest ? (std::max)(best, next) : (std::min)(best, next);
      }
      return static_cast<std::size_t>(best) & (most - 1);
    }

   private:
    using Key = Fixed<63, 0>;
    template <Number T>
    [[nodiscard]] constexpr Key::raw_type key(const Vec<T, 2>& v, std::size_t i) const noexcept {
      const auto along = narrow<58>(dot(v, places_[i]));
      return scale_up<63>(along, 4).raw() + static_cast<Key::raw_type>(i);
    }
    std::array<Vec<Place, 2>, most> places_;
    std::size_t size_ = 0;
  };
  Places a, b;

  /// Whether there seems to be a closest difference other than the origin. It is searched for in the
  /// direction from the origin to `toward` first. If not, and `count` is 3, three differences seem
  /// to enclose the origin.
  [[nodiscard]] constexpr bool find(const Vec<Place, 2>& toward) noexcept {
    corners_[0] = least_along(toward);
    count_ = 1;
    for (int i = 0; i < 24; ++i) {
      across_ = count_ == 1 ? corners_[0].place : normal();
      const Corner next = least_along(across_);
      if (!(dot(across_, next.place) < dot(across_, newest().place))) return true;
      add(next);
      if (count_ > 2) return false;
    }
    return false;
  }

  /// How many corners the feature has, and their indices; the newest is last.
  [[nodiscard]] constexpr int count() const noexcept { return count_; }
  [[nodiscard]] constexpr std::size_t index_a(std::size_t k) const noexcept {
    return corners_[k].in_a;
  }
  [[nodiscard]] constexpr std::size_t index_b(std::size_t k) const noexcept {
    return corners_[k].in_b;
  }
  /// A vector from the origin across the feature.
  using Across = Vec<Place, 2>;
  [[nodiscard]] constexpr const Across& across() const noexcept { return across_; }

 private:
  struct Corner {
    std::size_t in_a, in_b;
    Vec<Place, 2> place;
  };

  [[nodiscard]] constexpr const Corner& newest() const noexcept {
    return corners_[static_cast<std::size_t>(count_ - 1)];
  }

  [[nodiscard]] constexpr Corner least_along(const Vec<Place, 2>& v) const noexcept {
    const std::size_t in_a = a.extreme<true>(v), in_b = b.extreme<false>(v);
    return {in_a, in_b, narrow<29>(b[in_b] - a[in_a])};
  }

  /// A vector from the origin across the edge, on either side if the origin is on its line.
  [[nodiscard]] constexpr Across normal() const noexcept {
    const auto& from = corners_[1].place;
    const auto edge = narrow<29>(corners_[0].place - from);
    const auto height = edge.y * from.x - edge.x * from.y;
    const auto back = narrow_negative(edge);
    return height > 0 ? Across{edge.y, back.x} : Across{back.y, edge.x};
  }

  /// Adds a corner, and keeps the feature that contains the closest difference; see `with_nearest`.
  constexpr void add(const Corner& corner) noexcept {
    const auto& q = corner.place;
    const auto e = narrow<29>(corners_[0].place - q);
    const bool leads_closer = dot(e, q) < 0;
    if (count_ == 1) {
      corners_[leads_closer ? 1 : 0] = corner;
      count_ = leads_closer ? 2 : 1;
      return;
    }
    const auto f = narrow<29>(corners_[1].place - q);
    const bool f_leads_closer = dot(f, q) < 0;
    const auto turn = cross(e, f);
    const auto is_beside = [&](const auto& height, bool is_left) {
      return turn == 0 || height == 0 || (height > 0) == (is_left == (turn > 0));
    };
    if (!leads_closer && !f_leads_closer) {
      corners_[0] = corner;
      count_ = 1;
    } else if (leads_closer && is_beside(cross(e, q), true)) {
      corners_[1] = corner;
    } else if (f_leads_closer && is_beside(cross(f, q), false)) {
      corners_[0] = corners_[1];
      corners_[1] = corner;
    } else {
      corners_[2] = corner;
      count_ = 3;
    }
  }

  std::array<Corner, 3> corners_{};
  int count_ = 0;
  Across across_{};
};

}  // namespace detent::detail
