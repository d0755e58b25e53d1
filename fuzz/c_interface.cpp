// SPDX-License-Identifier: MIT
//
// Any sequence of calls of the C interface, with null pointers, wrong, stale or mistyped handles,
// and nonsensical numbers, returns a status and breaks nothing: the context can be closed, all its
// memory is freed, and writes stay within the given room.

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "detent.h"
#include "source.hpp"

namespace detent::fuzz {
namespace {

std::size_t blocks = 0;

detent_allocator counted() {
  return {nullptr,
          [](void*, std::size_t size) -> void* {
            ++blocks;
            return std::malloc(size);
          },
          [](void*, void* memory, std::size_t) {
            --blocks;
            std::free(memory);
          }};
}

/// Calls functions with arguments read from bytes.
class Caller {
 public:
  explicit Caller(Bytes bytes) : source_(bytes) {
    const auto hooks = counted();
    require(detent_open(&context_, &hooks) == DETENT_OK, [] { return "it does not open"; });
  }

  void run() {
    // Usually start with a scene and a world with some contents.
    if (source_.below(8) != 7) {
      for (const std::size_t which : {0, 13, 2, 33, 13, 33, 4}) check(call(which));
    }
    while (!source_.rest().empty()) check(call(source_.below(77)));
    std::uint32_t count = 0;
    check(detent_count(&context_, &count));
    require(detent_close(&context_) == DETENT_OK, [] { return "it does not close"; });
    require(blocks == 0, [] { return "memory is lost"; });
    for (const auto handle : handles_) {
      require(detent_scene3_optimize(&context_, handle) == DETENT_BAD_CONTEXT,
              [] { return "a closed context takes a handle"; });
    }
  }

 private:
  static constexpr std::uint32_t room = 4;
  static constexpr std::uint8_t guard = 0xa7;
  static constexpr std::size_t compound_kind = 12, session_kind = 14, replay_kind = 16;

  /// A list with room for four, followed by a guard.
  template <class T>
  struct List {
    std::array<T, room> items;
    std::array<std::uint8_t, 64> behind;
    List() {
      std::memset(&items, 0, sizeof items);
      behind.fill(guard);
    }
    void check() const {
      for (const auto byte : behind) {
        require(byte == guard, [] { return "it writes beyond its room"; });
      }
    }
  };

  static void check(detent_status status) {
    require(status >= DETENT_OTHER_ASSET && status <= DETENT_OK && status != DETENT_BROKEN &&
                status != DETENT_NO_MEMORY,
            [&] { return "status " + std::to_string(status); });
  }

