// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/shape/fields.hpp"
#include "detent/shape/hull.hpp"
#include "detent/shape/ray.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

template <Scalar S>
class Frustum;

namespace detail {

/// The kind of a query argument.
enum class Argument { none, point, segment, ray, shape };

template <class T>
inline constexpr Argument argument = ListsFields<T> ? Argument::shape : Argument::none;
template <Scalar S, int N>
inline constexpr Argument argument<Vec<S, N>> = Argument::point;
template <Scalar S, int N>
inline constexpr Argument argument<Segment<S, N>> = Argument::segment;
template <Scalar S, int N>
inline constexpr Argument argument<Ray<S, N>> = Argument::ray;
template <Scalar S, int N>
inline constexpr Argument argument<ConvexHull<S, N>> = Argument::shape;
template <Scalar S>
inline constexpr Argument argument<Frustum<S>> = Argument::shape;

/// Whether an argument is convex; surfaces of triangles are not.
template <class T>
inline constexpr bool is_convex = argument<T> != Argument::none;

/// The point type of an argument.
template <class T>
struct PointOf;
template <template <class, int> class T, class S, int N>
struct PointOf<T<S, N>> {
  using type = Vec<S, N>;
};
template <Scalar S>
struct PointOf<Frustum<S>> {
  using type = Vec<S, 3>;
};

template <class T>
concept IsArgument = (argument<T> != Argument::none);
template <class T>
concept IsPoint = (argument<T> == Argument::point);
template <class T>
concept IsSegment = (argument<T> == Argument::segment);
template <class T>
concept IsRay = (argument<T> == Argument::ray);
template <class T>
concept IsShape = (argument<T> == Argument::shape);

template <class A, class B>
concept Arguments = IsArgument<A> && IsArgument<B>;
template <class A, class B>
concept MixedArguments =
    Arguments<A, B> && !std::is_same_v<typename PointOf<A>::type, typename PointOf<B>::type>;

}  // namespace detail

}  // namespace detent
