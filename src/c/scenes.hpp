// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "c/assets.hpp"
#include "detent/scene/snapshot.hpp"

namespace detent::c {

#define DETENT_C_SHAPE(N, KIND, Shape, name) Shape,
template <int N>
struct SceneOf;
template <>
struct SceneOf<2> {
  using type = Scene<S, 2, DETENT_C_SCENE_SHAPES(DETENT_C_SHAPE, 2) HullInstance>;
  static constexpr Kind kind = Kind::scene2;
};
template <>
struct SceneOf<3> {
  using type = Scene<S, 3, DETENT_C_SCENE_SHAPES(DETENT_C_SHAPE, 3) HullInstance, MeshInstance,
                     FieldInstance>;
  static constexpr Kind kind = Kind::scene3;
};
#undef DETENT_C_SHAPE

[[nodiscard]] constexpr detent_status status_of(Restored restored) noexcept {
  switch (restored) {
    case Restored::yes:
      return DETENT_OK;
    case Restored::no_snapshot:
      return DETENT_NO_SNAPSHOT;
    case Restored::other_version:
      return DETENT_OTHER_VERSION;
    case Restored::truncated:
      return DETENT_TRUNCATED;
    case Restored::corrupted:
      return DETENT_CORRUPTED;
    case Restored::other_scene:
      return DETENT_OTHER_SCENE;
    case Restored::other_fixed_part:
      return DETENT_OTHER_FIXED_PART;
    case Restored::no_room:
      return DETENT_NO_ROOM;
    case Restored::unknown_asset:
      return DETENT_UNKNOWN_ASSET;
    case Restored::other_asset:
      return DETENT_OTHER_ASSET;
  }
  return DETENT_CORRUPTED;
}

[[nodiscard]] constexpr ObjectId id_of(const detent_id& id) noexcept {
  return {id.index, id.generation};
}
[[nodiscard]] constexpr detent_id id_of(const ObjectId& id) noexcept {
  return {id.index, id.generation};
}

/// Writes snapshot(room) for scenes and worlds.
template <class Snapshot>
detent_status write_snapshot(void* bytes, std::uint32_t room, std::uint32_t* size,
                             const Snapshot& snapshot) {
  if (size == nullptr || (bytes == nullptr && room != 0)) return DETENT_BAD_ARGUMENT;
  const auto count = snapshot(std::span(static_cast<std::byte*>(bytes), room));
  *size = static_cast<std::uint32_t>(count);
  return yes_or_no(count <= room);
}

template <int N>
struct Scenes {
  using T = Types<N>;
  using Scene = typename SceneOf<N>::type;
  static constexpr Kind kind = SceneOf<N>::kind;

  static detent_status create(detent_context* context, detent_handle* scene) {
    Context* const table = table_of(context);
    if (table == nullptr) return DETENT_BAD_CONTEXT;
    if (scene == nullptr) return DETENT_BAD_ARGUMENT;
    return guarded(nullptr, [&] { return table->make<Scene>(kind, scene, refers_to); });
  }
  static detent_status destroy(detent_context* context, detent_handle scene) {
    return destroy_object(context, kind, scene);
  }

