// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "detent/number/digest.hpp"
#include "detent/scene/keep_first.hpp"
#include "detent/scene/prefetch.hpp"
#include "detent/scene/question.hpp"
#include "detent/scene/search.hpp"
#include "detent/scene/store.hpp"

namespace detent {

/// An object that a question found. Lists of them are ordered by distance, then by id.
template <Scalar S>
struct Found {
  S distance{};
  ObjectId id;

  [[nodiscard]] friend constexpr auto operator<=>(const Found&, const Found&) noexcept = default;
};

/// Two objects with a point in common, the lower id first. Lists of them are ordered.
struct Overlap {
  ObjectId first;
  ObjectId second;

  [[nodiscard]] friend constexpr auto operator<=>(const Overlap&,
                                                  const Overlap&) noexcept = default;
};

template <class D, Scalar S>
constexpr void append(D& digest, const Found<S>& found) noexcept {
  digest.add(found.distance, found.id);
}
template <class D>
constexpr void append(D& digest, const Overlap& overlap) noexcept {
  digest.add(overlap.first, overlap.second);
}

/// Objects of the listed types of shapes, and questions about all of them at once. Write
/// `Scene<q16_16, 3, Sphere, Obb>`, or `BoundedScene<Bounded<256>, q16_16, 3, Sphere>` for one that
/// never allocates.
///
/// A scene is what it holds: answers and digests depend on the objects and their ids, never on the
/// order in which they came, moved and went.
///
/// Questions are rays, points, segments, spheres, boxes and capsules:
///
/// * `nearest(question, filter)`, the first of `all` without finding the others; of a point, the
///   object nearest to it, wherever that is;
/// * `any(question, filter)`, whether there is one;
/// * `all(question, filter)`, each object that has a point in common with the question, by distance
///   and then by id. For a ray that is the distance at which it first touches the object, else the
///   distance of the object from the point itself, the start of a segment, the center of a sphere
///   or box (of an `Aabb` rounded to nearest) or end `a` of a capsule;
/// * `overlaps(filter)`, all pairs of objects with a point in common, but for pairs of fixed ones.
///
/// A filter takes an `ObjectInfo` (for pairs two of them) and returns whether the object counts.
///
/// exact:  the answers of the queries on single shapes           (tests/scene/history.test.cpp)
template <class Storage, Scalar S, int N, class... Shapes>
class BasicScene {
 public:
  using Store = detail::Store<Storage, S, N, Shapes...>;
  /// What a growing scene lists its answers in: a `std::vector`.
  template <class T>
  using List = typename Storage::template List<T, 0>;
  static constexpr bool is_growing = requires { requires Storage::is_growing; };
  static constexpr std::size_t capacity = Storage::capacity;

  [[nodiscard]] constexpr std::size_t size() const noexcept { return store_.size(); }

  /// Adds an object under the lowest free index.
  ///
  /// result: nothing, and no change, when `capacity` objects are there, when 2^32 - 2 objects and
  ///         frames have been added, or when the frame is none of this scene's, or is asked for by
  ///         a fixed object
  template <detail::Among<Shapes...> Shape>
  constexpr std::optional<ObjectId> add(const Shape& shape, const Traits& traits = {}) {
    if (!are_valid(traits)) return std::nullopt;
    const auto id = store_.next_id();
    if (id) store_.put(*id, typename Store::Shape(shape), traits);
    return id;
  }

  /// Adds an object under an id of the caller's choice, so that two scenes filled in different
  /// orders hold the same objects.
  ///
  /// result: false, and no change, as for `add`, when the index is taken or not below `capacity`,
  ///         or when the generation is 0 or 2^32 - 1
  template <detail::Among<Shapes...> Shape>
  constexpr bool add_as(const ObjectId& id, const Shape& shape, const Traits& traits = {}) {
    if (!are_valid(traits) || id.index >= capacity || store_.is_object(id.index)) return false;
    if (id.generation == 0 || id.generation > Store::last_generation) return false;
    store_.put(id, typename Store::Shape(shape), traits);
    return true;
  }

