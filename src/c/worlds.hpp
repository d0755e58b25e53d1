// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "c/body_shapes.hpp"
#include "c/scenes.hpp"
#include "detent/dynamics/dynamics.hpp"

namespace detent::c {

/// Worlds of spheres, boxes, capsules, solid hulls, compounds and, in 3D, surfaces, with all kinds of
/// joints.
template <int N>
struct WorldOf;
template <>
struct WorldOf<2> {
  using type = World<S, 2, Sphere, Aabb, Obb, Capsule, BodyHull, BodyCompound, DistanceJoint,
                     BallJoint, HingeJoint, WeldJoint, SliderJoint, WheelJoint>;
};
template <>
struct WorldOf<3> {
  using type =
      World<S, 3, Sphere, Aabb, Obb, Capsule, BodyHull, BodyCompound, BodyMesh, BodyHeightField,
            DistanceJoint, BallJoint, HingeJoint, WeldJoint, SliderJoint, WheelJoint, ConeJoint>;
};

/// The restored world of a snapshot, with the assets of a context.
template <int N>
[[nodiscard]] Restored restore_with(const Context& table, typename WorldOf<N>::type& world,
                                    std::span<const std::byte> bytes) {
  const auto hulls = table.assets<SolidHull<S, N>>().span();
  const auto compounds = table.assets<SolidCompound<S, N>>().span();
  if constexpr (N == 2) {
    return detent::restore(world, bytes, hulls, compounds);
  } else {
    return detent::restore(world, bytes, hulls, compounds, table.assets<MeshAsset<S>>().span(),
                           table.assets<FieldAsset<S>>().span());
  }
}
/// Whether a body can have this asset.
template <int N>
[[nodiscard]] bool bodies_can_have(const Context& table, const void* asset) {
  const auto has = [&](const auto& assets) {
    for (const auto& one : assets.span()) {
      if (&one == asset) return true;
    }
    return false;
  };
  if (N == 3 && (has(table.assets<MeshAsset<S>>()) || has(table.assets<FieldAsset<S>>()))) {
    return true;
  }
  return has(table.assets<SolidHull<S, N>>()) || has(table.assets<SolidCompound<S, N>>());
}

/// Worlds, the options of their bodies, and joints.
template <int N>
struct Worlds {
  using T = Types<N>;
  using World = typename WorldOf<N>::type;
  using Settings = typename World::Settings;
  using Options = typename World::Options;
  static constexpr Kind kind = N == 2 ? Kind::world2 : Kind::world3;
  static constexpr std::uint32_t every_lock = 63;  // the bits of AxisLock, in 2D too

  static detent_status default_settings(typename T::Settings* out) {
    if (out == nullptr) return DETENT_BAD_ARGUMENT;
    const Settings own;
    *out = {own.ticks_per_second,  own.substeps,           Output<N>::vec(own.gravity),
            own.margin.raw(),      own.push_speed.raw(),   own.bounce_threshold.raw(),
            own.sleep_speed.raw(), own.hold_distance.raw()};
    return DETENT_OK;
  }
  static detent_status default_options(typename T::BodyOptions* out) {
    if (out == nullptr) return DETENT_BAD_ARGUMENT;
    const Options own;
    *out = {};
    out->user = own.user;
    out->layers = own.layers;
    out->collides_with = own.collides_with;
    out->motion = static_cast<std::uint32_t>(own.motion);
    out->density = own.density.raw();
    out->friction = own.friction.raw();
    out->restitution = own.restitution.raw();
    out->rolling_resistance = own.rolling_resistance.raw();
    out->linear_damping = own.linear_damping.raw();
    out->angular_damping = own.angular_damping.raw();
    out->gravity_scale = own.gravity_scale.raw();
    out->locked = own.locked;
    out->is_sensor = own.is_sensor ? 1 : 0;
    out->is_fast = own.is_fast ? 1 : 0;
    return DETENT_OK;
  }

