// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/argument.hpp"

// Overloads that catch wrong calls: the error is one sentence that says what to write instead.
// Every query is a better match, so they change no correct call, and a concept that checks for such
// a call finds none.
//
// GCC shows the line of a deleted function. clang would also list all other overloads, so there
// they are marked unavailable, which it treats as deleted.
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
concept MixedShapes = MixedArguments<A, B> && TwoShapes<A, B>;

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

template <class A, class B> requires detail::PointFirst<A, B>
void distance(const A&, const B&) DETENT_INSTEAD("swap them: distance(shape, point)");
template <class A, class B> requires detail::RayAndOther<A, B>
void distance(const A&, const B&) DETENT_INSTEAD("a ray: it takes a ray and a point, or two shapes");
template <class A, class B> requires detail::MixedDistance<A, B>
void distance(const A&, const B&) DETENT_INSTEAD("give both the same scalar and dimension");

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

// clang-format on

}  // namespace detent

#undef DETENT_INSTEAD