  // The functions that change or show an object return false, or nothing, when it is gone.

  constexpr bool remove(const ObjectId& id) {
    if (!contains(id)) return false;
    store_.remove(id.index);
    return true;
  }
  /// Gives an object another shape, of any listed type; an attached one in its frame.
  template <detail::Among<Shapes...> Shape>
  constexpr bool replace(const ObjectId& id, const Shape& shape) {
    if (!contains(id)) return false;
    store_.set_shape(id.index, typename Store::Shape(shape));
    return true;
  }
  /// Moves an object by a vector; an attached one in its frame.
  constexpr bool move(const ObjectId& id, const Vec<S, N>& by) {
    const auto* const record = store_.find(id);
    if (record == nullptr) return false;
    store_.set_shape(id.index, store_.local_shape(*record).visit([&](const auto& shape) {
      return typename Store::Shape(translated(shape, by));
    }));
    return true;
  }
  constexpr bool set_layers(const ObjectId& id, std::uint32_t layers) noexcept {
    if (!contains(id)) return false;
    store_.set_layers(id.index, layers);
    return true;
  }
  constexpr bool set_user(const ObjectId& id, std::uint64_t user) noexcept {
    if (!contains(id)) return false;
    store_.set_user(id.index, user);
    return true;
  }

  /// Makes questions faster after many additions, such as those of a level that has been loaded, at
  /// the cost of about a microsecond for each object; a bounded scene needs 28 bytes of stack for
  /// each that it has room for. It never changes an answer.
  constexpr void optimize() { store_.rebuild(); }

  [[nodiscard]] constexpr bool contains(const ObjectId& id) const noexcept {
    return store_.find(id) != nullptr;
  }
  [[nodiscard]] constexpr std::optional<ObjectInfo> info(const ObjectId& id) const noexcept {
    if (!contains(id)) return std::nullopt;
    return store_.info(id.index);
  }
  /// The object's shape in the world, when it is of this type.
  template <detail::Among<Shapes...> Shape>
  [[nodiscard]] constexpr std::optional<Shape> shape(const ObjectId& id) const noexcept {
    const auto* const record = store_.find(id);
    const Shape* const shape = record ? record->shape.template get<Shape>() : nullptr;
    return shape ? std::optional<Shape>(*shape) : std::nullopt;
  }
  /// Calls f(info, shape) for every object in the order of their ids, with its shape in the world.
  template <class F>
  constexpr void for_each(const F& f) const {
    for (std::size_t i = 0; i < store_.end(); ++i) {
      if (!store_.is_object(i)) continue;
      store_[i].shape.visit([&](const auto& shape) { f(store_.info(i), shape); });
    }
  }

  /// Adds a coordinate system, itself in another if that is given.
  ///
  /// result: nothing when the storage has no room for it, or no such parent
  constexpr std::optional<FrameId> add_frame(const Transform<S, N>& transform,
                                             const FrameId& parent = {}) {
    if (parent == FrameId{}) return store_.add_frame(transform, detail::nowhere);
    if (!store_.frames().is_frame(parent)) return std::nullopt;
    return store_.add_frame(transform, parent.index);
  }
  /// Moves a frame and all that is in it, at the cost of a look at every frame and attached object.
  constexpr bool move_frame(const FrameId& id, const Transform<S, N>& transform) {
    if (!store_.frames().is_frame(id)) return false;
    store_.move_frame(id.index, transform);
    return true;
  }
  /// Removes a frame; not while something is in it.
  constexpr bool remove_frame(const FrameId& id) noexcept {
    return store_.frames().is_frame(id) && store_.remove_frame(id.index);
  }

  template <class Question, ObjectFilter Filter = Everything>
  [[nodiscard]] constexpr std::optional<Found<S>> nearest(const Question& question,
                                                          const Filter& filter = {}) const {
    std::optional<Found<S>> best;
    visit_found(question, filter, [&](const Found<S>& found, auto shorten) {
      if (!best || found < *best) {
        best = found;
        shorten(found.distance);
      }
      return false;
    });
    return best;
  }

