// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/raycast.hpp"

/// Include this after linking `detent::detent` to let the library's copy of the raycasts serve
/// instead of compiling them again in every source file. No result depends on it.

// `extern template` in a user's source; src/instantiations.cpp leaves `extern` out.
#ifndef DETENT_INSTANTIATION
#define DETENT_INSTANTIATION extern template
#endif

#define DETENT_INSTANTIATE_SHAPE(S, N, Shape)                                                   \
  DETENT_INSTANTIATION std::optional<S> raycast(const Ray<S, N>&, const Shape<S, N>&) noexcept; \
  DETENT_INSTANTIATION std::optional<RayHit<S, N>> raycast_hit(const Ray<S, N>&,                \
                                                               const Shape<S, N>&) noexcept;    \
  DETENT_INSTANTIATION std::optional<Interval<S>> raycast_interval(const Ray<S, N>&,            \
                                                                   const Shape<S, N>&) noexcept;
#define DETENT_INSTANTIATE_DIMENSION(S, N) \
  DETENT_INSTANTIATE_SHAPE(S, N, Sphere)   \
  DETENT_INSTANTIATE_SHAPE(S, N, Aabb)     \
  DETENT_INSTANTIATE_SHAPE(S, N, Obb)      \
  DETENT_INSTANTIATE_SHAPE(S, N, Plane)    \
  DETENT_INSTANTIATE_SHAPE(S, N, Triangle)
#define DETENT_INSTANTIATE_SCALAR(S) \
  DETENT_INSTANTIATE_DIMENSION(S, 2) \
  DETENT_INSTANTIATE_DIMENSION(S, 3)

namespace detent {

DETENT_INSTANTIATE_SCALAR(q16_16)
DETENT_INSTANTIATE_SCALAR(q14_16)
DETENT_INSTANTIATE_SCALAR(q24_8)
DETENT_INSTANTIATE_SCALAR(q8_8)
DETENT_INSTANTIATE_SCALAR(float)
DETENT_INSTANTIATE_SCALAR(double)

}  // namespace detent

#undef DETENT_INSTANTIATE_SCALAR
#undef DETENT_INSTANTIATE_DIMENSION
#undef DETENT_INSTANTIATE_SHAPE
#undef DETENT_INSTANTIATION
