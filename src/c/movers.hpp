// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "c/mover_casts.hpp"
#include "c/scenes.hpp"
#include "detent/scene/mover.hpp"

// Characters, and casts in scenes. `MoverOf` and `SceneCastOf`, which take long to compile, are in
// src/c/casts/, for boxes and for capsules.
namespace detent::c {

template <int N>
using SceneType = typename SceneOf<N>::type;

/// Passes the objects of some layers, except one.
struct OthersInLayers {
  std::uint32_t layers = 0;
  ObjectId ignored;

  bool operator()(const ObjectInfo& info) const noexcept {
    return (info.layers & layers) != 0 && !(info.id == ignored);
  }
};
template <int N, template <class, int> class Shape>
struct MoverOf {
  static MoveResult<S, N> move(const SceneType<N>& scene, Mover<S, N, Shape>& mover,
                               const Vec<S, N>& by, const MoverSettings<S, N>& settings,
                               const OthersInLayers& filter);
};
template <int N, template <class, int> class Shape>
struct SceneCastOf {
  using Moving = Cast<Shape<S, N>>;
  static std::optional<ObjectHit<S, N>> nearest(const SceneType<N>& scene, const Moving& moving,
                                                InLayers layers);
  static bool any(const SceneType<N>& scene, const Moving& moving, InLayers layers);
  static std::size_t all(const SceneType<N>& scene, const Moving& moving,
                         std::span<ObjectHit<S, N>> room, InLayers layers);
};

template <int N>
struct Movers {
  using T = Types<N>;
  using Scene = SceneType<N>;
  static constexpr Kind kind = SceneOf<N>::kind;

  static detent_status cast(const detent_context* context, detent_handle scene,
                            const typename T::Shape* shape, const typename T::Direction* direction,
                            std::int32_t max_distance, std::uint32_t layers,
                            typename T::ObjectHit* hit) {
    return along(context, scene, shape, direction, max_distance,
                 [&]<class Casts>(const Scene& object, const auto& moving, Casts) {
                   const auto found = Casts::nearest(object, moving, InLayers{layers});
                   if (found && hit != nullptr) *hit = Scenes<N>::hit_of(*found);
                   return yes_or_no(found.has_value());
                 });
  }
  static detent_status cast_any(const detent_context* context, detent_handle scene,
                                const typename T::Shape* shape,
                                const typename T::Direction* direction, std::int32_t max_distance,
                                std::uint32_t layers) {
    return along(context, scene, shape, direction, max_distance,
                 [&]<class Casts>(const Scene& object, const auto& moving, Casts) {
                   return yes_or_no(Casts::any(object, moving, InLayers{layers}));
                 });
  }
  static detent_status cast_all(const detent_context* context, detent_handle scene,
                                const typename T::Shape* shape,
                                const typename T::Direction* direction, std::int32_t max_distance,
                                std::uint32_t layers, typename T::ObjectHit* hits,
                                std::uint32_t room, std::uint32_t* count) {
    return along(
        context, scene, shape, direction, max_distance,
        [&]<class Casts>(const Scene& object, const auto& moving, Casts) {
          return write_list<ObjectHit<S, N>>(
              hits, room, count,
              [&](auto list) { return Casts::all(object, moving, list, InLayers{layers}); },
              Scenes<N>::hit_of);
        });
  }

  static detent_status default_settings(typename T::MoverSettings* out) {
    if (out == nullptr) return DETENT_BAD_ARGUMENT;
    const MoverSettings<S, N> own;
    *out = {Output<N>::direction(own.up), own.skin.raw(), own.step_height.raw(),
            own.snap_distance.raw(), own.max_slope.raw()};
    return DETENT_OK;
  }

  static detent_status move(const detent_context* context, detent_handle scene,
                            typename T::Mover* mover, const typename T::Vec* by,
                            const typename T::MoverSettings* settings, std::uint32_t layers,
                            detent_id ignored, typename T::Move* result) {
    return read_object<
        Scene>(context, kind, scene, [&](const Context&, const Scene& object) -> detent_status {
      if (mover == nullptr || by == nullptr) return DETENT_BAD_ARGUMENT;
      Input<N> in;
      const auto how = settings == nullptr ? MoverSettings<S, N>() : read(in, *settings);
      const auto way = Input<N>::vec(*by);
      const auto go =
          [&]<template <class, int> class Shape>(const Shape<S, N>& shape) -> detent_status {
        Mover<S, N, Shape> own{shape};
        own.ground = read_ground(in, *mover);
        if (!in.is_valid()) return DETENT_NOT_UNIT;
        const auto moved = MoverOf<N, Shape>::move(object, own, way, how, {layers, id_of(ignored)});
        Output<N>::shape(mover->shape, own.shape);
        write(own.ground, *mover);
        if (result != nullptr) *result = move_of(moved);
        return DETENT_OK;
      };
      switch (mover->shape.kind) {
        case DETENT_CAPSULE:
          return go(in.capsule(mover->shape));
        case DETENT_AABB:
          return go(in.aabb(mover->shape));
        default:
          return no_query(mover->shape.kind);
      }
    });
  }