  static detent_status create(detent_context* context, const typename T::Settings* settings,
                              detent_handle* world) {
    Context* const table = table_of(context);
    if (table == nullptr) return DETENT_BAD_CONTEXT;
    if (world == nullptr) return DETENT_BAD_ARGUMENT;
    Settings own;
    if (settings != nullptr) {
      constexpr std::int32_t most = 32767;
      if (settings->ticks_per_second < 1 || settings->ticks_per_second > most ||
          settings->substeps < 1 || settings->substeps > most / settings->ticks_per_second ||
          settings->margin < 0 || settings->push_speed < 0 || settings->bounce_threshold < 0 ||
          settings->sleep_speed < 0 || settings->hold_distance < 0) {
        return DETENT_BAD_ARGUMENT;
      }
      own.ticks_per_second = settings->ticks_per_second;
      own.substeps = settings->substeps;
      own.gravity = Input<N>::vec(settings->gravity);
      own.margin = Input<N>::number(settings->margin);
      own.push_speed = Input<N>::number(settings->push_speed);
      own.bounce_threshold = Input<N>::number(settings->bounce_threshold);
      own.sleep_speed = Input<N>::number(settings->sleep_speed);
      own.hold_distance = Input<N>::number(settings->hold_distance);
    }
    return guarded(nullptr, [&] { return table->make<World>(kind, world, refers_to, own); });
  }
  static detent_status destroy(detent_context* context, detent_handle world) {
    return destroy_object(context, kind, world);
  }

  static detent_status add(detent_context* context, detent_handle world,
                           const typename T::Shape* shape, const typename T::BodyOptions* options,
                           detent_id* id) {
    const auto put = [&](const Context& table, World& object) -> detent_status {
      Options own;
      if (shape == nullptr || id == nullptr || !read_options(options, own)) {
        return DETENT_BAD_ARGUMENT;
      }
      return with_body_shape<N>(table, *shape, [&](const auto& read) -> detent_status {
        const auto added = object.add(read, own);
        if (!added) return DETENT_FULL;
        *id = id_of(*added);
        return DETENT_OK;
      });
    };
    return with_object<World>(context, kind, world, put);
  }
  static detent_status add_as(detent_context* context, detent_handle world, detent_id id,
                              const typename T::Shape* shape,
                              const typename T::BodyOptions* options) {
    const auto put = [&](const Context& table, World& object) -> detent_status {
      Options own;
      if (shape == nullptr || !read_options(options, own)) return DETENT_BAD_ARGUMENT;
      return with_body_shape<N>(table, *shape, [&](const auto& read) {
        return yes_or_no(object.put(id_of(id), read, own));
      });
    };
    return with_object<World>(context, kind, world, put);
  }
  static detent_status remove(detent_context* context, detent_handle world, detent_id id) {
    return change(context, world,
                  [&](World& object) { return yes_or_no(object.remove(id_of(id))); });
  }
  static detent_status step(detent_context* context, detent_handle world) {
    return change(context, world, [](World& object) -> detent_status {
      object.step();
      return DETENT_OK;
    });
  }

  static detent_status follow(detent_context* context, detent_handle scene, detent_handle world,
                              std::uint32_t sensors) {
    using Scene = typename SceneOf<N>::type;
    const auto put = [&](const Context& table, Scene& object) -> detent_status {
      const Slot* const slot = table.find(kind, world);
      if (slot == nullptr) return DETENT_BAD_HANDLE;
      if (slot->is_broken) return DETENT_BROKEN;
      if (sensors > 1) return DETENT_BAD_ARGUMENT;
      const auto& from = *static_cast<const World*>(slot->object);
      const bool had_room = detent::follow(
          object, from, [&](const BodyInfo& body) { return sensors == 1 || !body.is_sensor; });
      return had_room ? DETENT_OK : DETENT_FULL;
    };
    return with_object<Scene>(context, SceneOf<N>::kind, scene, put);
  }
  static detent_status part_of(const detent_context* context, detent_handle world, detent_id object,
                               detent_id* body, std::uint32_t* part) {
    return read(context, world, [&](const World& from) -> detent_status {
      const auto found = detent::part_of(from, id_of(object));
      if (!found) return DETENT_NO;
      if (body != nullptr) *body = id_of(found->body);
      if (part != nullptr) *part = found->part;
      return DETENT_OK;
    });
  }

