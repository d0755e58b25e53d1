// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "detent/cull/prefetch.hpp"
#include "detent/scene/found.hpp"
#include "detent/scene/mesh/raycast.hpp"
#include "detent/scene/question.hpp"
#include "detent/scene/separate.hpp"
#include "detent/scene/store.hpp"

namespace detent::detail {

/// Queries on all objects of a store: the trees find candidates, and the queries on single shapes
/// decide.
template <class Storage, Scalar S, int N, class... Shapes>
class Finder {
  using Index = std::uint32_t;

 public:
  explicit constexpr Finder(const Store<Storage, S, N, Shapes...>& store) noexcept
      : store_(store) {}

  /// Calls visit(index) for the objects that overlap the query shape, until it returns true.
  template <class Question, class Filter, class Visit>
  constexpr void visit_meeting(const Question& question, const Filter& filter,
                               const Visit& visit) const {
    if constexpr (is_question<SceneRegion<Question, S, N>>()) {
      const auto box = quantized_box(question);
      visit_trees<VisitMeeting>(box, [&](Index i) {
        return filter(store_.info(i)) &&
               store_[i].shape.visit([&](const auto& shape) { return meets(question, shape); }) &&
               visit(i);
      });
    }
  }
  template <class Filter, class Visit>
  constexpr void visit_meeting(const Ray<S, N>& ray, const Filter& filter,
                               const Visit& visit) const {
    visit_found(ray, filter, [&](const Found<S>& found, auto) { return visit(found.id.index); });
  }

  /// Calls visit(found, shorten) for each object that `Scene::all` lists. After shorten(distance),
  /// farther objects may be skipped.
  template <class Question, class Filter, class Visit>
  constexpr void visit_found(const Question& question, const Filter& filter,
                             const Visit& visit) const {
    if constexpr (is_question<SceneQuestion<Question, S, N>>()) {
      visit_meeting(question, filter, [&](std::size_t i) {
        return visit(found_at(i, reference(question)), [](const S&) {});
      });
    }
  }
  template <class Filter, class Visit>
  constexpr void visit_found(const Ray<S, N>& ray, const Filter& filter, const Visit& visit) const {
    if (ray.max_distance < 0) return;
    RayProbe<S, N> probe(ray);
    visit_trees<VisitNearest>(probe, [&](Index i) {
      if (!filter(store_.info(i))) return false;
      const auto distance =
          store_[i].shape.visit([&](const auto& shape) { return separately<Raycast>(ray, shape); });
      return distance && visit(Found<S>{*distance, store_.info(i).id},
                               [&](const S& limit) { probe.shorten(limit); });
    });
  }
  /// For a point, visits every object that is not empty, for `Scene::nearest`: an empty one has no
  /// box in a tree.
  template <class Filter, class Visit>
  constexpr void visit_found(const Vec<S, N>& point, const Filter& filter,
                             const Visit& visit) const {
    PointProbe<S, N> probe(point);
    visit_trees<VisitNearest>(probe, [&](Index i) {
      return filter(store_.info(i)) &&
             visit(found_at(i, point), [&](const S& limit) { probe.shorten(limit); });
    });
  }

  /// Calls add(found) for each object that `Scene::all` lists.
  template <class Question, class Filter, class Add>
  constexpr void collect(const Question& question, const Filter& filter, const Add& add) const {
    visit_found(question, filter, [&](const Found<S>& found, auto) { return add(found), false; });
  }
  template <class Filter, class Add>
  constexpr void collect(const Vec<S, N>& point, const Filter& filter, const Add& add) const {
    visit_meeting(point, filter, [&](std::size_t i) { return add(found_at(i, point)), false; });
  }

  /// The hit of a ray on an object that it is known to hit.
  [[nodiscard]] constexpr ObjectHit<S, N> hit_of(const Ray<S, N>& ray,
                                                 const Found<S>& found) const noexcept {
    return store_[found.id.index].shape.visit([&]<class Shape>(const Shape& shape) {
      ObjectHit<S, N> result{found.distance, found.id, {}, {}};
      const auto take = [&](const auto& hit) {
        if (!hit) return;
        result.point = hit->point;
        result.normal = hit->normal;
      };
      if constexpr (is_surface_type<Shape>) {
        if (const auto first = first_on_surface(ray, shape)) {
          take(raycast_hit(ray, first->triangle));
          result.triangle = first->hit.index;
        }
      } else {
        take(separately<RaycastHit>(ray, shape));
      }
      return result;
    });
  }

  /// Calls add(overlap) for each pair of overlapping objects, except pairs of fixed ones.
  template <class Filter, class Add>
  constexpr void visit_overlaps(const Filter& filter, const Add& add) const {
    const auto ask = [&](Index i, Index j) {
      if (!filter(store_.info(i), store_.info(j))) return;
      const bool meet = store_[i].shape.visit([&](const auto& a) {
        return store_[j].shape.visit([&](const auto& b) { return separately<Overlaps>(a, b); });
      });
      if (meet) add(Overlap{store_.info(i).id, store_.info(j).id});
    };
    // The objects of a large scene are not in cache: prefetch them while earlier pairs are tested.
    std::array<std::pair<Index, Index>, 16> waiting;
    std::size_t count = 0;
    const auto visit = [&](Index i, Index j) {
      auto& place = waiting[count++ % waiting.size()];
      if (count > waiting.size()) ask(place.first, place.second);
      place = std::minmax(i, j);
      prefetch(&store_[i], sizeof(store_[i]));
      prefetch(&store_[j], sizeof(store_[j]));
    };
    const auto& moving = store_.tree(Motion::moving);
    const auto& fixed = store_.tree(Motion::fixed);
    if (__builtin_is_constant_evaluated()) {
      VisitPairs()(moving, fixed, visit);
    } else {
      const PairVisitor visitor(visit);
      separately<VisitPairs>(moving, fixed, visitor);
    }
    for (std::size_t i = 0; i < (std::min)(count, waiting.size()); ++i) {
      ask(waiting[i].first, waiting[i].second);
    }
  }

 private:
  /// Visits the objects of both trees that `Walk` finds, until `visit` returns true.
  template <class Walk, class Target, class Visit>
  constexpr void visit_trees(Target& target, const Visit& visit) const {
    const auto& moving = store_.tree(Motion::moving);
    const auto& fixed = store_.tree(Motion::fixed);
    if (__builtin_is_constant_evaluated()) {
      static_cast<void>(Walk()(moving, target, visit) || Walk()(fixed, target, visit));
    } else {
      const ObjectVisitor visitor(visit);
      static_cast<void>(separately<Walk>(moving, target, visitor) ||
                        separately<Walk>(fixed, target, visitor));
    }
  }

  constexpr Found<S> found_at(std::size_t i, const Vec<S, N>& point) const noexcept {
    return {store_[i].shape.visit(
                [&](const auto& shape) { return separately<Distance>(shape, point); }),
            store_.info(i).id};
  }

  const Store<Storage, S, N, Shapes...>& store_;
};

}  // namespace detent::detail