  std::int32_t number() {
    switch (source_.below(4)) {
      case 0:
        return static_cast<std::int32_t>(source_.word(4));
      case 1:
        return static_cast<std::int32_t>(source_.word(2)) - 32768;
      case 2:
        return 65536 * (static_cast<std::int32_t>(source_.byte()) - 128);
      default:
        return source_.byte() < 128 ? INT32_MIN : INT32_MAX;
    }
  }
  detent_vec3 vec3() {
    const auto x = number(), y = number();
    return {x, y, number()};
  }
  detent_vec2 vec2() {
    const auto x = number();
    return {x, number()};
  }
  /// Usually an axis; sometimes not a unit vector.
  detent_direction3 direction3() {
    const auto choice = source_.below(16);
    if (choice == 15) return {number(), 0, 0};
    detent_direction3 d{};
    (choice % 3 == 0 ? d.x : choice % 3 == 1 ? d.y : d.z) = choice < 8 ? 1 << 30 : -(1 << 30);
    return d;
  }
  detent_direction2 direction2() {
    const auto d = direction3();
    return {d.x, d.z == 0 ? d.y : d.z};
  }
  detent_rotation3 rotation3() {
    const auto a = direction3(), b = direction3();
    return {{a, b, direction3()}};
  }
  detent_shape3 shape3() {
    detent_shape3 shape{};
    shape.kind = static_cast<std::uint32_t>(source_.below(14));
    shape.asset = handle(shape.kind == DETENT_MESH       ? 5
                         : shape.kind == DETENT_HULL     ? 7
                         : shape.kind == DETENT_COMPOUND ? compound_kind
                                                         : 8);
    if (shape.kind == DETENT_HULL && source_.below(2) == 1) shape.asset = handle(10);
    switch (shape.kind) {
      case DETENT_OBB:
        shape.as.obb = {vec3(), vec3(), rotation3()};
        break;
      case DETENT_PLANE:
        shape.as.plane = {direction3(), number()};
        break;
      case DETENT_HULL:
      case DETENT_MESH:
      case DETENT_COMPOUND:
        shape.as.placed = {vec3(), rotation3(), source_.below(2) == 0 ? 65536 : number()};
        break;
      default:
        shape.as.triangle = {vec3(), vec3(), vec3()};
    }
    return shape;
  }
  detent_shape2 shape2() {
    detent_shape2 shape{};
    shape.kind = static_cast<std::uint32_t>(source_.below(13));
    shape.asset = handle(6);
    if (shape.kind == DETENT_PLANE) {
      shape.as.plane = {direction2(), number()};
    } else if (shape.kind == DETENT_OBB || shape.kind == DETENT_HULL) {
      shape.as.obb = {vec2(), vec2(), {{direction2(), direction2()}}};
    } else {
      shape.as.triangle = {vec2(), vec2(), vec2()};
    }
    return shape;
  }
  /// Usually the last handle of a kind (the lowest five bits of each); occasionally an earlier one,
  /// one of another kind, or any number.
  detent_handle handle(std::size_t kind) {
    const auto choice = source_.below(32);
    if (choice == 31) return static_cast<detent_handle>(source_.word(4));
    if (choice < 4) return handles_[choice];
    return last_[kind];
  }
  detent_id id() {
    const auto choice = source_.below(16);
    if (choice == 15) {
      const auto index = static_cast<std::uint32_t>(source_.word(3));
      return {index, static_cast<std::uint32_t>(source_.word(4))};
    }
    return ids_[choice % ids_.size()];  // of scenes or worlds: the indices are the same
  }
  detent_traits traits() {
    const std::uint64_t user = source_.byte();
    const std::uint32_t layers = source_.byte();
    const auto motion = static_cast<std::uint32_t>(source_.below(3));
    return {user, layers, motion, source_.below(4) == 3 ? id() : detent_id{}};
  }
  detent_joint3 joint3() {
    detent_joint3 joint{};
    detent_joint3_defaults(static_cast<std::uint32_t>(source_.below(8)), &joint);
    joint.a = id();
    joint.b = id();
    joint.anchor_a = vec3();
    joint.anchor_b = vec3();
    if (source_.below(8) == 7) joint.frame_a = rotation3();
    joint.collide = static_cast<std::uint32_t>(source_.below(16)) / 5;
    joint.has_limits = static_cast<std::uint32_t>(source_.below(2));
    for (auto* field :
         {&joint.break_force, &joint.lower, &joint.upper, &joint.motor_speed, &joint.motor_force,
          &joint.length, &joint.frequency, &joint.damping_ratio}) {
      if (source_.below(4) == 3) *field = number();
    }
    return joint;
  }
  /// The pointer, or occasionally null.
  template <class T>
  T* or_null(T* pointer) {
    return source_.below(32) == 31 ? nullptr : pointer;
  }

  template <class Make>
  detent_status create(const Make& make) {
    detent_handle made = 0;
    const auto status = make(or_null(&made));
    if (made != 0) {
      handles_[next_handle_++ % handles_.size()] = made;
      last_[made & 31] = made;
    }
    return status;
  }
  template <class Add>
  detent_status add(const Add& add) {
    detent_id made{};
    const auto status = add(or_null(&made));
    if (status == DETENT_OK) ids_[next_id_++ % ids_.size()] = made;
    return status;
  }
  template <class T, class Ask>
  detent_status ask(const Ask& ask) {
    List<T> list;
    std::uint32_t count = 0;
    const auto status = ask(or_null(list.items.data()), or_null(&count));
    list.check();
    return status;
  }

