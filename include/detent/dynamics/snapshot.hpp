// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "detent/dynamics/asset_body.hpp"
#include "detent/dynamics/fields.hpp"
#include "detent/dynamics/held_bytes.hpp"
#include "detent/dynamics/hold.hpp"
#include "detent/dynamics/joint/bytes.hpp"
#include "detent/dynamics/rolling.hpp"
#include "detent/dynamics/world.hpp"
#include "detent/scene/assets.hpp"
#include "detent/scene/envelope.hpp"
#include "detent/scene/shape_tag.hpp"
#include "detent/scene/world.hpp"

// A world as bytes, and back:
//   snapshot(world)         -> the bytes, for a world that allocates
//   snapshot(world, room)   -> how many bytes, written when `room` holds them
//   restore(world, bytes)   -> Restored: yes, or why the world is unchanged
//   restore(world, bytes, lists...)   the same if bodies refer to hulls
//   digest(world)           -> 64 bits of gravity, all bodies, contacts and joints
//   digest_of(world, id)    -> 64 bits of one body
//
// Version 4, all little-endian:
// * a header of 64 bytes;
// * gravity;
// * each body that is not fixed, in order of index: a word of its index (bits 0 to 19), its quiet
//   ticks (20 to 27), whether it sleeps (28), whether its properties are those of the body before it
//   (29), whether forces or torques act on it (30) and whether it is held (31); generation (4
//   bytes); place, orientation, velocity, spin: 72 bytes in 3D with Q16.16; if forces or torques act,
//   their change of velocity and spin in each substep of the next tick. The places of held bodies
//   have the form of `held_bytes.hpp`. Unless bit 29 is set, the body's properties follow: motion
//   (1; plus 4 if the byte of locked axes follows, plus 8 if rolling resistance does), layers,
//   layers that it meets (4 each), user word (8), density, friction, restitution, damping of
//   velocity and spin, shape type (1), the numbers of the shape (of a hull or a surface its id (4),
//   its digest (8), and a translation and a rotation that do nothing); if one of them is not the
//   default, locked axes (bits 0 to 5), sensor (bit 6) and fast (bit 7) in a byte, and the scale of
//   gravity; rolling resistance if it is not 0;
// * each contact, in order of its bodies and its triangle: a word of the index of a (bits 0 to 19),
//   the number of points (20 to 22), whether it touches (23) and the low bits of the triangle (24 to
//   31); a word of the index of b (0 to 19) and the high bits of the triangle; if a body is a
//   compound, its part (2 bytes); the feature and pressure of each point, then the impulses of
//   friction: 52 bytes for four points in 3D; if the contact resists rolling, its rolling impulses.
//   If both bodies are compounds, the part of b takes the bits of the triangle;
// * each joint, in order of index: a word of its index (bits 0 to 20), whether its bodies collide
//   (21), whether it has limits (22), whether numbers of a spring follow that hinges and welds may
//   have (23) and its kind (24 to 31); generation, index of a, index of b (4 bytes each); its
//   numbers; the impulses of its pushes and turns;
// * the XXH64 of all that.
//
// Equal worlds have equal bytes. Fixed bodies appear only as a digest: a world restores snapshots
// that were taken with the same fixed bodies and the same settings, except gravity. The digest of a
// world omits the next generation, which depends on past bodies.

namespace detent {

namespace detail {

/// The first 64 bytes of a snapshot: "DTNW", version 4.
struct WorldHeader : SnapshotStart<0x574e5444u, 4, 64> {
  std::uint16_t shapes = 0, kinds = 0;  // of shapes and of joints, a bit each
  std::uint32_t next_generation = 0, bodies = 0, contacts = 0, fixed = 0;
  std::uint32_t next_joint = 0, joints = 0;
  std::uint64_t fixed_digest = 0, settings_digest = 0;
  std::uint16_t reserved = 0;

  [[nodiscard]] constexpr bool uses_reserved() const noexcept { return reserved != 0; }

