// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "detent/math/rotation.hpp"
#include "detent/shape/shape.hpp"

// One list of the shapes, and every shape as its fields, for `verify`, the tool, tests, the accuracy
// study, properties and benchmarks.
namespace detent::support {

template <class... Shape>
struct ShapeList;

template <class Kept, class Dropped, class... Shape>
struct Without {
  using type = Kept;
};
template <class... Kept, class... Dropped, class First, class... Rest>
struct Without<ShapeList<Kept...>, ShapeList<Dropped...>, First, Rest...>
    : Without<std::conditional_t<(std::is_same_v<First, Dropped> || ...), ShapeList<Kept...>,
                                 ShapeList<Kept..., First>>,
              ShapeList<Dropped...>, Rest...> {};

/// Types of shapes, in an order on which drawn cases depend: new ones come last.
template <class... Shape>
struct ShapeList {
  static constexpr std::size_t size = sizeof...(Shape);

  /// `To<Shape..., More...>`, such as a `std::variant`.
  template <template <class...> class To, class... More>
  using in = To<Shape..., More...>;

  template <class... More>
  using and_also = ShapeList<Shape..., More...>;

  /// The index of a shape in the list; `size` if it is not in the list.
  template <class Wanted>
  static constexpr std::size_t index = [] {
    std::size_t i = 0;
    (void)((std::is_same_v<Shape, Wanted> || (++i, false)) || ...);
    return i;
  }();

  template <class... Dropped>
  using without = typename Without<ShapeList<>, ShapeList<Dropped...>, Shape...>::type;

  /// Calls `f(Shape())` for every shape.
  template <class F>
  static constexpr void for_each(F&& f) {
    (f(Shape()), ...);
  }
  /// Calls `f(a, b)` for every two of the shapes, and for each with itself.
  template <class F>
  static constexpr void for_each_pair(F&& f) {
    with_rest<Shape...>(f);
  }
  /// Returns `f(Shape())` for the shape of this index, the last one for higher indices.
  template <class F>
  static constexpr auto at(std::size_t index, F&& f) {
    return visit<Shape...>(index, f);
  }

 private:
  template <class First, class... Rest, class F>
  static constexpr void with_rest(F& f) {
    f(First(), First());
    (f(First(), Rest()), ...);
    if constexpr (sizeof...(Rest) > 0) with_rest<Rest...>(f);
  }
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
/// Every shape that has an extent, such as a body.
template <Scalar S, int N>
using MovingShapes =
    typename SceneShapes<S, N>::template without<Plane<S, N>>::template and_also<ConvexHull<S, N>>;

/// The points within a radius of a core.
template <Scalar S, int N>
using RoundShapes = ShapeList<Sphere<S, N>, Capsule<S, N>>;

/// A shape with fields, a segment or a ray.
template <class Shape>
concept Mappable = detail::ListsFields<Shape>;

template <Mappable Shape>
constexpr std::string_view name_of(const Shape&) {
  return detail::ShapeFields<Shape>::name;
}

template <Scalar S, int N>
constexpr std::string_view name_of(const ConvexHull<S, N>&) {
  return "hull";
}

/// Returns f(field...).
template <Mappable Shape, class F>
constexpr auto with_fields(const Shape& shape, const F& f) {
  return detail::ShapeFields<Shape>::of(shape, f);
}

/// Calls f(field) for each field.
template <Mappable Shape, class F>
constexpr void visit_fields(const Shape& shape, F&& f) {
  with_fields(shape, [&](const auto&... fields) { (f(fields), ...); });
}

/// The shape made of `f(field)` for each field: a number, a point, a direction or a rotation.
template <template <Scalar, int> class Shape, Scalar S, int N, class F>
constexpr auto mapped(const Shape<S, N>& shape, F&& f) {
  return with_fields(shape, [&](const auto&... fields) { return Shape{f(fields)...}; });
}

/// Whether a field is a point.
template <class Field>
inline constexpr bool is_point = false;
template <Scalar S, int N>
inline constexpr bool is_point<Vec<S, N>> = true;

template <class Shape>
inline constexpr bool has_only_points_and_lengths = false;
template <Mappable Shape>
inline constexpr bool has_only_points_and_lengths<Shape> =
    with_fields(Shape(), []<class... Field>(const Field&...) {
      return ((is_point<Field> || Scalar<Field>)&&...);
    });
template <Scalar S, int N>
inline constexpr bool has_only_points_and_lengths<Aabb<S, N>> = false;  // it is empty if min > max

/// A sphere, triangle, capsule or segment: any points and lengths make a valid one.
template <class Shape>
concept OfPoints = has_only_points_and_lengths<Shape>;

/// The shape made of `point()` for each point and `length()` for each length, in order.
template <OfPoints Shape, class Point, class Length>
constexpr Shape made_of(Point&& point, Length&& length) {
  return mapped(Shape(), [&]<class Field>(const Field&) -> Field {
    if constexpr (is_point<Field>) {
      return point();
    } else {
      return length();
    }
  });
}

/// The shape with `f(point)` for each point.
template <OfPoints Shape, class F>
constexpr Shape with_points(const Shape& shape, F&& f) {
  return mapped(shape, [&]<class Field>(const Field& field) -> Field {
    if constexpr (is_point<Field>) {
      return f(field);
    } else {
      return field;
    }
  });
}

/// The number of points that define a shape.
template <OfPoints Shape>
inline constexpr std::size_t point_count = with_fields(
    Shape(), []<class... Field>(const Field&...) { return (std::size_t{is_point<Field>} + ...); });

/// The rotation with the axes `f(axis)`, in a scalar T.
template <Scalar T, Scalar S, int N, class F>
constexpr Rotation<T, N> mapped_axes(const Rotation<S, N>& rotation, F&& f) {
  std::array<Direction<T, N>, static_cast<std::size_t>(N)> axes;
  for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = f(rotation.axis(i));
  return Rotation<T, N>::from_axes(axes);
}

}  // namespace detent::support
