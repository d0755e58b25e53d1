// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/dynamics/world.hpp"
#include "detent/scene/height_field/instance.hpp"
#include "detent/scene/hull/instance.hpp"
#include "detent/scene/mesh/instance.hpp"
#include "detent/scene/scene.hpp"

namespace detent {

/// A body, or a part of a compound.
struct PartId {
  BodyId body;
  std::uint32_t part = 0;  // the number of the part; 0 for other bodies

  [[nodiscard]] friend constexpr auto operator<=>(const PartId&, const PartId&) noexcept = default;
};

/// A predicate: whether a body, or a part of a compound, counts.
template <class F>
concept BodyFilter = std::predicate<const F&, const BodyInfo&>;

/// The filter that accepts what pushes others: all but sensors.
struct Solids {
  [[nodiscard]] constexpr bool operator()(const BodyInfo& body) const noexcept {
    return !body.is_sensor;
  }
};

namespace detail {

template <class... Shapes>
struct ShapeList {};

/// `Shapes` with `Shape`, if it is not among them.
template <class List, class Shape>
struct WithShape;
template <class... Shapes, class Shape>
struct WithShape<ShapeList<Shapes...>, Shape> {
  using Type = std::conditional_t<Among<Shape, Shapes...>, ShapeList<Shapes...>,
                                  ShapeList<Shapes..., Shape>>;
};

/// The shapes in the world of bodies of the types `Parts`, each once.
template <Scalar S, int N, class List, class... Parts>
struct ShapesInWorld {
  using Type = List;
};
template <Scalar S, int N, class List, class Part, class... Rest>
struct ShapesInWorld<S, N, List, Part, Rest...> {
  static constexpr auto with() {
    if constexpr (requires(const Part& part) { in_world(Standing<S, N>(), part); }) {
      using Shape = decltype(in_world(Standing<S, N>(), Part()));
      return typename WithShape<List, Shape>::Type();
    } else {
      return List();  // a joint, or a compound, whose parts are of the other types
    }
  }
  using Type = typename ShapesInWorld<S, N, decltype(with()), Rest...>::Type;
};

template <class World>
struct SceneFor;
template <class Storage, Scalar S, int N, class... Parts>
struct SceneFor<BasicWorld<Storage, S, N, Parts...>> {
  template <class... Shapes>
  static auto holding(ShapeList<Shapes...>) -> BasicScene<Storage, S, N, Shapes...>;
  using List = typename ShapesInWorld<S, N, ShapeList<>, Parts...>::Type;
  using Type = decltype(holding(List()));
};

template <class Needed, class... Shapes>
inline constexpr bool holds_all = false;
template <class... Needed, class... Shapes>
inline constexpr bool holds_all<ShapeList<Needed...>, Shapes...> = (Among<Needed, Shapes...> &&
                                                                    ...);

/// The first index of objects for parts of compounds: the least power of two that exceeds all
/// indices of bodies, at most the world's capacity. Adding a body rarely changes it.
template <class World>
[[nodiscard]] constexpr std::size_t first_part_of(const World& world) noexcept {
  const auto& bodies = WorldAccess::bodies(world);
  std::size_t end = bodies.size();
  while (end != 0 && bodies[end - 1].generation == 0) --end;
  return (std::min)(std::bit_ceil(end), World::capacity);
}

/// Makes a scene hold certain shapes, given in order of their ids, and nothing else.
template <class Storage, Scalar S, int N, class... Shapes>
class Updater {
  using Objects = Store<Storage, S, N, Shapes...>;
  using AnyShape = typename Objects::Shape;

 public:
  /// In bulk if many objects will move.
  constexpr Updater(Objects& objects, bool many) noexcept : objects_(objects), in_bulk_(many) {
    if (in_bulk_) objects_.begin_bulk();
  }

  /// Puts an object at `index`; its generation is that of the body.
  template <class Shape>
  constexpr void put(std::size_t index, const ObjectInfo& info, const Shape& shape) {
    if (index >= Storage::capacity) {
      is_full_ = true;
      return;
    }
    remove_before(index);
    next_ = index + 1;
    const ObjectId id{static_cast<std::uint32_t>(index), info.id.generation};
    const Traits traits{info.layers, info.user, info.motion, {}};
    if (!objects_.is_object(id.index)) return objects_.put(id, AnyShape(shape), traits);
    const auto& old = objects_[id.index];
    const bool is_same = old.generation == id.generation && old.layers == info.layers &&
                         old.user == info.user && old.motion == info.motion &&
                         old.attachment == nowhere;
    if (!is_same) {
      objects_.remove(id.index);
      objects_.put(id, AnyShape(shape), traits);
      return;
    }
    const Shape* const before = old.shape.template get<Shape>();
    if (before != nullptr && *before == shape) return;
    if (in_bulk_ && objects_.put_shape(id, AnyShape(shape), traits)) return;
    objects_.set_shape(id.index, AnyShape(shape));
  }