  detent_status call(std::size_t which) {
    detent_context* const context = or_null(&context_);
    const auto layers = static_cast<std::uint32_t>(source_.byte());
    std::uint64_t digest = 0;
    std::uint32_t count = 0;
    switch (which) {
      case 0:
        return create([&](auto* out) { return detent_scene3_create(context, out); });
      case 1:
        return create([&](auto* out) { return detent_scene2_create(context, out); });
      case 2: {
        detent_world3_settings settings{};
        detent_world3_default_settings(&settings);
        if (source_.below(8) == 7) settings.ticks_per_second = number();
        if (source_.below(8) == 7) settings.gravity = vec3();
        if (source_.below(8) == 7) settings.margin = number();
        settings.substeps = static_cast<std::int32_t>(4 - source_.below(5));
        if (settings.substeps == 2) settings.hold_distance = 0;
        return create(
            [&](auto* out) { return detent_world3_create(context, or_null(&settings), out); });
      }
      case 3:
        return create([&](auto* out) { return detent_world2_create(context, nullptr, out); });
      case 4: {
        const detent_vec3 vertices[3] = {vec3(), vec3(), vec3()};
        const auto last = static_cast<std::uint32_t>(source_.below(4));
        const std::uint32_t faces[3] = {0, 1, last};
        const auto name = static_cast<std::uint32_t>(source_.below(4));
        return create([&](auto* out) {
          return detent_mesh_create(context, name, or_null(vertices), 3, or_null(faces), 1, out);
        });
      }
      case 5: {
        const detent_vec3 points[2] = {vec3(), vec3()};
        const auto name = static_cast<std::uint32_t>(source_.below(4));
        const auto size = static_cast<std::uint32_t>(source_.below(3));
        return create([&](auto* out) {
          return detent_hull3_create(context, name, or_null(points), size, out);
        });
      }
      case 6: {
        const std::int32_t heights[4] = {number(), number(), number(), number()};
        const detent_vec2 corner = vec2();
        const auto cell = number();
        const auto rows = static_cast<std::uint32_t>(1 + source_.below(2));
        const auto name = static_cast<std::uint32_t>(source_.below(4));
        return create([&](auto* out) {
          return detent_height_field_create(context, name, or_null(&corner), cell, 2, rows,
                                            or_null(heights), out);
        });
      }
      case 7: {
        const detent_vec2 points[2] = {vec2(), vec2()};
        return create([&](auto* out) { return detent_hull2_create(context, 1, points, 2, out); });
      }
      case 8:
        return detent_scene3_destroy(context, handle(2));
      case 9:
        return detent_scene2_destroy(context, handle(1));
      case 10:
        return detent_world3_destroy(context, handle(4));
      case 11:
        return detent_world2_destroy(context, handle(3));
      case 12:
        return detent_asset_destroy(context, handle(5 + source_.below(8)));
      case 13:
      case 14:
      case 15: {
        const auto shape = shape3();
        const auto with = traits();
        const auto scene = handle(2);
        return add([&](auto* out) {
          return detent_scene3_add(context, scene, or_null(&shape), or_null(&with), out);
        });
      }
      case 16: {
        const auto shape = shape2();
        const auto scene = handle(1);
        return add([&](auto* out) {
          return detent_scene2_add(context, scene, or_null(&shape), nullptr, out);
        });
      }
      case 17: {
        const auto shape = shape3();
        auto where = id();
        where.index &= 0xffff;  // a list of that length, not of a million
        return detent_scene3_add_as(context, handle(2), where, or_null(&shape), nullptr);
      }
      case 18:
        return detent_scene3_remove(context, handle(2), id());
      case 19: {
        const auto shape = shape3();
        const auto scene = handle(2);
        return detent_scene3_replace(context, scene, id(), or_null(&shape));
      }
      case 20: {
        const auto by = vec3();
        const auto scene = handle(2);
        return detent_scene3_move(context, scene, id(), or_null(&by));
      }
      case 21: {
        detent_shape3 shape{};
        detent_traits with{};
        const auto scene = handle(2);
        return detent_scene3_object(context, scene, id(), or_null(&shape), or_null(&with));
      }
      case 22: {
        const auto with = traits();
        const auto scene = handle(2);
        return detent_scene3_set_traits(context, scene, id(), or_null(&with));
      }
      case 23:
        return detent_scene3_optimize(context, handle(2));
      case 24: {
        const detent_ray3 ray{vec3(), direction3(), number()};
        const auto scene = handle(2);
        return ask<detent_object_hit3>([&](auto* hits, auto* number_of) {
          return detent_scene3_raycast_all(context, scene, or_null(&ray), layers, hits, room,
                                           number_of);
        });
      }
      case 25: {
        const detent_ray3 rays[2] = {{vec3(), direction3(), number()},
                                     {vec3(), direction3(), number()}};
        const auto scene = handle(2);
        return ask<detent_object_hit3>([&](auto* hits, auto*) {
          return detent_scene3_raycast_many(context, scene, or_null(rays), 2, layers, hits);
        });
      }
      case 26: {
        const detent_ray2 ray{vec2(), direction2(), number()};
        detent_object_hit2 hit{};
        return detent_scene2_raycast(context, handle(1), or_null(&ray), layers, or_null(&hit));
      }
      case 27: {
        const auto question = shape3();
        const auto scene = handle(2);
        return ask<detent_found>([&](auto* found, auto* number_of) {
          return detent_scene3_all(context, scene, or_null(&question), layers, found, room,
                                   number_of);
        });
      }
      case 28: {
        const auto question = shape2();
        detent_found found{};
        return detent_scene2_nearest(context, handle(1), or_null(&question), layers,
                                     or_null(&found));
      }
      case 29: {
        const auto scene = handle(2);
        return ask<detent_pair>([&](auto* pairs, auto* number_of) {
          return detent_scene3_overlaps(context, scene, pairs, room, number_of);
        });
      }
      case 30:
        return detent_scene3_digest(context, handle(2), or_null(&digest));
      case 31:
        save(detent_scene3_snapshot, context, 2);
        return DETENT_OK;
      case 32:
        return detent_scene3_restore(context, handle(2), or_null(saved()), saved_size_);
      case 33: {
        auto shape = shape3();
        if (source_.below(4) != 3) shape.kind = DETENT_AABB;
        const auto world = handle(4);
        detent_body3_options options{};
        detent_body3_default_options(&options);
        options.motion = static_cast<std::uint32_t>(source_.below(16)) / 5;
        options.is_fast = static_cast<std::uint32_t>(source_.below(16)) / 7;
        if (source_.below(16) == 15) options.density = number();
        if (source_.below(16) == 15) options.friction = number();
        if (source_.below(16) == 15) {
          options.restitution = number();
          options.rolling_resistance = number();
        }
        if (source_.below(16) == 15) options.velocity = vec3();
        if (source_.below(16) == 15) options.angular_velocity[1] = number();
        return add([&](auto* out) {
          return detent_world3_add(context, world, or_null(&shape), or_null(&options), out);
        });
      }
      case 34: {
        const auto shape = shape2();
        const auto world = handle(3);
        return add([&](auto* out) {
          return detent_world2_add(context, world, or_null(&shape), nullptr, out);
        });
      }
      case 35:
        return detent_world3_remove(context, handle(4), id());
      case 36:
        return detent_world3_step(context, handle(4));
      case 37:
        return detent_world2_step(context, handle(3));
      case 38: {
        const detent_id ids[2] = {id(), id()};
        const auto world = handle(4);
        return ask<detent_body3>([&](auto* bodies, auto*) {
          return detent_world3_bodies(context, world, or_null(ids), 2, bodies);
        });
      }
      case 39: {
        const auto velocity = vec3();
        const auto world = handle(4);
        return detent_world3_set_velocity(context, world, id(), or_null(&velocity));
      }
      case 40: {
        const std::int32_t spin[3] = {number(), number(), number()};
        const auto world = handle(4);
        return detent_world3_set_angular_velocity(context, world, id(), or_null(spin));
      }
      case 41: {
        const auto world = handle(4);
        return ask<detent_touch>([&](auto* events, auto* number_of) {
          return detent_world3_events(context, world, events, room, number_of);
        });
      }
      case 42:
        save(detent_world3_snapshot, context, 4);
        return detent_world3_digest_of(context, handle(4), id(), or_null(&digest));
      case 43: {
        const auto a = shape3(), b = shape3();
        detent_manifold3 contact{};
        return detent_contact3(or_null(&a), or_null(&b), or_null(&contact));
      }
      case 44: {
        const auto a = shape3(), b = shape3();
        detent_vec3 one{}, other{};
        return detent_closest_points3(or_null(&a), or_null(&b), or_null(&one), or_null(&other));
      }
      case 45: {
        const auto a = shape3(), b = shape3();
        const auto along = direction3();
        const auto length = number();
        detent_hit3 hit{};
        return detent_cast3(or_null(&a), or_null(&along), length, or_null(&b), or_null(&hit));
      }
      case 46: {
        const auto a = shape3(), b = shape3();
        const detent_sweep3 sweep_a{vec3(), vec3(), rotation3(), rotation3()};
        const detent_sweep3 sweep_b{vec3(), vec3(), rotation3(), rotation3()};
        detent_impact impact{};
        return detent_time_of_impact3(or_null(&a), or_null(&sweep_a), or_null(&b),
                                      or_null(&sweep_b), number(), or_null(&impact));
      }
      case 47:
      case 48: {
        const auto joint = joint3();
        const auto world = handle(4);
        return add([&](auto* out) {
          return detent_world3_add_joint(context, world, or_null(&joint), out);
        });
      }
      case 49: {
        const auto joint = joint3();
        const auto world = handle(4);
        return detent_world3_change_joint(context, world, id(), or_null(&joint));
      }
      case 50: {
        detent_joint3 joint{};
        const auto world = handle(4);
        check(detent_world3_joint(context, world, id(), or_null(&joint)));
        check(detent_world3_joint_count(context, world, or_null(&count)));
        return detent_world3_remove_joint(context, world, id());
      }
      case 51: {
        const auto world = handle(4);
        return ask<detent_id>([&](auto* joints, auto* number_of) {
          return detent_world3_broken(context, world, joints, room, number_of);
        });
      }
      case 52: {
        const auto point = vec3();
        const auto frame = rotation3();
        detent_vec3 local{};
        detent_rotation3 axes{};
        const auto world = handle(4);
        check(detent_world3_local_point(context, world, id(), or_null(&point), or_null(&local)));
        check(detent_world3_joint_force(context, world, id(), or_null(&local)));
        std::int32_t torque[3]{};
        check(detent_world3_joint_torque(context, world, id(), or_null(torque)));
        return detent_world3_local_frame(context, world, id(), or_null(&frame), or_null(&axes));
      }
      case 53: {
        const detent_vec3 points[4] = {vec3(), vec3(), vec3(), vec3()};
        const auto name = static_cast<std::uint32_t>(source_.below(4));
        const auto size = static_cast<std::uint32_t>(source_.below(5));
        return create([&](auto* out) {
          return detent_solid3_create(context, name, or_null(points), size, out);
        });
      }
      case 54: {
        const detent_transform3 transform{vec3(), rotation3(), number()};
        const auto scene = handle(2);
        const auto parent = source_.below(2) == 0 ? detent_id{} : id();
        return add([&](auto* out) {
          return detent_scene3_add_frame(context, scene, or_null(&transform), parent, out);
        });
      }
      case 55: {
        const detent_transform3 transform{vec3(), rotation3(), number()};
        detent_transform3 local{}, placed{};
        const auto scene = handle(2);
        const auto frame = id();
        check(detent_scene3_move_frame(context, scene, frame, or_null(&transform)));
        check(detent_scene3_frame(context, scene, frame, or_null(&local), or_null(&placed)));
        return detent_scene3_remove_frame(context, scene, frame);
      }
      case 56: {
        const auto shape = shape3();
        const auto along = direction3();
        const auto length = number();
        detent_object_hit3 hit{};
        const auto scene = handle(2);
        return detent_scene3_cast(context, scene, or_null(&shape), or_null(&along), length, layers,
                                  or_null(&hit));
      }
      case 57: {
        detent_mover3 mover{};
        mover.shape = shape3();
        if (source_.below(8) != 7) {
          mover.shape.kind = source_.below(2) == 0 ? DETENT_CAPSULE : DETENT_AABB;
        }
        mover.is_grounded = static_cast<std::uint32_t>(source_.below(2));
        mover.normal = direction3();
        mover.frame = id();
        mover.local = vec3();
        detent_mover3_settings settings{direction3(), number(), number(), number(), 1u << 29};
        detent_move3 result{};
        const auto by = vec3();
        detent_vec3 clipped{};
        const auto scene = handle(2);
        const auto ignored = id();
        const auto status =
            detent_mover3_move(context, scene, or_null(&mover), or_null(&by), or_null(&settings),
                               layers, ignored, or_null(&result));
        if (status == DETENT_OK && result.count != 0) {
          check(detent_mover3_clip_velocity(&by, &result, &clipped));
        }
        return status;
      }
      case 59:
      case 60: {
        detent_session_settings settings{};
        detent_session_default_settings(&settings);
        settings.players = static_cast<std::uint32_t>(1 + source_.below(2));
        settings.self = static_cast<std::uint32_t>(source_.below(2));
        settings.input_size = static_cast<std::uint32_t>(source_.below(5));
        settings.words = static_cast<std::uint32_t>(source_.below(3));
        settings.replay_every = static_cast<std::uint32_t>(source_.below(3));
        if (source_.below(8) == 7) settings.life = source_.byte();
        if (source_.below(8) == 7) settings.absent = source_.byte();
        if (source_.below(8) == 7) settings.spectators = static_cast<std::uint32_t>(number());
        if (source_.below(8) == 7) settings.prediction = source_.byte();
        if (source_.below(8) == 7) settings.frames_per_call = source_.byte();
        const auto world = handle(4);
        const auto status = create([&](auto* out) {
          return detent_session3_create(context, or_null(&settings), world, out);
        });
        take_world(detent_session3_world, context, session_kind);
        return status;
      }
      case 61: {
        List<std::array<std::uint8_t, 32>> inputs;
        const std::uint8_t pad[16] = {source_.byte()};
        detent_frame frame{};
        const auto status = detent_session3_begin_frame(context, handle(session_kind), or_null(pad),
                                                        or_null(&frame), or_null(&inputs.items));
        inputs.check();
        return status;
      }
      case 62:
        return detent_session3_end_frame(context, handle(session_kind));
      case 63: {
        std::array<std::uint8_t, DETENT_PACKET> packet{};
        std::uint32_t peer = 0, size = 0;
        now_ += source_.byte() * std::uint64_t{1000};
        check(detent_session3_packet(context, handle(session_kind), now_, or_null(&peer),
                                     or_null(packet.data()), DETENT_PACKET, or_null(&size)));
        // To another session, or back to its sender; occasionally with a changed byte.
        if (source_.below(4) == 3) packet[source_.word(2) % DETENT_PACKET] ^= source_.byte();
        return detent_session3_receive(context, handle(session_kind), peer ^ 1,
                                       or_null(packet.data()), size, now_);
      }
      case 64: {
        List<char> name;
        detent_session_event event{};
        detent_session_status status{};
        const auto session = handle(session_kind);
        check(detent_session3_status(context, session, or_null(&status)));
        check(detent_session3_matched(context, session, layers, or_null(&count)));
        check(detent_session3_is_awaited(context, session, layers));
        const auto result = detent_session3_event(context, session, or_null(&event),
                                                  or_null(name.items.data()), room);
        name.check();
        return result;
      }
      case 65: {
        const auto session = handle(session_kind);
        if (source_.below(4) == 3) check(detent_session3_pause(context, session, layers % 3));
        if (source_.below(4) == 3) check(detent_session3_drop(context, session, layers % 3));
        return source_.below(4) == 3 ? detent_session3_destroy(context, session) : DETENT_OK;
      }
      case 66: {
        save(detent_session3_replay, context, session_kind);
        const auto world = handle(4);
        const auto size = static_cast<std::uint32_t>(source_.below(5));
        const auto words = static_cast<std::uint32_t>(source_.below(3));
        const auto status = create([&](auto* out) {
          return detent_replay3_create(context, or_null(saved()), saved_size_, world, size, words,
                                       out);
        });
        take_world(detent_replay3_world, context, replay_kind);
        return status;
      }
      case 67: {
        List<std::array<std::uint8_t, 32>> inputs;
        detent_frame frame{};
        detent_replay_check result{};
        const auto replay = handle(replay_kind);
        check(detent_replay3_begin_frame(context, replay, or_null(&frame), or_null(&inputs.items)));
        inputs.check();
        if (source_.below(4) != 3) check(detent_replay3_end_frame(context, replay));
        check(detent_replay3_check(context, replay, or_null(&result)));
        return source_.below(8) == 7 ? detent_replay3_destroy(context, replay) : DETENT_OK;
      }
      case 68: {
        const std::array<std::uint32_t, 3> words{layers, layers, layers};
        std::array<std::uint32_t, 3> read{};
        const auto world = handle(4);
        check(detent_world3_set_words(context, world, or_null(words.data())));
        return detent_world3_words(context, world, or_null(read.data()));
      }
      case 69: {
        List<char> names;
        const bool is_scene = source_.below(2) == 1;
        const auto kind = is_scene ? std::size_t{2} : std::size_t{4};
        const auto a = handle(kind), b = handle(kind);
        const auto diff = is_scene ? detent_scene3_diff : detent_world3_diff;
        const auto status =
            diff(context, a, b, layers % 4, or_null(names.items.data()), room, or_null(&count));
        names.check();
        return status;
      }
      case 70: {
        detent_part3 parts[2] = {};
        for (auto& part : parts) {
          check(detent_part3_defaults(or_null(&part)));
          part.shape = shape3();
          if (source_.below(4) != 3) part.shape.kind = DETENT_SPHERE;
          if (source_.below(8) == 7) part.density = number();
          if (source_.below(8) == 7) {
            part.friction = number();
            part.rolling_resistance = number();
          }
          if (source_.below(8) == 7) part.is_sensor = static_cast<std::uint32_t>(source_.below(3));
        }
        const auto name = static_cast<std::uint32_t>(source_.below(4));
        const auto size = static_cast<std::uint32_t>(source_.below(3));
        return create([&](auto* out) {
          return detent_compound3_create(context, name, or_null(parts), size, out);
        });
      }
      case 71: {
        const auto shape = shape3();
        auto where = id();
        where.index &= 0xffff;
        const auto world = handle(4);
        return detent_world3_add_as(context, world, where, or_null(&shape), nullptr);
      }
      case 72: {
        detent_transform3 frame{};
        const auto world = handle(4);
        return detent_world3_frame(context, world, id(), or_null(&frame));
      }
      case 73:
        return ask_lists(context);
      case 74: {
        detent_frustum3 frustum{};
        for (auto& corner : frustum.corners) corner = vec3();
        const auto scene = handle(2);
        if (source_.below(2) == 0) {
          const auto shape = shape3();
          return detent_frustum3_overlaps(context, or_null(&frustum), or_null(&shape), 1);
        }
        return ask<detent_found>([&](auto* found, auto* number_of) {
          return detent_scene3_frustum_all(context, scene, or_null(&frustum), layers, found, room,
                                           number_of);
        });
      }
      case 75: {
        detent_camera3 camera{};
        camera.pose = {vec3(), rotation3(), 65536};
        camera.has_perspective = static_cast<std::uint32_t>(source_.below(3));
        camera.fov = static_cast<std::uint32_t>(source_.word(4));
        camera.aspect = number();
        camera.half_width = number();
        camera.half_height = number();
        camera.near_distance = number();
        camera.far_distance = number();
        detent_frustum3 frustum{};
        detent_ray3 ray{};
        const auto width = number(), height = number(), column = number(), row = number();
        check(detent_camera3_frustum(or_null(&camera), or_null(&frustum)));
        check(detent_camera3_pick_ray(&camera, width, height, column, row, or_null(&ray)));
        const auto point = vec3();
        detent_screen_point3 seen{};
        return detent_camera3_project(&camera, width, height, or_null(&point), or_null(&seen));
      }
      case 76: {
        check(change_body(context));
        const auto world = handle(4);
        const auto body = id();
        return ask<detent_world3_contact>([&](auto* contacts, auto* number_of) {
          return detent_world3_contacts(context, world, body, contacts, room, number_of);
        });
      }
      default:
        check(detent_world3_size(context, handle(4), or_null(&count)));
        return detent_world3_restore(context, handle(4), or_null(saved()), saved_size_);
    }
  }

