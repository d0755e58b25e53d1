// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "detent/math/rotation.hpp"
#include "detent/shape/shape.hpp"

// One list of the shapes, and every shape as its fields, for `verify`, the tool, tests, the accuracy
// study, properties and benchmarks.
namespace detent::support {

/// Types of shapes, in an order on which drawn cases depend: new ones come last.
template <class... Shape>
struct ShapeList {
  static constexpr std::size_t size = sizeof...(Shape);

  /// `To<Shape..., More...>`, such as a `std::variant`.
  template <template <class...> class To, class... More>
  using in = To<Shape..., More...>;

  template <class... More>
  using and_also = ShapeList<Shape..., More...>;

  /// Calls `f(Shape())` for every shape.
  template <class F>
  static constexpr void for_each(F&& f) {
    (f(Shape()), ...);
  }
  /// Returns `f(Shape())` for the shape of this index, the last one for higher indices.
  template <class F>
  static constexpr auto at(std::size_t index, F&& f) {
    return visit<Shape...>(index, f);
  }

 private:
  template <class First, class... Rest, class F>
  static constexpr auto visit(std::size_t index, F& f) {
    if constexpr (sizeof...(Rest) > 0) {
      if (index > 0) return visit<Rest...>(index - 1, f);
    }
    return f(First());
  }
};

/// The shapes of scenes, in the order of their numbers in snapshots.
template <Scalar S, int N>
using SceneShapes =
    ShapeList<Sphere<S, N>, Aabb<S, N>, Obb<S, N>, Plane<S, N>, Triangle<S, N>, Capsule<S, N>>;
/// Every shape of two-shape queries.
template <Scalar S, int N>
using AllShapes = typename SceneShapes<S, N>::template and_also<Segment<S, N>, ConvexHull<S, N>>;

/// A shape with fields, a segment or a ray.
template <class Shape>
concept Mappable = detail::ListsFields<Shape>;

template <Mappable Shape>
constexpr std::string_view name_of(const Shape&) {
  return detail::ShapeFields<Shape>::name;
}

/// The shape made of `f(field)` for each field: a number, a point, a direction or a rotation.
template <template <Scalar, int> class Shape, Scalar S, int N, class F>
constexpr auto mapped(const Shape<S, N>& shape, F&& f) {
  return detail::ShapeFields<Shape<S, N>>::of(
      shape, [&](const auto&... fields) { return Shape{f(fields)...}; });
}

/// The rotation with the axes `f(axis)`, in a scalar T.
template <Scalar T, Scalar S, int N, class F>
constexpr Rotation<T, N> mapped_axes(const Rotation<S, N>& rotation, F&& f) {
  std::array<Direction<T, N>, static_cast<std::size_t>(N)> axes;
  for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = f(rotation.axis(i));
  return Rotation<T, N>::from_axes(axes);
}

}  // namespace detent::support
