// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/dynamics/particle/system.hpp"
#include "detent/scene/envelope.hpp"
#include "detent/scene/fields.hpp"

// Particles as bytes, and back:
//   snapshot(system)         -> the bytes, for a system that allocates
//   snapshot(system, room)   -> how many bytes, written when `room` holds them
//   restore(system, bytes)   -> Restored: yes, or why the system is unchanged
//   digest(system)           -> 64 bits of all particles and constraints
//
// Version 1, all little-endian:
// * a header of 40 bytes;
// * each particle in order: place, velocity, mass, radius, whether it is pinned (1 byte);
// * each constraint in order: both indices (4 bytes each), length, frequency, whether it is a tether;
// * the XXH64 of all that.
//
// Equal systems have equal bytes.

namespace detent {

namespace detail {

/// The first 40 bytes of a snapshot: "DTNP", version 1.
struct ParticleHeader : SnapshotStart<0x504e5444u, 1, 40> {
  std::uint16_t reserved = 0;
  std::uint32_t particles = 0, constraints = 0;
  std::uint64_t settings_digest = 0;
  std::uint32_t reserved_too = 0;

  [[nodiscard]] constexpr bool uses_reserved() const noexcept {
    return reserved != 0 || reserved_too != 0;
  }

  template <class Header, class F>
  static constexpr void fields(Header& h, const F& f) noexcept {
    f(h.reserved, h.particles, h.constraints, h.settings_digest, h.byte_count, h.reserved_too);
  }
};

template <class D, Scalar S, int N>
constexpr void describe_particle(D& out, const ParticleRecord<S, N>& particle) noexcept {
  out.add(particle.place, particle.velocity, particle.mass, particle.radius,
          static_cast<std::uint8_t>(particle.is_pinned));
}
template <class D, Scalar S>
constexpr void describe_constraint(D& out, const DistanceConstraint<S>& constraint) noexcept {
  out.add(constraint.a, constraint.b, constraint.length, constraint.frequency,
          static_cast<std::uint8_t>(constraint.is_tether));
}

template <class D, class System>
constexpr void describe_particles(D& out, const System& system) noexcept {
  const auto& particles = ParticleAccess::particles(system);
  for (std::size_t i = 0; i < particles.size(); ++i) describe_particle(out, particles[i]);
  for (std::size_t i = 0; i < system.constraint_count(); ++i) {
    describe_constraint(out, system.constraint(i));
  }
}

template <class Storage, Scalar S, int N>
[[nodiscard]] constexpr ParticleHeader header_of(
    const BasicParticleSystem<Storage, S, N>& system) noexcept {
  ParticleHeader header;
  header.space = SnapshotSpace::of<S, N>();
  header.particles = static_cast<std::uint32_t>(system.size());
  header.constraints = static_cast<std::uint32_t>(system.constraint_count());
  const auto& settings = system.settings();
  Digest own;
  own.add(static_cast<std::int32_t>(settings.ticks_per_second),
          static_cast<std::int32_t>(settings.substeps),
          static_cast<std::int32_t>(settings.iterations), settings.integrator, settings.gravity,
          settings.damping, settings.friction, settings.restitution, settings.bounce_threshold);
  header.settings_digest = own.value();
  return header;
}

/// Reads both lists, which have the sizes of the snapshot; false for invalid bytes.
template <Scalar S, int N, class Particles, class Constraints>
[[nodiscard]] constexpr bool read_particles(Reader& in, const ParticleHeader& header,
                                            Particles& particles, Constraints& constraints) {
  constexpr auto particle_size = [] {
    Writer count;
    describe_particle(count, ParticleRecord<S, N>());
    return count.size();
  }();
  constexpr auto constraint_size = [] {
    Writer count;
    describe_constraint(count, DistanceConstraint<S>());
    return count.size();
  }();
  if (in.left() != particle_size * header.particles + constraint_size * header.constraints) {
    return false;
  }
  for (std::uint32_t i = 0; i < header.particles; ++i) {
    ParticleRecord<S, N> particle;
    std::uint8_t is_pinned = 0;
    in.get(particle.place, particle.velocity, particle.mass, particle.radius, is_pinned);
    particle.is_pinned = is_pinned != 0;
    if (in.has_failed() || is_pinned > 1) return false;
    particles.push_back(particle);
  }
  for (std::uint32_t i = 0; i < header.constraints; ++i) {
    ConstraintRecord<S> record;
    auto& constraint = record.constraint;
    std::uint8_t is_tether = 0;
    in.get(constraint.a, constraint.b, constraint.length, constraint.frequency, is_tether);
    constraint.is_tether = is_tether != 0;
    const bool follows = i == 0 || order(constraints[i - 1].constraint, constraint) < 0;
    if (in.has_failed() || is_tether > 1 || !follows || constraint.a >= constraint.b ||
        constraint.b >= header.particles) {
      return false;
    }
    constraints.push_back(record);
  }
  return true;
}

}  // namespace detail

/// Writes the snapshot of `system` to `room`; returns the number of its bytes. If `room` is
/// smaller, its contents are unspecified.
template <class Storage, Scalar S, int N>
constexpr std::size_t snapshot(const BasicParticleSystem<Storage, S, N>& system,
                               std::span<std::byte> room) noexcept {
  auto header = detail::header_of(system);
  return detail::seal(room, header,
                      [&](detail::Writer& out) { detail::describe_particles(out, system); });
}

#if __STDC_HOSTED__
/// The snapshot of a system that allocates.
template <Scalar S, int N>
[[nodiscard]] auto snapshot(const BasicParticleSystem<Growing, S, N>& system) {
  Growing::List<std::byte, 0> bytes(snapshot(system, std::span<std::byte>()));
  snapshot(system, std::span<std::byte>(bytes));
  return bytes;
}
#endif

/// Restores `system` from a snapshot, or returns why it is unchanged.
///
/// domain: any bytes
/// result: `other_scene` also for other settings; a restored system steps bit by bit like the one
///         that was saved (tests/dynamics/particle/snapshot.test.cpp)
template <class Storage, Scalar S, int N>
[[nodiscard]] constexpr Restored restore(BasicParticleSystem<Storage, S, N>& system,
                                         std::span<const std::byte> bytes) {
  using detail::ParticleHeader;
  using System = BasicParticleSystem<Storage, S, N>;
  ParticleHeader header;
  const auto read = detail::open(bytes, header);
  if (read != Restored::yes) return read;
  const auto own = detail::header_of(system);
  if (header.space != own.space || header.settings_digest != own.settings_digest) {
    return Restored::other_scene;
  }
  if (header.particles > System::capacity || header.constraints > System::constraint_capacity) {
    return Restored::no_room;
  }
  std::remove_cvref_t<decltype(detail::ParticleAccess::particles(system))> particles;
  std::remove_cvref_t<decltype(detail::ParticleAccess::constraints(system))> constraints;
  detail::Reader parts(ParticleHeader::body(bytes));
  if (!detail::read_particles<S, N>(parts, header, particles, constraints)) {
    return Restored::corrupted;
  }
  detail::ParticleAccess::assign(system, particles, constraints);
  return Restored::yes;
}

/// Appends to a digest: the particles and constraints as in a snapshot.
template <class D, class Storage, Scalar S, int N>
constexpr void append(D& digest, const BasicParticleSystem<Storage, S, N>& system) noexcept {
  detail::describe_particles(digest, system);
}

namespace detail {

/// A particle, as a field of its system.
template <Scalar S, int N>
struct ParticleField {
  const ParticleRecord<S, N>& particle;
};
template <Scalar S, int N, class F>
constexpr void for_each_field(const ParticleField<S, N>& field, const F& f) {
  f("", true);  // it exists
  f(" place", field.particle.place);
  f(" velocity", field.particle.velocity);
  f(" mass", field.particle.mass);
  f(" radius", field.particle.radius);
  f(" is_pinned", field.particle.is_pinned);
}

/// A constraint, as a field of its system.
template <Scalar S>
struct ConstraintField {
  const DistanceConstraint<S>& constraint;
};
template <Scalar S, class F>
constexpr void for_each_field(const ConstraintField<S>& field, const F& f) {
  f("", true);  // it exists
  f(" length", field.constraint.length);
  f(" frequency", field.constraint.frequency);
  f(" is_tether", field.constraint.is_tether);
}

}  // namespace detail

/// The particles and constraints of a system, so that `diff`, `SyncTest` and `Session` can name
/// differences: "particle 3 velocity.y", "constraint 3 4 length".
template <class Storage, Scalar S, int N, class F>
constexpr void for_each_field(const BasicParticleSystem<Storage, S, N>& system, const F& f) {
  const auto& particles = detail::ParticleAccess::particles(system);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    f(FieldName(" particle ").add_number(i), detail::ParticleField<S, N>{particles[i]});
  }
  for (std::size_t i = 0; i < system.constraint_count(); ++i) {
    const auto& constraint = system.constraint(i);
    f(FieldName(" constraint ").add_number(constraint.a).add(" ").add_number(constraint.b),
      detail::ConstraintField<S>{constraint});
  }
}

}  // namespace detent
