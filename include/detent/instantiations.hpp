// SPDX-License-Identifier: MIT
#pragma once

// What `detent::detent` compiles once for direct calls: raycasts in `q16_16`. query/raycast.hpp
// includes this header in programs that link the library (DETENT_USE_LIBRARY). It changes no result
// and no type.

#include <optional>

#include "detent/query/raycast.hpp"

// src/instantiations/ includes this header too, without the `extern`.
#ifndef DETENT_INSTANTIATION
#define DETENT_INSTANTIATION extern template
#endif

#define DETENT_INSTANTIATE_SHAPE(S, N, Shape, ...)                               \
  DETENT_INSTANTIATION std::optional<S> raycast(                                 \
      const Ray<S, N>&, const Shape<S, N>& __VA_OPT__(, ) __VA_ARGS__) noexcept; \
  DETENT_INSTANTIATION std::optional<RayHit<S, N>> raycast_hit(                  \
      const Ray<S, N>&, const Shape<S, N>& __VA_OPT__(, ) __VA_ARGS__) noexcept; \
  DETENT_INSTANTIATION std::optional<Interval<S>> raycast_interval(              \
      const Ray<S, N>&, const Shape<S, N>& __VA_OPT__(, ) __VA_ARGS__) noexcept;
#define DETENT_INSTANTIATE_DIMENSION(S, N) \
  DETENT_INSTANTIATE_SHAPE(S, N, Sphere)   \
  DETENT_INSTANTIATE_SHAPE(S, N, Aabb)     \
  DETENT_INSTANTIATE_SHAPE(S, N, Obb)      \
  DETENT_INSTANTIATE_SHAPE(S, N, Segment)  \
  DETENT_INSTANTIATE_SHAPE(S, N, Capsule)  \
  DETENT_INSTANTIATE_SHAPE(S, N, Plane, Facing)
#define DETENT_INSTANTIATE_SCALAR(S)       \
  DETENT_INSTANTIATE_DIMENSION(S, 2)       \
  DETENT_INSTANTIATE_DIMENSION(S, 3)       \
  DETENT_INSTANTIATE_SHAPE(S, 2, Triangle) \
  DETENT_INSTANTIATE_SHAPE(S, 3, Triangle, Facing)

namespace detent {

DETENT_INSTANTIATE_SCALAR(q16_16)

}  // namespace detent

#undef DETENT_INSTANTIATE_SCALAR
#undef DETENT_INSTANTIATE_DIMENSION
#undef DETENT_INSTANTIATE_SHAPE
#undef DETENT_INSTANTIATION
