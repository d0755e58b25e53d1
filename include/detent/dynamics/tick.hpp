// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "detent/dynamics/fast.hpp"
#include "detent/dynamics/flight.hpp"
#include "detent/dynamics/islands.hpp"
#include "detent/dynamics/joint/group.hpp"
#include "detent/dynamics/manifold/pair.hpp"
#include "detent/dynamics/manifold/terrain.hpp"
#include "detent/dynamics/pairs.hpp"
#include "detent/dynamics/record.hpp"
#include "detent/dynamics/relative.hpp"
#include "detent/dynamics/solve.hpp"
#include "detent/scene/one_of.hpp"

namespace detent::detail {

/// How many contacts a world with room for so many bodies has room for.
[[nodiscard]] constexpr std::size_t contact_room(std::size_t bodies) noexcept { return 8 * bodies; }

/// What one step of a world needs besides its state. Nothing of it outlives the step, so copies of a
/// world, as a rollback makes in every frame, leave it out.
///
/// `Parts` are the world's shapes and joints.
template <class Storage, Scalar S, int N, class... Parts>
class Tick {
  template <class... Shapes>
  using BodyOf = BodyRecord<S, N, OneOf<Shapes...>>;
  template <class... Joints>
  using GroupOf = JointGroup<Storage, S, N, Joints...>;

 public:
  using F = Formats<S>;
  using Body = typename Select<false, Parts...>::template In<BodyOf>;
  using Group = typename Select<true, Parts...>::template In<GroupOf>;
  using Joints = typename Group::List;
  using ContactState = BodyContact<S, N>;
  static constexpr std::size_t bodies_room = Storage::capacity;
  static constexpr std::size_t contacts_room = contact_room(Storage::capacity);
  using Bodies = typename Storage::template List<Body, bodies_room>;
  using Contacts = typename Storage::template List<ContactState, contacts_room>;

  constexpr Tick() noexcept = default;
  constexpr Tick(const Tick&) noexcept {}
  constexpr Tick& operator=(const Tick&) noexcept { return *this; }

  /// One step. Returns whether it has changed nothing, so that the next one would not either.
  constexpr bool run(Bodies& bodies, Contacts& contacts, Joints& joints, const Pace<S, N>& pace,
                     int substeps, const S& margin) {
    place(bodies);
    const bool has_fast = note_starts(bodies);
    group_.part(joints);
    find_pairs(bodies, margin);
    touch(bodies, contacts, margin, pace.margin);
    wake(bodies, joints);
    const bool is_still = !has_fast && stands_still(bodies) && have_stayed(contacts);
    order(bodies);
    for (std::size_t i = 0; i < moving_.size(); ++i) moving_[i] = moving_of(bodies[i]);
    prepare_all(bodies);
    group_.prepare(joints, bodies, supports_, pace.rate);
    for (int i = 0; i < substeps; ++i) substep(bodies, joints, pace);
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      auto& ready = ready_[i];
      bounce(ready, current_[ready.contact], moving_[ready.a], moving_[ready.b], pace.bounce);
    }
    finish(bodies, pace);
    if (has_fast) stop_fast(bodies, margin);
    std::swap(contacts, current_);
    return is_still;
  }

  /// The contacts before the last run.
  [[nodiscard]] constexpr const Contacts& contacts_before() const noexcept { return current_; }

  /// Calls f(index) for each joint that broke in the last run, in order.
  template <class Broken>
  constexpr void for_each_broken(const Broken& f) const {
    group_.for_each_broken(f);
  }

 private:
  /// A pair's manifold, kept from the search for contacts until they are prepared.
  struct Found {
    Manifold<S, N> manifold{};
    Vec<typename F::Lever, N> offset{};
  };