  template <class Header, class F>
  static constexpr void fields(Header& h, const F& f) noexcept {
    f(h.shapes, h.next_generation, h.bodies, h.contacts, h.fixed, h.fixed_digest, h.settings_digest,
      h.byte_count, h.kinds, h.reserved, h.next_joint, h.joints);
  }
};

inline constexpr std::uint8_t sensor_bit = 1u << 6, fast_bit = 1u << 7;

/// Whether locked axes, sensor, fast or the scale of gravity differ from the defaults.
template <class Body>
[[nodiscard]] constexpr bool has_extras(const Body& body) noexcept {
  return body.locked != 0 || body.is_sensor || body.is_fast ||
         body.gravity_scale != decltype(body.gravity_scale)(1);
}

template <class D, class Body>
constexpr void describe_make(D& out, const Body& body) noexcept {
  const bool has_more = has_extras(body);
  const bool has_rolling = body.rolling_resistance != decltype(body.rolling_resistance){};
  out.add(static_cast<std::uint8_t>(static_cast<unsigned>(body.motion) | (has_more ? 4u : 0u) |
                                    (has_rolling ? 8u : 0u)),
          body.layers, body.collides_with, body.user, body.density, body.friction, body.restitution,
          body.linear_damping, body.angular_damping);
  body.shape.visit([&]<class Shape>(const Shape& shape) { out.add(shape_tag<Shape>, shape); });
  if (has_more) {
    out.add(static_cast<std::uint8_t>(body.locked | (body.is_sensor ? sensor_bit : 0) |
                                      (body.is_fast ? fast_bit : 0)),
            body.gravity_scale);
  }
  if (has_rolling) out.add(body.rolling_resistance);
}

/// Appends the state of a body of a world of this pace.
template <class D, Scalar S, int N, class Shape>
constexpr void describe_state(D& out, const BodyRecord<S, N, Shape>& body,
                              const Pace<S, N>& pace) noexcept {
  if (body.is_held()) {
    HeldPlace<S, N>(body, pace.hold_grid).add_to(out);
  } else {
    out.add(body.state.place);
  }
  out.add(body.state.orientation, body.state.velocity);
  for (const auto& w : body.state.spin) out.add(w);
  if (body.is_pushed()) {
    out.add(body.push);
    for (const auto& w : body.twist) out.add(w);
  }
}

template <class Body>
[[nodiscard]] constexpr bool is_made_like(const Body& a, const Body& b) noexcept {
  return a.motion == b.motion && a.layers == b.layers && a.collides_with == b.collides_with &&
         a.user == b.user && a.density == b.density && a.friction == b.friction &&
         a.restitution == b.restitution && a.linear_damping == b.linear_damping &&
         a.angular_damping == b.angular_damping && a.gravity_scale == b.gravity_scale &&
         a.rolling_resistance == b.rolling_resistance && a.locked == b.locked &&
         a.is_sensor == b.is_sensor && a.is_fast == b.is_fast && a.shape == b.shape;
}

/// Whether one of two bodies is a compound.
template <class Body>
[[nodiscard]] constexpr bool has_compound(const Body& a, const Body& b) noexcept {
  return part_count(a) != 0 || part_count(b) != 0;
}

/// Appends the state of a contact of bodies a and b.
template <class D, class Body, class C>
constexpr void describe_contact(D& out, const Body& a, const Body& b, const C& contact) noexcept {
  out.add(contact.a | std::uint32_t{contact.count} << 20 |
              (contact.touches ? std::uint32_t{1} << 23 : 0u) | contact.part << 24,
          contact.b | contact.part >> 8 << 20);
  if (has_compound(a, b)) out.add(contact.member);
  for (std::size_t i = 0; i < contact.count; ++i) {
    out.add(contact.feature[i], contact.pressure[i]);
  }
  for (const auto& impulse : contact.friction) out.add(impulse);
  if constexpr (requires { contact.rolling; }) {
    if (!resists_rolling(a, b, contact)) return;
    for (const auto& impulse : contact.rolling) out.add(impulse);
  }
}

/// Calls f(body, before) for each body that is not fixed; `before` is the last of these or nullptr.
template <class Bodies, class F>
constexpr void for_each_loose(const Bodies& bodies, const F& f) noexcept {
  const auto* before = static_cast<decltype(&bodies[0])>(nullptr);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].generation == 0 || bodies[i].motion == BodyMotion::fixed) continue;
    f(bodies[i], static_cast<std::uint32_t>(i), before);
    before = &bodies[i];
  }
}

