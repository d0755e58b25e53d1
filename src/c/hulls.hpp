// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "c/points.hpp"
#include "detent/scene/hull/asset.hpp"

// Hulls as arguments of queries, and lists of shapes with hulls among them.
namespace detent::c {

/// The transformed points of a hull, each rounded.
template <int N>
struct HullRoom {
  std::array<Vec<S, N>, HullAsset<S, N>::capacity> points;
  std::size_t count = 0;

  /// Reads a shape of the kind DETENT_HULL; in assets.cpp.
  detent_status read(const detent_context* context, const typename Types<N>::Shape& shape);
};

/// f(hull) for a shape of the kind DETENT_HULL.
template <int N, class F>
detent_status with_hull(const detent_context* context, const typename Types<N>::Shape& shape,
                        const F& f) {
  HullRoom<N> room;
  const auto status = room.read(context, shape);
  if (status != DETENT_OK) return status;
  return f(ConvexHull<S, N>{std::span<const Vec<S, N>>(room.points).first(room.count)});
}

/// The same, also for other shapes, converted to a capsule, OBB, plane or hull: see points.hpp.
template <int N, class F>
detent_status with_hull_or_points(const detent_context* context,
                                  const typename Types<N>::Shape& shape, const F& f) {
  return shape.kind == DETENT_HULL ? with_hull<N>(context, shape, f) : with_points<N>(shape, f);
}

/// DETENT_OK if all shapes of a list can be read, otherwise the error of the first that cannot.
template <int N>
detent_status check_shapes(const detent_context* context, const typename Types<N>::Shape* shapes,
                           std::uint32_t count) {
  if (shapes == nullptr && count != 0) return DETENT_BAD_ARGUMENT;
  const auto is_fine = [](const auto&) -> detent_status { return DETENT_OK; };
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto status = shapes[i].kind == DETENT_HULL ? with_hull<N>(context, shapes[i], is_fine)
                                                      : with_shape<N>(shapes[i], is_fine);
    if (status != DETENT_OK) return status;
  }
  return DETENT_OK;
}
/// The same for two lists.
template <int N>
detent_status check_lists(const detent_context* context, const typename Types<N>::Shape* a,
                          std::uint32_t a_count, const typename Types<N>::Shape* b,
                          std::uint32_t b_count) {
  const auto status = check_shapes<N>(context, a, a_count);
  return status == DETENT_OK ? check_shapes<N>(context, b, b_count) : status;
}

}  // namespace detent::c
