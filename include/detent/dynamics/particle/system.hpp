// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "detent/cull/list.hpp"
#include "detent/dynamics/particle/collide.hpp"
#include "detent/dynamics/particle/obstacles.hpp"

namespace detent {

namespace detail {

struct ParticleAccess;

}  // namespace detail

/// Particles that fall, are connected by distance constraints, and never pass through a shape:
/// `ParticleSystem<q16_16, 3>`, or `BoundedParticleSystem<Bounded<256>, q16_16, 3>` for one that
/// never allocates. `add_rope` and `add_cloth` (dynamics/particle/cloth.hpp) make ropes and cloth
/// of them.
///
/// A tick is a function of the particles and their constraints, independent of the order in which
/// these were added and removed. docs/particles.md defines every number of it and where it is
/// rounded.
///
/// units:  lengths in world units, times in seconds
/// domain: scalars with up to 31 bits; ticks per second times substeps in [1, 32767]
/// exact:  as docs/particles.md says                  (tests/dynamics/particle/system.test.cpp)
template <class Storage, Scalar S, int N>
class BasicParticleSystem {
  using F = detail::Formats<S>;
  using Place = typename F::Place;
  using Speed = typename F::Speed;

 public:
  using Particle = detail::ParticleRecord<S, N>;
  using Constraint = detail::ConstraintRecord<S>;
  static constexpr std::size_t capacity = Storage::capacity;
  static constexpr std::size_t constraint_capacity = 8 * capacity;

  constexpr BasicParticleSystem() noexcept : BasicParticleSystem(ParticleSettings<S, N>()) {}
  explicit constexpr BasicParticleSystem(const ParticleSettings<S, N>& settings) noexcept
      : settings_(detail::with_valid_rate(settings)), pace_(detail::pace_of(settings_)) {}

  [[nodiscard]] constexpr const ParticleSettings<S, N>& settings() const noexcept {
    return settings_;
  }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return particles_.size(); }
  [[nodiscard]] constexpr std::size_t constraint_count() const noexcept {
    return constraints_.size();
  }
  [[nodiscard]] constexpr const DistanceConstraint<S>& constraint(std::size_t i) const noexcept {
    return constraints_[i].constraint;
  }

  /// Adds a particle; nothing if the system is full.
  constexpr std::optional<ParticleIndex> add(const Vec<S, N>& position,
                                             const ParticleOptions<S, N>& options = {}) {
    if (particles_.size() == capacity) return std::nullopt;
    Particle particle;
    particle.place = make_vec<N>([&](int i) { return Place(position[i]); });
    particle.velocity = per_substep(options.velocity);
    particle.mass = options.mass;
    particle.radius = options.radius;
    particle.is_pinned = options.is_pinned;
    if (particle.is_held()) particle.velocity = {};
    particles_.push_back(particle);
    next_.resize(particles_.size());
    return static_cast<ParticleIndex>(particles_.size() - 1);
  }

  /// Adds a constraint of two particles; false if they already have one, if there is no room, or if
  /// a particle does not exist. Constraints are solved in the order of the lesser index, then of
  /// the other.
  constexpr bool add(DistanceConstraint<S> constraint) {
    if (constraint.b < constraint.a) std::swap(constraint.a, constraint.b);
    if (constraint.a == constraint.b || constraint.b >= particles_.size()) return false;
    if (constraints_.size() == constraint_capacity) return false;
    const auto at = place_of(constraint);
    if (is_at(at, constraint)) return false;
    Constraint record;
    record.constraint = constraint;
    derive(record);
    constraints_.push_back(record);
    for (auto i = constraints_.size() - 1; i > at; --i) constraints_[i] = constraints_[i - 1];
    constraints_[at] = record;
    return true;
  }
  /// Removes the constraint of two particles, for instance to tear cloth; false if they have none.
  constexpr bool remove(ParticleIndex a, ParticleIndex b) {
    DistanceConstraint<S> constraint;
    constraint.a = (std::min)(a, b);
    constraint.b = (std::max)(a, b);
    const auto at = place_of(constraint);
    if (!is_at(at, constraint)) return false;
    for (auto i = at + 1; i < constraints_.size(); ++i) constraints_[i - 1] = constraints_[i];
    constraints_.pop_back();
    return true;
  }