template <class D, class World>
constexpr void describe_world(D& out, const World& world) noexcept {
  out.add(world.settings().gravity);
  for_each_loose(
      WorldAccess::bodies(world), [&](const auto& body, std::uint32_t i, const auto* before) {
        const bool alike = before != nullptr && is_made_like(body, *before);
        out.add(i | std::uint32_t{body.quiet} << 20 | (body.sleeps ? std::uint32_t{1} << 28 : 0u) |
                    (alike ? std::uint32_t{1} << 29 : 0u) |
                    (body.is_pushed() ? std::uint32_t{1} << 30 : 0u) |
                    (body.is_held() ? std::uint32_t{1} << 31 : 0u),
                body.generation);
        describe_state(out, body, WorldAccess::pace(world));
        if (!alike) describe_make(out, body);
      });
  const auto& contacts = WorldAccess::contacts(world);
  const auto& bodies = WorldAccess::bodies(world);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& contact = contacts[i];
    describe_contact(out, bodies[contact.a], bodies[contact.b], contact);
  }
  if constexpr (World::has_joints) describe_joints(out, WorldAccess::joints(world).list);
}

/// The number of fixed bodies, and their digest.
struct FixedBodies {
  std::uint32_t count = 0;
  std::uint64_t digest = 0;
};
template <class World>
[[nodiscard]] constexpr FixedBodies fixed_bodies(const World& world) noexcept {
  const auto& bodies = WorldAccess::bodies(world);
  FixedBodies result;
  Digest digest;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].generation == 0 || bodies[i].motion != BodyMotion::fixed) continue;
    ++result.count;
    digest.add(static_cast<std::uint32_t>(i), bodies[i].generation);
    describe_state(digest, bodies[i], WorldAccess::pace(world));
    describe_make(digest, bodies[i]);
  }
  result.digest = digest.value();
  return result;
}

/// The header of a world, without its number of bytes.
template <class Storage, Scalar S, int N, class... Parts>
[[nodiscard]] constexpr WorldHeader bare_header_of(
    const BasicWorld<Storage, S, N, Parts...>& world) noexcept {
  WorldHeader header;
  header.space = SnapshotSpace::of<S, N>();
  header.shapes =
      static_cast<std::uint16_t>(((IsJoint<Parts> ? 0u : 1u << shape_tag<Parts>) | ...));
  header.kinds =
      static_cast<std::uint16_t>(((is_listed_joint<Parts> ? 1u << joint_tag<Parts> : 0u) | ...));
  header.next_joint = WorldAccess::joints(world).next;
  if constexpr (std::remove_cvref_t<decltype(world)>::has_joints) {
    header.joints = static_cast<std::uint32_t>(world.joint_count());
  }
  header.next_generation = WorldAccess::next(world);
  header.contacts = static_cast<std::uint32_t>(WorldAccess::contacts(world).size());
  const auto& bodies = WorldAccess::bodies(world);
  const auto fixed = fixed_bodies(world);
  header.fixed = fixed.count;
  header.fixed_digest = fixed.digest;
  for_each_loose(bodies, [&](const auto&, std::uint32_t, const auto*) { ++header.bodies; });
  const auto& settings = world.settings();
  Digest own;
  own.add(static_cast<std::int32_t>(settings.ticks_per_second),
          static_cast<std::int32_t>(settings.substeps), settings.margin, settings.push_speed,
          settings.bounce_threshold, settings.sleep_speed, settings.hold_distance);
  header.settings_digest = own.value();
  return header;
}

/// The header of a world's snapshot.
template <class Storage, Scalar S, int N, class... Parts>
[[nodiscard]] constexpr WorldHeader header_of(
    const BasicWorld<Storage, S, N, Parts...>& world) noexcept {
  auto header = bare_header_of(world);
  ByteCounter count;
  describe_world(count, world);
  header.byte_count = WorldHeader::size + count.size() + WorldHeader::checksum_size;
  return header;
}

/// Writes all bytes of the snapshot of a world with this header.
template <class World>
constexpr void write_world(const WorldHeader& header, const World& world,
                           std::byte* room) noexcept {
  Storer out(room + WorldHeader::size);
  describe_world(out, world);
  store_envelope(room, header);
}

template <class Shape, class Assets>
[[nodiscard]] constexpr Restored read_part(Reader& in, Shape& shape,
                                           const Assets& assets) noexcept {
  if constexpr (AssetInstance<Shape>) {
    return read_asset(in, shape, assets);
  } else {
    in.get(shape);
    return Restored::yes;
  }
}

