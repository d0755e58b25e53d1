// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/math/direction.hpp"

namespace detent {

/// One point of a contact, on the surface of the first shape, and how deep the second shape is
/// there: its surface is at point - depth * normal.
///
/// `feature` identifies the corners, edges or faces that meet, and stays the same while they meet:
/// the lower 16 bits those of the first shape, the upper 16 bits those of the second. In each half,
/// the bytes are the numbers of the two corners of an edge, twice the number of a corner, or 0xffff
/// for a face. Corner i of a box is at the upper end of axis k if bit k of i is set; hulls,
/// triangles and segments count their corners in order, modulo 255.
template <Scalar S, int N>
struct ContactPoint {
  Vec<S, N> point;
  S depth{};
  std::uint32_t feature = 0;

  [[nodiscard]] friend constexpr bool operator==(const ContactPoint&,
                                                 const ContactPoint&) noexcept = default;
};

/// The least translation that separates two overlapping shapes a and b: b moves by `depth` along
/// `normal`, which points from a to b. The first `count` of `points` are set.
template <Scalar S, int N>
struct Contact {
  Direction<S, N> normal;
  S depth{};
  std::array<ContactPoint<S, N>, N == 2 ? 2 : 4> points{};
  std::size_t count = 0;

  [[nodiscard]] friend constexpr bool operator==(const Contact&, const Contact&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const ContactPoint<S, N>& point) noexcept {
  digest.add(point.point, point.depth, point.feature);
}
/// Appends to a digest: the normal, the depth, the number of points, and these points.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Contact<S, N>& contact) noexcept {
  digest.add(contact.normal, contact.depth, static_cast<std::uint32_t>(contact.count));
  for (std::size_t i = 0; i < contact.count; ++i) digest.add(contact.points[i]);
}

}  // namespace detent