  /// The position, rounded to nearest and clamped. Here and below, i must be less than size().
  [[nodiscard]] constexpr Vec<S, N> position(ParticleIndex i) const noexcept {
    return detail::saturated<S>(particles_[i].place);
  }
  /// The velocity in units per second, rounded to nearest and clamped.
  [[nodiscard]] constexpr Vec<S, N> velocity(ParticleIndex i) const noexcept {
    return detail::saturated<S>(particles_[i].velocity * detail::as_operand<S>(pace_.rate));
  }
  /// The ball of the particle that never touches a shape in which it did not start: its center is
  /// the position rounded down.
  [[nodiscard]] constexpr Sphere<S, N> ball(ParticleIndex i) const noexcept {
    return {detail::grid_point<S, N>(particles_[i].place), particles_[i].radius};
  }
  [[nodiscard]] constexpr bool is_pinned(ParticleIndex i) const noexcept {
    return particles_[i].is_pinned;
  }

  /// Sets the velocity in units per second. Ignored for held particles.
  constexpr void set_velocity(ParticleIndex i, const Vec<S, N>& velocity) noexcept {
    if (!particles_[i].is_held()) particles_[i].velocity = per_substep(velocity);
  }
  /// Holds a particle at its position, or releases it.
  constexpr void set_pinned(ParticleIndex i, bool is_pinned) noexcept {
    particles_[i].is_pinned = is_pinned;
    particles_[i].velocity = {};
    for (std::size_t k = 0; k < constraints_.size(); ++k) {
      const auto& [a, b, length, frequency, is_tether] = constraints_[k].constraint;
      if (a == i || b == i) derive(constraints_[k]);
    }
  }
  /// Moves a pinned particle evenly during the next tick to `point`, such as a corner of a body:
  /// within a few steps of the grid of positions, and by at most 4 units a substep along each axis.
  constexpr void move_to(ParticleIndex i, const Vec<S, N>& point) noexcept {
    auto& particle = particles_[i];
    if (!particle.is_held()) return;
    particle.velocity = make_vec<N>([&](int k) {
      return quotient_nearest<Speed>(Place(point[k]) - particle.place[k],
                                     detail::as_operand<S>(settings_.substeps));
    });
  }