  static detent_status add(detent_context* context, detent_handle scene,
                           const typename T::Shape* shape, const detent_traits* traits,
                           detent_id* id) {
    return change(context, scene, [&](const Context& table, Scene& object) -> detent_status {
      if (shape == nullptr || id == nullptr || !is_valid(traits)) return DETENT_BAD_ARGUMENT;
      if (!has_frame(object, traits)) return DETENT_NO;
      return with_object_shape(table, *shape, [&](const auto& read) -> detent_status {
        const auto added = object.add(read, traits_of(traits));
        if (!added) return DETENT_FULL;
        *id = id_of(*added);
        return DETENT_OK;
      });
    });
  }
  static detent_status add_as(detent_context* context, detent_handle scene, detent_id id,
                              const typename T::Shape* shape, const detent_traits* traits) {
    return change(context, scene, [&](const Context& table, Scene& object) -> detent_status {
      if (shape == nullptr || !is_valid(traits)) return DETENT_BAD_ARGUMENT;
      return with_object_shape(table, *shape, [&](const auto& read) {
        return yes_or_no(object.add_as(id_of(id), read, traits_of(traits)));
      });
    });
  }
  static detent_status remove(detent_context* context, detent_handle scene, detent_id id) {
    return change(context, scene, [&](const Context&, Scene& object) {
      return yes_or_no(object.remove(id_of(id)));
    });
  }
  static detent_status replace(detent_context* context, detent_handle scene, detent_id id,
                               const typename T::Shape* shape) {
    return change(context, scene, [&](const Context& table, Scene& object) -> detent_status {
      if (shape == nullptr) return DETENT_BAD_ARGUMENT;
      return with_object_shape(table, *shape, [&](const auto& read) {
        return yes_or_no(object.replace_local(id_of(id), read));
      });
    });
  }
  static detent_status move(detent_context* context, detent_handle scene, detent_id id,
                            const typename T::Vec* by) {
    return change(context, scene, [&](const Context&, Scene& object) -> detent_status {
      if (by == nullptr) return DETENT_BAD_ARGUMENT;
      return yes_or_no(object.move(id_of(id), Input<N>::vec(*by)));
    });
  }
  static detent_status object(const detent_context* context, detent_handle scene, detent_id id,
                              typename T::Shape* shape, detent_traits* traits) {
    return read(context, scene, [&](const Context& table, const Scene& from) -> detent_status {
      const auto info = from.info(id_of(id));
      if (!info) return DETENT_NO;
      if (traits != nullptr) {
        const auto frame = from.frame_of(id_of(id)).value_or(FrameId{});
        *traits = {info->user,
                   info->layers,
                   static_cast<std::uint32_t>(info->motion),
                   {frame.index, frame.generation}};
      }
      if (shape != nullptr) {
        *shape = {};
        from.visit(id_of(id), [&](const auto& found) { write(table, found, *shape); });
      }
      return DETENT_OK;
    });
  }
  static detent_status set_traits(detent_context* context, detent_handle scene, detent_id id,
                                  const detent_traits* traits) {
    return change(context, scene, [&](const Context&, Scene& object) -> detent_status {
      if (traits == nullptr) return DETENT_BAD_ARGUMENT;
      return yes_or_no(object.set_layers(id_of(id), traits->layers) &&
                       object.set_user(id_of(id), traits->user));
    });
  }
  static detent_status add_frame(detent_context* context, detent_handle scene,
                                 const typename T::Transform* transform, detent_id parent,
                                 detent_id* frame) {
    return change(context, scene, [&](const Context&, Scene& object) -> detent_status {
      if (transform == nullptr || frame == nullptr) return DETENT_BAD_ARGUMENT;
      Input<N> in;
      const auto own = in.transform(*transform);
      if (!in.is_valid()) return DETENT_NOT_UNIT;
      const auto above = frame_of(parent);
      if (!(above == FrameId{}) && !object.frame(above)) return DETENT_NO;
      const auto added = object.add_frame(own, above);
      if (!added) return DETENT_FULL;
      *frame = {added->index, added->generation};
      return DETENT_OK;
    });
  }
  static detent_status move_frame(detent_context* context, detent_handle scene, detent_id frame,
                                  const typename T::Transform* transform) {
    return change(context, scene, [&](const Context&, Scene& object) -> detent_status {
      if (transform == nullptr) return DETENT_BAD_ARGUMENT;
      Input<N> in;
      const auto own = in.transform(*transform);
      if (!in.is_valid()) return DETENT_NOT_UNIT;
      return yes_or_no(object.move_frame(frame_of(frame), own));
    });
  }
  static detent_status remove_frame(detent_context* context, detent_handle scene, detent_id frame) {
    return change(context, scene, [&](const Context&, Scene& object) {
      return yes_or_no(object.remove_frame(frame_of(frame)));
    });
  }
  static detent_status frame(const detent_context* context, detent_handle scene, detent_id frame,
                             typename T::Transform* local, typename T::Transform* world) {
    return read(context, scene, [&](const Context&, const Scene& object) -> detent_status {
      const auto found = object.frame(frame_of(frame));
      if (!found) return DETENT_NO;
      if (local != nullptr) *local = Output<N>::transform(found->local);
      if (world != nullptr) *world = Output<N>::transform(found->world);
      return DETENT_OK;
    });
  }
  static detent_status size(const detent_context* context, detent_handle scene,
                            std::uint32_t* size) {
    return write_from<Scene>(context, kind, scene, size,
                             [](const Scene& object) { return object.size(); });
  }
  static detent_status optimize(detent_context* context, detent_handle scene) {
    return change(context, scene, [&](const Context&, Scene& object) -> detent_status {
      object.optimize();
      return DETENT_OK;
    });
  }

