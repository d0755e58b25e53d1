// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "oracle/solid.hpp"

namespace detent::oracle {

/// A point with the coordinates over[i] / under raw units, and its squared distance from the query
/// point. Denominators are positive.
template <int N>
struct Place {
  Vector<N> over;
  Integer under = 1;
  Moment squared;
};

/// The result for a point and a shape, nothing for an empty shape. The shape is all points within
/// `radius` of its core (points, lines, faces or boxes), and `core` is the closest point of the
/// core.
template <int N>
struct Nearest {
  Place<N> core;
  Integer radius = 0;
  /// Whether a point inside is its own closest point.
  bool keeps_inside = false;
};

[[nodiscard]] std::optional<Nearest<2>> nearest(const Solid<2>& solid, const Vector<2>& point);
[[nodiscard]] std::optional<Nearest<3>> nearest(const Solid<3>& solid, const Vector<3>& point);
[[nodiscard]] std::optional<Nearest<2>> nearest(const Line<2>& line, const Vector<2>& point);
[[nodiscard]] std::optional<Nearest<3>> nearest(const Line<3>& line, const Vector<3>& point);

/// Whether the point is within `tolerance` of the shape.
template <int N>
bool is_within(const std::optional<Nearest<N>>& truth, const Integer& tolerance) {
  if (!truth || tolerance < 0) return false;
  const Integer reach = truth->radius + tolerance;
  return truth->core.squared.over <= reach * reach * truth->core.squared.under;
}

/// Whether given = floor(max(0, distance)), clamped to `limit`, which is the distance of an empty
/// shape.
template <int N>
bool is_distance(const Integer& given, const std::optional<Nearest<N>>& truth,
                 const Integer& limit) {
  if (!truth) return given == limit;
  if (given < 0) return false;
  const Integer reach = truth->radius + given;
  const auto& [over, under] = truth->core.squared;
  if (given > 0 && over < reach * reach * under) return false;
  return given == limit || over < (reach + 1) * (reach + 1) * under;
}

/// Whether `given` is core + radius * v / |v| on one axis, rounded to nearest, ties to even; v
/// points away from the core.
template <int N>
bool is_rounded(const Integer& given, const Place<N>& core, std::size_t axis, const Integer& radius,
                const Vector<N>& v);

/// Whether `given` is the point of the shape closest to `point`, rounded and clamped.
template <int N>
bool is_closest(const Vector<N>& given, const Vector<N>& point,
                const std::optional<Nearest<N>>& truth, const Integer& lowest,
                const Integer& highest);

}  // namespace detent::oracle
