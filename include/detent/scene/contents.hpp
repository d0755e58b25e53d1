// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "detent/scene/store.hpp"

namespace detent {

/// A frame's transforms to its parent (`FrameId{}` for the world) and to the world.
template <Scalar S, int N>
struct FrameInfo {
  Transform<S, N> local;
  Transform<S, N> world;
  FrameId parent;

  [[nodiscard]] friend constexpr bool operator==(const FrameInfo&,
                                                 const FrameInfo&) noexcept = default;
};

namespace detail {

struct SceneAccess;

/// The part of a scene that stores objects and frames, and adds, reads, changes and removes them.
///
/// `shape`, `visit`, `for_each` and `replace` use shapes in the world; `add`, `add_as`,
/// `local_shape`, `replace_local` and `move` use shapes in the object's frame. Both are the same
/// for an object in no frame.
///
/// Functions that read or change an object or a frame return false, or nothing, when it does not
/// exist, including for `no_object` and `no_frame`.
///
/// Fixed objects are not in snapshots. Once one is added, changed, moved or removed, earlier
/// snapshots cannot be restored: `restore` returns `Restored::other_fixed_part`.
template <class Storage, Scalar S, int N, class... Shapes>
class SceneContents {
  static_assert((... && (shape_tag<Shapes> != 0)),
                "detent: a scene holds shapes, named as templates: Scene<q16_16, 3, Sphere, Obb>; "
                "hulls, meshes and height fields are HullInstance, MeshInstance and "
                "FieldInstance; rays, segments and points are queries, not objects");

 public:
  static constexpr bool is_growing = requires { requires Storage::is_growing; };
  static constexpr std::size_t capacity = Storage::capacity;

  constexpr SceneContents() = default;
  constexpr SceneContents(const SceneContents&) = default;
  constexpr SceneContents& operator=(const SceneContents&) = default;
  /// Leaves the other scene as if nothing had ever been added to it.
  constexpr SceneContents(SceneContents&& other) noexcept : store_(std::move(other.store_)) {
    other.store_.clear();
  }
  constexpr SceneContents& operator=(SceneContents&& other) noexcept {
    if (this == &other) return *this;
    store_ = std::move(other.store_);
    other.store_.clear();
    return *this;
  }
  constexpr ~SceneContents() = default;

  /// The number of objects.
  [[nodiscard]] constexpr std::size_t size() const noexcept { return store_.size(); }

  /// Adds an object at the lowest free index. On failure, `value_or(no_object)` gives an id on
  /// which every function returns false:
  ///
  ///     const ObjectId ball = scene.add(Sphere{center, radius}).value_or(no_object);
  ///
  /// result: nothing, and no change, when the scene holds `capacity` objects, when 2^32 - 2 objects
  ///         and frames have been added, when the frame is not in this scene, or when a fixed
  ///         object is given a frame
  template <Among<Shapes...> Shape>
  constexpr std::optional<ObjectId> add(const Shape& shape, const Traits& traits = {}) {
    if (!are_valid(traits)) return std::nullopt;
    const auto id = store_.next_id();
    if (id) store_.put(*id, AnyShape(shape), traits);
    return id;
  }

  // Deleted: compilers show the line with the name.
  // clang-format off
  template <class Other>
  requires(!Among<Other, Shapes...>)
  std::optional<ObjectId> add(const Other&, const Traits& = {}) = delete;  // detent: name this shape in the type of the scene: Scene<S, N, Sphere, Aabb, ...>
  // clang-format on

  /// Adds an object with an id chosen by the caller, so that two scenes filled in different orders
  /// hold the same objects.
  ///
  /// result: false, and no change, when `add` would refuse the frame, when the index is taken or
  ///         not below `capacity`, or when the generation is 0 or 2^32 - 1
  template <Among<Shapes...> Shape>
  constexpr bool add_as(const ObjectId& id, const Shape& shape, const Traits& traits = {}) {
    if (!are_valid(traits) || id.index >= capacity || store_.is_object(id.index)) return false;
    if (id.generation == 0 || id.generation > Objects::last_generation) return false;
    store_.put(id, AnyShape(shape), traits);
    return true;
  }

  /// Removes an object. Its id never refers to another one.
  constexpr bool remove(const ObjectId& id) {
    if (!contains(id)) return false;
    store_.remove(id.index);
    return true;
  }
  /// Replaces an object's shape by one of any listed type, given in the world. Returns false for an
  /// object in a frame: use `replace_local`.
  template <Among<Shapes...> Shape>
  constexpr bool replace(const ObjectId& id, const Shape& shape) {
    return frame_of(id) == FrameId{} && replace_local(id, shape);
  }
  /// Replaces an object's shape by one of any listed type, given in the object's frame.
  template <Among<Shapes...> Shape>
  constexpr bool replace_local(const ObjectId& id, const Shape& shape) {
    if (!contains(id)) return false;
    store_.set_shape(id.index, AnyShape(shape));
    return true;
  }
  /// Moves an object by a vector in its frame.
  constexpr bool move(const ObjectId& id, const Vec<S, N>& by) {
    const auto* const record = store_.find(id);
    if (record == nullptr) return false;
    store_.set_shape(id.index, store_.local_shape(*record).visit([&](const auto& shape) {
      return AnyShape(translated(shape, by));
    }));
    return true;
  }
  /// Sets the layers that filters read.
  constexpr bool set_layers(const ObjectId& id, std::uint32_t layers) noexcept {
    if (!contains(id)) return false;
    store_.set_layers(id.index, layers);
    return true;
  }
  /// Sets the number that the caller keeps with an object.
  constexpr bool set_user(const ObjectId& id, std::uint64_t user) noexcept {
    if (!contains(id)) return false;
    store_.set_user(id.index, user);
    return true;
  }