  static detent_status clip_velocity(const typename T::Vec* velocity,
                                     const typename T::Move* result, typename T::Vec* clipped) {
    if (velocity == nullptr || result == nullptr || clipped == nullptr || result->count > 8) {
      return DETENT_BAD_ARGUMENT;
    }
    Input<N> in;
    MoveResult<S, N> own;
    own.count = result->count;
    for (std::size_t i = 0; i < own.count; ++i) {
      own.touched[i].normal = in.direction(result->touched[i].normal);
    }
    if (!in.is_valid()) return DETENT_NOT_UNIT;
    *clipped = Output<N>::vec(detent::clip_velocity(Input<N>::vec(*velocity), own));
    return DETENT_OK;
  }

 private:
  /// f(scene, cast, query) for the caller's moving shape.
  template <class F>
  static detent_status along(const detent_context* context, detent_handle scene,
                             const typename T::Shape* shape, const typename T::Direction* direction,
                             std::int32_t max_distance, const F& f) {
    return read_object<Scene>(
        context, kind, scene, [&](const Context&, const Scene& object) -> detent_status {
          if (shape == nullptr || direction == nullptr) return DETENT_BAD_ARGUMENT;
          Input<N> in;
          const auto way = in.direction(*direction);
          const auto ask =
              [&]<template <class, int> class Shape>(const Shape<S, N>& moving) -> detent_status {
            if (!in.is_valid()) return DETENT_NOT_UNIT;
            return f(object, Cast<Shape<S, N>>{moving, way, Input<N>::number(max_distance)},
                     SceneCastOf<N, Shape>());
          };
          switch (shape->kind) {
            case DETENT_SPHERE: {
              const auto sphere = in.sphere(*shape);
              return ask(Capsule<S, N>{sphere.center, sphere.center, sphere.radius});
            }
            case DETENT_SEGMENT: {
              const auto segment = in.segment(*shape);
              return ask(Capsule<S, N>{segment.start, segment.end, S(0)});
            }
            case DETENT_CAPSULE:
              return ask(in.capsule(*shape));
            case DETENT_AABB:
              return ask(in.aabb(*shape));
            case DETENT_OBB:
              return ask(in.obb(*shape));
            default:
              return no_query(shape->kind);
          }
        });
  }

  static Ground<S, N> read_ground(Input<N>& in, const typename T::Mover& mover) noexcept {
    Ground<S, N> ground;
    if (mover.is_grounded == 0) return ground;
    ground.is_grounded = true;
    ground.object = id_of(mover.object);
    ground.normal = in.direction(mover.normal);
    ground.frame = {mover.frame.index, mover.frame.generation};
    ground.local = Input<N>::vec(mover.local);
    ground.point = Input<N>::vec(mover.point);
    return ground;
  }
  static MoverSettings<S, N> read(Input<N>& in, const typename T::MoverSettings& given) noexcept {
    MoverSettings<S, N> own;
    own.up = in.direction(given.up);
    own.skin = Input<N>::number(given.skin);
    own.step_height = Input<N>::number(given.step_height);
    own.snap_distance = Input<N>::number(given.snap_distance);
    own.max_slope = Angle<S>::from_raw(given.max_slope);
    return own;
  }
  static void write(const Ground<S, N>& ground, typename T::Mover& mover) noexcept {
    mover.is_grounded = ground.is_grounded ? 1 : 0;
    mover.object = id_of(ground.object);
    mover.normal = Output<N>::direction(ground.normal);
    mover.frame = {ground.frame.index, ground.frame.generation};
    mover.local = Output<N>::vec(ground.local);
    mover.point = Output<N>::vec(ground.point);
  }
  static typename T::Move move_of(const MoveResult<S, N>& own) noexcept {
    typename T::Move result{};
    result.moved = Output<N>::vec(own.moved);
    result.carried = Output<N>::vec(own.carried);
    result.pushed = Output<N>::vec(own.pushed);
    result.count = static_cast<std::uint32_t>(own.count);
    result.is_stuck = own.is_stuck ? 1 : 0;
    for (std::size_t i = 0; i < own.count; ++i) {
      result.touched[i] = {id_of(own.touched[i].object), Output<N>::vec(own.touched[i].point),
                           Output<N>::direction(own.touched[i].normal)};
    }
    return result;
  }
};

}  // namespace detent::c
