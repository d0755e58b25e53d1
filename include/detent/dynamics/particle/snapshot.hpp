// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/dynamics/particle/system.hpp"
#include "detent/scene/fields.hpp"
#include "detent/scene/header.hpp"

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

struct ParticleHeader {
  static constexpr std::uint32_t right_magic = 0x504e5444u;  // "DTNP"
  static constexpr std::uint16_t right_version = 1;
  static constexpr std::size_t size = 40;
  static constexpr std::size_t checksum_size = 8;

  std::uint32_t magic = right_magic;
  std::uint16_t version = right_version;
  std::uint8_t dimension = 0, is_floating = 0, bits = 0, frac = 0;
  std::uint16_t reserved = 0;
  std::uint32_t particles = 0, constraints = 0;
  std::uint64_t settings_digest = 0, byte_count = 0;
  std::uint32_t reserved_too = 0;

  template <class D>
  constexpr void describe(D& out) const noexcept {
    out.add(magic, version, dimension, is_floating, bits, frac, reserved, particles, constraints,
            settings_digest, byte_count, reserved_too);
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
  header.dimension = static_cast<std::uint8_t>(N);
  if constexpr (is_fixed<S>) {
    header.bits = static_cast<std::uint8_t>(S::bits);
    header.frac = static_cast<std::uint8_t>(S::frac);
  } else {
    header.is_floating = 1;
    header.bits = static_cast<std::uint8_t>(8 * sizeof(S));
  }
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

/// Reads both lists; false for bytes that are no particles. Both have room for as many.
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

/// Writes the snapshot of `system` into `room` if it holds all bytes, and returns their number.
template <class Storage, Scalar S, int N>
constexpr std::size_t snapshot(const BasicParticleSystem<Storage, S, N>& system,
                               std::span<std::byte> room) noexcept {
  using detail::ParticleHeader;
  auto header = detail::header_of(system);
  detail::Writer count;
  detail::describe_particles(count, system);
  header.byte_count = ParticleHeader::size + count.size() + ParticleHeader::checksum_size;
  const auto size = static_cast<std::size_t>(header.byte_count);
  if (room.size() < size) return size;
  const auto bytes = room.first(size);
  detail::Writer out(bytes);
  header.describe(out);
  detail::describe_particles(out, system);
  const auto length = size - ParticleHeader::checksum_size;
  Digest digest;
  digest.add_bytes(bytes.first(length));
  detail::store_word(bytes.data() + length, digest.value());
  return size;
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

/// Makes `system` the one of the snapshot, or returns why it is unchanged.
///
/// domain: any bytes
/// result: `other_scene` also for other settings; a system restored steps bit by bit as the one that
///         was saved                           (tests/dynamics/particle/snapshot.test.cpp)
template <class Storage, Scalar S, int N>
[[nodiscard]] constexpr Restored restore(BasicParticleSystem<Storage, S, N>& system,
                                         std::span<const std::byte> bytes) {
  using detail::ParticleHeader;
  using System = BasicParticleSystem<Storage, S, N>;
  ParticleHeader header;
  detail::Reader in(bytes);
  in.get(header.magic, header.version);
  if (in.has_failed()) return Restored::truncated;
  if (header.magic != ParticleHeader::right_magic) return Restored::no_snapshot;
  if (header.version != ParticleHeader::right_version) return Restored::other_version;
  in.get(header.dimension, header.is_floating, header.bits, header.frac, header.reserved,
         header.particles, header.constraints, header.settings_digest, header.byte_count,
         header.reserved_too);
  if (in.has_failed() || bytes.size() < header.byte_count) return Restored::truncated;
  if (bytes.size() != header.byte_count || header.reserved != 0 || header.reserved_too != 0 ||
      bytes.size() < ParticleHeader::size + ParticleHeader::checksum_size) {
    return Restored::corrupted;
  }
  const auto checked = bytes.first(bytes.size() - ParticleHeader::checksum_size);
  Digest digest;
  digest.add_bytes(checked);
  if (digest.value() != detail::load_word<std::uint64_t>(checked.data() + checked.size())) {
    return Restored::corrupted;
  }
  const auto own = detail::header_of(system);
  if (header.dimension != own.dimension || header.is_floating != own.is_floating ||
      header.bits != own.bits || header.frac != own.frac ||
      header.settings_digest != own.settings_digest) {
    return Restored::other_scene;
  }
  if (header.particles > System::capacity || header.constraints > System::constraint_capacity) {
    return Restored::no_room;
  }
  std::remove_cvref_t<decltype(detail::ParticleAccess::particles(system))> particles;
  std::remove_cvref_t<decltype(detail::ParticleAccess::constraints(system))> constraints;
  detail::Reader parts(checked.subspan(ParticleHeader::size));
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

/// The particles and constraints of a system, so that `diff`, `SyncTest` and `Session` can name what
/// differs: "particle 3 velocity.y", "constraint 3 4 length".
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