  /// Returns whether there was room for all objects.
  constexpr bool finish(std::uint32_t next_generation) {
    remove_before(objects_.end());
    if (in_bulk_) objects_.end_bulk();
    objects_.set_next_generation(next_generation);
    return !is_full_;
  }

 private:
  constexpr void remove_before(std::size_t end) {
    for (end = (std::min)(end, objects_.end()); next_ < end; ++next_) {
      if (objects_.is_object(next_)) objects_.remove(static_cast<std::uint32_t>(next_));
    }
  }

  Objects& objects_;
  std::size_t next_ = 0;  // the least index that is still to be compared
  bool in_bulk_;
  bool is_full_ = false;
};

}  // namespace detail

/// The type of a scene for all shapes of a world: `SceneOf<World<q16_16, 3, Sphere, Aabb>>` holds
/// spheres and `Obb`s. It has the world's capacity.
template <class World>
using SceneOf = typename detail::SceneFor<World>::Type;

/// Makes `scene` hold the shapes of the bodies of `world`, as `world.for_each` gives them, and
/// nothing else. Call it after each step, or whenever queries are due. Shapes that have not moved
/// are compared and not replaced.
///
/// An object has the id of its body, its layers, its user word, and `Motion::fixed` if the body is
/// fixed. A compound has an object for each part; `part_of` finds their bodies. `filter` selects
/// bodies and parts: all but sensors, unless you pass another one. The assets of bodies must outlive
/// the scene.
///
/// domain: scenes that name all shapes of `SceneOf<World>`; leave their contents to this function
/// result: whether the scene had room; objects with an index beyond its capacity are left out
/// exact:  answers and digests depend only on the present state of the world
///         (docs/dynamics.md, tests/dynamics/follow_zoo.test.cpp)
template <class Room, class Storage, Scalar S, int N, class... Shapes, class... Parts,
          BodyFilter Filter = Solids>
constexpr bool follow(BasicScene<Room, S, N, Shapes...>& scene,
                      const BasicWorld<Storage, S, N, Parts...>& world, const Filter& filter = {}) {
  using Needed = typename detail::SceneFor<BasicWorld<Storage, S, N, Parts...>>::List;
  constexpr bool is_complete = detail::holds_all<Needed, Shapes...>;
  static_assert(
      is_complete,
      "detent: name the shapes of all bodies in the scene, or use SceneOf<World>: Obb for "
      "Aabb, HullInstance for BodyHull, MeshInstance for BodyMesh, FieldInstance for "
      "BodyHeightField");
  if constexpr (is_complete) {
    const auto& bodies = detail::WorldAccess::bodies(world);
    std::size_t awake = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      awake += bodies[i].motion != BodyMotion::fixed && !bodies[i].sleeps ? 1u : 0u;
    }
    detail::Updater objects(detail::SceneAccess::store(scene), 4 * awake > scene.size());
    bool has_compounds = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].generation == 0) continue;
      if (detail::part_count(bodies[i]) != 0) {
        has_compounds = true;
        continue;
      }
      detail::visit_in_world<Parts...>(bodies[i], static_cast<std::uint32_t>(i),
                                       [&](const BodyInfo& info, const auto& shape) {
                                         if (filter(info)) objects.put(i, info, shape);
                                       });
    }
    if (has_compounds) {
      std::size_t first = detail::first_part_of(world);
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto parts = detail::part_count(bodies[i]);
        if (parts == 0) continue;
        detail::visit_in_world<Parts...>(bodies[i], static_cast<std::uint32_t>(i),
                                         [&](const BodyInfo& info, const auto& shape) {
                                           if (filter(info))
                                             objects.put(first + info.part, info, shape);
                                         });
        first += parts;
      }
    }
    return objects.finish(detail::WorldAccess::next(world));
  } else {
    return false;
  }
}

/// The body, and its part, of an object of a scene that follows `world`: the body with this id, or
/// the part of a compound that has the object; otherwise nothing.
///
/// domain: ids of a scene that followed since the last body was added or removed; those of compounds
///         change with that
template <class Storage, Scalar S, int N, class... Parts>
[[nodiscard]] constexpr std::optional<PartId> part_of(
    const BasicWorld<Storage, S, N, Parts...>& world, const ObjectId& object) noexcept {
  if (world.contains(object)) return PartId{object};
  const auto& bodies = detail::WorldAccess::bodies(world);
  std::size_t first = detail::first_part_of(world);
  for (std::size_t i = 0; i < bodies.size() && first <= object.index; ++i) {
    const auto parts = detail::part_count(bodies[i]);
    if (object.index < first + parts && object.generation == bodies[i].generation) {
      return PartId{{static_cast<std::uint32_t>(i), bodies[i].generation},
                    static_cast<std::uint32_t>(object.index - first)};
    }
    first += parts;
  }
  return std::nullopt;
}

}  // namespace detent