  template <class Question, ObjectFilter Filter = Everything>
  [[nodiscard]] constexpr bool any(const Question& question, const Filter& filter = {}) const {
    bool is_found = false;
    visit_meeting(question, filter, [&](std::size_t) { return is_found = true; });
    return is_found;
  }

  template <class Question, ObjectFilter Filter = Everything>
  [[nodiscard]] List<Found<S>> all(const Question& question, const Filter& filter = {}) const
      requires(is_growing) {
    List<Found<S>> list;
    collect(question, filter, [&](const Found<S>& found) { list.push_back(found); });
    std::sort(list.begin(), list.end());
    return list;
  }

  /// The first of `all` that fit `room`, in order; returns how many there are in all.
  template <class Question, ObjectFilter Filter = Everything>
  constexpr std::size_t all(const Question& question, std::span<Found<S>> room,
                            const Filter& filter = {}) const {
    std::size_t count = 0;
    collect(question, filter,
            [&](const Found<S>& found) { detail::keep_first(room, count++, found); });
    sort_first(room, count);
    return count;
  }

  template <PairFilter Filter = Everything>
  [[nodiscard]] List<Overlap> overlaps(const Filter& filter = {}) const requires(is_growing) {
    List<Overlap> list;
    visit_overlaps(filter, [&](const Overlap& overlap) { list.push_back(overlap); });
    std::sort(list.begin(), list.end());
    return list;
  }

  /// The first of the pairs that fit `room`, in order; returns how many there are in all.
  template <PairFilter Filter = Everything>
  constexpr std::size_t overlaps(std::span<Overlap> room, const Filter& filter = {}) const {
    std::size_t count = 0;
    visit_overlaps(filter,
                   [&](const Overlap& overlap) { detail::keep_first(room, count++, overlap); });
    sort_first(room, count);
    return count;
  }

  /// What snapshots and digests are made from.
  [[nodiscard]] constexpr const Store& store() const noexcept { return store_; }
  [[nodiscard]] constexpr Store& store() noexcept { return store_; }

 private:
  using Index = std::uint32_t;

  constexpr bool are_valid(const Traits& traits) const noexcept {
    if (traits.frame == FrameId{}) return true;
    return traits.motion == Motion::moving && store_.frames().is_frame(traits.frame);
  }

  /// Those of `count` that `room` holds, in order.
  template <class T>
  static constexpr void sort_first(std::span<T> room, std::size_t count) noexcept {
    std::sort(room.begin(),
              room.begin() + static_cast<std::ptrdiff_t>((std::min)(room.size(), count)));
  }

  template <class Visit>
  constexpr void visit_trees(const Visit& visit) const {
    if (!visit(store_.tree(Motion::moving))) visit(store_.tree(Motion::fixed));
  }

  /// Calls visit(index) for the objects that have a point in common with the question until it
  /// returns true.
  template <class Question, class Filter, class Visit>
  constexpr void visit_meeting(const Question& question, const Filter& filter,
                               const Visit& visit) const {
    const auto box = detail::culling_box(question);
    visit_trees([&](const auto& tree) {
      return detail::visit_meeting(tree, box, [&](Index i) {
        return filter(store_.info(i)) && store_[i].shape.visit([&](const auto& shape) {
          return detail::meets(question, shape);
        }) && visit(i);
      });
    });
  }
  template <class Filter, class Visit>
  constexpr void visit_meeting(const Ray<S, N>& ray, const Filter& filter,
                               const Visit& visit) const {
    visit_found(ray, filter, [&](const Found<S>& found, auto) { return visit(found.id.index); });
  }