  static detent_status body(const detent_context* context, detent_handle world, detent_id id,
                            typename T::Body* body) {
    return read_body(context, world, id, body != nullptr,
                     [&](const World& object) { *body = body_of(object, id_of(id)); });
  }
  static detent_status bodies(const detent_context* context, detent_handle world,
                              const detent_id* ids, std::uint32_t count, typename T::Body* bodies) {
    return read(context, world, [&](const World& object) -> detent_status {
      if (count != 0 && (ids == nullptr || bodies == nullptr)) return DETENT_BAD_ARGUMENT;
      for (std::uint32_t i = 0; i < count; ++i) {
        const auto id = id_of(ids[i]);
        bodies[i] = object.contains(id) ? body_of(object, id) : typename T::Body();
      }
      return DETENT_OK;
    });
  }
  static detent_status frame(const detent_context* context, detent_handle world, detent_id id,
                             typename T::Transform* frame) {
    return read_body(context, world, id, frame != nullptr, [&](const World& object) {
      *frame = Output<N>::transform(object.frame(id_of(id)));
    });
  }
  static detent_status info(const detent_context* context, detent_handle world, detent_id id,
                            detent_body_info* info) {
    return read_body(context, world, id, info != nullptr, [&](const World& object) {
      const auto own = *object.info(id_of(id));
      const auto& body = detail::WorldAccess::bodies(object)[id.index];
      *info = {own.user,
               own.layers,
               own.collides_with,
               static_cast<std::uint32_t>(own.motion),
               own.is_sensor ? 1u : 0u,
               own.is_asleep ? 1u : 0u,
               static_cast<std::uint32_t>(detail::part_count(body))};
    });
  }
  static detent_status set_position(detent_context* context, detent_handle world, detent_id id,
                                    const typename T::Vec* position) {
    return change_body(context, world, id, position != nullptr, [&](World& object) {
      object.set_position(id_of(id), Input<N>::vec(*position));
    });
  }
  static detent_status set_rotation(detent_context* context, detent_handle world, detent_id id,
                                    const typename T::Rotation* rotation) {
    return change(context, world, [&](World& object) -> detent_status {
      if (rotation == nullptr) return DETENT_BAD_ARGUMENT;
      Input<N> in;
      const auto axes = in.rotation(*rotation);
      if (!in.is_valid()) return DETENT_NOT_UNIT;
      return yes_or_no(object.set_rotation(id_of(id), axes));
    });
  }
  static detent_status set_filter(detent_context* context, detent_handle world, detent_id id,
                                  std::uint32_t layers, std::uint32_t collides_with) {
    return change(context, world, [&](World& object) {
      return yes_or_no(object.set_filter(id_of(id), layers, collides_with));
    });
  }
  static detent_status set_friction(detent_context* context, detent_handle world, detent_id id,
                                    std::int32_t friction) {
    return change_body(context, world, id, friction >= 0, [&](World& object) {
      object.set_friction(id_of(id), Input<N>::number(friction));
    });
  }
  static detent_status set_restitution(detent_context* context, detent_handle world, detent_id id,
                                       std::int32_t restitution) {
    return change_body(context, world, id, restitution >= 0, [&](World& object) {
      object.set_restitution(id_of(id), Input<N>::number(restitution));
    });
  }
  static detent_status set_sensor(detent_context* context, detent_handle world, detent_id id,
                                  std::uint32_t is_sensor) {
    return change_body(context, world, id, is_sensor <= 1,
                       [&](World& object) { object.set_sensor(id_of(id), is_sensor == 1); });
  }
  static detent_status set_gravity_scale(detent_context* context, detent_handle world, detent_id id,
                                         std::int32_t scale) {
    return change(context, world, [&](World& object) {
      return yes_or_no(object.set_gravity_scale(id_of(id), Input<N>::number(scale)));
    });
  }
  static detent_status set_damping(detent_context* context, detent_handle world, detent_id id,
                                   std::int32_t linear, std::int32_t angular) {
    return change_body(context, world, id, linear >= 0 && angular >= 0, [&](World& object) {
      object.set_damping(id_of(id), Input<N>::number(linear), Input<N>::number(angular));
    });
  }
  static detent_status set_locked(detent_context* context, detent_handle world, detent_id id,
                                  std::uint32_t locked) {
    return change_body(context, world, id, locked <= every_lock, [&](World& object) {
      object.set_locked(id_of(id), static_cast<std::uint8_t>(locked));
    });
  }
  static detent_status set_fast(detent_context* context, detent_handle world, detent_id id,
                                std::uint32_t is_fast) {
    return change_body(context, world, id, is_fast <= 1,
                       [&](World& object) { object.set_fast(id_of(id), is_fast == 1); });
  }
  static detent_status set_user(detent_context* context, detent_handle world, detent_id id,
                                std::uint64_t user) {
    return change(context, world,
                  [&](World& object) { return yes_or_no(object.set_user(id_of(id), user)); });
  }
  static detent_status set_gravity(detent_context* context, detent_handle world,
                                   const typename T::Vec* gravity) {
    return change(context, world, [&](World& object) -> detent_status {
      if (gravity == nullptr) return DETENT_BAD_ARGUMENT;
      object.set_gravity(Input<N>::vec(*gravity));
      return DETENT_OK;
    });
  }
  static detent_status set_velocity(detent_context* context, detent_handle world, detent_id id,
                                    const typename T::Vec* velocity) {
    return change_body(context, world, id, velocity != nullptr, [&](World& object) {
      object.set_velocity(id_of(id), Input<N>::vec(*velocity));
    });
  }
  static detent_status set_angular_velocity(detent_context* context, detent_handle world,
                                            detent_id id, const std::int32_t* velocity) {
    return turn(context, world, id, velocity, [](World& object, const BodyId& body, const auto& w) {
      object.set_angular_velocity(body, w);
    });
  }
  static detent_status apply_impulse(detent_context* context, detent_handle world, detent_id id,
                                     const typename T::Vec* impulse, const typename T::Vec* at) {
    return push(context, world, id, impulse, at, [](World& object, const auto&... arguments) {
      object.apply_impulse(arguments...);
    });
  }
  static detent_status apply_force(detent_context* context, detent_handle world, detent_id id,
                                   const typename T::Vec* force, const typename T::Vec* at) {
    return push(context, world, id, force, at,
                [](World& object, const auto&... arguments) { object.apply_force(arguments...); });
  }
  static detent_status apply_torque(detent_context* context, detent_handle world, detent_id id,
                                    const std::int32_t* torque) {
    return turn(context, world, id, torque, [](World& object, const BodyId& body, const auto& w) {
      object.apply_torque(body, w);
    });
  }