/// Reads the properties of a body; returns a reason other than `yes` if they are not valid for this
/// world.
template <Scalar S, int N, class... Shapes, class Assets>
[[nodiscard]] constexpr Restored read_make(Reader& in, BodyRecord<S, N, OneOf<Shapes...>>& body,
                                           const Assets& assets) noexcept {
  std::uint8_t motion = 0, tag = 0;
  in.get(motion, body.layers, body.collides_with, body.user, body.density, body.friction,
         body.restitution, body.linear_damping, body.angular_damping, tag);
  bool known = false;
  auto said = Restored::yes;
  const auto read = [&]<class Shape>(Shape shape) {
    if (known || shape_tag<Shape> != tag) return;
    known = true;
    said = read_part(in, shape, assets);
    body.shape = OneOf<Shapes...>(shape);
  };
  (read(Shapes()), ...);
  body.motion = static_cast<BodyMotion>(motion & 3u);
  if (said == Restored::yes && (motion & 4u) != 0) {
    const auto flags = in.number<std::uint8_t>();
    in.get(body.gravity_scale);
    body.locked = static_cast<std::uint8_t>(flags & (sensor_bit - 1u));
    body.is_sensor = (flags & sensor_bit) != 0;
    body.is_fast = (flags & fast_bit) != 0;
    if (!has_extras(body)) return Restored::corrupted;
  }
  if (said == Restored::yes && (motion & 8u) != 0) {
    in.get(body.rolling_resistance);
    if (body.rolling_resistance == S{}) return Restored::corrupted;
  }
  const bool is_body = known && !in.has_failed() && motion >> 4 == 0 &&
                       (body.motion == BodyMotion::dynamic || body.motion == BodyMotion::kinematic);
  return is_body ? said : Restored::corrupted;
}

/// Whether two bodies have the parts or triangles that a contact names.
template <class Body, class Contact>
[[nodiscard]] constexpr bool has_parts(const Body& a, const Body& b,
                                       const Contact& contact) noexcept {
  const auto is_surface = [](const Body& body) {
    return body.shape.visit([]<class Shape>(const Shape&) { return is_surface_body<Shape>; });
  };
  const auto of_a = part_count(a), of_b = part_count(b);
  if (of_a != 0 && of_b != 0) return contact.member < of_a && contact.part < of_b;
  return contact.member < (std::max)({std::size_t{1}, of_a, of_b}) &&
         (contact.part == 0 || is_surface(a) || is_surface(b));
}