  static detent_status raycast(const detent_context* context, detent_handle scene,
                               const typename T::Ray* ray, std::uint32_t layers,
                               typename T::ObjectHit* hit) {
    return along(context, scene, ray, [&](const Scene& object, const Ray<S, N>& read) {
      if (hit == nullptr) return yes_or_no(object.nearest(read, InLayers{layers}).has_value());
      return write_nearest(object, read, layers, *hit);
    });
  }
  static detent_status raycast_any(const detent_context* context, detent_handle scene,
                                   const typename T::Ray* ray, std::uint32_t layers) {
    return along(context, scene, ray, [&](const Scene& object, const Ray<S, N>& read) {
      return yes_or_no(object.any(read, InLayers{layers}));
    });
  }
  static detent_status raycast_all(const detent_context* context, detent_handle scene,
                                   const typename T::Ray* ray, std::uint32_t layers,
                                   typename T::ObjectHit* hits, std::uint32_t room,
                                   std::uint32_t* count) {
    return along(context, scene, ray, [&](const Scene& object, const Ray<S, N>& read) {
      return write_list<ObjectHit<S, N>>(
          hits, room, count,
          [&](auto list) { return object.all_hits(read, list, InLayers{layers}); }, hit_of);
    });
  }
  static detent_status raycast_many(const detent_context* context, detent_handle scene,
                                    const typename T::Ray* rays, std::uint32_t count,
                                    std::uint32_t layers, typename T::ObjectHit* hits) {
    return read(context, scene, [&](const Context&, const Scene& object) -> detent_status {
      if (count != 0 && (rays == nullptr || hits == nullptr)) return DETENT_BAD_ARGUMENT;
      for (std::uint32_t i = 0; i < count; ++i) {
        Input<N> in;
        const auto ray = in.ray(rays[i]);
        if (!in.is_valid()) return DETENT_NOT_UNIT;
        if (write_nearest(object, ray, layers, hits[i]) == DETENT_OK) continue;
        hits[i] = {};
        hits[i].distance = -1;
      }
      return DETENT_OK;
    });
  }

  static detent_status nearest(const detent_context* context, detent_handle scene,
                               const typename T::Shape* question, std::uint32_t layers,
                               detent_found* found) {
    return about(context, scene, question, [&](const Scene& object, const auto& shape) {
      const auto first = object.nearest(shape, InLayers{layers});
      if (first && found != nullptr) *found = found_of(*first);
      return yes_or_no(first.has_value());
    });
  }
  static detent_status any(const detent_context* context, detent_handle scene,
                           const typename T::Shape* question, std::uint32_t layers) {
    return about(context, scene, question, [&](const Scene& object, const auto& shape) {
      return yes_or_no(object.any(shape, InLayers{layers}));
    });
  }
  static detent_status all(const detent_context* context, detent_handle scene,
                           const typename T::Shape* question, std::uint32_t layers,
                           detent_found* found, std::uint32_t room, std::uint32_t* count) {
    return about(context, scene, question, [&](const Scene& object, const auto& shape) {
      return write_list<Found<S>>(
          found, room, count, [&](auto list) { return object.all(shape, list, InLayers{layers}); },
          found_of);
    });
  }
  static detent_status overlaps(const detent_context* context, detent_handle scene,
                                detent_pair* pairs, std::uint32_t room, std::uint32_t* count) {
    return read(context, scene, [&](const Context&, const Scene& object) {
      return write_list<Overlap>(
          pairs, room, count, [&](auto list) { return object.overlaps(list); },
          [](const Overlap& pair) {
            return detent_pair{id_of(pair.first), id_of(pair.second)};
          });
    });
  }