  constexpr void place(const Bodies& bodies) {
    supports_.resize(bodies.size());
    moving_.resize(bodies.size());
    half_way_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].generation != 0) supports_[i] = support_of<S, N>(bodies[i]);
    }
  }

  /// Notes where bodies are, if one of them is fast.
  constexpr bool note_starts(const Bodies& bodies) {
    starts_.clear();
    bool has_fast = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) has_fast = has_fast || is_fast(bodies[i]);
    if (!has_fast) return false;
    for (std::size_t i = 0; i < supports_.size(); ++i) {
      starts_.push_back({supports_[i].place, supports_[i].axes});
    }
    return true;
  }
  static constexpr bool is_fast(const Body& body) noexcept {
    return body.is_fast && body.generation != 0 && body.can_move();
  }

  /// Stops fast bodies on their way through this tick, by others in the order of their ranks. What
  /// comes last holds: fixed bodies.
  constexpr void stop_fast(Bodies& bodies, const S& margin) {
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      if (!is_fast(bodies[i])) continue;
      for (int rank = 0; rank < 4; ++rank) {
        for (std::uint32_t j = 0; j < bodies.size(); ++j) {
          const Body& other = bodies[j];
          if (j == i || other.generation == 0 || rank_of(other) != rank ||
              is_sensed(bodies, i, j) || !meet(bodies[i], other) ||
              group_.keeps_apart({(std::min)(i, j), (std::max)(i, j)})) {
            continue;
          }
          stop(bodies[i], starts_[i], other, starts_[j], margin);
        }
      }
    }
  }
  static constexpr int rank_of(const Body& body) noexcept {
    if (body.motion == BodyMotion::fixed) return 3;
    return body.motion == BodyMotion::kinematic ? 2 : is_fast(body) ? 0 : 1;
  }
  static constexpr void stop(Body& body, const Standing<S, N>& start, const Body& other,
                             const Standing<S, N>& before, const S& margin) noexcept {
    const auto after =
        other.motion == BodyMotion::fixed
            ? before
            : Standing<S, N>{other.state.place, axes_of<S, N>(other.state.orientation)};
    const auto from = seen_from(before, start.place), to = seen_from(after, body.state.place);
    std::optional<Vec<typename F::Lever, N>> at;
    body.shape.visit([&]<class Mine>(const Mine& mine) {
      if constexpr (!is_surface_body<Mine>) {
        const auto radius = (max)(inner_radius(mine), S(0));
        other.shape.visit([&]<class Other>(const Other& shape) {
          if constexpr (!is_surface_body<Other>) {
            at = stop_before(shape, other.reach, from, to, radius, margin);
          }
        });
      }
    });
    if (!at) return;
    const auto place = out_of(after, *at);
    for (int k = 0; k < N; ++k) {
      if (!is_locked(body.locked, k)) body.state.place[k] = place[k];
    }
    body.sleeps = false;
    body.quiet = 0;
  }

  /// Whether two bodies are in layers that meet.
  static constexpr bool meet(const Body& a, const Body& b) noexcept {
    return (a.layers & b.collides_with) != 0 && (b.layers & a.collides_with) != 0;
  }

  constexpr void find_pairs(const Bodies& bodies, const S& margin) {
    swept_.clear();
    pairs_.clear();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].generation == 0) continue;
      swept_.push_back(
          {bounds_of<S, N>(supports_[i].place, supports_[i].axes, bodies[i].reach, margin),
           static_cast<std::uint32_t>(i)});
    }
    if (swept_.size() == 0) return;
    sweep(&swept_[0], swept_.size(), lane_, [&](const BodyPair& pair) {
      const Body &a = bodies[pair.a], &b = bodies[pair.b];
      if (meet(a, b) && (a.can_move() || b.can_move()) && !group_.keeps_apart(pair) &&
          pairs_.size() < pair_room) {
        pairs_.push_back(pair);
      }
    });
    if (pairs_.size() != 0) std::sort(&pairs_[0], &pairs_[0] + pairs_.size());
  }

  /// The contacts of this tick, in order of their bodies, with the impulses of the last.
  constexpr void touch(const Bodies& bodies, const Contacts& before, const S& reach,
                       const typename F::Lever& margin) {
    current_.clear();
    found_.clear();
    std::size_t old = 0;
    for (std::size_t p = 0; p < pairs_.size() && current_.size() < contacts_room; ++p) {
      const BodyPair pair = pairs_[p];
      while (old < before.size() && pair_of(before[old]) < pair) ++old;
      bodies[pair.a].shape.visit([&]<class A>(const A& first) {
        bodies[pair.b].shape.visit([&]<class B>(const B& second) {
          if constexpr (is_surface_body<A> && is_surface_body<B>) {
            return;  // none of them can move
          } else if constexpr (is_surface_body<A>) {
            touch_terrain(bodies, pair, first, second, true, before, old, reach, margin);
          } else if constexpr (is_surface_body<B>) {
            touch_terrain(bodies, pair, second, first, false, before, old, reach, margin);
          } else {
            const auto& a = supports_[pair.a];
            const auto& b = supports_[pair.b];
            const auto offset = offset_between(a, b);
            const auto pose = relative_pose(a, b, offset);
            const bool known = old < before.size() && pair_of(before[old]) == pair;
            add_contact(bodies, pair, {manifold(first, second, pose, margin), offset},
                        known ? &before[old] : nullptr);
          }
        });
      });
    }
  }

  /// The contacts of a surface, the first or the second of the pair, and a solid.
  template <class Terrain, class Solid>
  constexpr void touch_terrain(const Bodies& bodies, const BodyPair& pair, const Terrain& terrain,
                               const Solid& solid, bool is_first, const Contacts& before,
                               std::size_t old, const S& reach, const typename F::Lever& margin) {
    const auto ground = is_first ? pair.a : pair.b, other = is_first ? pair.b : pair.a;
    const auto pose = relative_pose(supports_[ground], supports_[other],
                                    offset_between(supports_[ground], supports_[other]));
    const auto offset = offset_between(supports_[pair.a], supports_[pair.b]);
    const auto back = relative_pose(supports_[pair.a], supports_[pair.b], offset);
    FacetContacts<decltype(facets_), S> contacts(facets_, contacts_room);
    contacts.find(terrain, solid, pose, bodies[other].reach, reach, margin);
    for (std::size_t i = 0; i < facets_.size() && current_.size() < contacts_room; ++i) {
      const auto& found = facets_[i].manifold;
      if (found.count == 0) continue;
      const auto last = contacts.last_of(i, before, old);
      add_contact(bodies, pair, {is_first ? found : swapped(back, found), offset},
                  last < before.size() ? &before[last] : nullptr);
      current_.back().part = facets_[i].part.index;
    }
  }

  constexpr void add_contact(const Bodies& bodies, const BodyPair& pair, const Found& found,
                             const ContactState* before) {
    if (found.manifold.count == 0) return;
    if (is_sensed(bodies, pair.a, pair.b)) {
      current_.push_back(sensed(pair, found.manifold));
    } else {
      current_.push_back(continued(pair, found.manifold, before));
    }
    found_.push_back(found);
  }

  /// Whether one of two bodies is a sensor, so that nothing is pushed.
  static constexpr bool is_sensed(const Bodies& bodies, std::uint32_t a, std::uint32_t b) noexcept {
    return bodies[a].is_sensor || bodies[b].is_sensor;
  }
  /// A contact with a sensor: whether they overlap.
  static constexpr ContactState sensed(const BodyPair& pair,
                                       const Manifold<S, N>& manifold) noexcept {
    auto contact = continued(pair, manifold, nullptr);
    for (std::size_t i = 0; i < contact.count; ++i) {
      contact.touches = contact.touches || manifold.points[i].separation <= 0;
    }
    return contact;
  }

  static constexpr ContactState continued(const BodyPair& pair, const Manifold<S, N>& manifold,
                                          const ContactState* before) noexcept {
    ContactState contact;
    contact.a = pair.a;
    contact.b = pair.b;
    contact.count = static_cast<std::uint8_t>(manifold.count);
    for (std::size_t i = 0; i < contact.count; ++i) {
      contact.feature[i] = manifold.points[i].feature;
    }
    if (before == nullptr) return contact;
    contact.touches = before->touches;
    contact.friction = before->friction;
    for (std::size_t i = 0; i < contact.count; ++i) {
      for (std::size_t j = 0; j < before->count; ++j) {
        if (before->feature[j] == contact.feature[i]) contact.pressure[i] = before->pressure[j];
      }
    }
    return contact;
  }

  /// Calls f(a, b) for the bodies of each contact without a sensor.
  template <class Found>
  constexpr void for_each_pushing(const Bodies& bodies, const Found& f) {
    for (std::size_t i = 0; i < current_.size(); ++i) {
      const auto a = current_[i].a, b = current_[i].b;
      if (!is_sensed(bodies, a, b)) f(a, b);
    }
  }

  /// An island with a body that is awake, or that a moving kinematic body touches, is awake.
  constexpr void wake(Bodies& bodies, const Joints& joints) {
    islands_.reset(bodies.size());
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
      if (bodies[a].can_move() && bodies[b].can_move()) islands_.join(a, b);
    };
    for_each_pushing(bodies, join);
    group_.for_each_pair(joints, join);
    awake_.clear();
    awake_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].can_move() && !bodies[i].sleeps) awake_[island(i)] = 1;
    }
    const auto drive = [&](std::uint32_t a, std::uint32_t b) {
      if (is_driven(bodies[a])) awake_[islands_.of(b)] = 1;
      if (is_driven(bodies[b])) awake_[islands_.of(a)] = 1;
    };
    for_each_pushing(bodies, drive);
    group_.for_each_pair(joints, drive);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!bodies[i].can_move()) continue;
      const bool sleeps = awake_[island(i)] == 0;
      if (bodies[i].sleeps && !sleeps) bodies[i].quiet = 0;
      bodies[i].sleeps = sleeps;
    }
  }

  /// A colour for each contact that is awake: the least that no earlier contact of its bodies has;
  /// the last colour for all others. Contacts of a colour share no body that can move.
  constexpr void order(const Bodies& bodies) {
    used_.clear();
    used_.resize(bodies.size());
    colour_.resize(current_.size());
    std::array<std::uint32_t, colours + 1> start{};
    for (std::size_t i = 0; i < current_.size(); ++i) {
      const auto& contact = current_[i];
      const bool moves_a = is_awake(bodies[contact.a]), moves_b = is_awake(bodies[contact.b]);
      if ((!moves_a && !moves_b) || is_sensed(bodies, contact.a, contact.b)) {
        colour_[i] = asleep;
        continue;
      }
      const auto taken = (moves_a ? used_[contact.a] : 0) | (moves_b ? used_[contact.b] : 0);
      const int colour = (std::min)(std::countr_one(taken), colours - 1);
      colour_[i] = static_cast<std::uint8_t>(colour);
      if (moves_a) used_[contact.a] |= std::uint64_t{1} << colour;
      if (moves_b) used_[contact.b] |= std::uint64_t{1} << colour;
      ++start[static_cast<std::size_t>(colour) + 1];
    }
    for (std::size_t c = 0; c < colours; ++c) start[c + 1] += start[c];
    ready_.clear();
    ready_.resize(start[colours]);
    for (std::size_t i = 0; i < current_.size(); ++i) {
      if (colour_[i] == asleep) continue;
      auto& ready = ready_[start[colour_[i]]++];
      ready.contact = static_cast<std::uint32_t>(i);
      ready.a = current_[i].a;
      ready.b = current_[i].b;
    }
  }

  constexpr void prepare_all(const Bodies& bodies) {
    using Ratio = typename F::Ratio;
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      auto& ready = ready_[i];
      const Body &a = bodies[ready.a], &b = bodies[ready.b];
      const auto& found = found_[ready.contact];
      const auto [share_a, share_b] = mass_shares<S>(a, b);
      prepare(ready, found.manifold, supports_[ready.a], supports_[ready.b], found.offset, share_a,
              share_b);
      ready.grip = sqrt_floor<Ratio>(a.friction * b.friction);
      ready.bounce = saturate_to<Ratio>((max)(a.restitution, b.restitution));
      for (std::size_t k = 0; k < ready.count; ++k) {
        ready.closing[k] = rate_along<S, N>(ready.normal.along, ready.pressure[k],
                                            moving_[ready.a].velocity, moving_[ready.a].spin,
                                            moving_[ready.b].velocity, moving_[ready.b].spin);
      }
    }
  }

  constexpr void substep(Bodies& bodies, Joints& joints, const Pace<S, N>& pace) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (is_awake(bodies[i])) {
        accelerate(bodies[i], moving_[i], supports_[i].axes, half_way_[i], pace);
      }
    }
    group_.warm_start(joints, moving_);
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      const auto& ready = ready_[i];
      warm_start(ready, current_[ready.contact], moving_[ready.a], moving_[ready.b]);
    }
    group_.template solve_all<Pass::biased>(joints, moving_);
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      auto& ready = ready_[i];
      solve_pressure<Pass::biased>(ready, current_[ready.contact], moving_[ready.a],
                                   moving_[ready.b], pace.push);
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const bool moves = is_awake(bodies[i]) || is_driven(bodies[i]);
      if (moves) move(bodies[i], moving_[i], half_way_[i], supports_[i].axes);
    }
    group_.follow(joints, bodies, supports_);
    group_.template solve_all<Pass::relaxed>(joints, moving_);
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      auto& ready = ready_[i];
      auto& contact = current_[ready.contact];
      solve_pressure<Pass::relaxed>(ready, contact, moving_[ready.a], moving_[ready.b], pace.push);
      solve_friction(ready, contact, moving_[ready.a], moving_[ready.b]);
    }
  }

  /// Writes velocities back, and lets quiet islands sleep.
  constexpr void finish(Bodies& bodies, const Pace<S, N>& pace) {
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      const auto& ready = ready_[i];
      bool touches = false;
      for (std::size_t k = 0; k < ready.count; ++k) {
        touches = touches || ready.was_pushed[k] || ready.gap[k] <= 0;
      }
      current_[ready.contact].touches = touches;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) awake_[i] = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Body& body = bodies[i];
      if (!is_awake(body)) continue;
      body.state.velocity = moving_[i].velocity;
      body.state.spin = moving_[i].spin;
      body.push = {};
      body.twist = {};
      const bool is_quiet = is_slow(body.state, pace);
      body.quiet = is_quiet ? static_cast<std::uint8_t>((std::min)(body.quiet + 1, 255)) : 0;
      if (body.quiet < (std::min)(pace.quiet_ticks, 255)) awake_[island(i)] = 1;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Body& body = bodies[i];
      if (!is_awake(body) || awake_[island(i)] != 0 || pace.sleep <= 0) continue;
      body.sleeps = true;
      body.state.velocity = {};
      body.state.spin = {};
    }
  }

  /// Whether no body moves by itself.
  static constexpr bool stands_still(const Bodies& bodies) noexcept {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (is_awake(bodies[i]) || is_driven(bodies[i])) return false;
    }
    return true;
  }
  /// Whether the contacts found are those of the last tick.
  constexpr bool have_stayed(const Contacts& before) const noexcept {
    if (before.size() != current_.size()) return false;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (!(before[i] == current_[i])) return false;
    }
    return true;
  }

  static constexpr bool is_slow(const BodyState<S, N>& state, const Pace<S, N>& pace) noexcept {
    for (int i = 0; i < N; ++i) {
      if (abs(state.velocity[i]) > pace.sleep) return false;
    }
    for (const auto& w : state.spin) {
      if (abs(w) > pace.sleep_spin) return false;
    }
    return true;
  }

  static constexpr Moving<S, N> moving_of(const Body& body) noexcept {
    Moving<S, N> moving;
    if (body.generation == 0 || body.motion == BodyMotion::fixed) return moving;
    moving.velocity = body.state.velocity;
    moving.spin = body.state.spin;
    return moving;
  }
  static constexpr bool is_awake(const Body& body) noexcept {
    return body.generation != 0 && body.can_move() && !body.sleeps;
  }
  /// A kinematic body that moves.
  static constexpr bool is_driven(const Body& body) noexcept {
    return body.generation != 0 && body.motion == BodyMotion::kinematic &&
           !(body.state.velocity == Vec<typename F::Speed, N>() &&
             body.state.spin == Axial<typename F::Spin, N>());
  }
  constexpr std::uint32_t island(std::size_t body) noexcept {
    return islands_.of(static_cast<std::uint32_t>(body));
  }

  static constexpr int colours = 64;
  static constexpr std::uint8_t asleep = 0xff;
  static constexpr std::size_t pair_room = 4 * contacts_room;

  template <class T, std::size_t Room>
  using List = typename Storage::template List<T, Room>;
  List<Support<S, N>, bodies_room> supports_;
  List<Standing<S, N>, bodies_room> starts_;  // empty without a fast body
  List<Moving<S, N>, bodies_room> moving_;
  List<Axes<S, N>, bodies_room> half_way_;  // the axes at the middle of the substep
  List<SweepEntry<S, N>, bodies_room> swept_;
  List<std::uint32_t, bodies_room> lane_;
  List<BodyPair, pair_room> pairs_;
  Contacts current_;
  List<Found, contacts_room> found_;
  List<FacetContact<S>, (is_surface_body<Parts> || ...) ? contacts_room : 0> facets_;
  List<ReadyContact<S, N>, contacts_room> ready_;
  List<std::uint8_t, contacts_room> colour_;
  List<std::uint64_t, bodies_room> used_;
  List<std::uint8_t, bodies_room> awake_;
  Islands<List<std::uint32_t, bodies_room>> islands_;
  Group group_;
};

}  // namespace detent::detail