  /// Sets one property of a body, or the gravity of all.
  detent_status change_body(detent_context* context) {
    const auto world = handle(4);
    const auto body = id();
    const auto value = number(), other = number();
    const auto word = static_cast<std::uint32_t>(source_.word(4));
    switch (source_.below(12)) {
      case 0: {
        const auto position = vec3();
        return detent_world3_set_position(context, world, body, or_null(&position));
      }
      case 1: {
        const auto rotation = rotation3();
        return detent_world3_set_rotation(context, world, body, or_null(&rotation));
      }
      case 2:
        return detent_world3_set_filter(context, world, body, word, word);
      case 3:
        return detent_world3_set_friction(context, world, body, value);
      case 4:
        return detent_world3_set_restitution(context, world, body, value);
      case 5:
        return detent_world3_set_sensor(context, world, body, word);
      case 6:
        return detent_world3_set_gravity_scale(context, world, body, value);
      case 7:
        return detent_world3_set_damping(context, world, body, value, other);
      case 8:
        return detent_world3_set_locked(context, world, body, word);
      case 9:
        return detent_world3_set_fast(context, world, body, word);
      case 10: {
        const auto gravity = vec3();
        return detent_world3_set_gravity(context, world, or_null(&gravity));
      }
      default:
        return detent_world3_set_user(context, world, body, word);
    }
  }

