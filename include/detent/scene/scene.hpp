// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "detent/cull/keep_first.hpp"
#include "detent/query/cast.hpp"
#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"
#include "detent/query/intersects.hpp"
#include "detent/query/overlaps.hpp"
#include "detent/query/raycast.hpp"
#include "detent/scene/contents.hpp"
#include "detent/scene/find.hpp"

namespace detent {

namespace detail {

// Compilers show the line with the name.
// clang-format off
template <class... Shapes>
concept NamesShapes = sizeof...(Shapes) > 0;  // detent: name the scene's shapes: Scene<q16_16, 3, Sphere, Aabb>
// clang-format on

}  // namespace detail

/// Objects of the listed shape types, and queries over all of them. Write
/// `Scene<q16_16, 3, Sphere, Obb>`, or `BoundedScene<Bounded<256>, q16_16, 3, Sphere>` for one that
/// never allocates.
///
/// Results and digests depend on the objects and their ids, never on the order in which objects
/// were added, moved and removed.
///
/// Query with rays, points, segments, spheres, boxes, capsules, in 3D frusta, and casts of moving
/// shapes, such as `Cast{ball, direction, distance}`:
///
/// * `nearest(question, filter)`, the first of `all`, without finding the others. For a point, the
///   nearest object at any distance. None of these functions ever finds an empty object (such as a
///   sphere of negative radius), although `distance(shape, point)` returns the greatest number for
///   it;
/// * `any(question, filter)`, whether there is any such object;
/// * `any_each(rays, answers, filter)`, the same for many rays;
/// * `all(question, filter)`, each object that overlaps the query shape, sorted by distance, then
///   by id. For a ray or a cast, that is the distance at which it first touches the object;
///   otherwise it is the distance of the object from the point, the start of a segment, the center
///   of a sphere or box (of an `Aabb`, rounded to nearest), end `a` of a capsule, or the middle of
///   the near side of a frustum (rounded to nearest);
/// * `nearest_hit(ray, filter)` and `all_hits(ray, filter)`, the same with points and normals; also
///   for casts, with the points and normals of `cast`;
/// * `overlaps(filter)`, all pairs of overlapping objects, except pairs of fixed ones.
///
/// A filter takes an `ObjectInfo` (for pairs two of them) and returns whether the object counts.
///
/// Any number of threads may call const functions at once, while none changes the scene
/// (tests/scene/threads.cpp).
///
/// exact:  the results of the queries on single shapes
///         (tests/scene/history.test.cpp, tests/scene/cast.test.cpp)
template <class Storage, Scalar S, int N, class... Shapes>
requires detail::NamesShapes<Shapes...>
class BasicScene : public detail::SceneContents<Storage, S, N, Shapes...> {
  using Base = detail::SceneContents<Storage, S, N, Shapes...>;

 public:
  /// The list type of a growing scene's results: `std::vector`.
  template <class T>
  using List = typename Storage::template List<T, 0>;
  using Base::is_growing;

  /// The first of `all`: the least distance, then the least id.
  template <class Question, ObjectFilter Filter = Everything>
  [[nodiscard]] constexpr std::optional<Found<S>> nearest(const Question& question,
                                                          const Filter& filter = {}) const {
    std::optional<Found<S>> best;
    finder().visit_found(question, filter, [&](const Found<S>& found, S& limit) {
      if (!best || found < *best) {
        best = found;
        limit = found.distance;
      }
      return Walk::go_on;
    });
    return best;
  }

  /// Whether `all` has any object.
  template <class Question, ObjectFilter Filter = Everything>
  [[nodiscard]] constexpr bool any(const Question& question, const Filter& filter = {}) const {
    bool is_found = false;
    finder().visit_meeting(question, filter, [&](std::size_t) {
      is_found = true;
      return Walk::stop;
    });
    return is_found;
  }

