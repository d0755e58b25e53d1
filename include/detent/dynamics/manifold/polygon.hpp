// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/manifold/polytope.hpp"
#include "detent/math/width.hpp"

namespace detent::detail {

/// A segment (in 2D and for capsules) or a convex polygon over a face of a polytope, in the
/// polytope's frame, which the sides of the face clip.
///
/// Line i of the polygon runs from its corner i to the next; the line of side k of the face has the
/// number 32 + k. A polygon's corner is named by the lines before and after it, the end of a segment
/// by its number or the side that replaced it.
template <Scalar S, int N, bool IsSegment = N == 2>
class ClippedPolygon {
 public:
  using Gap = typename Formats<S>::Gap;
  using Lever = typename Formats<S>::Lever;
  using Point = Vec<Lever, N>;
  static constexpr int first_side = 32;
  static constexpr std::size_t room = IsSegment ? 2 : 64;

  constexpr void add(const Point& p, int line) noexcept {
    points_[count_] = p;
    lines_[count_++] = static_cast<std::uint8_t>(line);
  }

  /// Cuts off the parts beyond the sides of the face by more than the tolerance. A new corner is
  /// the kept one plus its share of the vector to the other, each coordinate rounded once.
  constexpr void clip(const Polytope<S, N>& own, const PolytopeFace<S, N>& face) noexcept {
    for (std::size_t k = 0; k < face.count && count_ > 0; ++k) clip_side(own, face, k);
  }

  /// The corners within the margin of the face, at most four: the deepest, the one farthest from it,
  /// and on each side of the line through both the one that spans the largest area; the first of
  /// equals. Surfaces are `radius` away from the polygon.
  [[nodiscard]] constexpr Manifold<S, N> manifold(const Polytope<S, N>& own,
                                                  const PolytopeFace<S, N>& face, const S& radius,
                                                  std::uint32_t name,
                                                  const Gap& margin) const noexcept {
    std::array<Gap, room> heights{};
    std::array<std::uint8_t, room> kept{};
    std::size_t size = 0;
    for (std::size_t v = 0; v < count_; ++v) {
      heights[v] = nearest_to<Gap>(own.height(face, points_[v]));
      if (nearest_to<Gap>(heights[v] - radius) <= margin) {
        kept[size++] = static_cast<std::uint8_t>(v);
      }
    }
    Manifold<S, N> result;
    if (size == 0) return result;
    result.normal = face.normal;
    const auto chosen = choose(face, heights, std::span(kept).first(size));
    for (const auto v : std::span(kept).first(size)) {
      if (!chosen[v]) continue;
      const auto drop = half(heights[v] + radius);
      result.points[static_cast<std::size_t>(result.count++)] = {
          nearest_to<Lever>(points_[v] - face.normal * drop), nearest_to<Gap>(heights[v] - radius),
          name + code(v)};
    }
    return result;
  }

 private:
  [[nodiscard]] constexpr std::uint32_t code(std::size_t v) const noexcept {
    const std::uint32_t line = lines_[v];
    return IsSegment ? line : std::uint32_t{lines_[v > 0 ? v - 1 : count_ - 1]} * 64 + line;
  }

  constexpr void clip_side(const Polytope<S, N>& own, const PolytopeFace<S, N>& face,
                           std::size_t k) noexcept {
    std::array<Gap, room> rooms{};
    bool all_inside = true;
    for (std::size_t v = 0; v < count_; ++v) {
      rooms[v] = nearest_to<Gap>(ContactFormats<S>::tolerance - own.beyond(face, k, points_[v]));
      all_inside = all_inside && rooms[v] >= 0;
    }
    if (all_inside) return;
    const auto line = static_cast<int>(first_side + k);
    const auto between = [&](std::size_t kept, std::size_t lost) {
      const auto share = [](const auto& way, const auto& numerator, const auto& denominator) {
        return make_vec<N>(
            [&](int c) { return quotient_nearest<Lever>(way[c] * numerator, denominator); });
      };
      const auto way = points_[lost] - points_[kept];
      return nearest_to<Lever>(points_[kept] +
                               by_width<31>(share, way, rooms[kept], rooms[kept] - rooms[lost]));
    };
    ClippedPolygon result;
    for (std::size_t v = 0; v < count_; ++v) {
      const std::size_t next = v + 1 < count_ ? v + 1 : 0;
      if (IsSegment) {  // each end is kept or replaced
        if (rooms[v] >= 0) {
          result.add(points_[v], lines_[v]);
        } else if (rooms[next] > 0) {
          result.add(between(next, v), line);
        }
        continue;
      }
      if (rooms[v] >= 0) {
        result.add(points_[v], rooms[v] == 0 && rooms[next] < 0 ? line : lines_[v]);
      }
      if (result.count_ == room) break;
      if (rooms[v] > 0 && rooms[next] < 0) result.add(between(v, next), line);
      if (rooms[v] < 0 && rooms[next] > 0) result.add(between(next, v), lines_[v]);
      if (result.count_ == room) break;
    }
    *this = result;
  }

  [[nodiscard]] constexpr std::array<bool, room> choose(
      const PolytopeFace<S, N>& face, const std::array<Gap, room>& heights,
      std::span<const std::uint8_t> kept) const noexcept {
    std::array<bool, room> chosen{};
    for (const auto v : kept) chosen[v] = kept.size() <= 4;
    if constexpr (!IsSegment) {
      if (kept.size() > 4) {
        std::size_t deepest = kept[0];
        for (const auto v : kept) {
          if (heights[v] < heights[deepest]) deepest = v;
        }
        const auto offset = [&](std::size_t v) { return points_[v] - points_[deepest]; };
        std::size_t farthest = deepest, left = deepest, right = deepest;
        auto distance = squared_length(offset(deepest));
        for (const auto v : kept) {
          const auto other = squared_length(offset(v));
          if (other > distance) distance = other, farthest = v;
        }
        const auto along = offset(farthest);
        auto most = dot(face.normal, cross(along, along)), least = most;
        for (const auto v : kept) {
          const auto area = dot(face.normal, cross(along, offset(v)));
          if (area > most) most = area, left = v;
          if (area < least) least = area, right = v;
        }
        chosen[deepest] = chosen[farthest] = chosen[left] = chosen[right] = true;
      }
    }
    return chosen;
  }

  std::array<Point, room> points_{};
  std::array<std::uint8_t, room> lines_{};
  std::size_t count_ = 0;
};

}  // namespace detent::detail