  /// A query of lists of shapes.
  detent_status ask_lists(const detent_context* context) {
    const detent_shape3 a[2] = {shape3(), shape3()};
    const detent_shape3 b[1] = {shape3()};
    const auto point = vec3();
    const auto along = direction3();
    const auto length = number();
    const auto count = static_cast<std::uint32_t>(source_.below(3));
    detent_vec3 one{}, other{};
    detent_hit3 hit{};
    std::int32_t distance = 0;
    switch (source_.below(7)) {
      case 0: {
        const detent_ray3 ray{point, along, length};
        return detent_shapes3_raycast(context, or_null(&ray), or_null(a), count, or_null(&hit));
      }
      case 1:
        return detent_shapes3_overlaps(context, or_null(a), count, or_null(b), 1);
      case 2:
        return detent_shapes3_closest_point(context, or_null(a), count, or_null(&point),
                                            or_null(&one));
      case 3:
        return detent_shapes3_distance(context, or_null(a), count, or_null(b), 1,
                                       or_null(&distance));
      case 4:
        return detent_shapes3_closest_points(context, or_null(a), count, or_null(b), 1,
                                             or_null(&one), or_null(&other));
      case 5:
        return detent_shapes3_cast(context, or_null(b), or_null(&along), length, or_null(a), count,
                                   or_null(&hit));
      default: {
        detent_manifold3 contact{};
        return detent_shapes3_contact(context, or_null(a), or_null(b), or_null(&contact));
      }
    }
  }