  static detent_status defaults(std::uint32_t which, typename T::Joint* joint) {
    if (joint == nullptr) return DETENT_BAD_ARGUMENT;
    return with_kind(which, [&](const auto& own) -> detent_status {
      *joint = joint_of(own);
      return DETENT_OK;
    });
  }
  static detent_status add_joint(detent_context* context, detent_handle world,
                                 const typename T::Joint* joint, detent_id* id) {
    return change(context, world, [&](World& object) -> detent_status {
      if (joint == nullptr || id == nullptr) return DETENT_BAD_ARGUMENT;
      return with_joint(*joint, [&](const auto& read) -> detent_status {
        if (!object.contains(read.a) || !object.contains(read.b) || read.a == read.b) {
          return DETENT_NO;
        }
        const auto added = object.add(read);
        if (!added) return DETENT_FULL;
        *id = {added->index, added->generation};
        return DETENT_OK;
      });
    });
  }
  static detent_status change_joint(detent_context* context, detent_handle world, detent_id id,
                                    const typename T::Joint* joint) {
    return change(context, world, [&](World& object) -> detent_status {
      if (joint == nullptr) return DETENT_BAD_ARGUMENT;
      return with_joint(
          *joint, [&](const auto& read) { return yes_or_no(object.change(joint_id(id), read)); });
    });
  }
  static detent_status remove_joint(detent_context* context, detent_handle world, detent_id id) {
    return change(context, world,
                  [&](World& object) { return yes_or_no(object.remove(joint_id(id))); });
  }
  static detent_status joint(const detent_context* context, detent_handle world, detent_id id,
                             typename T::Joint* joint) {
    return read(context, world, [&](const World& object) -> detent_status {
      if (joint == nullptr) return DETENT_BAD_ARGUMENT;
      for (std::uint32_t which = DETENT_DISTANCE_JOINT; which <= last_joint; ++which) {
        const auto status = with_kind(which, [&]<class Joint>(const Joint&) {
          const Joint* const found = object.template find_joint<Joint>(joint_id(id));
          if (found != nullptr) *joint = joint_of(*found);
          return yes_or_no(found != nullptr);
        });
        if (status == DETENT_OK) return DETENT_OK;
      }
      return DETENT_NO;
    });
  }
  static detent_status joint_force(const detent_context* context, detent_handle world, detent_id id,
                                   typename T::Vec* force) {
    return read(context, world, [&](const World& object) -> detent_status {
      if (force == nullptr) return DETENT_BAD_ARGUMENT;
      if (!object.contains(joint_id(id))) return DETENT_NO;
      *force = Output<N>::vec(object.joint_force(joint_id(id)));
      return DETENT_OK;
    });
  }
  static detent_status joint_torque(const detent_context* context, detent_handle world,
                                    detent_id id, std::int32_t* torque) {
    return read(context, world, [&](const World& object) -> detent_status {
      if (torque == nullptr) return DETENT_BAD_ARGUMENT;
      if (!object.contains(joint_id(id))) return DETENT_NO;
      const auto own = object.joint_torque(joint_id(id));
      for (std::size_t i = 0; i < own.size(); ++i) torque[i] = own[i].raw();
      return DETENT_OK;
    });
  }
  static detent_status joint_count(const detent_context* context, detent_handle world,
                                   std::uint32_t* count) {
    return write_from<World>(context, kind, world, count,
                             [](const World& object) { return object.joint_count(); });
  }
  static detent_status joint_ids(const detent_context* context, detent_handle world,
                                 detent_id* joints, std::uint32_t room, std::uint32_t* count) {
    return list(context, world, joints, room, count, [](const World& object, const auto& put) {
      object.for_each_joint([&](const JointId& id) { put({id.index, id.generation}); });
    });
  }
  static detent_status broken(const detent_context* context, detent_handle world, detent_id* joints,
                              std::uint32_t room, std::uint32_t* count) {
    return list(context, world, joints, room, count, [](const World& object, const auto& put) {
      for (std::size_t i = 0; i < object.broken_count(); ++i) {
        put({object.broken(i).index, object.broken(i).generation});
      }
    });
  }
  static detent_status local_point(const detent_context* context, detent_handle world, detent_id id,
                                   const typename T::Vec* point, typename T::Vec* local) {
    const bool is_valid = point != nullptr && local != nullptr;
    return read_body(context, world, id, is_valid, [&](const World& object) {
      *local = Output<N>::vec(object.local_point(id_of(id), Input<N>::vec(*point)));
    });
  }
  static detent_status local_frame(const detent_context* context, detent_handle world, detent_id id,
                                   const typename T::Rotation* frame, typename T::Rotation* local) {
    return read(context, world, [&](const World& object) -> detent_status {
      if (frame == nullptr || local == nullptr) return DETENT_BAD_ARGUMENT;
      Input<N> in;
      const auto axes = in.rotation(*frame);
      if (!in.is_valid()) return DETENT_NOT_UNIT;
      if (!object.contains(id_of(id))) return DETENT_NO;
      *local = Output<N>::rotation(object.local_frame(id_of(id), axes));
      return DETENT_OK;
    });
  }