  /// Calls visit(found, shorten) for what `all` is to list; with shorten(distance) it may waive
  /// what lies beyond.
  template <class Question, class Filter, class Visit>
  constexpr void visit_found(const Question& question, const Filter& filter,
                             const Visit& visit) const {
    visit_meeting(question, filter, [&](std::size_t i) {
      return visit(found_at(i, detail::reference(question)), [](const S&) {});
    });
  }
  template <class Filter, class Visit>
  constexpr void visit_found(const Ray<S, N>& ray, const Filter& filter, const Visit& visit) const {
    if (ray.max_distance < 0) return;
    detail::RayProbe<S, N> probe(ray);
    visit_trees([&](const auto& tree) {
      return detail::visit_nearest(tree, probe, [&](Index i) {
        if (!filter(store_.info(i))) return false;
        const auto distance =
            store_[i].shape.visit([&](const auto& shape) { return raycast(ray, shape); });
        return distance && visit(Found<S>{*distance, store_.info(i).id},
                                 [&](const S& limit) { probe.shorten(limit); });
      });
    });
  }
  /// Of a point, every object is found for `nearest`.
  template <class Filter, class Visit>
  constexpr void visit_found(const Vec<S, N>& point, const Filter& filter,
                             const Visit& visit) const {
    detail::PointProbe<S, N> probe(point);
    visit_trees([&](const auto& tree) {
      return detail::visit_nearest(tree, probe, [&](Index i) {
        return filter(store_.info(i)) &&
               visit(found_at(i, point), [&](const S& limit) { probe.shorten(limit); });
      });
    });
  }

  template <class Question, class Filter, class Add>
  constexpr void collect(const Question& question, const Filter& filter, const Add& add) const {
    visit_found(question, filter, [&](const Found<S>& found, auto) { return add(found), false; });
  }
  template <class Filter, class Add>
  constexpr void collect(const Vec<S, N>& point, const Filter& filter, const Add& add) const {
    visit_meeting(point, filter, [&](std::size_t i) { return add(found_at(i, point)), false; });
  }

  constexpr Found<S> found_at(std::size_t i, const Vec<S, N>& point) const noexcept {
    return {store_[i].shape.visit([&](const auto& shape) { return distance(shape, point); }),
            store_.info(i).id};
  }

  template <class Filter, class Add>
  constexpr void visit_overlaps(const Filter& filter, const Add& add) const {
    const auto ask = [&](Index i, Index j) {
      if (!filter(store_.info(i), store_.info(j))) return;
      const bool meet = store_[i].shape.visit([&](const auto& a) {
        return store_[j].shape.visit([&](const auto& b) { return detail::meets(a, b); });
      });
      if (meet) add(Overlap{store_.info(i).id, store_.info(j).id});
    };
    // Objects of a large scene are far from the processor: they are fetched while others are asked.
    std::array<std::pair<Index, Index>, 16> waiting;
    std::size_t count = 0;
    const auto visit = [&](Index i, Index j) {
      auto& place = waiting[count++ % waiting.size()];
      if (count > waiting.size()) ask(place.first, place.second);
      place = std::minmax(i, j);
      detail::prefetch(&store_[i], sizeof(store_[i]));
      detail::prefetch(&store_[j], sizeof(store_[j]));
    };
    const auto& moving = store_.tree(Motion::moving);
    const auto& fixed = store_.tree(Motion::fixed);
    if (moving.is_empty()) return;
    detail::visit_pairs(moving, moving.root(), visit);
    if (!fixed.is_empty()) {
      detail::visit_pairs_below(moving, moving.root(), fixed, fixed.root(), visit);
    }
    for (std::size_t i = 0; i < (std::min)(count, waiting.size()); ++i) {
      ask(waiting[i].first, waiting[i].second);
    }
  }

  Store store_;
};

#if __STDC_HOSTED__
/// A scene that takes memory as it grows, up to `Growing::capacity` objects.
template <Scalar S, int N, template <Scalar, int> class... Shapes>
using Scene = BasicScene<Growing, S, N, Shapes<S, N>...>;
#endif

/// A scene in the storage that `Bounds` names, a `Bounded<Capacity, FrameCapacity>`: it holds its
/// memory inside itself.
template <class Bounds, Scalar S, int N, template <Scalar, int> class... Shapes>
using BoundedScene = BasicScene<Bounds, S, N, Shapes<S, N>...>;

}  // namespace detent