  /// Adds the world of the last session or replay to the handles.
  template <class WorldOf>
  void take_world(const WorldOf& world_of, detent_context* context, std::size_t kind) {
    detent_handle world = 0;
    check(world_of(context, handle(kind), or_null(&world)));
    if (world == 0) return;
    handles_[next_handle_++ % handles_.size()] = world;
    last_[4] = world;
  }

  template <class Snapshot>
  void save(const Snapshot& snapshot, detent_context* context, std::size_t kind) {
    std::uint32_t size = 0;
    const auto status = snapshot(context, handle(kind), or_null(saved_.data()),
                                 static_cast<std::uint32_t>(saved_.size()), or_null(&size));
    check(status);
    if (status == DETENT_OK) saved_size_ = size;
  }
  /// The last snapshot, sometimes with a changed byte or truncated.
  std::uint8_t* saved() {
    if (source_.below(4) == 3 && saved_size_ != 0) {
      saved_[source_.word(2) % saved_size_] ^= source_.byte();
    }
    if (source_.below(8) == 7) saved_size_ = saved_size_ == 0 ? 0 : saved_size_ - 1;
    return saved_.data();
  }

  Source source_;
  detent_context context_{};
  std::array<detent_handle, 4> handles_{};
  std::array<detent_handle, 32> last_{};
  std::array<detent_id, 4> ids_{};
  std::size_t next_handle_ = 0, next_id_ = 0;
  std::array<std::uint8_t, 4096> saved_{};
  std::uint32_t saved_size_ = 0;
  std::uint64_t now_ = 0;
};

}  // namespace

void property(Bytes input) {
  blocks = 0;
  Caller(input).run();
}

}  // namespace detent::fuzz
