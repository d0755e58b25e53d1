// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "detent/scene/fields.hpp"
#include "detent/scene/snapshot.hpp"

namespace detent {

/// The state that a rollback must restore, as a type of your game. It has
///
/// * independent copies: data that it refers to by pointer or reference is shared by all copies and
///   must not change;
/// * `for_each_field(world, f)` in its namespace, which calls f(name, field) for each of its
///   fields.
///
/// A scene is a world by itself. One with a scene and velocities:
///
///     struct Game {
///       Scene<q16_16, 3, Sphere> scene;
///       std::array<Vec<q16_16, 3>, 2> velocity;
///     };
///     template <class F>
///     void for_each_field(const Game& game, const F& f) {
///       f("scene", game.scene);
///       f("velocity", game.velocity);
///     }
///
/// (tests/examples/sync_world.cpp)
template <class T>
concept RollbackWorld = std::copyable<T> && detail::Field<T>;

namespace detail {

/// An object of a scene, as a field of the scene.
template <class Store>
struct ObjectField {
  const Store& store;
  std::size_t index;

  [[nodiscard]] constexpr ObjectInfo info() const noexcept { return store.info(index); }
};
template <class Store>
ObjectField(const Store&, std::size_t) -> ObjectField<Store>;
template <class Store, class F>
constexpr void for_each_field(const ObjectField<Store>& object, const F& f) {
  const Store& store = object.store;
  const auto info = object.info();
  const auto& record = store[object.index];
  store.local_shape(record).visit([&]<class Shape>(const Shape& shape) {
    const auto with_type = [&](const PartName& name, const auto& field) {
      f(FieldName(" (").add(shape_names[shape_tag<Shape>]).add(") ").add(name.view()), field);
    };
    f("", true);  // it exists
    f(" type", shape_tag<Shape>);
    with_type("motion", info.motion);
    with_type("layers", info.layers);
    with_type("user", info.user);
    with_type("frame", store.frame_of(record));
    if constexpr (HasFields<Shape>) {
      for_each_field(shape, with_type);
    } else {
      with_type("shape", shape);
    }
  });
}

/// A frame of a scene, as a field of the scene.
template <Scalar S, int N>
struct FrameField {
  const Frame<S, N>& frame;
};
template <Scalar S, int N, class F>
constexpr void for_each_field(const FrameField<S, N>& field, const F& f) {
  f("", true);  // it exists
  f(" parent", field.frame.parent);
  for_each_field(field.frame.local, [&](const PartName& name, const auto& part) {
    f(FieldName(" ").add(name.view()), part);
  });
}

[[nodiscard]] constexpr FieldName name_of(const PartName& kind, std::size_t index,
                                          std::uint32_t generation) noexcept {
  return FieldName(" ").add(kind.view()).add(" ").add_number(index).add(":").add_number(generation);
}

}  // namespace detail

/// The objects, the frames and the next generation of a scene, named as in `detent diff`.
template <class Storage, Scalar S, int N, class... Shapes, class F>
constexpr void for_each_field(const BasicScene<Storage, S, N, Shapes...>& scene, const F& f) {
  const auto& store = detail::SceneAccess::store(scene);
  for (std::size_t i = 0; i < store.end(); ++i) {
    if (!store.is_object(i)) continue;
    f(detail::name_of("object", i, store[i].generation), detail::ObjectField{store, i});
  }
  const auto& frames = store.frames();
  for (std::size_t i = 0; i < frames.end(); ++i) {
    if (!frames.is_frame(i)) continue;
    f(detail::name_of("frame", i, frames[i].generation), detail::FrameField<S, N>{frames[i]});
  }
  f(" next generation", store.next_generation());
}

namespace detail {

/// Digests a field with parts as a whole, which is faster than part by part: `add(all, fixed,
/// value)` adds everything to `all`, and the part that never moves to `fixed`. Not defined for most
/// types.
template <class T>
struct WholeDigest;

template <class Storage, Scalar S, int N, class... Shapes>
struct WholeDigest<BasicScene<Storage, S, N, Shapes...>> {
  static constexpr void add(Digest& all, Digest& fixed,
                            const BasicScene<Storage, S, N, Shapes...>& scene) {
    const auto& store = SceneAccess::store(scene);
    all.add(scene, store.next_generation());
    fixed.add(static_cast<std::uint64_t>(store.fixed_size()), store.fixed_digest());
  }
};

template <class T>
concept HasWholeDigest = requires(Digest& digest, const T& value) {
  WholeDigest<T>::add(digest, digest, value);
};

/// The digests of all fields of a world, and of the fixed objects of its scenes.
class WorldDigest {
 public:
  template <RollbackWorld World>
  explicit constexpr WorldDigest(const World& world) {
    add(world);
  }
  [[nodiscard]] constexpr std::uint64_t all() const noexcept { return all_.value(); }
  [[nodiscard]] constexpr std::uint64_t fixed() const noexcept { return fixed_.value(); }

 private:
  template <Field T>
  constexpr void add(const T& value) {
    if constexpr (HasWholeDigest<T>) {
      WholeDigest<T>::add(all_, fixed_, value);
    } else if constexpr (HasFields<T>) {
      for_each_field(value, [&](const PartName&, const auto& field) { add(field); });
    } else if constexpr (IsList<T>) {
      all_.add(static_cast<std::uint64_t>(std::size(value)));
      for (const auto& element : value) add(element);
    } else {
      all_.add(value);
    }
  }

  Digest all_;
  Digest fixed_;
};

}  // namespace detail

/// A digest of all fields of `world`, equal on machines whose worlds are equal.
template <RollbackWorld World>
[[nodiscard]] constexpr std::uint64_t world_digest(const World& world) {
  return detail::WorldDigest(world).all();
}

}  // namespace detent
