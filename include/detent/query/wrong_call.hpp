// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/argument.hpp"
#include "detent/query/kernel/core.hpp"
#include "detent/shape/plane.hpp"

// Overloads that catch wrong calls: the error is one sentence that says what to write instead.
// Every query is a better match, so correct calls do not change, and a concept that checks for a
// wrong call finds none.
//
// GCC shows the line of a deleted function. clang would also list all other overloads, so for clang
// they are marked unavailable, which it treats like deleted.
#if defined(__clang__)
#define DETENT_INSTEAD(sentence) __attribute__((unavailable(sentence)))
#else
#define DETENT_INSTEAD(sentence) = delete
#endif

namespace detent {

namespace detail {

template <class A, class B>
concept PointFirst = Arguments<A, B> && IsPoint<A> && !IsPoint<B>;
template <class A, class B>
concept NoPoint = Arguments<A, B> && !IsPoint<A> && !IsPoint<B>;
template <class A, class B>
concept MixedWithPoint = MixedArguments<A, B> && IsPoint<B>;

template <class A, class B>
concept RayAndOther = NoPoint<A, B> &&(IsRay<A> || IsRay<B>);
template <class A, class B>
concept MixedDistance = MixedArguments<A, B> && !PointFirst<A, B> && !RayAndOther<A, B>;

template <class A, class B>
concept RayLast = Arguments<A, B> && !IsRay<A> && IsRay<B>;
template <class A, class B>
concept NoRay = Arguments<A, B> && !IsRay<A> && !IsRay<B>;
template <class A, class B>
concept RayAndPoint = IsRay<A> && IsPoint<B>;
template <class A, class B>
concept MixedWithRay = MixedArguments<A, B> && IsRay<A> && !IsPoint<B>;

template <class A, class B>
concept HaveRay = Arguments<A, B> &&(IsRay<A> || IsRay<B>);
template <class A, class B>
concept HavePoint = NoRay<A, B> &&(IsPoint<A> || IsPoint<B>);
template <class A, class B>
concept HaveSegment = NoRay<A, B> && NoPoint<A, B> &&(IsSegment<A> || IsSegment<B>);
template <class A, class B>
concept MixedSegment = MixedArguments<A, B> && HaveSegment<A, B>;
template <class A, class B>
concept TwoShapes = IsShape<A> && IsShape<B>;
template <class A, class B>
concept MixedBodies = MixedArguments<A, B> && NoRay<A, B> && NoPoint<A, B>;
template <class A, class B>
concept MixedShapes = MixedArguments<A, B> && TwoShapes<A, B>;
template <class A, class B>
concept MixedSolids = MixedArguments<A, B> && NoRay<A, B> && NoPoint<A, B>;
template <class A, class B>
concept HavePlane = TwoShapes<A, B> &&(is_kind<A, Plane> || is_kind<B, Plane>);
template <class A, class B>
concept PlaneFirst = Arguments<A, B> && NoRay<A, B> && NoPoint<A, B> && is_kind<A, Plane>;
template <class A, class B>
concept NotTwoShapes = Arguments<A, B> && !TwoShapes<A, B>;
template <class A, class B>
concept HaveSurface = TwoShapes<A, B> && !MixedArguments<A, B> && !(is_convex<A> && is_convex<B>);
template <class D, class A, class B>
concept VectorBetween = IsPoint<D> && TwoShapes<A, B> && !MixedArguments<A, B>;

}  // namespace detail

// clang-format off

template <class A, class B> requires detail::HaveRay<A, B>
void overlaps(const A&, const B&) DETENT_INSTEAD("a ray: use raycast(ray, shape)");
template <class A, class B> requires detail::HavePoint<A, B>
void overlaps(const A&, const B&) DETENT_INSTEAD("a point: use contains(shape, point)");
template <class A, class B> requires detail::HaveSegment<A, B>
void overlaps(const A&, const B&) DETENT_INSTEAD("a segment: use intersects(segment, shape)");
template <class A, class B> requires detail::MixedShapes<A, B>
void overlaps(const A&, const B&) DETENT_INSTEAD("give both shapes the same scalar and dimension");

template <class A, class B> requires detail::HaveRay<A, B>
void intersects(const A&, const B&) DETENT_INSTEAD("a ray: use raycast(ray, shape)");
template <class A, class B> requires detail::HavePoint<A, B>
void intersects(const A&, const B&) DETENT_INSTEAD("a point: use contains(shape, point)");
template <class A, class B> requires detail::TwoShapes<A, B>
void intersects(const A&, const B&) DETENT_INSTEAD("two shapes: use overlaps(a, b)");
template <class A, class B> requires detail::MixedSegment<A, B>
void intersects(const A&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

template <class A, class B> requires detail::PointFirst<A, B>
void contains(const A&, const B&) DETENT_INSTEAD("swap them: contains(shape, point)");
template <class A, class B> requires detail::NoPoint<A, B>
void contains(const A&, const B&) DETENT_INSTEAD("no point: use overlaps(a, b) for two shapes");
template <class A, class B> requires detail::MixedWithPoint<A, B>
void contains(const A&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

template <class A, class B> requires detail::PointFirst<A, B>
void closest_point(const A&, const B&) DETENT_INSTEAD("swap them: closest_point(shape, point)");
template <class A, class B> requires detail::NoPoint<A, B>
void closest_point(const A&, const B&) DETENT_INSTEAD("no point: it takes a shape and a point");
template <class A, class B> requires detail::MixedWithPoint<A, B>
void closest_point(const A&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

template <class A, class B> requires detail::HaveRay<A, B>
void closest_points(const A&, const B&) DETENT_INSTEAD("a ray: it takes two shapes or segments");
template <class A, class B> requires detail::HavePoint<A, B>
void closest_points(const A&, const B&) DETENT_INSTEAD("a point: use closest_point(shape, point)");
template <class A, class B> requires detail::MixedSolids<A, B>
void closest_points(const A&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

template <class A, class B> requires detail::PointFirst<A, B>
void distance(const A&, const B&) DETENT_INSTEAD("swap them: distance(shape, point)");
template <class A, class B> requires detail::RayAndOther<A, B>
void distance(const A&, const B&) DETENT_INSTEAD("a ray: it takes a ray and a point, or two shapes");
template <class A, class B> requires detail::MixedDistance<A, B>
void distance(const A&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

template <class A, class B> requires detail::HaveRay<A, B>
void contact(const A&, const B&) DETENT_INSTEAD("a ray: use raycast_hit(ray, shape)");
template <class A, class B> requires detail::HavePoint<A, B>
void contact(const A&, const B&) DETENT_INSTEAD("a point: give a sphere of radius 0");
template <class A, class B> requires detail::HaveSurface<A, B>
void contact(const A&, const B&) DETENT_INSTEAD("a mesh or terrain: use contacts(mesh, shape, out)");
template <class A, class B> requires detail::MixedBodies<A, B>
void contact(const A&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

template <class A, class B> requires detail::RayLast<A, B>
void raycast(const A&, const B&) DETENT_INSTEAD("swap them: raycast(ray, shape)");
template <class A, class B> requires detail::NoRay<A, B>
void raycast(const A&, const B&) DETENT_INSTEAD("no ray; segments: intersects(segment, shape)");
template <class A, class B> requires detail::RayAndPoint<A, B>
void raycast(const A&, const B&) DETENT_INSTEAD("a point: use contains(ray, point)");
template <class A, class B> requires detail::MixedWithRay<A, B>
void raycast(const A&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

template <class A, class B> requires detail::RayLast<A, B>
void raycast_hit(const A&, const B&) DETENT_INSTEAD("swap them: raycast_hit(ray, shape)");
template <class A, class B> requires detail::NoRay<A, B>
void raycast_hit(const A&, const B&) DETENT_INSTEAD("no ray; segments: intersects(segment, shape)");
template <class A, class B> requires detail::RayAndPoint<A, B>
void raycast_hit(const A&, const B&) DETENT_INSTEAD("a point: use contains(ray, point)");
template <class A, class B> requires detail::MixedWithRay<A, B>
void raycast_hit(const A&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

template <class A, class B> requires detail::RayLast<A, B>
void raycast_interval(const A&, const B&) DETENT_INSTEAD("swap them: raycast_interval(ray, shape)");
template <class A, class B> requires detail::NoRay<A, B>
void raycast_interval(const A&, const B&) DETENT_INSTEAD("no ray: it takes a ray and a shape");
template <class A, class B> requires detail::RayAndPoint<A, B>
void raycast_interval(const A&, const B&) DETENT_INSTEAD("a point: use contains(ray, point)");
template <class A, class B> requires detail::MixedWithRay<A, B>
void raycast_interval(const A&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

template <class A, class D, class T, class B> requires detail::HaveRay<A, B>
void cast(const A&, const D&, const T&, const B&) DETENT_INSTEAD("a ray: use raycast_hit(ray, shape)");
template <class A, class D, class T, class B> requires detail::HavePoint<A, B>
void cast(const A&, const D&, const T&, const B&) DETENT_INSTEAD("a point: give a sphere of radius 0");
template <class A, class D, class T, class B> requires detail::PlaneFirst<A, B>
void cast(const A&, const D&, const T&, const B&) DETENT_INSTEAD("a plane rests: give it as the target");
template <class A, class D, class T, class B> requires detail::MixedBodies<A, B>
void cast(const A&, const D&, const T&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

template <class A, class D, class T, class B> requires(detail::VectorBetween<D, A, B> && !detail::PlaneFirst<A, B>)
void cast(const A&, const D&, const T&, const B&) DETENT_INSTEAD("a vector: give a direction, *normalize(v)");

template <class A, class SweepA, class B, class SweepB> requires detail::HavePlane<A, B>
void time_of_impact(const A&, const SweepA&, const B&, const SweepB&) DETENT_INSTEAD("a plane rests: use time_of_impact(a, sweep, plane)");
template <class A, class SweepA, class B, class SweepB> requires detail::NotTwoShapes<A, B>
void time_of_impact(const A&, const SweepA&, const B&, const SweepB&) DETENT_INSTEAD("no shape: use a Sphere or Capsule of radius 0");
template <class A, class SweepA, class B, class SweepB> requires(detail::VectorBetween<SweepA, A, B> && !detail::HavePlane<A, B>)
void time_of_impact(const A&, const SweepA&, const B&, const SweepB&) DETENT_INSTEAD("a vector: give a Sweep{start, end}");
template <class A, class SweepA, class B, class SweepB> requires detail::MixedShapes<A, B>
void time_of_impact(const A&, const SweepA&, const B&, const SweepB&) DETENT_INSTEAD("give both shapes the same scalar and dimension");

// clang-format on

}  // namespace detent

#undef DETENT_INSTEAD