  static detent_status size(const detent_context* context, detent_handle world,
                            std::uint32_t* size) {
    return write_from<World>(context, kind, world, size,
                             [](const World& object) { return object.size(); });
  }
  static detent_status body_ids(const detent_context* context, detent_handle world, detent_id* ids,
                                std::uint32_t room, std::uint32_t* count) {
    return list(context, world, ids, room, count, [](const World& object, const auto& put) {
      object.for_each([&](const BodyInfo& body) { put(id_of(body.id)); });
    });
  }
  static detent_status touching(const detent_context* context, detent_handle world, detent_id body,
                                detent_touch* touches, std::uint32_t room, std::uint32_t* count) {
    const auto only = id_of(body);
    return list(context, world, touches, room, count, [&](const World& object, const auto& put) {
      object.for_each_touch([&](const TouchEvent& touch) {
        if (only == BodyId{} || touch.a == only || touch.b == only) put(touch_of(touch));
      });
    });
  }
  static detent_status contacts(const detent_context* context, detent_handle world, detent_id body,
                                typename T::WorldContact* contacts, std::uint32_t room,
                                std::uint32_t* count) {
    return list(context, world, contacts, room, count, [&](const World& object, const auto& put) {
      const auto visit = [&](const WorldContact<S, N>& contact) { put(contact_of(contact)); };
      id_of(body) == BodyId{} ? object.for_each_contact(visit)
                              : object.for_each_contact(id_of(body), visit);
    });
  }
  static detent_status events(const detent_context* context, detent_handle world,
                              detent_touch* events, std::uint32_t room, std::uint32_t* count) {
    return list(context, world, events, room, count, [](const World& object, const auto& put) {
      for (std::size_t i = 0; i < object.event_count(); ++i) put(touch_of(object.event(i)));
    });
  }
  static detent_status digest(const detent_context* context, detent_handle world,
                              std::uint64_t* digest) {
    return write_from<World>(context, kind, world, digest,
                             [](const World& object) { return detent::digest(object); });
  }
  static detent_status digest_of(const detent_context* context, detent_handle world, detent_id id,
                                 std::uint64_t* digest) {
    return read_body(context, world, id, digest != nullptr,
                     [&](const World& object) { *digest = detent::digest_of(object, id_of(id)); });
  }
  static detent_status snapshot(const detent_context* context, detent_handle world, void* bytes,
                                std::uint32_t room, std::uint32_t* size) {
    return read(context, world, [&](const World& object) {
      return write_snapshot(bytes, room, size,
                            [&](auto span) { return detent::snapshot(object, span); });
    });
  }
  static detent_status restore(detent_context* context, detent_handle world, const void* bytes,
                               std::uint32_t size) {
    const auto put = [&](const Context& table, World& object) -> detent_status {
      if (bytes == nullptr && size != 0) return DETENT_BAD_ARGUMENT;
      return status_of(
          restore_with<N>(table, object, std::span(static_cast<const std::byte*>(bytes), size)));
    };
    return with_object<World>(context, kind, world, put);
  }