/// Reads the parts of a snapshot into lists that already have the fixed bodies.
template <Scalar S, int N, class Bodies, class Contacts, class Joints, class Assets>
[[nodiscard]] constexpr Restored read_world(Reader& in, const WorldHeader& header, Bodies& bodies,
                                            Contacts& contacts, Joints& joints,
                                            std::size_t bodies_room, std::size_t contacts_room,
                                            const Pace<S, N>& pace, const Assets& assets) {
  using F = Formats<S>;
  std::size_t lowest = 0, before = 0;
  bool has_before = false;
  for (std::uint32_t k = 0; k < header.bodies; ++k) {
    const auto word = in.number<std::uint32_t>();
    const auto generation = in.number<std::uint32_t>();
    const std::size_t i = word & 0xfffffu;
    const bool alike = (word >> 29 & 1) != 0;
    if (in.has_failed() || i < lowest || generation == 0 || generation >= header.next_generation ||
        (alike && !has_before)) {
      return Restored::corrupted;
    }
    if (i >= bodies_room) return Restored::no_room;
    const auto size = bodies.size();
    if (i < size && bodies[i].generation != 0) return Restored::corrupted;  // of a fixed body
#ifdef __OPTIMIZE_SIZE__
    constexpr bool appends = false;
#else
    const bool appends = alike && i == size;  // faster than resize, which initializes the element
#endif
    if (appends) {
      bodies.push_back(bodies[before]);
    } else {
      if (i >= size) bodies.resize(i + 1);
      if (alike) bodies[i] = bodies[before];
    }
    auto& body = bodies[i];
    body.generation = generation;
    body.quiet = static_cast<std::uint8_t>(word >> 20);
    body.sleeps = (word >> 28 & 1) != 0;
    body.let_go();
    const bool is_held = word >> 31 != 0;
    HeldPlace<S, N> held;
    if (is_held) {
      held.get_from(in);
    } else {
      in.get(body.state.place);
    }
    in.get(body.state.orientation, body.state.velocity);
    for (auto& w : body.state.spin) in.get(w);
    body.push = {};
    body.twist = {};
    const bool is_pushed = (word >> 30 & 1) != 0;
    if (is_pushed) {
      in.get(body.push);
      for (auto& w : body.twist) in.get(w);
    }
    if (in.has_failed() || !is_unit(to_array(body.state.orientation)) ||
        (is_held && !held.set(body, pace.hold_grid))) {
      return Restored::corrupted;
    }
    if (!alike) {
      const auto said = read_make(in, body, assets);
      if (said != Restored::yes) return said;
      if (has_before && is_made_like(body, bodies[before])) return Restored::corrupted;
      derive(body, pace.rate);
    }
    if (body.is_pushed() != is_pushed || ((is_pushed || is_held) && !body.can_move()) ||
        (is_held && !is_within_hold(body, pace))) {
      return Restored::corrupted;
    }
    before = i;
    has_before = true;
    lowest = i + 1;
  }
  const auto is_body = [&](std::uint32_t i) {
    return i < bodies.size() && bodies[i].generation != 0;
  };
  if (header.contacts > contacts_room) return Restored::no_room;
  contacts.reserve((std::min)(std::size_t{header.contacts}, in.left() / sizeof(std::uint64_t)));
  for (std::uint32_t k = 0; k < header.contacts; ++k) {
    typename std::remove_cvref_t<decltype(contacts[0])> contact;
    const auto word = in.number<std::uint32_t>();
    contact.a = word & 0xfffffu;
    const auto second = in.number<std::uint32_t>();
    contact.b = second & 0xfffffu;
    contact.part = word >> 24 | second >> 20 << 8;
    contact.count = static_cast<std::uint8_t>(word >> 20 & 7);
    contact.touches = (word >> 23 & 1) != 0;
    if (in.has_failed() || contact.a >= contact.b || !is_body(contact.a) || !is_body(contact.b) ||
        contact.count == 0 || contact.count > contact.feature.size()) {
      return Restored::corrupted;
    }
    const auto &a = bodies[contact.a], &b = bodies[contact.b];
    if (has_compound(a, b)) in.get(contact.member);
    const bool follows = k == 0 || key_of(contacts[k - 1]) < key_of(contact);
    if (in.has_failed() || !follows || !has_parts(a, b, contact)) return Restored::corrupted;
    for (std::size_t p = 0; p < contact.count; ++p) {
      in.get(contact.feature[p], contact.pressure[p]);
      if (contact.pressure[p] < typename F::Impulse()) return Restored::corrupted;
    }
    for (auto& impulse : contact.friction) in.get(impulse);
    if constexpr (requires { contact.rolling; }) {
      if (resists_rolling(a, b, contact)) {
        for (auto& impulse : contact.rolling) in.get(impulse);
      }
    }
    contacts.push_back(contact);
  }
  const auto said = read_joints(in, joints, header.joints, header.next_joint, bodies);
  if (said != Restored::yes) return said;
  return in.has_failed() || in.left() != 0 ? Restored::corrupted : Restored::yes;
}

}  // namespace detail

/// Writes the snapshot of `world` to `room`; returns the number of its bytes. If `room` is smaller,
/// it is not written to.
template <class Storage, Scalar S, int N, class... Shapes>
constexpr std::size_t snapshot(const BasicWorld<Storage, S, N, Shapes...>& world,
                               std::span<std::byte> room) noexcept {
  const auto header = detail::header_of(world);
  if (room.size() >= header.byte_count) detail::write_world(header, world, room.data());
  return static_cast<std::size_t>(header.byte_count);
}

#if __STDC_HOSTED__
/// The snapshot of a world that allocates.
template <Scalar S, int N, class... Shapes>
[[nodiscard]] auto snapshot(const BasicWorld<Growing, S, N, Shapes...>& world) {
  const auto header = detail::header_of(world);
  Growing::List<std::byte, 0> bytes(header.byte_count);
  detail::write_world(header, world, bytes.data());
  return bytes;
}
#endif