  /// Writes what `any` returns for each ray, for as many as `answers` has room. The object that
  /// stopped one ray is the first that the next one is tested against, so shadow rays in the order of
  /// a picture take half the time.
  ///
  /// exact:  as `any`, whatever the order                 (tests/scene/many_rays.test.cpp)
  template <ObjectFilter Filter = Everything>
  constexpr void any_each(std::span<const Ray<S, N>> rays, std::span<bool> answers,
                          const Filter& filter = {}) const {
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < (std::min)(rays.size(), answers.size()); ++i) {
      answers[i] = last && finder().distance_to(*last, rays[i]).has_value();
      if (answers[i]) continue;
      finder().visit_meeting(rays[i], filter, [&](std::size_t object) {
        answers[i] = true;
        last = object;
        return Walk::stop;
      });
    }
  }

  /// Every object that overlaps the query shape, by distance, then id.
  template <class Question, ObjectFilter Filter = Everything>
  [[nodiscard]] List<Found<S>> all(const Question& question, const Filter& filter = {}) const
      requires(is_growing) {
    List<Found<S>> list;
    finder().collect(question, filter, [&](const Found<S>& found) { list.push_back(found); });
    std::sort(list.begin(), list.end());
    return list;
  }

  /// Writes the first of `all` that fit `room`, in order; returns the total number.
  template <class Question, ObjectFilter Filter = Everything>
  constexpr std::size_t all(const Question& question, std::span<Found<S>> room,
                            const Filter& filter = {}) const {
    std::size_t count = 0;
    finder().collect(question, filter,
                     [&](const Found<S>& found) { detail::keep_first(room, count++, found); });
    detail::sort_kept(room, count);
    return count;
  }

  /// All pairs of overlapping objects, except pairs of fixed ones, sorted.
  template <PairFilter Filter = Everything>
  [[nodiscard]] List<Overlap> overlaps(const Filter& filter = {}) const requires(is_growing) {
    List<Overlap> list;
    finder().visit_overlaps(filter, [&](const Overlap& overlap) { list.push_back(overlap); });
    sort_overlaps(list, this->store_.end());
    return list;
  }

  /// Writes the first of the pairs that fit `room`, in order; returns the total number.
  template <PairFilter Filter = Everything>
  constexpr std::size_t overlaps(std::span<Overlap> room, const Filter& filter = {}) const {
    std::size_t count = 0;
    finder().visit_overlaps(
        filter, [&](const Overlap& overlap) { detail::keep_first(room, count++, overlap); });
    detail::sort_kept(room, count);
    return count;
  }

  /// Where the ray first touches the object that `nearest` finds.
  template <ObjectFilter Filter = Everything>
  [[nodiscard]] constexpr std::optional<ObjectHit<S, N>> nearest_hit(
      const Ray<S, N>& ray, const Filter& filter = {}) const {
    return first_hit(ray, filter);
  }
  /// Where the moving shape first touches the object that `nearest` finds.
  template <class Shape, ObjectFilter Filter = Everything>
  [[nodiscard]] constexpr std::optional<ObjectHit<S, N>> nearest_hit(
      const Cast<Shape>& moving, const Filter& filter = {}) const {
    return first_hit(moving, filter);
  }

  /// Where the ray first touches each of the objects of `all`, in that order.
  template <ObjectFilter Filter = Everything>
  [[nodiscard]] List<ObjectHit<S, N>> all_hits(const Ray<S, N>& ray,
                                               const Filter& filter = {}) const
      requires(is_growing) {
    return list_hits(ray, filter);
  }
  /// Where the moving shape first touches each of the objects of `all`, in that order.
  template <class Shape, ObjectFilter Filter = Everything>
  [[nodiscard]] List<ObjectHit<S, N>> all_hits(const Cast<Shape>& moving,
                                               const Filter& filter = {}) const
      requires(is_growing) {
    return list_hits(moving, filter);
  }