  static detent_status words(const detent_context* context, detent_handle world,
                             std::uint32_t* words) {
    return read_object<World>(context, kind, world, [&](const Context& table, const World&) {
      const Words* const own = table.find(kind, world)->words;
      if (own == nullptr) return detent_status{DETENT_NO};
      if (words == nullptr && own->count != 0) return detent_status{DETENT_BAD_ARGUMENT};
      std::copy_n(own->values.begin(), own->count, words);
      return detent_status{DETENT_OK};
    });
  }
  static detent_status set_words(detent_context* context, detent_handle world,
                                 const std::uint32_t* words) {
    return with_object<World>(context, kind, world, [&](const Context& table, World&) {
      Words* const own = table.find(kind, world)->words;
      if (own == nullptr) return detent_status{DETENT_NO};
      if (words == nullptr && own->count != 0) return detent_status{DETENT_BAD_ARGUMENT};
      std::copy_n(words, own->count, own->values.begin());
      return detent_status{DETENT_OK};
    });
  }

 private:
  template <class F>
  static detent_status change(detent_context* context, detent_handle world, const F& f) {
    return with_object<World>(context, kind, world,
                              [&](const Context&, World& object) { return f(object); });
  }
  template <class F>
  static detent_status read(const detent_context* context, detent_handle world, const F& f) {
    return read_object<World>(context, kind, world,
                              [&](const Context&, const World& object) { return f(object); });
  }

  /// Writes the elements of a list to the caller's memory: all(world, put) calls put with each.
  template <class T, class All>
  static detent_status list(const detent_context* context, detent_handle world, T* out,
                            std::uint32_t room, std::uint32_t* count, const All& all) {
    return read(context, world, [&](const World& object) -> detent_status {
      if (count == nullptr || (out == nullptr && room != 0)) return DETENT_BAD_ARGUMENT;
      *count = 0;
      all(object, [&](const T& element) {
        if (*count < room) out[*count] = element;
        ++*count;
      });
      return DETENT_OK;
    });
  }
  static detent_touch touch_of(const TouchEvent& touch) noexcept {
    return {id_of(touch.a), id_of(touch.b), touch.begins ? 1u : 0u, touch.part_a, touch.part_b};
  }

  static typename T::WorldContact contact_of(const WorldContact<S, N>& own) noexcept {
    typename T::WorldContact contact{};
    contact.a = id_of(own.a);
    contact.b = id_of(own.b);
    contact.part_a = own.part_a;
    contact.part_b = own.part_b;
    contact.triangle = own.triangle;
    contact.normal = Output<N>::direction(own.normal);
    contact.impulse = own.impulse.raw();
    contact.friction = Output<N>::vec(own.friction);
    contact.count = static_cast<std::uint32_t>(own.count);
    for (std::size_t i = 0; i < own.count; ++i) {
      const auto& point = own.points[i];
      contact.points[i] = {Output<N>::vec(point.point), point.separation.raw(), point.impulse.raw(),
                           point.feature};
    }
    return contact;
  }

