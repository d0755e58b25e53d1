// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/math/rotation.hpp"
#include "detent/math/width.hpp"

namespace detent::detail {

// A 3D box against another box or a triangle. If they are apart, a face of one or a pair of their
// edges separates them (separation.hpp). All these tests share a few products with the boxes' edges
// and face normals.

/// The coordinate axes as the edges of a box.
struct WorldFrame {
  /// The dot product of `v` with edge `i`.
  template <Number T, int N>
  [[nodiscard]] constexpr T along(int i, const Vec<T, N>& v) const noexcept {
    return v[i];
  }
  /// The dot product of `v` with the normal of face `i`, the cross product of the other two edges.
  template <Number T>
  [[nodiscard]] constexpr T across(int i, const Vec<T, 3>& v) const noexcept {
    return v[i];
  }
  /// The magnitude of `across` for `extent` times edge i.
  template <Number H>
  [[nodiscard]] constexpr H thickness(const H& extent) const noexcept {
    return extent;
  }
};

/// The axes of a rotation, exactly as stored, as the edges of a box.
template <Scalar S>
class EdgeFrame {
 public:
  explicit constexpr EdgeFrame(const Rotation<S, 3>& rotation) noexcept : rotation_(rotation) {
    for (int i = 0; i < 3; ++i) {
      const auto& next = rotation.axis((i + 1) % 3).vec();
      const auto& last = rotation.axis((i + 2) % 3).vec();
      normals_[static_cast<std::size_t>(i)] = narrow_cross<cosine_bits<S>>(next, last);
    }
    volume_ = narrow<bits_of<Volume>>(abs(across(0, rotation.axis(0).vec())));
  }

  [[nodiscard]] constexpr const auto& edge(int i) const noexcept { return rotation_.axis(i); }
  [[nodiscard]] constexpr const auto& normal(int i) const noexcept {
    return normals_[static_cast<std::size_t>(i)];
  }
  /// Whether the edges lie in one plane.
  [[nodiscard]] constexpr bool is_flat() const noexcept { return volume_ == 0; }

  template <Number T>
  [[nodiscard]] constexpr auto along(int i, const Vec<T, 3>& v) const noexcept {
    return dot(edge(i), v);
  }
  template <Number T>
  [[nodiscard]] constexpr auto across(int i, const Vec<T, 3>& v) const noexcept {
    // |normal| <= (1 + 2^-13)^2, and sqrt(3) times that is less than 2.
    return narrow_dot<cosine_bits<S> + bits_of<T>>(normal(i), v);
  }
  template <Number H>
  [[nodiscard]] constexpr auto thickness(const H& extent) const noexcept {
    return extent * volume_;
  }

 private:
  using Component = direction_component<S>;
  using Normal = decltype(narrow_cross<cosine_bits<S>>(Vec<Component, 3>(), Vec<Component, 3>()));
  using Volume =
      decltype(narrow_dot<cosine_bits<S> + bits_of<Component>>(Normal(), Vec<Component, 3>()));

