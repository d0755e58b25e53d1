// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "detent/dynamics/particle/constraint.hpp"
#include "detent/query/cast/pair.hpp"
#include "detent/query/contact/pair.hpp"
#include "detent/query/overlaps/aabb_capsule.hpp"
#include "detent/query/overlaps/capsule_capsule.hpp"
#include "detent/query/overlaps/capsule_hull.hpp"
#include "detent/query/overlaps/obb_capsule.hpp"
#include "detent/query/overlaps/plane_capsule.hpp"
#include "detent/query/overlaps/sphere_capsule.hpp"
#include "detent/query/overlaps/triangle_capsule.hpp"
#include "detent/shape/bounding_box.hpp"

// Particles against shapes. The position of a particle is rounded down to the grid of the scalar:
// between two such points it sweeps a capsule, and `overlaps` is exact. A move that would touch a
// shape is never made.

namespace detent::detail {

/// One step of the grid; 2^-16 in `float` and `double`.
template <Scalar S>
[[nodiscard]] constexpr S grid_step() noexcept {
  if constexpr (is_fixed<S>) {
    return S::from_raw(1);
  } else {
    return fraction<S>(1, 65536);
  }
}

/// A radius plus some steps of the grid.
template <Scalar S>
[[nodiscard]] constexpr S grown(const S& radius, int steps) noexcept {
  return saturate_to<S>(radius + grid_step<S>() * as_operand<S>(steps));
}

/// A position rounded down to the grid of the scalar.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> grid_point(
    const Vec<typename Formats<S>::Place, N>& place) noexcept {
  return make_vec<N>([&](int i) { return floor_to<S>(place[i]); });
}

/// The shapes that a particle touched in a substep, as normals that point away from them.
template <Scalar S, int N>
struct Impacts {
  static constexpr std::size_t most = 5;
  std::array<Vec<typename Formats<S>::Ratio, N>, most> normal{};
  std::size_t count = 0;
};

/// The first contact of a particle that moves from one grid point to another.
template <Scalar S, int N>
struct Obstruction {
  S distance{};  // along its path
  Vec<S, N> at{};
  std::optional<Contact<S, N>> contact{};  // with the particle there, grown by 4 steps
};

/// The first shape on the path from `from` to `to`, or nothing.
///
/// A ball that is larger by one step covers the capsule although the direction is rounded, as long
/// as the path is shorter than 2^28 steps: then the end of the cast is within a quarter of a step
/// of `to`. The distance is rounded down and each coordinate to nearest, so the shape is less than
/// 3 steps from the ball of the particle's own radius there, and `contact` finds it.
template <Scalar S, int N, class Obstacles>
[[nodiscard]] constexpr std::optional<Obstruction<S, N>> first_obstruction(
    const Vec<S, N>& from, const Vec<S, N>& to, const S& radius, const Obstacles& obstacles) {
  const Capsule<S, N> way{from, to, radius};
  const auto direction = direction_of<S>(to - from).value_or(Direction<S, N>());
  const auto limit = sqrt_ceil<S>(squared_length(to - from));
  std::optional<Obstruction<S, N>> first;
  obstacles(bounding_box(way), [&](const auto& shape) {
    if (!overlaps(shape, way)) return;
    const Sphere<S, N> ball{from, grown(radius, 1)};
    const auto distance = cast_distance(ball, direction, limit, shape).value_or(limit);
    if (first && !(distance < first->distance)) return;
    Obstruction<S, N> found{
        distance, make_vec<N>([&](int i) {
          return saturate_to<S>(from[i] + nearest_to<S>(distance * direction[i]));
        })};
    found.contact = contact(shape, Sphere<S, N>{found.at, grown(radius, 4)});
    first = found;
  });
  return first;
}

/// v after friction has shortened its component along a surface by at most `limit`.
template <Number T, Number Ratio, int N>
[[nodiscard]] constexpr Vec<T, N> rubbed(const Vec<T, N>& v, const Vec<Ratio, N>& normal,
                                         const T& limit) noexcept {
  const auto rise = nearest_to<T>(dot(normal, v));
  const auto along =
      make_vec<N>([&](int i) { return saturate_to<T>(v[i] - nearest_to<T>(rise * normal[i])); });
  const auto length = sqrt_floor<T>(squared_length(along));
  const auto share = length > limit ? quotient_nearest<Ratio>(limit, length) : Ratio(1);
  return make_vec<N>([&](int i) { return saturate_to<T>(v[i] - nearest_to<T>(share * along[i])); });
}

/// Moves a particle from `place` towards `next`, and sets `next` to where it ends: outside the
/// shapes it hits, slowed by friction, or back at its start.
template <Scalar S, int N, class Obstacles>
constexpr Impacts<S, N> collide(const Vec<typename Formats<S>::Place, N>& place,
                                Vec<typename Formats<S>::Place, N>& next, const S& radius,
                                const typename Formats<S>::Ratio& friction,
                                const Obstacles& obstacles) {
  using F = Formats<S>;
  using Reach = typename F::Reach;
  Impacts<S, N> impacts;
  const auto from = grid_point<S, N>(place);
  while (true) {
    const auto to = grid_point<S, N>(next);
    if (to == from) return impacts;
    const auto met = first_obstruction(from, to, radius, obstacles);
    if (!met) return impacts;
    if (!met->contact || impacts.count == impacts.most) break;
    const auto normal =
        make_vec<N>([&](int i) { return typename F::Ratio(met->contact->normal[i]); });
    impacts.normal[impacts.count++] = normal;
    const auto offset = make_vec<N>(
        [&](int i) { return saturate_to<Reach>(next[i] - typename F::Place(met->at[i])); });
    const auto height = nearest_to<Reach>(dot(normal, offset));
    const auto step = nearest_to<Reach>(grid_step<S>());
    const auto push =
        (std::max)(saturate_to<Reach>(met->contact->depth - (step + step) - height), step);
    for (int i = 0; i < N; ++i) {
      next[i] = saturate_to<typename F::Place>(next[i] + nearest_to<Reach>(push * normal[i]));
    }
    const auto moved =
        rubbed(saturated<Reach>(next - place), normal, nearest_to<Reach>(friction * push));
    for (int i = 0; i < N; ++i) next[i] = saturate_to<typename F::Place>(place[i] + moved[i]);
  }
  next = place;
  return impacts;
}

/// Pushes a particle out of shapes that have moved onto it: out of the first it touches,
/// repeatedly, at most 4 times. It does not pass a shape that it did not touch.
template <Scalar S, int N, class Obstacles>
constexpr void release(Vec<typename Formats<S>::Place, N>& place, const S& radius,
                       const Obstacles& obstacles) {
  for (int turn = 0; turn < 4; ++turn) {
    const auto from = grid_point<S, N>(place);
    const Sphere<S, N> ball{from, radius};
    std::optional<Vec<S, N>> push;
    obstacles(bounding_box(ball), [&](const auto& shape) {
      if (push) return;
      if (const auto touch = contact(shape, ball)) push = separation(*touch);
    });
    if (!push) return;
    const auto to = make_vec<N>([&](int i) { return saturate_to<S>(from[i] + (*push)[i]); });
    const Capsule<S, N> start{from, from, radius}, way{from, to, radius};
    bool is_free = true;
    obstacles(bounding_box(way), [&](const auto& shape) {
      if (overlaps(shape, way) && !overlaps(shape, start)) is_free = false;
    });
    if (!is_free) return;
    for (int i = 0; i < N; ++i) place[i] = typename Formats<S>::Place(to[i]);
  }
}

}  // namespace detent::detail
