// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "detent/cull/columns.hpp"
#include "detent/math/orthonormal.hpp"
#include "detent/query/kernel/clip.hpp"
#include "detent/shape/bounding_box.hpp"
#include "detent/shape/plane.hpp"

namespace detent::detail {

/// A box around all points at which a ray may touch a shape, or nothing if it may exceed the range
/// of the scalar.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Aabb<S, N>> within_range(const Aabb<S, N>& box) noexcept {
  if (is_empty(box)) return box;
  for (int i = 0; i < N; ++i) {
    // The box may have been clamped.
    if (box.min[i] == lowest<S> || box.max[i] == largest<S>) return std::nullopt;
  }
  return box;
}

template <class Shape>
[[nodiscard]] constexpr auto ray_bounds(const Shape& shape) noexcept {
  return within_range(bounding_box(shape));
}

template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Aabb<S, N>> ray_bounds(const Plane<S, N>&) noexcept {
  return std::nullopt;
}

/// To rays, a box is its slabs. If the cosines between its axes are at most e = 2^-10, a point with
/// coordinates |y_i| <= h along them is the sum of z_i axis(i) with |z_i - y_i| <= 1.01 e * 3 h. So
/// the box around the edges, grown by h / 64, contains the slabs. Slabs along more skewed axes may
/// be anywhere.
template <Scalar S, int N>
[[nodiscard]] constexpr auto ray_bounds(const Obb<S, N>& box) noexcept {
  using Result = std::optional<Aabb<S, N>>;
  auto around = bounding_box(box);
  if (is_empty(box)) return Result(around);
  if (!are_perpendicular<10>(box.rotation)) return Result();
  S longest{};
  for (int i = 0; i < N; ++i) longest = (std::max)(longest, box.half_extents[i]);
  const auto more = quotient_floor<finer<S, 6>>(longest, S(64));  // exactly
  for (int i = 0; i < N; ++i) {
    around.min[i] = floor_to<S>(around.min[i] - more);
    around.max[i] = ceil_to<S>(around.max[i] + more);
  }
  return within_range(around);
}

/// The part of a ray in the region of a batch, quantized, or nothing.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<LaneRay<S, N>> quantized_part(
    const Ray<S, N>& ray, const BatchGrid<S, N>& grid) noexcept {
  if (is_empty(grid.region())) return std::nullopt;
  const auto inside = clip(ray, grid.region()).interval();
  if (!inside) return std::nullopt;
  return grid.quantize(Segment<S, N>{point_at(ray, inside->enter), point_at(ray, inside->exit)},
                       ray.direction);
}

}  // namespace detent::detail
