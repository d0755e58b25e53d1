// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"
#include "oracle/half_spaces.hpp"

namespace detent::oracle {

/// A box is 2N half-spaces: for every axis the lower, then the upper one. The face hit is the first
/// whose half-space is entered exactly at the time of the hit.
template <int N>
Expected<N> raycast_box(const Line<N>& line,
                        const std::array<HalfSpace, static_cast<std::size_t>(2 * N)>& faces,
                        const std::array<Raw<N>, static_cast<std::size_t>(N)>& axes) {
  const auto inside = span(faces, line.max);
  if (!inside) return {};
  auto normal = against(line);
  if (!inside_at_start(faces)) {
    for (std::size_t i = faces.size(); i-- > 0;) {
      if (!faces[i].entered_at(inside->enter)) continue;
      const auto& axis = axes[i / 2];
      normal = stored<N>(i % 2 == 0 ? negated(axis) : axis);
    }
  }
  return hit(line, floor(inside->enter), floor(inside->exit), normal);
}

template <Scalar S, int N>
Expected<N> expected_raycast(const Ray<S, N>& ray, const Aabb<S, N>& box) {
  const auto line = oracle::line(ray);
  const auto min = raw(box.min);
  const auto max = raw(box.max);
  std::array<HalfSpace, static_cast<std::size_t>(2 * N)> faces;
  std::array<Raw<N>, static_cast<std::size_t>(N)> axes{};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (max[i] < min[i]) return {};
    faces[2 * i] = {(min[i] - line.origin[i]) * line.one, -line.direction[i]};
    faces[2 * i + 1] = {(line.origin[i] - max[i]) * line.one, line.direction[i]};
    axes[i][i] = static_cast<std::int64_t>(line.one);
  }
  return raycast_box<N>(line, faces, axes);
}

/// As slabs, with the axes exactly as stored: they need not be quite orthogonal.
template <Scalar S, int N>
Expected<N> expected_raycast(const Ray<S, N>& ray, const Obb<S, N>& box) {
  const auto line = oracle::line(ray);
  const auto apart = difference(line.origin, raw(box.center));
  const auto half = raw(box.half_extents);
  std::array<HalfSpace, static_cast<std::size_t>(2 * N)> faces;
  std::array<Raw<N>, static_cast<std::size_t>(N)> axes{};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (half[i] < 0) return {};
    axes[i] = raw(box.rotation.axis(static_cast<int>(i)));
    const auto axis = widen(axes[i]);
    const Integer place = dot(axis, apart);
    const Integer speed = dot(axis, line.direction);
    faces[2 * i] = {(-half[i] * line.one - place) * line.one, -speed};
    faces[2 * i + 1] = {(place - half[i] * line.one) * line.one, speed};
  }
  return raycast_box<N>(line, faces, axes);
}

}  // namespace detent::oracle