  /// Makes queries faster after many additions, such as loading a level. Costs about a microsecond
  /// per object; a bounded scene needs 28 bytes of stack for each object of its capacity. Never
  /// changes a result.
  constexpr void optimize() { store_.rebuild(); }

  /// Whether the object exists.
  [[nodiscard]] constexpr bool contains(const ObjectId& id) const noexcept {
    return store_.find(id) != nullptr;
  }
  /// The properties of an object that filters see.
  [[nodiscard]] constexpr std::optional<ObjectInfo> info(const ObjectId& id) const noexcept {
    if (!contains(id)) return std::nullopt;
    return store_.info(id.index);
  }
  /// The object's shape in the world, if it is of this type.
  template <Among<Shapes...> Shape>
  [[nodiscard]] constexpr std::optional<Shape> shape(const ObjectId& id) const noexcept {
    const auto* const record = store_.find(id);
    return record ? as<Shape>(record->shape) : std::nullopt;
  }
  /// The object's shape in its frame, as given to `add` or `replace_local`, if it is of this type.
  template <Among<Shapes...> Shape>
  [[nodiscard]] constexpr std::optional<Shape> local_shape(const ObjectId& id) const noexcept {
    const auto* const record = store_.find(id);
    return record ? as<Shape>(store_.local_shape(*record)) : std::nullopt;
  }
  /// Calls f(shape) with the object's shape in the world, in its own type.
  template <class F>
  constexpr bool visit(const ObjectId& id, const F& f) const {
    const auto* const record = store_.find(id);
    if (record == nullptr) return false;
    record->shape.visit([&](const auto& shape) { f(shape); });
    return true;
  }
  /// Calls f(info, shape) for every object in order of id, with its shape in the world.
  template <class F>
  constexpr void for_each(const F& f) const {
    for (std::size_t i = 0; i < store_.end(); ++i) {
      if (!store_.is_object(i)) continue;
      store_[i].shape.visit([&](const auto& shape) { f(store_.info(i), shape); });
    }
  }

  /// The frame that an object is in; `FrameId{}` for the world.
  [[nodiscard]] constexpr std::optional<FrameId> frame_of(const ObjectId& id) const noexcept {
    const auto* const record = store_.find(id);
    if (record == nullptr) return std::nullopt;
    return store_.frames().id(store_.frame_of(*record));
  }
  /// A frame's transforms and parent; nothing for the world.
  [[nodiscard]] constexpr std::optional<FrameInfo<S, N>> frame(const FrameId& id) const noexcept {
    const auto& frames = store_.frames();
    if (!frames.is_frame(id)) return std::nullopt;
    const auto& frame = frames[id.index];
    return FrameInfo<S, N>{frame.local, frame.world, frames.id(frame.parent)};
  }

  /// Adds a frame, inside `parent` if given. On failure, `value_or(no_frame)` gives a frame that
  /// nothing can be added to.
  ///
  /// result: nothing when the storage has no room or the parent does not exist
  constexpr std::optional<FrameId> add_frame(const Transform<S, N>& transform,
                                             const FrameId& parent = {}) {
    if (parent == FrameId{}) return store_.add_frame(transform, nowhere);
    if (!store_.frames().is_frame(parent)) return std::nullopt;
    return store_.add_frame(transform, parent.index);
  }
  /// Moves a frame in its parent, with everything in it. Visits every frame and attached object.
  constexpr bool move_frame(const FrameId& id, const Transform<S, N>& transform) {
    if (!store_.frames().is_frame(id)) return false;
    store_.move_frame(id.index, transform);
    return true;
  }
  /// Removes a frame; returns false while anything is in it.
  constexpr bool remove_frame(const FrameId& id) noexcept {
    return store_.frames().is_frame(id) && store_.remove_frame(id.index);
  }

 protected:
  using Objects = Store<Storage, S, N, Shapes...>;
  Objects store_;

 private:
  friend struct SceneAccess;
  using AnyShape = typename Objects::Shape;

  constexpr bool are_valid(const Traits& traits) const noexcept {
    if (traits.frame == FrameId{}) return true;
    return traits.motion == Motion::moving && store_.frames().is_frame(traits.frame);
  }

  template <class Shape>
  static constexpr std::optional<Shape> as(const AnyShape& any) noexcept {
    const Shape* const shape = any.template get<Shape>();
    return shape ? std::optional<Shape>(*shape) : std::nullopt;
  }
};

/// The store of a scene, for snapshots, digests and tests.
struct SceneAccess {
  template <class Storage, Scalar S, int N, class... Shapes>
  [[nodiscard]] static constexpr auto& store(
      const SceneContents<Storage, S, N, Shapes...>& scene) noexcept {
    return scene.store_;
  }
  template <class Storage, Scalar S, int N, class... Shapes>
  [[nodiscard]] static constexpr auto& store(
      SceneContents<Storage, S, N, Shapes...>& scene) noexcept {
    return scene.store_;
  }
};

}  // namespace detail

}  // namespace detent
