// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/math/components.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/vec_list.hpp"

namespace detent::detail {

/// Which points two faces have in common, seen along a direction, a bit each: incident corners over
/// the reference, the edges of the reference that each incident edge crosses, and corners of the
/// reference under the incident face.
template <std::size_t Most>
struct Overlay {
  std::uint32_t over = 0, under = 0;
  std::array<std::uint32_t, Most> crossed{};
};

/// `count` of the least steps of S; 0 for floating point.
template <Scalar S>
[[nodiscard]] constexpr S steps_of(int count) noexcept {
  if constexpr (is_fixed<S>) {
    return S::from_raw(static_cast<typename S::raw_type>(count));
  } else {
    return S(0);
  }
}

/// On which side of something points are, a bit each.
struct PointSides {
  std::uint32_t inside = 0, outside = 0;

  template <Number Side>
  constexpr void set(std::size_t i, const Side& side) noexcept {
    inside |= std::uint32_t{side > 0} << i;
    outside |= std::uint32_t{side < 0} << i;
  }
  /// The sides of the next of `count` points, in place of each.
  [[nodiscard]] constexpr PointSides of_next(std::size_t count) const noexcept {
    const auto turned = [&](std::uint32_t bits) { return bits >> 1 | (bits & 1) << (count - 1); };
    return {turned(inside), turned(outside)};
  }
  /// Where the other side is the opposite.
  [[nodiscard]] constexpr std::uint32_t opposite(const PointSides& other) const noexcept {
    return (inside & other.outside) | (outside & other.inside);
  }
};

/// The edges of an outline, seen along a direction.
template <Scalar S, std::size_t Most, Number T>
struct Rim {
  constexpr Rim(const Direction<S, 3>& direction, const VecList<T, 3, Most>& at,
                std::size_t size) noexcept
      : seen(direction), corners(at), count(size) {
    for (std::size_t i = 0; i < count; ++i) {
      across.set(i, cross(seen, corners[next(i)] - corners[i]));
    }
  }

  [[nodiscard]] constexpr std::size_t next(std::size_t i) const noexcept {
    return i + 1 < count ? i + 1 : 0;
  }
  /// Twice the area of the triangle of an edge and a point: positive inside.
  [[nodiscard]] constexpr auto side(std::size_t i, const Vec<T, 3>& point) const noexcept {
    return dot(across[i], point - corners[i]);
  }
  /// On which side of each edge a point is.
  [[nodiscard]] constexpr PointSides sides_of(const Vec<T, 3>& point) const noexcept {
    PointSides sides;
    for (std::size_t i = 0; i < count; ++i) sides.set(i, side(i, point));
    return sides;
  }
  /// On which side of edge i the corners of another outline are.
  [[nodiscard]] constexpr PointSides sides_along(std::size_t i, const Rim& other) const noexcept {
    PointSides sides;
    for (std::size_t k = 0; k < other.count; ++k) sides.set(k, side(i, other.corners[k]));
    return sides;
  }
  /// Whether a point is at most `slack` steps from an edge, for edges across the direction.
  [[nodiscard]] constexpr bool is_near(const Vec<T, 3>& point, int slack) const noexcept {
    const auto limit = square(steps_of<S>(slack));
    for (std::size_t i = 0; i < count; ++i) {
      const auto edge = corners[next(i)] - corners[i], to_point = point - corners[i];
      const auto along = dot(edge, to_point), whole = squared_length(edge);
      if (along > 0 && along < whole ? square(side(i, point)) <= whole * limit
                                     : squared_length(cross(seen, to_point)) <= limit)
        return true;
    }
    return false;
  }

  const Direction<S, 3>& seen;
  const VecList<T, 3, Most>& corners;
  VecList<decltype(cross(Direction<S, 3>(), Vec<T, 3>() - Vec<T, 3>()).x), 3, Most> across;
  std::size_t count;
};

/// Which points a reference face and an incident feature have in common. `slack` is how many of the
/// least steps of S a corner may be outside.
template <Scalar S, std::size_t Most, Number T>
[[nodiscard]] constexpr Overlay<Most> overlay_of(const Rim<S, Most, T>& reference,
                                                 const Rim<S, Most, T>& incident,
                                                 int slack) noexcept {
  const auto is_within = [&](const Rim<S, Most, T>& outline, std::uint32_t outside,
                             const auto& point) {
    return outside == 0 || (slack > 0 && outline.is_near(point, slack));
  };
  Overlay<Most> overlay;
  std::array<PointSides, Most>
      sides;  // of the edges of the reference, on which incident corners are
  for (std::size_t k = 0; k < incident.count; ++k) {
    const auto& point = incident.corners[k];
    sides[k] = reference.sides_of(point);
    overlay.over |= std::uint32_t{is_within(reference, sides[k].outside, point)} << k;
  }
  if (incident.count > 1) {
    const std::size_t edges = incident.count == 2 ? 1 : incident.count;
    std::uint32_t inside = ~std::uint32_t{0}, outside = 0;  // corners of the reference
    for (std::size_t k = 0; k < incident.count; ++k) {
      const auto along = incident.sides_along(k, reference);
      inside &= along.inside;
      outside |= along.outside;
      if (k < edges) {
        overlay.crossed[k] = sides[k].opposite(sides[incident.next(k)]) &
                             along.opposite(along.of_next(reference.count));
      }
    }
    for (std::size_t i = 0; i < reference.count; ++i) {
      const auto& r = reference.corners[i];
      bool is_under = is_within(incident, outside >> i & 1, r);
      // A corner that is strictly inside does not coincide with one of the incident feature.
      for (std::size_t k = 0; k < incident.count && (inside >> i & 1) == 0; ++k) {
        is_under = is_under && !is_zero(cross(incident.seen, r - incident.corners[k]));
      }
      overlay.under |= std::uint32_t{is_under} << i;
    }
  }
  return overlay;
}

}  // namespace detent::detail