  Rotation<S, 3> rotation_;
  std::array<Normal, 3> normals_;
  Volume volume_;
};

/// Whether two boxes overlap; `apart` leads from one center to the other. At most one may be flat.
///
/// The triple product of two edges of one with an edge of the other serves its face and four pairs
/// of edges, so 18 of them cover the 15 directions. For 32-bit scalars the sums have 126 bits.
///
/// source: Gottschalk, Lin, Manocha, OBBTree: A Hierarchical Structure for Rapid Interference
///         Detection (1996)
template <class Frame, Scalar S, Number H, Number T>
[[nodiscard]] constexpr bool boxes_overlap(const Frame& a, const Vec<H, 3>& half_a,
                                           const EdgeFrame<S>& b, const Vec<H, 3>& half_b,
                                           const Vec<T, 3>& apart) noexcept {
  using Edge = Vec<direction_component<S>, 3>;
  using AcrossA = decltype(abs(a.across(0, Edge())));
  using AcrossB = decltype(abs(a.along(0, b.normal(0))));
  std::array<Vec<AcrossA, 3>, 3> across_a;  // [i][j]: face i of a, edge j of b
  std::array<Vec<AcrossB, 3>, 3> across_b;  // [j][i]: face j of b, edge i of a
  for (int i = 0; i < 3; ++i) {
    auto& row = across_a[static_cast<std::size_t>(i)];
    row = make_vec<3>([&](int j) { return abs(a.across(i, b.edge(j).vec())); });
    if (abs(a.across(i, apart)) > a.thickness(half_a[i]) + dot(half_b, row)) return false;
  }
  for (int j = 0; j < 3; ++j) {
    auto& row = across_b[static_cast<std::size_t>(j)];
    row = make_vec<3>([&](int i) { return abs(a.along(i, b.normal(j))); });
    if (abs(b.across(j, apart)) > b.thickness(half_b[j]) + dot(half_a, row)) return false;
  }
  for (int j = 0; j < 3; ++j) {
    const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const auto& row_j1 = across_b[static_cast<std::size_t>(j1)];
    const auto& row_j2 = across_b[static_cast<std::size_t>(j2)];
    const auto moment = cross(b.edge(j), apart);
    for (int i = 0; i < 3; ++i) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      const auto& row_i1 = across_a[static_cast<std::size_t>(i1)];
      const auto& row_i2 = across_a[static_cast<std::size_t>(i2)];
      const auto reach_a = half_a[i1] * row_i2[j] + half_a[i2] * row_i1[j];
      const auto reach_b = half_b[j1] * row_j2[i] + half_b[j2] * row_j1[i];
      if (abs(a.along(i, moment)) > reach_a + reach_b) return false;
    }
  }
  return true;
}

/// Whether the plane of a triangle is farther from the center of a box than the box reaches, both
/// measured in volumes over the triangle.
template <Number Height, Number Along, Number H>
[[nodiscard]] constexpr bool is_beyond(const Height& height, const Vec<Along, 3>& along,
                                       const Vec<H, 3>& half_extents) noexcept {
  return abs(height) > dot(half_extents, make_vec<3>([&](int i) { return abs(along[i]); }));
}

/// Whether a box that is not flat meets the triangle with these corners, given relative to its
/// center.
///
/// All corners are in a cube of side 2^Side, and twice the area of a triangle in a square is at
/// most that of the square. Projected onto the cross product of an edge of the box and one of the
/// triangle, two corners coincide, and the third is off by the projection of the box edge onto the
/// normal.
///
/// source: Akenine-Moeller, Fast 3D Triangle-Box Overlap Testing (2001)
template <int Side, class Frame, Number H, Number T>
[[nodiscard]] constexpr bool box_meets_triangle(const Frame& box, const Vec<H, 3>& half_extents,
                                                const Vec<T, 3>& a, const Vec<T, 3>& b,
                                                const Vec<T, 3>& c) noexcept {
  const auto misses = [](const auto& reach, const auto&... places) {
    return ((places > reach) && ...) || ((places < -reach) && ...);
  };
  using Height = decltype(box.across(0, a));
  std::array<Vec<Height, 3>, 3> heights;  // [i][k]: corner k against face i
  for (int i = 0; i < 3; ++i) {
    auto& row = heights[static_cast<std::size_t>(i)];
    row = {box.across(i, a), box.across(i, b), box.across(i, c)};
    if (misses(box.thickness(half_extents[i]), row.x, row.y, row.z)) return false;
  }

  const auto normal = narrow_cross<2 * Side>(b - a, c - a);
  const auto along = make_vec<3>([&](int i) { return box.along(i, normal); });
  const auto plane_misses = [](const auto&... x) { return is_beyond(x...); };
  if (by_width<94>(plane_misses, dot(normal, a), along, half_extents)) return false;

  const std::array corners{&a, &b, &c};
  for (int k = 0; k < 3; ++k) {
    const int k1 = (k + 1) % 3;
    const auto& from = *corners[static_cast<std::size_t>(k)];
    const auto& to = *corners[static_cast<std::size_t>(k1)];
    const auto moment = narrow_cross<2 * Side>(to, from);
    for (int i = 0; i < 3; ++i) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      // The triangle's edge across a face, which is no longer than a corner may be.
      const auto across = [&](int face) {
        const auto& row = heights[static_cast<std::size_t>(face)];
        return abs(narrow_difference<bits_of<Height>>(row[k1], row[k]));
      };
      const auto reach = half_extents[i1] * across(i2) + half_extents[i2] * across(i1);
      const auto place = box.along(i, moment);
      if (misses(reach, place, place + along[i])) return false;
    }
  }
  return true;
}

}  // namespace detent::detail
