// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/filter/filtered.hpp"
#include "detent/number/filter/leading.hpp"
#include "detent/number/unit.hpp"
#include "detent/query/raycast/capsule/cylinder.hpp"

namespace detent::detail {

/// The part of a capsule's surface that a line crosses.
enum class CapsulePart { none, inside, first_end, side, last_end };

[[nodiscard]] constexpr bool is_end(CapsulePart part) noexcept {
  return part == CapsulePart::first_end || part == CapsulePart::last_end;
}

/// The part at which the ray is at distance t, from its position along the axis, m . e + t d . e.
template <Scalar S, int N, Number L, Number R>
[[nodiscard]] constexpr Decided<CapsulePart> part_at(const RayCylinder<S, N, L, R>& ray,
                                                     const Leading& t) noexcept {
  const auto me = dot(ray.m, ray.e);
  const auto to_last = ray.ee - me;
  const auto passed = t * Leading(ray.de);
  const auto is_past = [&](const auto& end) {
    return decide(difference(passed, Leading(abs(end)), Relative{42}));
  };
  const Filtered first = me > 0 ? Filtered::yes : is_past(me);
  if (first == Filtered::no) return {CapsulePart::first_end, true};
  const Filtered last = to_last < 0 ? Filtered::yes : is_past(to_last);
  if (last == Filtered::yes) return {CapsulePart::last_end, true};
  return {CapsulePart::side, first == Filtered::yes && last == Filtered::no};
}

/// Signs for the point where the line meets the plane through an end, perpendicular to the axis:
/// after or before the line is closest to the axis, and outside or inside the sphere about the end.
struct EndPlane {
  int after_closest;
  int outside;
};

/// `m` leads from the end to the ray's origin.
template <Scalar S, int N, Number L, Number R, Number M>
[[nodiscard]] constexpr EndPlane end_plane(const RayCylinder<S, N, L, R>& ray,
                                           const Vec<M, N>& m) noexcept {
  // Compares t = -(m . e) / (d . e) with t = -(m . d) / (d . d), the latter without the components
  // along the axis.
  const auto me = dot(m, ray.e);
  const auto after = ray.de * dot(m, ray.d);
  const auto closest = me * squared_length(ray.d);
  const auto there = make_vec<N>([&](int i) { return ray.de * m[i] - me * ray.d[i]; });
  return {(after > closest) - (after < closest),
          compare_length(to_array(there), abs(ray.de) * ray.radius)};
}

/// The part of the capsule where the line enters the cylinder, whose side is `side`, ahead of the
/// ray's origin.
template <Scalar S, int N, Number L, Number R, class Side>
[[nodiscard]] constexpr CapsulePart entered_part(const RayCylinder<S, N, L, R>& ray,
                                                 const Side& side) noexcept {
  if constexpr (is_fixed<S>) {
    if (const auto part = part_at(ray, side.leading_first()); part.is_sure) return part.value;
  }
  const auto first = end_plane(ray, ray.m);
  if (first.after_closest > 0 || first.outside < 0) return CapsulePart::first_end;
  const auto last = end_plane(ray, ray.m - ray.e);
  if (last.after_closest < 0 && last.outside > 0) return CapsulePart::last_end;
  return CapsulePart::side;
}

/// The part where the line leaves the capsule, which must be ahead of the ray's origin.
template <Scalar S, int N, Number L, Number R>
[[nodiscard]] constexpr CapsulePart left_part(const RayCylinder<S, N, L, R>& ray) noexcept {
  if (ray.a == 0) return CapsulePart::last_end;
  if constexpr (is_fixed<S>) {
    if (const auto part = part_at(ray, ray.side().leading_last()); part.is_sure) return part.value;
  }
  const auto first = end_plane(ray, ray.m);
  if (first.after_closest > 0 && first.outside > 0) return CapsulePart::first_end;
  const auto last = end_plane(ray, ray.m - ray.e);
  if (last.after_closest < 0 || last.outside < 0) return CapsulePart::last_end;
  return CapsulePart::side;
}

}  // namespace detent::detail
