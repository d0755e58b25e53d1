// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "detent/query/contact/boxes.hpp"
#include "detent/query/contact/contact.hpp"
#include "detent/query/contact/manifold.hpp"
#include "detent/query/contact/obbs.hpp"
#include "detent/query/contact/segment_box.hpp"
#include "detent/query/contact/sphere_box.hpp"
#include "detent/query/contact/spheres.hpp"
#include "detent/query/kernel/argument.hpp"
#include "detent/query/kernel/least_push.hpp"

namespace detent {

namespace detail {

template <class T>
concept HasContacts = (IsShape<T> || IsSegment<T>)&&is_convex<T>;
template <class A, class B>
concept HaveContact = HasContacts<A> && HasContacts<B> && !MixedArguments<A, B> &&
                      !(is_kind<A, Plane> && is_kind<B, Plane>);

template <Scalar S, Number T, int N>
[[nodiscard]] constexpr Direction<S, N> unit_of(const Vec<T, N>& v) noexcept {
  return direction_of<S>(v).value_or(Direction<S, N>());
}
template <Scalar S, int N>
[[nodiscard]] constexpr const Direction<S, N>& unit_of(const Direction<S, N>& d) noexcept {
  return d;
}

/// The corners of a core with few corners; other cores are bodies themselves.
template <class Core>
[[nodiscard]] constexpr auto corners_of(const Core& core) noexcept {
  if constexpr (is_kind<Core, Vec>) {
    return std::array{core};
  } else if constexpr (is_kind<Core, Segment>) {
    return std::array{core.start, core.end};
  } else if constexpr (is_kind<Core, Triangle>) {
    return std::array{core.a, core.b, core.c};
  } else {
    return core;
  }
}
/// Points, segments and triangles are bodies of one type, to save compile time.
template <Scalar S, int N, std::size_t Count>
[[nodiscard]] constexpr auto body_of_corners(const std::array<Vec<S, N>, Count>& corners) noexcept {
  return HullBody(ConvexHull<S, N>{corners});
}
template <class Core>
[[nodiscard]] constexpr auto body_of_corners(const Core& core) noexcept {
  return body_of(core);
}

/// Makes the contact of a push; meet(manifold) finds its points, from features of at most `Most`
/// corners.
template <std::size_t Most, Scalar S, int N, Number Depth, class Meet>
[[nodiscard]] constexpr std::optional<Contact<S, N>> make_contact(const Direction<S, N>& normal,
                                                                  const Depth& depth,
                                                                  const S& radius_a,
                                                                  const S& radius_b,
                                                                  const Meet& meet) noexcept {
  Contact<S, N> contact;
  contact.normal = normal;
  contact.depth = floor_to<S>(depth);
  const auto radii = radius_a + radius_b;
  ContactBuilder<S, N, Most> manifold(normal, narrow<bits_of<Length<S>>>(depth - radii), radius_a,
                                      radii);
  meet(manifold);
  manifold.write(contact);
  return contact;
}

template <Scalar S, int N, class Core>
[[nodiscard]] constexpr std::optional<Contact<S, N>> contact_with_plane(const Plane<S, N>& plane,
                                                                        const Core& core,
                                                                        const S& radius,
                                                                        bool plane_is_a) noexcept {
  const auto corners = corners_of(core);
  const auto body = body_of_corners(corners);
  const auto push = least_push_from_plane(plane, body, radius);
  if (!push) return std::nullopt;
  const auto& away = push->normal;
  const S none(0);
  constexpr auto most = most_corners<std::remove_cvref_t<decltype(body)>>;
  return make_contact<most>(
      plane_is_a ? away : -away, push->depth, plane_is_a ? none : radius,
      plane_is_a ? radius : none, [&](auto& manifold) {
        const auto deepest = extreme_feature<S, most>(body, body, away.vec(), false);
        manifold.meet_plane(plane_is_a, opposed_feature(core, body, deepest, away), deepest);
      });
}

/// The contact of a box and a segment, which may be a point, by their least push.
template <class Box, Scalar S, int N>
[[nodiscard]] constexpr std::optional<Contact<S, N>> contact_of_push(
    const Box& box, const Segment<S, N>& segment, const S& radius, bool box_is_a,
    const std::optional<SegmentBoxPush<S, N>>& push) noexcept {
  if (!push) return std::nullopt;
  const auto& away = push->away;
  const S none(0);
  constexpr std::size_t most = std::size_t{1} << N;
  return make_contact<most>(box_is_a ? away : -away, push->depth, box_is_a ? none : radius,
                            // cppcheck-suppress invalidLifetime  // false positive: called here
                            box_is_a ? radius : none, [&](auto& manifold) {
                              // cppcheck-suppress legacyUninitvar  // false positive
                              const auto side = push->template side<most>(box);
                              // cppcheck-suppress legacyUninitvar  // false positive
                              const auto end = push->template end<most>(segment);
                              const auto wide = [](const auto& feature) { return feature; };
                              const auto whole = [&](const auto& feature) {
                                const std::array ends{segment.start, segment.end};
                                return opposed_feature(segment, body_of_corners(ends), feature,
                                                       away);
                              };
                              if (box_is_a) {
                                manifold.meet(side, end, wide, whole);
                              } else {
                                manifold.meet(end, side, whole, wide);
                              }
                            });
}
/// The same for an oriented box, measured in its frame.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Contact<S, N>> contact_in_frame(const Obb<S, N>& box,
                                                                      const Segment<S, N>& segment,
                                                                      const S& radius,
                                                                      bool box_is_a) noexcept {
  return contact_of_push(box, segment, radius, box_is_a, segment_box_push(box, segment, radius));
}

/// The contact of two cores as any convex bodies; `filter` is that of the cores: see axis_filter.hpp.
template <Scalar S, int N, class A, class B, class Filter>
[[nodiscard]] constexpr std::optional<Contact<S, N>> contact_of_bodies(
    const A& a, const B& b, const S& radius_a, const S& radius_b, const Filter& filter) noexcept {
  const auto corners_a = corners_of(a);
  const auto corners_b = corners_of(b);
  const auto body_a = body_of_corners(corners_a);
  const auto body_b = body_of_corners(corners_b);
  constexpr auto most =
      most_corners_of<std::remove_cvref_t<decltype(body_a)>, std::remove_cvref_t<decltype(body_b)>>;
  Feature<S, N, most> face_a, face_b;
  using UnitPush = LeastPush<Direction<S, N>, Depth<S>>;
  const auto push =
      least_push_between<S>(body_a, body_b, radius_a + radius_b, filter,
                            [&](const auto& normal, const Depth<S>& depth, const auto&... known) {
                              face_a = face_along<S, most>(body_a, normal, true, known.a...);
                              face_b = face_along<S, most>(body_b, normal, false, known.b...);
                              return std::optional<UnitPush>({unit_of<S>(normal), depth});
                            });
  if (!push) return std::nullopt;
  const auto& normal = push->normal;
  return make_contact<most>(normal, push->depth, radius_a, radius_b, [&](auto& manifold) {
    manifold.meet(
        face_a, face_b,
        [&](const auto& deepest) { return opposed_feature(a, body_a, deepest, -normal); },
        [&](const auto& deepest) { return opposed_feature(b, body_b, deepest, normal); });
  });
}

template <Scalar S, int N, class A, class B>
[[nodiscard]] constexpr std::optional<Contact<S, N>> contact_of_cores(const A& a, const B& b,
                                                                      const S& radius_a,
                                                                      const S& radius_b) noexcept {
  if constexpr (is_kind<A, Vec> && has_sphere_contact<S, B>) {
    if (has_solid_faces(b)) return SphereBoxContact<S, N, B>(b, a, radius_a, false).find();
  }
  if constexpr (is_kind<B, Vec> && has_sphere_contact<S, A>) {
    if (has_solid_faces(a)) return SphereBoxContact<S, N, A>(a, b, radius_b, true).find();
  }
  if constexpr (is_kind<A, Vec> && is_kind<B, Vec> && filter_pays<S>) {
    if (a != b) return contact_of_spheres(a, b, radius_a, radius_b);
  }
  if constexpr (is_kind<A, Plane>) {
    return contact_with_plane(a, b, radius_b, true);
  } else if constexpr (is_kind<B, Plane>) {
    return contact_with_plane(b, a, radius_a, false);
  } else if constexpr (is_kind<A, Obb> && is_kind<B, Vec>) {
    return contact_in_frame(a, Segment{b, b}, radius_b, true);
  } else if constexpr (is_kind<A, Obb> && is_kind<B, Segment>) {
    return contact_in_frame(a, b, radius_b, true);
  } else if constexpr (is_kind<B, Obb> && is_kind<A, Vec>) {
    return contact_in_frame(b, Segment{a, a}, radius_a, false);
  } else if constexpr (is_kind<B, Obb> && is_kind<A, Segment>) {
    return contact_in_frame(b, a, radius_a, false);
  } else {
    if constexpr (is_kind<A, Aabb> && is_kind<B, Aabb> && N == 3) {
      if (boxes_are_apart(a, b)) return std::nullopt;
      if (const auto found = BoxesContact<S>(a, b).find()) return found;
    }
    if constexpr (is_kind<A, Aabb> && is_kind<B, Segment> && has_segment_in_frame<A>) {
      const auto push = SegmentBoxFilter<S>(a, b, radius_b).find();
      if (push.is_sure) return contact_of_push(a, b, radius_b, true, push.value);
    }
    if constexpr (is_kind<A, Segment> && is_kind<B, Aabb> && has_segment_in_frame<B>) {
      const auto push = SegmentBoxFilter<S>(b, a, radius_a).find();
      if (push.is_sure) return contact_of_push(b, a, radius_a, false, push.value);
    }
    const auto filter = axis_filter<S>(a, b);
    if (filter.are_apart()) return std::nullopt;
    if constexpr (is_kind<A, Obb> && is_kind<B, Obb> && has_axis_filter<S, A, B>) {
      if (const auto found = ObbsContact<S>(a, b, filter).find()) return found;
    }
    return contact_of_bodies<S, N>(a, b, radius_a, radius_b, filter);
  }
}

}  // namespace detail