  /// One tick, without obstacles, or with those of `obstacles(...)` or a similar object.
  constexpr void step() { step(obstacles<S, N>()); }
  template <class Obstacles>
  constexpr void step(const Obstacles& around) {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      auto& particle = particles_[i];
      if (!particle.is_held()) detail::release<S, N>(particle.place, particle.radius, around);
    }
    for (int substep = 0; substep < settings_.substeps; ++substep) {
      for (std::size_t i = 0; i < particles_.size(); ++i) next_[i] = start(particles_[i]);
      for (int pass = 0; pass < settings_.iterations; ++pass) {
        for (std::size_t k = 0; k < constraints_.size(); ++k) {
          const auto& constraint = constraints_[k].constraint;
          detail::project<S, N>(constraints_[k], next_[constraint.a], next_[constraint.b]);
        }
      }
      for (std::size_t i = 0; i < particles_.size(); ++i) {
        finish(particles_[i], next_[i], around);
      }
    }
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      if (particles_[i].is_held()) particles_[i].velocity = {};
    }
  }

 private:
  friend struct detail::ParticleAccess;

  /// The velocity after gravity and damping; returns the position it leads to.
  constexpr Vec<Place, N> start(Particle& particle) const noexcept {
    auto& v = particle.velocity;
    return make_vec<N>([&](int i) {
      if (!particle.is_held()) {
        v[i] = saturate_to<Speed>(v[i] + pace_.gravity[i]);
        v[i] = nearest_to<Speed>(v[i] * pace_.kept);
      }
      return saturate_to<Place>(particle.place[i] + v[i]);
    });
  }

  /// Moves the particle as far as shapes allow, and sets its velocity.
  template <class Obstacles>
  constexpr void finish(Particle& particle, Vec<Place, N> next, const Obstacles& around) const {
    if (particle.is_held()) {
      particle.place = next;
      return;
    }
    const auto impacts =
        detail::collide<S, N>(particle.place, next, particle.radius, pace_.friction, around);
    const auto before = particle.velocity;
    auto v = before;
    if (settings_.integrator == Integrator::verlet) {
      v = detail::saturated<Speed>(next - particle.place);
    } else {
      for (std::size_t k = 0; k < impacts.count; ++k) {
        const auto& normal = impacts.normal[k];
        const auto closing = nearest_to<Speed>(dot(normal, v));
        if (!(closing < 0)) continue;
        accelerate(v, normal, -closing);
        v = detail::rubbed(v, normal, saturate_to<Speed>(-closing * pace_.friction));
      }
    }
    for (std::size_t k = 0; k < impacts.count; ++k) {
      const auto& normal = impacts.normal[k];
      const auto closing = nearest_to<Speed>(dot(normal, before));
      if (!(pace_.restitution > 0) || !(closing + pace_.bounce < 0)) continue;
      const auto rise = nearest_to<Speed>(dot(normal, v));
      const auto wanted = saturate_to<Speed>(-(pace_.restitution * closing));
      if (rise < wanted) accelerate(v, normal, wanted - rise);
    }
    particle.velocity = v;
    particle.place = next;
  }

  template <class T>
  static constexpr void accelerate(Vec<Speed, N>& v, const Vec<typename F::Ratio, N>& along,
                                   const T& by) noexcept {
    for (int i = 0; i < N; ++i) v[i] = saturate_to<Speed>(v[i] + nearest_to<Speed>(by * along[i]));
  }

  /// The index of the first constraint that is not before this one.
  [[nodiscard]] constexpr std::size_t place_of(
      const DistanceConstraint<S>& constraint) const noexcept {
    std::size_t low = 0, high = constraints_.size();
    while (low < high) {
      const auto middle = (low + high) / 2;
      if (detail::order(constraints_[middle].constraint, constraint) < 0) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
  [[nodiscard]] constexpr bool is_at(std::size_t i,
                                     const DistanceConstraint<S>& constraint) const noexcept {
    return i < constraints_.size() && detail::order(constraints_[i].constraint, constraint) == 0;
  }
  constexpr void derive(Constraint& record) const noexcept {
    detail::derive(record, particles_[record.constraint.a], particles_[record.constraint.b],
                   pace_.rate);
  }
  [[nodiscard]] constexpr Vec<Speed, N> per_substep(const Vec<S, N>& v) const noexcept {
    return quotient_nearest<Speed>(v, detail::as_operand<S>(pace_.rate));
  }

  ParticleSettings<S, N> settings_;
  detail::ParticlePace<S, N> pace_;
  typename Storage::template List<Particle, capacity> particles_;
  typename Storage::template List<Constraint, constraint_capacity> constraints_;
  typename Storage::template List<Vec<Place, N>, capacity>
      next_;  // the position that each is about to take
};

#if __STDC_HOSTED__
/// Particles that allocate as they grow.
template <Scalar S, int N>
using ParticleSystem = BasicParticleSystem<Growing, S, N>;
#endif
/// Particles stored inside the system: `BoundedParticleSystem<Bounded<256>, q16_16, 3>`.
template <class Storage, Scalar S, int N>
using BoundedParticleSystem = BasicParticleSystem<Storage, S, N>;

namespace detail {

/// For snapshots and tests.
struct ParticleAccess {
  template <class System>
  [[nodiscard]] static constexpr auto& particles(System& system) noexcept {
    return system.particles_;
  }
  template <class System>
  [[nodiscard]] static constexpr auto& constraints(System& system) noexcept {
    return system.constraints_;
  }
  /// Replaces both lists.
  template <class System, class Particles, class Constraints>
  static constexpr void assign(System& system, const Particles& particles,
                               const Constraints& constraints) {
    system.particles_ = particles;
    system.constraints_ = constraints;
    system.next_.resize(particles.size());
    for (std::size_t k = 0; k < constraints.size(); ++k) system.derive(system.constraints_[k]);
  }
};

}  // namespace detail

}  // namespace detent
