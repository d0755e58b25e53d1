// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "detent/math/components.hpp"
#include "detent/math/direction.hpp"
#include "detent/math/orthonormal.hpp"
#include "detent/query/contact/contact.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/least_push.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/point_obb.hpp"

namespace detent::detail {

/// A point in the frame of a box, which is there the box from `low` to `high`.
template <Number T, int N>
struct PointInFrame {
  Vec<T, N> point, low, high;
};
template <Scalar S, int N>
[[nodiscard]] constexpr PointInFrame<S, N> point_in_frame(const Aabb<S, N>& box,
                                                          const Vec<S, N>& point) noexcept {
  return {point, box.min, box.max};
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto point_in_frame(const Obb<S, N>& box, const Vec<S, N>& point) noexcept {
  const auto place = in_frame(box, point - box.center);
  using T = std::remove_cvref_t<decltype(place.x)>;
  const auto& half = box.half_extents;
  return PointInFrame<T, N>{place, make_vec<N>([&](int i) { return T(-half[i]); }),
                            make_vec<N>([&](int i) { return T(half[i]); })};
}

/// Whether the corners of a box, rounded to the grid, are those of faces: all different, and no
/// three of a face in one line, seen along the axis of the face.
template <Scalar S, int N>
[[nodiscard]] constexpr bool has_solid_faces(const Aabb<S, N>& box) noexcept {
  bool all = true;
  for (int i = 0; i < N; ++i) all = box.min[i] < box.max[i] && all;
  return all;
}
/// Edges have at least 16 steps less 2^-9, and rounding moves each end by less than 0.9 steps. Three
/// corners of a face span the area e f of its edges, within e f 2^-7 for their angle and that of the
/// axis, and 1.8 (e + f) + 4 for the rounding: more than 180 for the shortest edges.
template <Scalar S, int N>
[[nodiscard]] constexpr bool has_solid_faces(const Obb<S, N>& box) noexcept {
  bool all = are_perpendicular<10>(box.rotation);
  for (int i = 0; i < N; ++i) all = box.half_extents[i] >= S::from_raw(8) && all;
  return all;
}

/// The contact of a box with solid faces and a sphere, in closed form: the position of the center
/// in the frame of the box determines which of its features is nearest. The general search would
/// find the same: that feature, the vector across it, and one point. All numbers are exact, so no
/// filter is needed.
template <Scalar S, int N, class Box>
class SphereBoxContact {
 public:
  constexpr SphereBoxContact(const Box& box, const Vec<S, N>& center, const S& radius,
                             bool box_is_a) noexcept
      : box_(box),
        center_(center),
        radius_(radius),
        box_is_a_(box_is_a),
        place_(point_in_frame(box, center)) {}

  [[nodiscard]] constexpr std::optional<Contact<S, N>> find() const noexcept {
    // The radius has so many bits on the grid of the frame, and so has what is within it.
    constexpr int bits = bits_of<S> + T::frac - S::frac;
    Vec<Fixed<bits, T::frac>, N> beyond;
    Region at;
    for (int i = 0; i < N; ++i) {
      const auto& x = place_.point[i];
      const bool is_above = x > place_.high[i], is_below = x < place_.low[i];
      const auto nearest = is_above ? place_.high[i] : is_below ? place_.low[i] : x;
      const auto past = narrow_difference<difference_bits>(x, nearest);
      if (past > radius_ || past < -radius_) return std::nullopt;
      beyond[i] = narrow<bits>(past);
      at.add(i, is_above, is_below);
    }
    if (at.is_inside()) return inside();
    const auto squared = squared_length(beyond);
    if (squared > square(radius_)) return std::nullopt;
    using Squared = Fixed<2 * bits_of<S>, 2 * S::frac>;
    const auto gap = sqrt_floor<S>(floor_to<Squared>(narrow<2 * bits>(squared)));
    return contact(at, at.is_face() ? along(at) : across(beyond), narrow<bits_of<Far>>(-gap));
  }

 private:
  using T = std::remove_cvref_t<decltype(point_in_frame(Box(), Vec<S, N>()).point.x)>;
  using Far = Length<S>;
  /// Holds the difference of two scalars. In the frame of an oriented box, no difference taken here
  /// is greater than a coordinate of the center or a doubled half extent.
  static constexpr int difference_bits = is_kind<Box, Obb> ? bits_of<T> : bits_of<S> + 1;

  /// The axes on which the center is above the box, and those on which it is neither above nor below.
  struct Region {
    std::uint32_t upper = 0, free = 0;

    constexpr void add(int axis, bool is_above, bool is_below) noexcept {
      upper |= std::uint32_t{is_above} << axis;
      free |= std::uint32_t{!is_above && !is_below} << axis;
    }
    [[nodiscard]] constexpr bool is_inside() const noexcept { return free == (1u << N) - 1; }
    /// Whether the center is beyond one face only.
    [[nodiscard]] constexpr bool is_face() const noexcept { return axes() == N - 1; }
    [[nodiscard]] constexpr bool is_corner() const noexcept { return free == 0; }
    [[nodiscard]] constexpr int axes() const noexcept { return std::popcount(free); }
    [[nodiscard]] constexpr int axis() const noexcept { return std::countr_one(free); }
    /// As in `ContactPoint`.
    [[nodiscard]] constexpr std::uint32_t number() const noexcept {
      return axes() == 2 ? 0xffff : upper | (upper | free) << 8;
    }
  };

  /// The same for a center inside: through the nearest face, of equally near ones the preferred
  /// (see `is_preferred`).
  [[nodiscard]] constexpr Contact<S, N> inside() const noexcept {
    const bool first_side = is_kind<Box, Obb> || box_is_a_;
    int axis = 0;
    bool is_upper = first_side;
    auto least = height(0, first_side);
    for (int i = 0; i < N; ++i) {
      for (const bool side : {first_side, !first_side}) {
        const auto here = height(i, side);
        if (!(here < least)) continue;
        least = here;
        axis = i;
        is_upper = side;
      }
    }
    Region at;
    for (int i = 0; i < N; ++i) at.add(i, i == axis && is_upper, i == axis && !is_upper);
    return contact(at, along(at), ceil_to<Far>(least));
  }
  /// How far the center is from the upper or lower face across an axis.
  [[nodiscard]] constexpr auto height(int i, bool is_upper) const noexcept {
    const auto& x = place_.point[i];
    return is_upper ? narrow_difference<difference_bits>(place_.high[i], x)
                    : narrow_difference<difference_bits>(x, place_.low[i]);
  }

  /// The outward normal of a face.
  [[nodiscard]] constexpr Direction<S, N> along(const Region& at) const noexcept {
    const auto outward = [&] {
      if constexpr (is_kind<Box, Obb>) {
        return *direction_of<S>(box_.rotation.axis(at.axis()).vec());
      } else {
        return Direction<S, N>::along(at.axis());
      }
    }();
    return at.upper == 0 ? -outward : outward;
  }
  /// The direction of a vector in the frame.
  template <Number V>
  [[nodiscard]] constexpr Direction<S, N> across(const Vec<V, N>& v) const noexcept {
    if constexpr (is_kind<Box, Obb>) {
      return *direction_of<S>(from_frame(box_, v));
    } else {
      return *direction_of<S>(v);
    }
  }

  /// `depth` is that of the box and the center, negative if they are apart.
  [[nodiscard]] constexpr Contact<S, N> contact(const Region& at, const Direction<S, N>& outward,
                                                const Far& depth) const noexcept {
    Contact<S, N> contact;
    contact.normal = box_is_a_ ? outward : -outward;
    contact.depth = floor_to<S>(radius_ + depth);
    contact.count = 1;
    contact.points[0] = {point_on_a(at, contact.normal, depth), contact.depth,
                         box_is_a_ ? at.number() : at.number() << 16};
    return contact;
  }
  [[nodiscard]] constexpr Vec<S, N> point_on_a(const Region& at, const Direction<S, N>& normal,
                                               const Far& depth) const noexcept {
    if (box_is_a_ && at.is_corner()) return corner(at.upper);
    const auto to_surface = box_is_a_ ? depth : Far(radius_);
    return make_vec<N>([&](int i) { return nearest_to<S>(center_[i] + normal[i] * to_surface); });
  }
  [[nodiscard]] constexpr Vec<S, N> corner(std::uint32_t sides) const noexcept {
    return nearest_to<S>(nearest_to<Far>(body_of(box_).corner(sides)));
  }

  const Box& box_;
  const Vec<S, N>& center_;
  const S& radius_;
  bool box_is_a_;
  PointInFrame<T, N> place_;
};

/// Whether contacts of this kind of box with spheres are found in closed form, if its faces are solid.
template <Scalar S, class Box>
inline constexpr bool has_sphere_contact = is_fixed<S>&& filter_pays<S> &&
                                           (is_kind<Box, Aabb> || is_kind<Box, Obb>);

}  // namespace detent::detail