/// The least translation that separates two shapes or segments that share a point, or nothing if
/// they share none. Touching is a contact of depth 0.
///
/// If several translations are equally short, the result is one along a face normal of the shapes'
/// difference (for a flat difference, along a perpendicular to it). To choose among several of
/// those, flip each normal so that its first nonzero component is positive, and take the greatest
/// x, then y, then z; of the two directions of a line, take the positive one. So contact(b, a) is
/// the mirror image of contact(a, b), unless both directions are equally right. A plane is only its
/// surface: a shape leaves it to either side, and if both are equally deep, to the side of its
/// normal.
///
/// Points: if the normal is that of a face, the most opposed face of the other shape is clipped
/// against the sides of that face. A segment or the axis of a capsule is clipped as a whole; of a
/// flat shape seen edge-on, the edge at its deepest corner that is most opposed. At most four points
/// are kept, two in 2D: the deepest, the farthest from it, and those that add the largest area on
/// either side. Two parallel edges give the two ends of their overlap; all other pairs give one
/// point. Of a face with more than 32 corners, the first 32 count.
///
/// To segments, spheres and capsules, an oriented box is its slabs, depths are measured in its frame,
/// and ties are decided there: those of contact(box, other), whose opposite contact(other, box)
/// returns. To other shapes it is the box that its edges span.
///
/// units:  world units
/// domain: every input; an empty shape touches nothing; depths are clamped to the greatest scalar
/// exact:  whether there is a contact; the depth rounded up, error in [0, 1) ULP; the normal of a
///         plane as stored, otherwise each component rounded to nearest; points and their depths
///         within 4 ULP and 2^-27 of the distance from the origin or, if greater, of the radius,
///         because they use the rounded normal and corners of oriented boxes rounded to the grid;
///         the deepest point has the depth of the contact  (tests/oracle/contact_pairs.test.cpp)
/// source: van den Bergen (2001), for polytopes: see query/kernel/expansion.hpp
template <class A, class B>
requires detail::HaveContact<A, B>
[[nodiscard]] constexpr auto contact(const A& a, const B& b) noexcept {
  using Point = typename detail::PointOf<A>::type;
  using S = std::remove_cvref_t<decltype(Point().x)>;
  constexpr int N = static_cast<int>(sizeof(Point) / sizeof(S));
  if (!detail::has_points(a) || !detail::has_points(b)) return std::optional<Contact<S, N>>();
  return detail::contact_of_cores<S, N>(detail::core_of(a), detail::core_of(b),
                                        detail::radius_of(a), detail::radius_of(b));
}