  static detent_status digest(const detent_context* context, detent_handle scene,
                              std::uint64_t* digest) {
    return write_from<Scene>(context, kind, scene, digest,
                             [](const Scene& object) { return detent::digest(object); });
  }
  static detent_status snapshot(const detent_context* context, detent_handle scene, void* bytes,
                                std::uint32_t room, std::uint32_t* size) {
    return read(context, scene, [&](const Context&, const Scene& object) {
      return write_snapshot(bytes, room, size,
                            [&](auto span) { return detent::snapshot(object, span); });
    });
  }
  static detent_status restore(detent_context* context, detent_handle scene, const void* bytes,
                               std::uint32_t size) {
    return change(context, scene, [&](const Context& table, Scene& object) -> detent_status {
      if (bytes == nullptr && size != 0) return DETENT_BAD_ARGUMENT;
      const std::span from(static_cast<const std::byte*>(bytes), size);
      const auto hulls = table.assets<HullAsset<S, N>>().span();
      if constexpr (N == 2) {
        return status_of(detent::restore(object, from, hulls));
      } else {
        return status_of(detent::restore(object, from, hulls, table.assets<MeshAsset<S>>().span(),
                                         table.assets<FieldAsset<S>>().span()));
      }
    });
  }

  static typename T::ObjectHit hit_of(const ObjectHit<S, N>& hit) noexcept {
    return {hit.distance.raw(),        id_of(hit.id),
            Output<N>::vec(hit.point), Output<N>::direction(hit.normal),
            hit.triangle.value_or(0),  hit.triangle ? 1u : 0u};
  }
  static detent_found found_of(const Found<S>& found) noexcept {
    return {found.distance.raw(), id_of(found.id)};
  }

 private:
  template <class F>
  static detent_status change(detent_context* context, detent_handle scene, const F& f) {
    return with_object<Scene>(context, kind, scene, f);
  }
  template <class F>
  static detent_status read(const detent_context* context, detent_handle scene, const F& f) {
    return read_object<Scene>(context, kind, scene, f);
  }
  /// f(scene, ray) for the caller's ray.
  template <class F>
  static detent_status along(const detent_context* context, detent_handle scene,
                             const typename T::Ray* ray, const F& f) {
    return read(context, scene, [&](const Context&, const Scene& object) -> detent_status {
      if (ray == nullptr) return DETENT_BAD_ARGUMENT;
      Input<N> in;
      const auto along = in.ray(*ray);
      return in.is_valid() ? f(object, along) : DETENT_NOT_UNIT;
    });
  }
  /// f(scene, shape) for the caller's query shape.
  template <class F>
  static detent_status about(const detent_context* context, detent_handle scene,
                             const typename T::Shape* question, const F& f) {
    return read(context, scene, [&](const Context&, const Scene& object) -> detent_status {
      if (question == nullptr) return DETENT_BAD_ARGUMENT;
      if (question->kind == DETENT_POINT) return f(object, Input<N>::vec(question->as.point));
      return with_shape<N>(*question, [&](const auto& shape) -> detent_status {
        using Shape = std::remove_cvref_t<decltype(shape)>;
        if constexpr (SceneQuestion<Shape, S, N>) {
          return f(object, shape);
        } else {
          return DETENT_NO_QUERY;
        }
      });
    });
  }

