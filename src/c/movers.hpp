// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "c/mover_casts.hpp"
#include "c/scenes.hpp"
#include "detent/scene/mover.hpp"

// Characters, and casts of round shapes in scenes.
namespace detent::c {

template <int N>
struct Movers {
  using T = Types<N>;
  using Scene = typename SceneOf<N>::type;
  static constexpr Kind kind = SceneOf<N>::kind;

  static detent_status cast(const detent_context* context, detent_handle scene,
                            const typename T::Shape* shape, const typename T::Direction* direction,
                            std::int32_t max_distance, std::uint32_t layers,
                            typename T::ObjectHit* hit) {
    return read_object<Scene>(context, kind, scene, [&](const Context&, const Scene& object) {
      if (shape == nullptr || direction == nullptr) return detent_status{DETENT_BAD_ARGUMENT};
      Input<N> in;
      const auto along = in.direction(*direction);
      Capsule<S, N> moving;
      switch (shape->kind) {
        case DETENT_SPHERE: {
          const auto sphere = in.sphere(*shape);
          moving = {sphere.center, sphere.center, sphere.radius};
          break;
        }
        case DETENT_CAPSULE:
          moving = in.capsule(*shape);
          break;
        case DETENT_SEGMENT: {
          const auto segment = in.segment(*shape);
          moving = {segment.start, segment.end, S(0)};
          break;
        }
        default:
          return shape->kind >= DETENT_SPHERE && shape->kind <= DETENT_COMPOUND
                     ? detent_status{DETENT_NO_QUERY}
                     : detent_status{DETENT_BAD_ARGUMENT};
      }
      if (!in.is_valid()) return detent_status{DETENT_NOT_UNIT};
      const auto found =
          object.nearest_hit(Cast{moving, along, Input<N>::number(max_distance)}, InLayers{layers});
      if (found && hit != nullptr) *hit = Scenes<N>::hit_of(*found);
      return yes_or_no(found.has_value());
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
    return read_object<Scene>(context, kind, scene, [&](const Context&, const Scene& object) {
      if (mover == nullptr || by == nullptr) return detent_status{DETENT_BAD_ARGUMENT};
      Input<N> in;
      auto own = read(in, *mover);
      const auto how = settings == nullptr ? MoverSettings<S, N>() : read(in, *settings);
      if (!in.is_valid()) return detent_status{DETENT_NOT_UNIT};
      const auto moved =
          own.move(object, Input<N>::vec(*by), how, [layers, ignored](const ObjectInfo& info) {
            return (info.layers & layers) != 0 && !(info.id == id_of(ignored));
          });
      write(own, *mover);
      if (result != nullptr) *result = move_of(moved);
      return detent_status{DETENT_OK};
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
  static Mover<S, N, Capsule> read(Input<N>& in, const typename T::Mover& mover) noexcept {
    Mover<S, N, Capsule> own{{Input<N>::vec(mover.shape.a), Input<N>::vec(mover.shape.b),
                              Input<N>::number(mover.shape.radius)}};
    if (mover.is_grounded == 0) return own;
    own.ground.is_grounded = true;
    own.ground.object = id_of(mover.object);
    own.ground.normal = in.direction(mover.normal);
    own.ground.frame = {mover.frame.index, mover.frame.generation};
    own.ground.local = Input<N>::vec(mover.local);
    own.ground.point = Input<N>::vec(mover.point);
    return own;
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
  static void write(const Mover<S, N, Capsule>& own, typename T::Mover& mover) noexcept {
    mover.shape = {Output<N>::vec(own.shape.a), Output<N>::vec(own.shape.b),
                   own.shape.radius.raw()};
    mover.is_grounded = own.ground.is_grounded ? 1 : 0;
    mover.object = id_of(own.ground.object);
    mover.normal = Output<N>::direction(own.ground.normal);
    mover.frame = {own.ground.frame.index, own.ground.frame.generation};
    mover.local = Output<N>::vec(own.ground.local);
    mover.point = Output<N>::vec(own.ground.point);
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
