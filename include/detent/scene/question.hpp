// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>

#include "detent/scene/separate.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/fields.hpp"
#include "detent/shape/frustum.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/segment.hpp"

// Query shapes of a scene other than rays and casts: a point, segment, sphere, box, capsule or
// frustum finds the objects that it overlaps. Distances are measured from one reference point of
// the query shape.

namespace detent {

namespace detail {

template <class Shape, Scalar S, int N>
[[nodiscard]] constexpr bool meets(const Vec<S, N>& point, const Shape& shape) noexcept {
  return separately<job::Contains>(shape, point);
}
template <class Shape, Scalar S, int N>
[[nodiscard]] constexpr bool meets(const Segment<S, N>& segment, const Shape& shape) noexcept {
  return separately<job::Intersects>(segment, shape);
}
template <class Question, class Shape>
[[nodiscard]] constexpr bool meets(const Question& question, const Shape& shape) noexcept {
  return separately<job::Overlaps>(question, shape);
}

template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> reference(const Vec<S, N>& point) noexcept {
  return point;
}
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> reference(const Segment<S, N>& segment) noexcept {
  return segment.start;
}
template <Round Shape>
[[nodiscard]] constexpr auto reference(const Shape& shape) noexcept {
  return reference(ShapeFields<Shape>::core(shape));
}
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> reference(const Aabb<S, N>& box) noexcept {
  return make_vec<N>([&](int i) { return nearest_to<S>(half(box.min[i] + box.max[i])); });
}
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> reference(const Obb<S, N>& box) noexcept {
  return box.center;
}
/// The middle of the near corners, rounded to nearest.
template <Scalar S>
[[nodiscard]] constexpr Vec<S, 3> reference(const Frustum<S>& frustum) noexcept {
  const auto& corners = frustum.corners();
  return nearest_to<S>(half(half((corners[0] + corners[1]) + (corners[2] + corners[3]))));
}

}  // namespace detail

/// A query shape other than a ray or a cast for a scene's `nearest` and `all`: it has a reference
/// point to measure distances from. `any` takes other shapes as well.
template <class Question, class S, int N>
concept SceneQuestion = requires(const Question& question) {
  { detail::reference(question) } -> std::same_as<Vec<S, N>>;
};

namespace detail {

/// A `Cast` for a scene.
template <class Moving, class S, int N>
concept SceneCast = requires(const Moving& moving) {
  { moving.direction } -> std::same_as<const Direction<S, N>&>;
  { bounding_box(moving.shape) } -> std::same_as<Aabb<S, N>>;
};

template <class Question, class S, int N>
concept SceneRegion = SceneQuestion<Question, S, N> || requires(const Question& question) {
  { bounding_box(question) } -> std::same_as<Aabb<S, N>>;
};

/// Always true, or a compile error of one sentence; `if constexpr` on it then avoids further
/// errors.
template <bool IsQuestion>
[[nodiscard]] constexpr bool is_question() noexcept {
  static_assert(IsQuestion,
                "detent: query a scene with a ray, point, segment, sphere, box, capsule, frustum "
                "or a Cast of its own scalar and dimension");
  return IsQuestion;
}

}  // namespace detail

}  // namespace detent