  /// f(shape) for a shape that scenes hold.
  template <class F>
  static detent_status with_object_shape(const Context& table, const typename T::Shape& shape,
                                         const F& f) {
    if (shape.kind < DETENT_HULL || shape.kind > DETENT_HEIGHT_FIELD) {
      return with_shape<N>(shape, [&](const auto& read) -> detent_status {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(read)>, Segment<S, N>>) {
          return DETENT_NO_QUERY;
        } else {
          return f(read);
        }
      });
    }
    if constexpr (N == 3) {
      if (shape.kind == DETENT_MESH) {
        return with_placed<MeshAsset<S>, PlacedMesh<S>>(table, shape, f);
      }
      if (shape.kind == DETENT_HEIGHT_FIELD) {
        const auto* const asset = table.asset<FieldAsset<S>>(shape.asset);
        if (asset == nullptr) return DETENT_BAD_HANDLE;
        return f(PlacedField<S>{asset, Input<N>::vec(shape.as.point)});
      }
    }
    if (shape.kind != DETENT_HULL) return DETENT_NO_QUERY;
    return with_placed<HullAsset<S, N>, PlacedHull<S, N>>(table, shape, f);
  }
  template <class Asset, class Placed, class F>
  static detent_status with_placed(const Context& table, const typename T::Shape& shape,
                                   const F& f) {
    const auto* const asset = table.asset<Asset>(shape.asset);
    if (asset == nullptr) return DETENT_BAD_HANDLE;
    Input<N> in;
    const auto transform = in.transform(shape.as.placed);
    return in.is_valid() ? f(Placed{asset, transform}) : DETENT_NOT_UNIT;
  }

  template <class Shape>
  static void write(const Context& table, const Shape& shape, typename T::Shape& out) {
    if constexpr (requires { shape.asset; }) {
      using Asset = std::remove_cvref_t<decltype(*shape.asset)>;
      out.asset = table.assets<Asset>().handle_of(shape.asset);
      if constexpr (std::is_same_v<Asset, HullAsset<S, N>>) {
        const auto& solids = table.assets<SolidHull<S, N>>();  // of bodies that the scene follows
        for (std::uint32_t i = 0; i < solids.end && out.asset == 0; ++i) {
          if (&solids.list[i].asset() == shape.asset) out.asset = solids.handles[i];
        }
      }
      if constexpr (requires { shape.transform; }) {
        out.kind = asset_kind<Asset> == Kind::mesh ? DETENT_MESH : DETENT_HULL;
        out.as.placed = Output<N>::transform(shape.transform);
      } else {
        out.kind = DETENT_HEIGHT_FIELD;
        out.as.point = Output<N>::vec(shape.translation);
      }
    } else {
      Output<N>::shape(out, shape);
    }
  }

  static bool refers_to(const void* scene, const void* asset) {
    bool does = false;
    static_cast<const Scene*>(scene)->for_each([&](const ObjectInfo&, const auto& shape) {
      if constexpr (requires { shape.asset; }) does |= shape.asset == asset;
    });
    return does;
  }

  static bool is_valid(const detent_traits* traits) noexcept {
    return traits == nullptr ||
           (traits->motion <= DETENT_FIXED &&
            (traits->motion == DETENT_MOVING || frame_of(traits->frame) == FrameId{}));
  }
  static bool has_frame(const Scene& scene, const detent_traits* traits) {
    if (traits == nullptr || frame_of(traits->frame) == FrameId{}) return true;
    return scene.frame(frame_of(traits->frame)).has_value();
  }
  static FrameId frame_of(const detent_id& id) noexcept { return {id.index, id.generation}; }
  static Traits traits_of(const detent_traits* traits) noexcept {
    if (traits == nullptr) return {};
    return {traits->layers, traits->user, static_cast<Motion>(traits->motion),
            frame_of(traits->frame)};
  }
  static detent_status write_nearest(const Scene& scene, const Ray<S, N>& ray, std::uint32_t layers,
                                     typename T::ObjectHit& hit) {
    const auto found = scene.nearest_hit(ray, InLayers{layers});
    if (found) hit = hit_of(*found);
    return yes_or_no(found.has_value());
  }
};

}  // namespace detent::c
