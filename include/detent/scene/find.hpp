// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "detent/cull/prefetch.hpp"
#include "detent/number/next_up.hpp"
#include "detent/scene/found.hpp"
#include "detent/scene/mesh/cast.hpp"
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

  /// Visits the objects that overlap the query shape: calls visit(index). Tests candidates once
  /// more than `most` are collected: `most_waiting` for a visit that never stops, 0 for one that
  /// may.
  template <class Question, class Filter, class Visit>
  constexpr void visit_meeting(const Question& question, const Filter& filter, const Visit& visit,
                               std::size_t most = 0) const {
    if constexpr (is_question<SceneRegion<Question, S, N>>()) {
      visit_boxes(quantized_box(question), most, [&](std::span<const Index> objects) {
        for (const Index i : objects) prefetch(&store_[i], sizeof(store_[i]));
        for (const Index i : objects) {
          const bool is_met =
              filter(store_.info(i)) &&
              store_[i].shape.visit([&](const auto& shape) { return meets(question, shape); });
          if (is_met && visit(i) == Walk::stop) return Walk::stop;
        }
        return Walk::go_on;
      });
    }
  }
  template <class Filter, class Visit>
  constexpr void visit_meeting(const Ray<S, N>& ray, const Filter& filter,
                               const Visit& visit) const {
    visit_found(ray, filter, [&](const Found<S>& found, S&) { return visit(found.id.index); });
  }

  template <class Shape, class Filter, class Visit>
  constexpr void visit_meeting(const Cast<Shape>& moving, const Filter& filter,
                               const Visit& visit) const {
    visit_found(moving, filter, [&](const Found<S>& found, S&) { return visit(found.id.index); });
  }

  /// Visits each object that `Scene::all` lists: calls visit(found, limit).
  template <class Question, class Filter, class Visit>
  constexpr void visit_found(const Question& question, const Filter& filter,
                             const Visit& visit) const {
    if constexpr (is_question<SceneQuestion<Question, S, N>>()) {
      S limit = largest<S>;
      visit_meeting(
          question, filter,
          [&](std::size_t i) { return visit(found_at(i, reference(question)), limit); },
          most_waiting);
    }
  }
  template <class Filter, class Visit>
  constexpr void visit_found(const Ray<S, N>& ray, const Filter& filter, const Visit& visit) const {
    if (ray.max_distance < 0) return;
    visit_hit<job::Raycast>(ray, RayProbe<S, N>(ray), filter, visit);
  }
  template <class Shape, class Filter, class Visit>
  constexpr void visit_found(const Cast<Shape>& moving, const Filter& filter,
                             const Visit& visit) const {
    if constexpr (is_question<SceneCast<Cast<Shape>, S, N>>()) {
      const auto box = quantized_box(moving.shape);
      if (moving.max_distance < 0 || box.is_empty()) return;
      visit_hit<job::CastDistance>(
          moving, RayProbe<S, N>(box, moving.direction, moving.max_distance), filter, visit);
    }
  }
  /// For `Scene::nearest` of a point: visits every object that is not empty. Empty ones have no box
  /// in a tree.
  template <class Filter, class Visit>
  constexpr void visit_found(const Vec<S, N>& point, const Filter& filter,
                             const Visit& visit) const {
    PointProbe<S, N> probe(point);
    S limit = largest<S>;
    visit_each<job::VisitNearest>(probe, [&](Index i) {
      if (!filter(store_.info(i))) return Walk::go_on;
      const Walk walk = visit(found_at(i, point), limit);
      probe.shorten(limit);
      return walk;
    });
  }

  /// Calls add(found) for each object that `Scene::all` lists.
  template <class Question, class Filter, class Add>
  constexpr void collect(const Question& question, const Filter& filter, const Add& add) const {
    visit_found(question, filter,
                [&](const Found<S>& found, S&) { return add(found), Walk::go_on; });
  }
  template <class Filter, class Add>
  constexpr void collect(const Vec<S, N>& point, const Filter& filter, const Add& add) const {
    visit_meeting(
        point, filter, [&](std::size_t i) { return add(found_at(i, point)), Walk::go_on; },
        most_waiting);
  }

  /// The distance at which a ray hits an object of a single shape. Surfaces are left to the tree
  /// walk, which takes as long.
  [[nodiscard]] constexpr std::optional<S> distance_to(std::size_t object,
                                                       const Ray<S, N>& ray) const noexcept {
    return store_[object].shape.visit([&]<class Shape>(const Shape& shape) -> std::optional<S> {
      if constexpr (is_surface_type<Shape>) {
        return std::nullopt;
      } else {
        return separately<job::Raycast>(ray, shape);
      }
    });
  }

  /// The hit of a ray or a moving shape on an object that it is known to hit.
  template <class Question>
  [[nodiscard]] constexpr ObjectHit<S, N> hit_of(const Question& question,
                                                 const Found<S>& found) const noexcept {
    using Hit =
        std::conditional_t<std::is_same_v<Question, Ray<S, N>>, job::RaycastHit, job::CastHit>;
    return store_[found.id.index].shape.visit([&]<class Shape>(const Shape& shape) {
      ObjectHit<S, N> result{found.distance, found.id, {}, {}};
      const auto take = [&](const auto& hit) {
        if (!hit) return;
        result.point = hit->point;
        result.normal = hit->normal;
      };
      if constexpr (is_surface_type<Shape>) {
        auto shorter = question;
        if constexpr (is_fixed<S>) {
          // The hit is known to be at this distance, so the traversal can stop there.
          shorter.max_distance = (std::min)(question.max_distance, next_up(found.distance));
        }
        if (const auto first = first_on_surface(shorter, shape)) {
          take(separately<Hit>(question, first->triangle));
          result.triangle = first->hit.index;
        }
      } else {
        take(separately<Hit>(question, shape));
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
        return store_[j].shape.visit(
            [&](const auto& b) { return separately<job::Overlaps>(a, b); });
      });
      if (meet) add(Overlap{store_.info(i).id, store_.info(j).id});
    };
    const auto visit = [&](const CandidatePairs& pairs) {
      const auto size = pairs.first.size();
      // The objects of a large scene are not in cache.
      for (std::size_t k = 0; k < size; ++k) {
        prefetch(&store_[pairs.first[k]], sizeof(store_[0]));
        prefetch(&store_[pairs.second[k]], sizeof(store_[0]));
      }
      for (std::size_t k = 0; k < size; ++k) {
        const auto [i, j] = std::minmax(pairs.first[k], pairs.second[k]);
        ask(i, j);
      }
    };
    const auto& moving = store_.tree(Motion::moving);
    const auto& fixed = store_.tree(Motion::fixed);
    if (__builtin_is_constant_evaluated()) {
      job::VisitPairs()(moving, fixed, visit);
    } else {
      const PairVisitor visitor(visit);
      separately<job::VisitPairs>(moving, fixed, visitor);
    }
  }

 private:
  /// Visits the objects that a ray or a moving shape hits, at the distances of `Job`.
  template <class Job, class Question, class Filter, class Visit>
  constexpr void visit_hit(const Question& question, RayProbe<S, N> probe, const Filter& filter,
                           const Visit& visit) const {
    S limit = question.max_distance;
    auto shorter = question;
    visit_each<job::VisitNearest>(probe, [&](Index i) {
      if (!filter(store_.info(i))) return Walk::go_on;
      const auto distance = store_[i].shape.visit(
          [&](const auto& shape) { return separately<Job>(std::as_const(shorter), shape); });
      if (!distance) return Walk::go_on;
      const Walk walk = visit(Found<S>{*distance, store_.info(i).id}, limit);
      probe.shorten(limit);
      // Of objects at the same rounded distance, the least id wins.
      shorter.max_distance = (std::min)(question.max_distance, next_up(limit));
      return walk;
    });
  }

  /// Visits the objects of both trees whose boxes overlap `box`: calls visit(objects).
  template <class Visit>
  constexpr void visit_boxes(const QuantizedBox<S, N>& box, const std::size_t& most,
                             const Visit& visit) const {
    visit_trees<job::VisitMeeting>(visit, ObjectsVisitor(visit), box, most);
  }

  /// Visits the objects of both trees that `Job` finds near `target`, one by one.
  template <class Job, class Target, class Visit>
  constexpr void visit_each(Target& target, const Visit& visit) const {
    const ObjectVisitor visitor(visit, store_.end() > 0 ? &store_[0] : nullptr);
    visit_trees<Job>(visit, visitor, target);
  }

  /// Lets `Job` walk both trees, the second only if the first walk is not stopped. `visitor` refers
  /// to `visit`, for calls that are compiled separately.
  template <class Job, class Visit, class Visitor, class... Target>
  constexpr void visit_trees(const Visit& visit, const Visitor& visitor, Target&... target) const {
    const auto& moving = store_.tree(Motion::moving);
    const auto& fixed = store_.tree(Motion::fixed);
    if (__builtin_is_constant_evaluated()) {
      if (Job()(moving, target..., visit) == Walk::go_on) Job()(fixed, target..., visit);
    } else if (separately<Job>(moving, target..., visitor) == Walk::go_on) {
      separately<Job>(fixed, target..., visitor);
    }
  }

  constexpr Found<S> found_at(std::size_t i, const Vec<S, N>& point) const noexcept {
    return {store_[i].shape.visit(
                [&](const auto& shape) { return separately<job::Distance>(shape, point); }),
            store_.info(i).id};
  }

  const Store<Storage, S, N, Shapes...>& store_;
};

}  // namespace detent::detail