// Deleted: compilers show the line with the name.
// clang-format off
template <std::size_t... Rooms, Scalar S, int N, class... Shapes>
void snapshot(const BasicWorld<Bounded<Rooms...>, S, N, Shapes...>&) = delete;  // detent: a BoundedWorld writes to a std::span: snapshot(world, room)
// clang-format on

/// Sets `world` to the state of a snapshot, or returns why it is unchanged.
///
/// domain: any bytes
/// result: `other_scene` also for different settings, except gravity, which is restored; a restored
///         world steps bit by bit like the one that was saved    (tests/dynamics/snapshot.test.cpp)
template <class Storage, Scalar S, int N, class... Shapes, AssetList... Lists>
[[nodiscard]] constexpr Restored restore(BasicWorld<Storage, S, N, Shapes...>& world,
                                         std::span<const std::byte> bytes, const Lists&... lists) {
  using detail::WorldAccess;
  using detail::WorldHeader;
  using World = BasicWorld<Storage, S, N, Shapes...>;
  WorldHeader header;
  const auto read = detail::open(bytes, header);
  if (read != Restored::yes) return read;
  const auto own = detail::bare_header_of(world);
  if (header.space != own.space || header.shapes != own.shapes || header.kinds != own.kinds ||
      header.settings_digest != own.settings_digest) {
    return Restored::other_scene;
  }
  if (header.fixed != own.fixed || header.fixed_digest != own.fixed_digest) {
    return Restored::other_fixed_part;
  }
  if (header.next_generation == 0) return Restored::corrupted;
  const auto& old = WorldAccess::bodies(world);
  std::remove_cvref_t<decltype(old)> bodies;
  // No more than the bytes can hold, whatever the header claims.
  bodies.reserve((std::min)(std::size_t{header.bodies} + std::size_t{header.fixed},
                            old.size() + bytes.size() / sizeof(std::uint64_t)));
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (old[i].generation == 0 || old[i].motion != BodyMotion::fixed) continue;
    if (old[i].generation >= header.next_generation) return Restored::corrupted;
    bodies.resize(i + 1);
    bodies[i] = old[i];
  }
  typename World::Contacts contacts;
  std::remove_cvref_t<decltype(WorldAccess::joints(world))> joints;
  detail::Reader parts(WorldHeader::body(bytes));
  Vec<S, N> gravity{};
  parts.get(gravity);
  const auto said = detail::read_world<S, N>(
      parts, header, bodies, contacts, joints, World::capacity, World::contact_capacity,
      WorldAccess::pace(world), detail::AssetLists<Lists...>(lists...));
  if (said == Restored::yes) {
    WorldAccess::assign(world, gravity, std::move(bodies), std::move(contacts), std::move(joints),
                        header.next_generation, header.bodies + std::size_t{header.fixed});
  }
  return said;
}

/// Appends to a digest, as in a snapshot: gravity, the bodies that are not fixed, the contacts and
/// the joints.
template <class D, class Storage, Scalar S, int N, class... Shapes>
constexpr void append(D& digest, const BasicWorld<Storage, S, N, Shapes...>& world) noexcept {
  detail::describe_world(digest, world);
}

namespace detail {

template <class Storage, Scalar S, int N, class... Shapes>
struct WholeDigest<BasicWorld<Storage, S, N, Shapes...>> {
  static constexpr void add(Digest& all, Digest& fixed,
                            const BasicWorld<Storage, S, N, Shapes...>& world) noexcept {
    const auto bodies = fixed_bodies(world);
    all.add(world, bodies.count, bodies.digest);
    fixed.add(bodies.count, bodies.digest);
  }
};

}  // namespace detail

/// 64 bits of one body: its pose, motion and properties; 0 if it does not exist.
template <class Storage, Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr std::uint64_t digest_of(const BasicWorld<Storage, S, N, Shapes...>& world,
                                                const BodyId& id) noexcept {
  if (!world.contains(id)) return 0;
  const auto& body = detail::WorldAccess::bodies(world)[id.index];
  Digest digest;
  digest.add(id, body.quiet, body.sleeps);
  detail::describe_state(digest, body, detail::WorldAccess::pace(world));
  detail::describe_make(digest, body);
  return digest.value();
}

}  // namespace detent
