// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/query/contact/contact.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/vec_list.hpp"

namespace detent::detail {

/// The points of a contact, of which a few are kept.
template <Scalar S, int N, std::size_t Most>
class ContactPoints {
 public:
  [[nodiscard]] constexpr std::size_t size() const noexcept { return count_; }
  [[nodiscard]] constexpr bool is_full() const noexcept { return count_ == Most; }
  constexpr void clear() noexcept { count_ = 0; }

  /// `place` is the position by which to choose the points to keep: on the grid, and invariant under
  /// swapping the shapes.
  constexpr void add(const Vec<S, N>& point, const S& depth, std::uint32_t feature,
                     const Vec<Length<S>, N>& place) noexcept {
    places_.set(count_, place);
    points_.set(count_, point);
    depths_.set(count_, depth);
    features_[count_++] = feature;
  }

  /// Writes the points to keep, seen along a direction: the deepest, the farthest from it, and in 3D
  /// those that add the largest area on either side of the line through these two. Ties go to the
  /// first point. The deepest gets the depth of the contact, which rounding may have lessened.
  constexpr void write(Contact<S, N>& contact, const Direction<S, N>& seen) const noexcept {
    const auto best = [&](const auto& value) {
      std::size_t found = 0;
      auto greatest = value(0);
      for (std::size_t i = 1; i < count_; ++i) {
        const auto here = value(i);
        if (!(here > greatest)) continue;
        greatest = here;
        found = i;
      }
      return std::pair{found, greatest};
    };
    const auto keep = [&](std::size_t i) {
      contact.points[contact.count++] = {points_[i], depths_[i], features_[i]};
    };
    contact.count = 0;
    if (count_ == 0) return;
    const auto first = best([&](std::size_t i) { return depths_[i]; }).first;
    keep(first);
    contact.points[0].depth = contact.depth;
    const auto& p = places_[first];
    const auto second = best([&](std::size_t i) { return squared_distance(p, places_[i]); }).first;
    if (second == first) return;
    keep(second);
    if constexpr (N == 3) {
      by_width<30>(
          [&](const auto& edge) {
            const auto across = cross(seen, edge);
            const auto area = [&](std::size_t i) { return dot(across, places_[i] - p); };
            const auto left = best(area);
            if (left.second > 0) keep(left.first);
            const auto right = best([&](std::size_t i) { return -area(i); });
            if (right.second > 0) keep(right.first);
          },
          places_[second] - p);
    }
  }

 private:
  VecList<S, N, Most> points_;
  NumberList<S, Most> depths_;
  std::array<std::uint32_t, Most> features_;  // not set to 0: few are used
  VecList<Length<S>, N, Most> places_;
  std::size_t count_ = 0;
};

}  // namespace detent::detail
