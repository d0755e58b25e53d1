// SPDX-License-Identifier: MIT
#pragma once

// Compiled once in `detent::detent` for scenes in `q16_16` with any list of shapes: queries on a
// shape or a pair, and trees with their traversals. scene/scene.hpp includes this header in
// programs that link the library (DETENT_USE_LIBRARY). It changes no result and no type.

#include <cstdint>
#include <optional>

#include "detent/scene/bytes.hpp"
#include "detent/scene/scene.hpp"

// src/instantiations/ includes this header without the `extern`.
#ifndef DETENT_INSTANTIATION
#define DETENT_INSTANTIATION extern template
#endif

#define DETENT_INSTANTIATE_OVERLAPS(S, N, Shape, Other)                            \
  DETENT_INSTANTIATION bool call_separate<job::Overlaps, bool>(const Shape<S, N>&, \
                                                               const Other<S, N>&);
#define DETENT_INSTANTIATE_SHAPE(S, N, Shape)                                                     \
  DETENT_INSTANTIATION std::optional<S> call_separate<job::Raycast, std::optional<S>>(            \
      const Ray<S, N>&, const Shape<S, N>&);                                                      \
  DETENT_INSTANTIATION std::optional<RayHit<S, N>>                                                \
  call_separate<job::RaycastHit, std::optional<RayHit<S, N>>>(const Ray<S, N>&,                   \
                                                              const Shape<S, N>&);                \
  DETENT_INSTANTIATION S call_separate<job::Distance, S>(const Shape<S, N>&, const Vec<S, N>&);   \
  DETENT_INSTANTIATION bool call_separate<job::Contains, bool>(const Shape<S, N>&,                \
                                                               const Vec<S, N>&);                 \
  DETENT_INSTANTIATION bool call_separate<job::Intersects, bool>(const Segment<S, N>&,            \
                                                                 const Shape<S, N>&);             \
  DETENT_INSTANTIATION Shape<S, N> call_separate<job::Place, Shape<S, N>>(const Transform<S, N>&, \
                                                                          const Shape<S, N>&);    \
  DETENT_INSTANTIATION void call_separate<job::Describe, void>(Digest&, const Shape<S, N>&);      \
  DETENT_INSTANTIATION void call_separate<job::Describe, void>(Writer&, const Shape<S, N>&);      \
  DETENT_INSTANTIATE_OVERLAPS(S, N, Shape, Sphere)                                                \
  DETENT_INSTANTIATE_OVERLAPS(S, N, Shape, Aabb)                                                  \
  DETENT_INSTANTIATE_OVERLAPS(S, N, Shape, Obb)                                                   \
  DETENT_INSTANTIATE_OVERLAPS(S, N, Shape, Plane)                                                 \
  DETENT_INSTANTIATE_OVERLAPS(S, N, Shape, Triangle)                                              \
  DETENT_INSTANTIATE_OVERLAPS(S, N, Shape, Capsule)
#define DETENT_INSTANTIATE_TREE(S, N)                                                      \
  DETENT_INSTANTIATION void call_separate<job::SetBox, void>(                              \
      Tree<Growing, S, N>&, const std::uint32_t&, const QuantizedBox<S, N>&);              \
  DETENT_INSTANTIATION void call_separate<job::Rebuild, void>(Tree<Growing, S, N>&);       \
  DETENT_INSTANTIATION void call_separate<job::MoveFrame, void>(                           \
      Frames<Growing, S, N>&, const std::uint32_t&, const Transform<S, N>&);               \
  DETENT_INSTANTIATION void call_separate<job::PlaceFrames, void>(Frames<Growing, S, N>&); \
  DETENT_INSTANTIATION Walk call_separate<job::VisitNearest, Walk>(                        \
      const Tree<Growing, S, N>&, RayProbe<S, N>&, const ObjectVisitor&);                  \
  DETENT_INSTANTIATION Walk call_separate<job::VisitNearest, Walk>(                        \
      const Tree<Growing, S, N>&, PointProbe<S, N>&, const ObjectVisitor&);                \
  DETENT_INSTANTIATION Walk call_separate<job::VisitMeeting, Walk>(                        \
      const Tree<Growing, S, N>&, const QuantizedBox<S, N>&, const std::size_t&,           \
      const ObjectsVisitor&);                                                              \
  DETENT_INSTANTIATION void call_separate<job::VisitPairs, void>(                          \
      const Tree<Growing, S, N>&, const Tree<Growing, S, N>&, const PairVisitor&);
#define DETENT_INSTANTIATE_DIMENSION(S, N) \
  DETENT_INSTANTIATE_TREE(S, N)            \
  DETENT_INSTANTIATE_SHAPE(S, N, Sphere)   \
  DETENT_INSTANTIATE_SHAPE(S, N, Aabb)     \
  DETENT_INSTANTIATE_SHAPE(S, N, Obb)      \
  DETENT_INSTANTIATE_SHAPE(S, N, Plane)    \
  DETENT_INSTANTIATE_SHAPE(S, N, Triangle) \
  DETENT_INSTANTIATE_SHAPE(S, N, Capsule)

namespace detent::detail {

#if !defined(DETENT_INSTANTIATED_DIMENSION) || DETENT_INSTANTIATED_DIMENSION == 2
DETENT_INSTANTIATE_DIMENSION(q16_16, 2)
#endif
#if !defined(DETENT_INSTANTIATED_DIMENSION) || DETENT_INSTANTIATED_DIMENSION == 3
DETENT_INSTANTIATE_DIMENSION(q16_16, 3)
#endif

}  // namespace detent::detail

#undef DETENT_INSTANTIATE_DIMENSION
#undef DETENT_INSTANTIATE_TREE
#undef DETENT_INSTANTIATE_SHAPE
#undef DETENT_INSTANTIATE_OVERLAPS
#undef DETENT_INSTANTIATION
