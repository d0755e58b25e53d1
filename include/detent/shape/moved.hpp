// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/math/transform.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/capsule.hpp"
#include "detent/shape/fields.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/plane.hpp"
#include "detent/shape/sphere.hpp"
#include "detent/shape/triangle.hpp"

// Moved shapes:
//   translated(shape, by)      -> the shape moved by a vector
//   placed(transform, shape)   -> the shape transformed from a local frame into the world
//
// exact: every number of the result is the exact one for the given input, rounded to nearest,
//        ties to even, and clamped to the range of the scalar   (tests/shape/moved.test.cpp)

namespace detent {

namespace detail {

/// Shapes of points and lengths, such as spheres, triangles and capsules.
template <class Shape, class S, int N>
inline constexpr bool is_of_points = false;
template <ListsFields Shape, Scalar S, int N>
inline constexpr bool is_of_points<Shape, S, N> = [](const Shape& shape) {
  return ShapeFields<Shape>::of(shape, []<class... Field>(const Field&...) {
    return ((std::is_same_v<Field, Vec<S, N>> || std::is_same_v<Field, S>)&&...);
  });
}(Shape());

}  // namespace detail

/// `shape` moved by a vector.
template <class Shape, Scalar S, int N>
requires detail::is_of_points<Shape, S, N>
[[nodiscard]] constexpr Shape translated(const Shape& shape, const Vec<S, N>& by) noexcept {
  return detail::with_fields(shape, [&]<class Field>(const Field& field) -> Field {
    if constexpr (std::is_same_v<Field, S>) {
      return field;
    } else {
      return nearest_to<S>(field + by);
    }
  });
}
template <Scalar S, int N>
[[nodiscard]] constexpr Obb<S, N> translated(const Obb<S, N>& box, const Vec<S, N>& by) noexcept {
  return {nearest_to<S>(box.center + by), box.half_extents, box.rotation};
}
template <Scalar S, int N>
[[nodiscard]] constexpr Plane<S, N> translated(const Plane<S, N>& plane,
                                               const Vec<S, N>& by) noexcept {
  return {plane.normal, nearest_to<S>(plane.offset + dot(plane.normal, by))};
}

namespace detail {

/// A length of the local frame in the world; a negative length, of an empty shape, is unchanged.
template <Scalar S, int N>
[[nodiscard]] constexpr S placed_length(const Transform<S, N>& transform,
                                        const S& length) noexcept {
  if (length < 0) return length;
  return nearest_to<S>(length * abs(transform.scale));
}

}  // namespace detail

/// `shape`, from a local frame, in the world.
template <class Shape, Scalar S, int N>
requires detail::is_of_points<Shape, S, N>
[[nodiscard]] constexpr Shape placed(const Transform<S, N>& transform,
                                     const Shape& shape) noexcept {
  return detail::with_fields(shape, [&]<class Field>(const Field& field) -> Field {
    if constexpr (std::is_same_v<Field, S>) {
      return detail::placed_length(transform, field);
    } else {
      return transform_point(transform, field);
    }
  });
}

/// An axis-aligned box cannot be rotated: this is the smallest box of the grid around the rotated
/// one.
template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> placed(const Transform<S, N>& transform,
                                          const Aabb<S, N>& box) noexcept {
  if (is_empty(box)) return box;
  const auto corner = [&](int j, bool is_most) {
    return make_vec<N>([&](int i) {
      const bool rises = (transform.rotation.axis(i)[j] < 0) == (transform.scale < 0);
      return rises == is_most ? box.max[i] : box.min[i];
    });
  };
  Aabb<S, N> result;
  for (int j = 0; j < N; ++j) {
    result.min[j] =
        floor_to<S>(transform.translation[j] + detail::moved(transform, corner(j, false), j));
    result.max[j] =
        ceil_to<S>(transform.translation[j] + detail::moved(transform, corner(j, true), j));
  }
  return result;
}

template <Scalar S, int N>
[[nodiscard]] constexpr Obb<S, N> placed(const Transform<S, N>& transform,
                                         const Obb<S, N>& box) noexcept {
  return {transform_point(transform, box.center),
          make_vec<N>([&](int i) { return detail::placed_length(transform, box.half_extents[i]); }),
          compose(transform.rotation, box.rotation)};
}

/// The offset is for the normal as stored in the result.
template <Scalar S, int N>
[[nodiscard]] constexpr Plane<S, N> placed(const Transform<S, N>& transform,
                                           const Plane<S, N>& plane) noexcept {
  const auto normal = transform_direction(transform, plane.normal);
  return {normal,
          nearest_to<S>(dot(normal, transform.translation) + abs(transform.scale) * plane.offset)};
}

}  // namespace detent