/// The translation on the grid that moves b so that it no longer touches a, given contact(a, b):
/// slightly more than the depth along the normal, each component rounded away from 0.
///
/// units:  world units
/// domain: a depth less than the greatest scalar; a greater translation is clamped
/// result: separates the shapes, whatever the rounding of the normal
///         (tests/oracle/contact_pairs.test.cpp)
///
/// Proof: let u be the exact unit normal, d the depth. The normal's product with u is at least
/// 1 - 2^-28: a rounded normal is off by 2^-31 per component, a stored one by 2^-29 in length, and
/// a box's frame by 3 2^-31. Rounding away from 0 moves further along u. So it is enough to move by
/// more than d (1 + 2^-27), and d + 2^-27 d, rounded down, + 1 ULP is more.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> separation(const Contact<S, N>& contact) noexcept {
  if constexpr (!is_fixed<S>) {
    return contact.depth * contact.normal.vec();
  } else {
    constexpr int bits = bits_of<direction_component<S>> - 4;
    const auto past = contact.depth + scale_down<bits_of<S>>(contact.depth, bits) +
                      Fixed<bits_of<S>, S::frac>::from_raw(1);
    return make_vec<N>([&](int i) {
      const auto component = past * contact.normal[i];
      return component > 0 ? ceil_to<S>(component) : floor_to<S>(component);
    });
  }
}

}  // namespace detent
