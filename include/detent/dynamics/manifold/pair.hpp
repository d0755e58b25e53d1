// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/hull.hpp"
#include "detent/dynamics/manifold/box_box.hpp"
#include "detent/dynamics/manifold/box_round.hpp"
#include "detent/dynamics/manifold/polytope_round.hpp"
#include "detent/dynamics/manifold/round.hpp"

namespace detent::detail {

template <class T>
inline constexpr bool is_box_solid = false;
template <Scalar S, int N>
inline constexpr bool is_box_solid<Aabb<S, N>> = true;
template <Scalar S, int N>
inline constexpr bool is_box_solid<Obb<S, N>> = true;

template <class T>
inline constexpr bool is_hull_solid = requires(const T& shape) {
  faces_of(shape);
};

/// A box with a box, both in the frames of their bodies.
template <class A, class B, Scalar S, int N>
requires(is_box_solid<A>&& is_box_solid<B>) [[nodiscard]] constexpr Manifold<S, N> manifold(
    const A& a, const B& b, const RelativePose<S, N>& pose,
    const typename Formats<S>::Gap& margin) noexcept {
  const auto core_a = box_core(a), core_b = box_core(b);
  if (core_a.is_empty || core_b.is_empty) return {};
  const auto local = between(core_a, pose, core_b);
  return moved_out(core_a, box_manifold<S, N>(core_a.half, core_b.half, local, margin));
}

/// The manifold of shape `a` of one body and shape `b` of another, for the solver. Both are in the
/// frames of their bodies; `pose` is that of b's body in the frame of a's.
///
/// units:  points with a separation of at most `margin`
/// domain: every shape and pose; empty shapes touch nothing. Coordinates and half extents beyond the
///         range of a lever (512 units of q16_16) are clamped to it
/// result: in the frame of a; each number rounded where docs/contacts_of_bodies.md says, all
///         decisions between two roundings exact (tests/dynamics/manifold/box_box.test.cpp,
///         tests/dynamics/manifold/round.test.cpp)
/// source: separating axes and clipping, Gregorius, Robust Contact Creation, GDC 2015
template <class A, class B, Scalar S, int N>
requires(Round<A>&& Round<B>) [[nodiscard]] constexpr Manifold<S, N> manifold(
    const A& a, const B& b, const RelativePose<S, N>& pose,
    const typename Formats<S>::Gap& margin) noexcept {
  return round_manifold(round_core(a), placed_core(pose, round_core(b)), margin);
}

template <class A, class B, Scalar S, int N>
requires(is_box_solid<A>&& Round<B>) [[nodiscard]] constexpr Manifold<S, N> manifold(
    const A& a, const B& b, const RelativePose<S, N>& pose,
    const typename Formats<S>::Gap& margin) noexcept {
  const auto box = box_core(a);
  const auto core = round_core(b);
  if (box.is_empty || core.is_empty()) return {};
  const auto local = between(box, pose, body_frame<S, N>());
  return moved_out(box, box_round_manifold(box.half, placed_core(local, core), margin));
}

template <class A, class B, Scalar S, int N>
requires(Round<A>&& is_box_solid<B>) [[nodiscard]] constexpr Manifold<S, N> manifold(
    const A& a, const B& b, const RelativePose<S, N>& pose,
    const typename Formats<S>::Gap& margin) noexcept {
  const auto core = round_core(a);
  const auto box = box_core(b);
  if (box.is_empty || core.is_empty()) return {};
  const auto local = between(body_frame<S, N>(), pose, box);
  return swapped(local, box_round_manifold(box.half, lifted_core(local, core), margin));
}

/// Calls f with the faces of a box or hull; does nothing for an empty one.
template <class Shape, class F>
constexpr void with_faces(const Shape& shape, const F& f) noexcept {
  if constexpr (is_hull_solid<Shape>) {
    f(faces_of(shape));
  } else if (const auto core = box_core(shape); !core.is_empty) {
    const auto parts = polytope_of(core);
    f(parts.view());
  }
}

/// A hull with a hull or a box, each in the frame of its body.
template <class A, class B, Scalar S, int N>
requires((is_hull_solid<A> && (is_hull_solid<B> || is_box_solid<B>)) ||
         (is_box_solid<A> && is_hull_solid<B>))
    [[nodiscard]] constexpr Manifold<S, N> manifold(
        const A& a, const B& b, const RelativePose<S, N>& pose,
        const typename Formats<S>::Gap& margin) noexcept {
  Manifold<S, N> result;
  with_faces(a, [&](const auto& first) {
    with_faces(
        b, [&](const auto& second) { result = polytope_manifold(first, second, pose, margin); });
  });
  return result;
}

template <class A, class B, Scalar S, int N>
requires(is_hull_solid<A>&& Round<B>) [[nodiscard]] constexpr Manifold<S, N> manifold(
    const A& a, const B& b, const RelativePose<S, N>& pose,
    const typename Formats<S>::Gap& margin) noexcept {
  return polytope_round_manifold(faces_of(a), placed_core(pose, round_core(b)), margin);
}

template <class A, class B, Scalar S, int N>
requires(Round<A>&& is_hull_solid<B>) [[nodiscard]] constexpr Manifold<S, N> manifold(
    const A& a, const B& b, const RelativePose<S, N>& pose,
    const typename Formats<S>::Gap& margin) noexcept {
  return swapped(pose,
                 polytope_round_manifold(faces_of(b), lifted_core(pose, round_core(a)), margin));
}

}  // namespace detent::detail