  /// Writes the first of these hits that fit `room`, in order; returns the total number.
  template <ObjectFilter Filter = Everything>
  constexpr std::size_t all_hits(const Ray<S, N>& ray, std::span<ObjectHit<S, N>> room,
                                 const Filter& filter = {}) const {
    return write_hits(ray, room, filter);
  }
  template <class Shape, ObjectFilter Filter = Everything>
  constexpr std::size_t all_hits(const Cast<Shape>& moving, std::span<ObjectHit<S, N>> room,
                                 const Filter& filter = {}) const {
    return write_hits(moving, room, filter);
  }

  // Deleted: compilers show the line with the name.
  // clang-format off
  template <class Question, ObjectFilter Filter = Everything>
  void all(const Question&, const Filter& = {}) const requires(!is_growing) = delete;  // detent: a BoundedScene writes to a std::span: all(question, room)
  template <PairFilter Filter = Everything>
  void overlaps(const Filter& = {}) const requires(!is_growing) = delete;  // detent: a BoundedScene writes to a std::span: overlaps(room)
  template <class Question, ObjectFilter Filter = Everything>
  void all_hits(const Question&, const Filter& = {}) const requires(!is_growing) = delete;  // detent: a BoundedScene writes to a std::span: all_hits(question, room)
  // clang-format on

 private:
  /// Sorts pairs of objects with indices below `end`, of which each has one id. Counting how many
  /// pairs come before each index takes less time than comparing, unless pairs are few.
  static void sort_overlaps(List<Overlap>& pairs, std::size_t end) requires(is_growing) {
    if (pairs.size() < end / 8) {
      std::sort(pairs.begin(), pairs.end());
      return;
    }
    List<Overlap> sorted(pairs.size());
    for (const auto member : {&Overlap::second, &Overlap::first}) {
      List<std::size_t> place(end);
      for (const auto& pair : pairs) ++place[(pair.*member).index];
      std::size_t before = 0;
      for (auto& count : place) before += std::exchange(count, before);
      for (const auto& pair : pairs) sorted[place[(pair.*member).index]++] = pair;
      std::swap(pairs, sorted);
    }
  }

  template <class Question, class Filter>
  constexpr std::optional<ObjectHit<S, N>> first_hit(const Question& question,
                                                     const Filter& filter) const {
    const auto found = nearest(question, filter);
    if (!found) return std::nullopt;
    return finder().hit_of(question, *found);
  }
  template <class Question, class Filter>
  List<ObjectHit<S, N>> list_hits(const Question& question, const Filter& filter) const {
    List<ObjectHit<S, N>> list;
    for (const auto& found : all(question, filter)) {
      list.push_back(finder().hit_of(question, found));
    }
    return list;
  }
  template <class Question, class Filter>
  constexpr std::size_t write_hits(const Question& question, std::span<ObjectHit<S, N>> room,
                                   const Filter& filter) const {
    std::size_t count = 0;
    finder().collect(question, filter, [&](const Found<S>& found) {
      detail::keep_first(room, count++, ObjectHit<S, N>{found.distance, found.id, {}, {}});
    });
    detail::sort_kept(room, count);
    for (auto& hit : room.first((std::min)(room.size(), count))) {
      hit = finder().hit_of(question, {hit.distance, hit.id});
    }
    return count;
  }
  [[nodiscard]] constexpr auto finder() const noexcept { return detail::Finder(this->store_); }
};

#if __STDC_HOSTED__
/// A scene that allocates as it grows, up to `Growing::capacity` objects.
template <Scalar S, int N, template <Scalar, int> class... Shapes>
using Scene = BasicScene<Growing, S, N, Shapes<S, N>...>;
#endif

/// A scene whose memory is inside itself; `Bounds` is a `Bounded<Capacity, FrameCapacity>`.
template <class Bounds, Scalar S, int N, template <Scalar, int> class... Shapes>
using BoundedScene = BasicScene<Bounds, S, N, Shapes<S, N>...>;

}  // namespace detent

// In programs that link `detent::detent`.
#if defined(DETENT_USE_LIBRARY) && DETENT_USE_LIBRARY
#include "detent/scene/instantiations.hpp"
#endif