  /// f(world) if there is such a body and the arguments are valid.
  template <class F>
  static detent_status change_body(detent_context* context, detent_handle world, detent_id id,
                                   bool is_valid, const F& f) {
    return change(context, world, [&](World& object) { return if_body(object, id, is_valid, f); });
  }
  template <class F>
  static detent_status read_body(const detent_context* context, detent_handle world, detent_id id,
                                 bool is_valid, const F& f) {
    return read(context, world,
                [&](const World& object) { return if_body(object, id, is_valid, f); });
  }
  template <class Object, class F>
  static detent_status if_body(Object& object, detent_id id, bool is_valid, const F& f) {
    if (!is_valid) return DETENT_BAD_ARGUMENT;
    if (!object.contains(id_of(id))) return DETENT_NO;
    f(object);
    return DETENT_OK;
  }
  /// f(world, body, vector, point), without the point if `at` is null.
  template <class F>
  static detent_status push(detent_context* context, detent_handle world, detent_id id,
                            const typename T::Vec* vector, const typename T::Vec* at, const F& f) {
    return change_body(context, world, id, vector != nullptr, [&](World& object) {
      const auto read = Input<N>::vec(*vector);
      if (at == nullptr) return f(object, id_of(id), read);
      f(object, id_of(id), read, Input<N>::vec(*at));
    });
  }
  /// f(world, body, numbers) for numbers about the axes.
  template <class F>
  static detent_status turn(detent_context* context, detent_handle world, detent_id id,
                            const std::int32_t* numbers, const F& f) {
    return change_body(context, world, id, numbers != nullptr, [&](World& object) {
      auto read = object.angular_velocity(id_of(id));
      for (std::size_t i = 0; i < read.size(); ++i) read[i] = Input<N>::number(numbers[i]);
      f(object, id_of(id), read);
    });
  }

  static bool refers_to(const void* world, const void* asset) {
    const auto& bodies = detail::WorldAccess::bodies(*static_cast<const World*>(world));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      bool does = false;
      bodies[i].shape.visit([&](const auto& shape) {
        if constexpr (requires { shape.asset; }) does = shape.asset == asset;
      });
      if (bodies[i].generation != 0 && does) return true;
    }
    return false;
  }

