// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/dynamics/manifold/formats.hpp"
#include "detent/math/width.hpp"

namespace detent::detail {

/// `v` with the reference's axis first, and back.
template <Number T, int N>
[[nodiscard]] constexpr Vec<T, N> axis_first(const Vec<T, N>& v, int axis) noexcept {
  return make_vec<N>([&](int c) { return v[(axis + c) % N]; });
}
template <Number T, int N>
[[nodiscard]] constexpr Vec<T, N> axis_back(const Vec<T, N>& v, int axis) noexcept {
  return make_vec<N>([&](int c) { return v[(c + N - axis) % N]; });
}

/// An incident face in the frame of the reference face that clips it: a segment or, in 3D, a
/// polygon.
///
/// Line i of the incident face runs from its corner i to the next; the lines of the clipping sides
/// have the numbers after those. A polygon's corner is named by the lines before and after it.
/// Coordinate 0 is the height, the others are those of the sides.
template <Number T, int N, bool IsSegment = N == 2>
struct ClippedFace {
  static constexpr int corners = IsSegment ? 2 : 4;
  static constexpr std::size_t capacity = IsSegment ? 2 : 8;

  std::array<Vec<T, N>, capacity> points{};
  std::array<int, capacity> lines{};  // the line that leaves the corner; of a segment, its name
  int count = 0;

  constexpr void add(const Vec<T, N>& p, int line) noexcept {
    points[static_cast<std::size_t>(count)] = p;
    lines[static_cast<std::size_t>(count++)] = line;
  }

  /// The corner's name: 2 or 6 bits.
  [[nodiscard]] constexpr int code(int v) const noexcept {
    const auto line = [&](int i) { return lines[static_cast<std::size_t>(i)]; };
    return IsSegment ? line(v) : names[static_cast<std::size_t>(v)];
  }

  /// Clips at `end` and -end along the axis. A new corner is the kept one plus its share of the
  /// vector to the other, each coordinate rounded once.
  template <int Axis, Number E>
  constexpr void clip(const E& end, bool negative, int line) noexcept {
    const auto room_of = [&](const Vec<T, N>& p) {
      return negative ? end + p[Axis] : end - p[Axis];
    };
    std::array<decltype(end - T()), capacity> room{};
    bool all_inside = true;
    const auto size = static_cast<std::size_t>(count);
    for (std::size_t v = 0; v < size; ++v) {
      room[v] = room_of(points[v]);
      all_inside = all_inside && room[v] >= 0;
    }
    if (all_inside) return;
    const auto from = points;
    const auto names_of = lines;
    const auto between = [&](std::size_t kept, std::size_t lost) {
      const auto way = from[lost] - from[kept];
      const auto share = [](const auto& whole_way, const auto& numerator, const auto& denominator) {
        return make_vec<N>([&](int c) {
          if (c == Axis) return T();
          return quotient_nearest<T>(whole_way[c] * numerator, denominator);
        });
      };
      const auto part = by_width<31>(share, way, room[kept], room[kept] - room[lost]);
      auto p = nearest_to<T>(from[kept] + part);
      p[Axis] = nearest_to<T>(negative ? -end : end);
      return p;
    };
    count = 0;
    for (std::size_t v = 0; v < size; ++v) {
      const std::size_t next = v + 1 < size ? v + 1 : 0;
      if (IsSegment) {  // each end is kept or replaced
        if (room[v] >= 0) {
          add(from[v], names_of[v]);
        } else if (room[next] > 0) {
          add(between(next, v), line);
        }
        continue;
      }
      if (room[v] >= 0) add(from[v], room[v] == 0 && room[next] < 0 ? line : names_of[v]);
      if (room[v] > 0 && room[next] < 0) add(between(v, next), line);
      if (room[v] < 0 && room[next] > 0) add(between(next, v), names_of[v]);
    }
  }

  /// Names the corners and keeps those for which test(point) is true.
  template <class Test>
  constexpr void keep(const Test& test) noexcept {
    for (int v = 0; v < count; ++v) {
      const auto before = static_cast<std::size_t>(v > 0 ? v - 1 : count - 1);
      names[static_cast<std::size_t>(v)] = lines[before] * 8 + lines[static_cast<std::size_t>(v)];
    }
    int kept = 0;
    for (int v = 0; v < count; ++v) {
      const auto from = static_cast<std::size_t>(v), to = static_cast<std::size_t>(kept);
      if (!test(points[from])) continue;
      points[to] = points[from];
      lines[to] = lines[from];
      names[to] = names[from];
      ++kept;
    }
    count = kept;
  }

  /// All corners, if there are at most four; otherwise the deepest, the one farthest from it, and
  /// on each side of the line through both the one that spans the largest area. The lower index on
  /// ties.
  template <class Heights>
  [[nodiscard]] constexpr std::array<bool, capacity> choose(const Heights& heights) const noexcept {
    std::array<bool, capacity> chosen{};
    for (auto& c : chosen) c = count <= corners;
    if constexpr (!IsSegment) {
      if (count > corners) {
        std::size_t deepest = 0;
        const auto size = static_cast<std::size_t>(count);
        for (std::size_t v = 1; v < size; ++v) {
          if (heights[v] < heights[deepest]) deepest = v;
        }
        const auto offset = [&](std::size_t v) {
          const auto d = points[v] - points[deepest];
          return Vec{d[1], d[2]};
        };
        const auto squared = [](const auto& d) { return widened(squared_length(d)); };
        const auto area_of = [](const auto& d, const auto& e) { return widened(cross(d, e)); };
        std::size_t farthest = deepest, left = deepest, right = deepest;
        auto distance = by_width<30>(squared, offset(deepest));
        for (std::size_t v = 0; v < size; ++v) {
          const auto other = by_width<30>(squared, offset(v));
          if (other > distance) distance = other, farthest = v;
        }
        const auto along = offset(farthest);
        auto most = by_width<30>(area_of, along, along), least = most;
        for (std::size_t v = 0; v < size; ++v) {
          const auto area = by_width<30>(area_of, along, offset(v));
          if (area > most) most = area, left = v;
          if (area < least) least = area, right = v;
        }
        chosen[deepest] = chosen[farthest] = chosen[left] = chosen[right] = true;
      }
    }
    return chosen;
  }

  std::array<int, capacity> names{};

 private:
  /// In the type of the widest such product.
  template <Number X>
  [[nodiscard]] static constexpr auto widened(const X& x) noexcept {
    using Difference = decltype(T() - T());
    return decltype(Difference() * Difference() + Difference() * Difference())(x);
  }
};

}  // namespace detent::detail