  static JointId joint_id(const detent_id& id) noexcept { return {id.index, id.generation}; }
  static constexpr std::uint32_t last_joint = N == 2 ? DETENT_WHEEL_JOINT : DETENT_CONE_JOINT;
  /// f(joint) with a default one of this kind.
  template <class F>
  static detent_status with_kind(std::uint32_t which, const F& f) {
    switch (which) {
      case DETENT_DISTANCE_JOINT:
        return f(DistanceJoint<S, N>());
      case DETENT_BALL_JOINT:
        return f(BallJoint<S, N>());
      case DETENT_HINGE_JOINT:
        return f(HingeJoint<S, N>());
      case DETENT_WELD_JOINT:
        return f(WeldJoint<S, N>());
      case DETENT_SLIDER_JOINT:
        return f(SliderJoint<S, N>());
      case DETENT_WHEEL_JOINT:
        return f(WheelJoint<S, N>());
      case DETENT_CONE_JOINT:
        if constexpr (N == 3) return f(ConeJoint<S, N>());
        [[fallthrough]];
      default:
        return DETENT_BAD_ARGUMENT;
    }
  }
  /// Calls f(field, number) for the fields of a joint that are plain numbers.
  template <class Joint, class Given, class F>
  static void for_numbers(Joint& joint, Given& given, const F& f) {
    f(joint.break_force, given.break_force);
    if constexpr (requires { joint.least; }) {
      f(joint.least, given.lower);
      f(joint.most, given.upper);
    }
    if constexpr (requires { joint.lower; }) {
      f(joint.lower, given.lower);
      f(joint.upper, given.upper);
    }
    if constexpr (requires { joint.cone_angle; }) f(joint.cone_angle, given.cone_angle);
    if constexpr (requires { joint.motor_speed; }) f(joint.motor_speed, given.motor_speed);
    if constexpr (requires { joint.motor_torque; }) f(joint.motor_torque, given.motor_force);
    if constexpr (requires { joint.motor_force; }) f(joint.motor_force, given.motor_force);
    if constexpr (requires { joint.max_force; }) f(joint.max_force, given.motor_force);
    if constexpr (requires { joint.length; }) f(joint.length, given.length);
    if constexpr (requires { joint.angle; }) f(joint.angle, given.length);
    if constexpr (requires { joint.frequency; }) {
      f(joint.frequency, given.frequency);
      f(joint.damping_ratio, given.damping_ratio);
    }
  }
  /// f(joint) for the caller's joint.
  template <class F>
  static detent_status with_joint(const typename T::Joint& given, const F& f) {
    if (given.collide > 1 || given.has_limits > 1 || given.break_force < 0 ||
        given.motor_force < 0 || given.frequency < 0 || given.damping_ratio < 0 ||
        given.cone_angle < 0) {
      return DETENT_BAD_ARGUMENT;
    }
    return with_kind(given.kind, [&](auto joint) -> detent_status {
      Input<N> in;
      joint.a = id_of(given.a);
      joint.b = id_of(given.b);
      joint.anchor_a = Input<N>::vec(given.anchor_a);
      joint.anchor_b = Input<N>::vec(given.anchor_b);
      joint.collide = given.collide != 0;
      if constexpr (requires { joint.frame_a; }) {
        joint.frame_a = in.rotation(given.frame_a);
        joint.frame_b = in.rotation(given.frame_b);
      }
      if constexpr (requires { joint.has_limits; }) joint.has_limits = given.has_limits != 0;
      for_numbers(joint, given, [](S& field, std::int32_t raw) { field = Input<N>::number(raw); });
      return in.is_valid() ? f(joint) : DETENT_NOT_UNIT;
    });
  }
  template <class Joint>
  static typename T::Joint joint_of(const Joint& joint) noexcept {
    typename T::Joint given{};
    given.kind = detail::joint_tag<Joint>;
    given.a = id_of(joint.a);
    given.b = id_of(joint.b);
    given.anchor_a = Output<N>::vec(joint.anchor_a);
    given.anchor_b = Output<N>::vec(joint.anchor_b);
    given.frame_a = given.frame_b = Output<N>::rotation(Rotation<S, N>());
    given.collide = joint.collide ? 1 : 0;
    if constexpr (requires { joint.frame_a; }) {
      given.frame_a = Output<N>::rotation(joint.frame_a);
      given.frame_b = Output<N>::rotation(joint.frame_b);
    }
    if constexpr (requires { joint.has_limits; }) given.has_limits = joint.has_limits ? 1 : 0;
    for_numbers(joint, given, [](const S& field, std::int32_t& raw) { raw = field.raw(); });
    return given;
  }

  static bool read_options(const typename T::BodyOptions* options, Options& own) noexcept {
    if (options == nullptr) return true;
    if (options->motion > DETENT_FIXED_BODY || options->friction < 0 || options->restitution < 0 ||
        options->rolling_resistance < 0 || options->linear_damping < 0 ||
        options->angular_damping < 0 || options->locked > every_lock || options->is_sensor > 1 ||
        options->is_fast > 1) {
      return false;
    }
    own.motion = static_cast<BodyMotion>(options->motion);
    own.density = Input<N>::number(options->density);
    own.friction = Input<N>::number(options->friction);
    own.restitution = Input<N>::number(options->restitution);
    own.rolling_resistance = Input<N>::number(options->rolling_resistance);
    own.linear_damping = Input<N>::number(options->linear_damping);
    own.angular_damping = Input<N>::number(options->angular_damping);
    own.velocity = Input<N>::vec(options->velocity);
    for (std::size_t i = 0; i < own.angular_velocity.size(); ++i) {
      own.angular_velocity[i] = Input<N>::number(options->angular_velocity[i]);
    }
    own.gravity_scale = Input<N>::number(options->gravity_scale);
    own.locked = static_cast<std::uint8_t>(options->locked);
    own.is_sensor = options->is_sensor != 0;
    own.is_fast = options->is_fast != 0;
    own.layers = options->layers;
    own.collides_with = options->collides_with;
    own.user = options->user;
    return true;
  }

  static typename T::Body body_of(const World& world, const BodyId& id) noexcept {
    typename T::Body body;
    body.position = Output<N>::vec(world.position(id));
    body.rotation = Output<N>::rotation(world.rotation(id));
    body.velocity = Output<N>::vec(world.velocity(id));
    const auto spin = world.angular_velocity(id);
    for (std::size_t i = 0; i < spin.size(); ++i) body.angular_velocity[i] = spin[i].raw();
    body.is_asleep = world.is_asleep(id) ? 1 : 0;
    return body;
  }
};

}  // namespace detent::c
