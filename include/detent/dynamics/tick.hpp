// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/cull/prefetch.hpp"
#include "detent/dynamics/contact_group.hpp"
#include "detent/dynamics/fast.hpp"
#include "detent/dynamics/flight.hpp"
#include "detent/dynamics/four_contacts.hpp"
#include "detent/dynamics/four_flight.hpp"
#include "detent/dynamics/hold.hpp"
#include "detent/dynamics/idle.hpp"
#include "detent/dynamics/islands.hpp"
#include "detent/dynamics/joint/group.hpp"
#include "detent/dynamics/manifold/pair.hpp"
#include "detent/dynamics/manifold/terrain.hpp"
#include "detent/dynamics/pairs.hpp"
#include "detent/dynamics/record.hpp"
#include "detent/dynamics/relative.hpp"
#include "detent/dynamics/rolling.hpp"
#include "detent/dynamics/solve.hpp"
#include "detent/dynamics/threads.hpp"
#include "detent/number/next_up.hpp"
#include "detent/scene/one_of.hpp"

namespace detent::detail {

/// The contact capacity of a world with this body capacity.
[[nodiscard]] constexpr std::size_t contact_room(std::size_t bodies) noexcept { return 8 * bodies; }

/// The scratch data of one step of a world. It does not outlive the step, so copies of a world,
/// which a rollback makes in every frame, omit it.
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
  static constexpr bool has_round = (Round<Parts> || ...);
  using ContactState = std::conditional_t<has_round, RollingContact<S, N>, BodyContact<S, N>>;
  static constexpr std::size_t bodies_room = Storage::capacity;
  static constexpr std::size_t contacts_room = contact_room(Storage::capacity);
  static constexpr std::size_t passes_room = Storage::capacity;
  using Bodies = typename Storage::template List<Body, bodies_room>;
  using Contacts = typename Storage::template List<ContactState, contacts_room>;
  using Ready = ReadyContact<S, N>;
  using Rows = ContactRows<S, N>;

  static constexpr bool has_compounds = (is_compound_body<Parts> || ...);

  constexpr Tick() noexcept = default;
  constexpr Tick(const Tick&) noexcept {}
  constexpr Tick& operator=(const Tick&) noexcept { return *this; }

  /// One step. Returns whether it changed nothing, in which case the next one would not either.
  ///
  /// Parallel calls write only to their own elements: contacts of one colour share no body that can
  /// move.
  template <class Threads>
  constexpr bool run(Bodies& bodies, Contacts& contacts, Joints& joints, const Pace<S, N>& pace,
                     int substeps, const S& margin, const Threads& threads) {
    place(bodies, threads);
    const bool has_fast = note_starts(bodies);
    group_.part(joints);
    find_pairs(bodies, margin);
    are_held_ = pace.hold > 0;
    hold_back(bodies);
    touch(bodies, contacts, margin, pace.margin, threads);
    wake(bodies, joints);
    const bool is_still = !has_fast && stands_still(bodies) && have_stayed(contacts);
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      moving_[i] = motion_of(bodies[i]);
      if (!are_held_) continue;
      moving_[i].shift = bodies[i].drift;
      moving_[i].turn = leans_[i];
    }
    const bool has_rolling = has_round && resist_rolling(bodies);
    are_grouped_ = has_groups && runs_vectors() && !has_rolling;  // groups have no rows for rolling
    const auto ends = order(bodies);
    rolling_.clear();
    if (has_rolling) rolling_.resize(ready_.size());
    prepare_all(bodies, ends, threads);
    if (are_held_) {
      measure_gaps(bodies, ends, threads);
      let_go(bodies);
    }
    group_.prepare(joints, bodies, supports_, pace.rate);
    for (int i = 0; i < substeps; ++i) {
      substep(static_cast<std::size_t>(i), bodies, joints, pace, ends, threads);
    }
    scatter_all(threads);
    group_.finish(joints);
    for_each_ready(ends, threads, [&](Ready& ready, const Rows& rows) {
      bounce(ready, rows, found_.contacts[ready.contact], moving_[ready.a], moving_[ready.b],
             pace.bounce);
    });
    finish(bodies, pace);
    passes_.clear();
    if (has_fast) {
      stop_fast(bodies, margin);
      find_passes(bodies, contacts, margin, pace.margin, threads);
    }
    std::swap(contacts, found_.contacts);
    return is_still;
  }

  /// The pairs with a sensor of which a fast body passed the other one in the last run, in order.
  /// They touched neither at its start nor at its end.
  [[nodiscard]] constexpr const auto& passes() const noexcept { return passes_; }

  /// The contacts before the last run.
  [[nodiscard]] constexpr const Contacts& contacts_before() const noexcept {
    return found_.contacts;
  }

  /// Calls f(index) for each joint that broke in the last run, in order.
  template <class Broken>
  constexpr void for_each_broken(const Broken& f) const {
    group_.for_each_broken(f);
  }

  /// Calls f for each contact of a pair that touches and pushes, as the next run would find it: with
  /// the contact, the support of a, the manifold, and the position of b relative to a. Those of the
  /// pair in `contacts` begin at `first`.
  template <class F2>
  static constexpr void visit_touching(const Bodies& bodies, const Contacts& contacts,
                                       std::size_t first, const S& reach,
                                       const typename F::Lever& margin, const F2& f) {
    const auto pair = pair_of(contacts[first]);
    const Body &a = bodies[pair.a], &b = bodies[pair.b];
    const auto held_a = held_support(a), held_b = held_support(b);
    PairSearch search;
    touch_pair(bodies, {pair.a, held_a, held_b}, pair,
               slack_of(a, lean_of(a)) + slack_of(b, lean_of(b)), contacts, first, reach, margin,
               search);
    for (std::size_t i = 0; i < search.contacts.size(); ++i) {
      const auto& contact = search.contacts[i];
      if (!contact.touches || is_sensed(bodies, contact)) continue;
      f(contact, held_a, search.manifolds[i].manifold, search.manifolds[i].offset);
    }
  }

  /// The identity of a contact in events: bodies, and the parts of compounds, but no triangles.
  template <class Contact>
  [[nodiscard]] static constexpr ContactKey touching(const Bodies& bodies,
                                                     const Contact& contact) noexcept {
    auto key = key_of(contact);
    if (!are_compounds(bodies, key.pair)) key.part = 0;
    return key;
  }
  /// The indices of the parts of compounds; 0 for other bodies.
  [[nodiscard]] static constexpr std::array<std::uint32_t, 2> parts_touching(
      const Bodies& bodies, const ContactKey& key) noexcept {
    if (compound_of<S, N>(bodies[key.pair.a].shape) == nullptr) return {0, key.member};
    const bool are_two = compound_of<S, N>(bodies[key.pair.b].shape) != nullptr;
    return {key.member, are_two ? key.part : 0};
  }
  /// The triangle of a contact with a mesh or height field; 0 for others.
  [[nodiscard]] static constexpr std::uint32_t triangle_of(const Bodies& bodies,
                                                           const ContactState& contact) noexcept {
    return are_compounds(bodies, pair_of(contact)) ? 0 : contact.part;
  }

 private:
  template <class T, std::size_t Room>
  using List = typename Storage::template List<T, Room>;

  /// A pair's manifold, kept from the search for contacts until they are prepared.
  struct Found {
    Manifold<S, N> manifold{};
    Vec<typename F::Lever, N> offset{};
  };

  /// The supports of two bodies, by their indices.
  struct PairSupports {
    std::uint32_t index_of_a;
    const Support<S, N>&a, &b;

    [[nodiscard]] constexpr const Support<S, N>& operator[](std::uint32_t index) const noexcept {
      return index == index_of_a ? a : b;
    }
  };

  /// Whether both bodies are compounds.
  [[nodiscard]] static constexpr bool are_compounds(const Bodies& bodies,
                                                    const BodyPair& pair) noexcept {
    return has_compounds && compound_of<S, N>(bodies[pair.a].shape) != nullptr &&
           compound_of<S, N>(bodies[pair.b].shape) != nullptr;
  }

  static constexpr int colours = 64, pair_colours = 48;
  static constexpr bool has_groups = uses_long_lanes<Storage, S, N>;
  using ColourEnds = std::array<std::uint32_t, colours + 1>;

  /// The contacts of some pairs, in order, and their manifolds.
  template <std::size_t Room>
  struct SearchOf {
    static constexpr std::size_t room = Room;
    List<ContactState, Room> contacts;
    List<Found, Room> manifolds;
    List<FacetContact<S>, (is_surface_body<Parts> || ...) ? Room : 0> facets;

    [[nodiscard]] constexpr bool is_full() const noexcept { return contacts.size() >= Room; }
  };
  using Search = SearchOf<contacts_room>;
  /// The contacts of one pair: of the same type if it allocates, otherwise small enough for a stack.
  static constexpr bool is_growing = requires { Storage::is_growing; };
  using PairSearch =
      SearchOf<is_growing ? contacts_room : (std::min)(contacts_room, std::size_t{64})>;

  template <class Threads>
  constexpr void place(const Bodies& bodies, const Threads& threads) {
    supports_.resize(bodies.size());
    moving_.resize(bodies.size());
    half_way_.resize(bodies.size());
    each_block(bodies, threads, [&](std::size_t begin, std::size_t end) {
      SupportQueue<has_groups, S, N, Bodies, decltype(supports_)> queue(bodies, supports_);
      for (std::size_t i = begin; i < end; ++i) {
        if (bodies[i].generation != 0) queue.add(i, false);
      }
      queue.flush();
    });
  }

  /// Calls f(begin, end) for ranges of bodies: of one body, or of 32 where four are processed at
  /// once.
  template <class Threads, class Visit>
  static constexpr void each_block(const Bodies& bodies, const Threads& threads, const Visit& f) {
    constexpr std::size_t size = 32;
    if constexpr (has_groups) {
      threads.each(0, (bodies.size() + size - 1) / size, bodies_a_call / size,
                   [&](std::size_t k) { f(k * size, (std::min)((k + 1) * size, bodies.size())); });
    } else {
      threads.each(0, bodies.size(), bodies_a_call, [&](std::size_t i) { f(i, i + 1); });
    }
  }

  /// Records the poses of bodies, if one of them is fast.
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

  /// Stops fast bodies on their paths through this tick, for the other bodies in the order of their
  /// ranks. The last stop counts, so fixed bodies come last.
  constexpr void stop_fast(Bodies& bodies, const S& margin) {
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      if (!is_fast(bodies[i])) continue;
      const auto ball = inner_ball_of(bodies[i]);
      for (int rank = 0; rank < 4; ++rank) {
        for (std::uint32_t j = 0; j < bodies.size(); ++j) {
          if (can_collide(bodies, i, j) && rank_of(bodies[j]) == rank) {
            meet_on_way(bodies, i, j, ball, margin, false);
          }
        }
      }
    }
  }
  /// Whether `other` is another body that can touch a body that can move.
  constexpr bool can_collide(const Bodies& bodies, std::uint32_t body, std::uint32_t other) const {
    return other != body && bodies[other].generation != 0 && meet(bodies[body], bodies[other]) &&
           !group_.keeps_apart({(std::min)(body, other), (std::max)(body, other)});
  }
  static constexpr int rank_of(const Body& body) noexcept {
    if (body.motion == BodyMotion::fixed) return 3;
    return body.motion == BodyMotion::kinematic ? 2 : is_fast(body) ? 0 : 1;
  }
  /// The greatest ball about a body's center that lies inside one of its shapes; the part that it
  /// is in.
  struct InnerBall {
    S radius{};
    std::uint32_t part = 0;
  };
  static constexpr InnerBall inner_ball_of(const Body& body) noexcept {
    return body.shape.visit([]<class Mine>(const Mine& mine) {
      InnerBall ball;
      if constexpr (is_compound_body<Mine>) {
        if (mine.asset == nullptr) return ball;
        const auto parts = mine.asset->parts();
        for (std::size_t k = 0; k < parts.size(); ++k) {
          if (parts[k].options().is_sensor) continue;
          const auto pose = pose_in(*mine.asset, parts[k]);
          visit_part(parts[k], [&](const auto& solid) {
            const auto radius = inner_radius(solid, pose);
            if (radius > ball.radius) ball = {radius, static_cast<std::uint32_t>(k)};
          });
        }
      } else if constexpr (!is_surface_body<Mine>) {
        ball.radius = (max)(ball.radius, inner_radius(mine));
      }
      return ball;
    });
  }
  /// Stops a fast body before the shapes of another one on its path through this tick; or, if it
  /// `passes`, finds the sensors among them.
  constexpr void meet_on_way(Bodies& bodies, std::uint32_t fast, std::uint32_t index,
                             const InnerBall& ball, const S& margin, bool passes) {
    Body& body = bodies[fast];
    const Body& other = bodies[index];
    const bool are_sensed = is_sensed(bodies, fast, index);
    if (are_sensed != passes && compound_of<S, N>(other.shape) == nullptr) return;
    const auto before = starts_[index];
    const auto after =
        other.motion == BodyMotion::fixed
            ? before
            : Standing<S, N>{other.state.place, axes_of<S, N>(other.state.orientation)};
    const auto meet = [&](std::uint32_t part, const auto& shape, const BodyExtent<S, N>& extent,
                          const Standing<S, N>& from, const Standing<S, N>& to) {
      const auto at = stop_before(shape, extent, seen_from(from, starts_[fast].place),
                                  seen_from(to, body.state.place), ball.radius, margin);
      if (!at) return;
      if (passes) {
        add_pass(bodies, fast < index ? event_key(bodies, {fast, index}, ball.part, part)
                                      : event_key(bodies, {index, fast}, part, ball.part));
      } else {
        stop(body, out_of(to, *at));
      }
    };
    other.shape.visit([&]<class Other>(const Other& shape) {
      if constexpr (is_compound_body<Other>) {
        if (shape.asset == nullptr) return;
        const auto parts = shape.asset->parts();
        for (std::size_t k = 0; k < parts.size(); ++k) {
          if ((are_sensed || parts[k].options().is_sensor) != passes) continue;
          const auto pose = pose_in(*shape.asset, parts[k]);
          visit_part(parts[k], [&](const auto& solid) {
            meet(static_cast<std::uint32_t>(k), solid, parts[k].reach(), part_at(before, pose),
                 part_at(after, pose));
          });
        }
      } else {
        meet(0, shape, other.reach, before, after);
      }
    });
  }
  static constexpr void stop(Body& body, const Vec<typename F::Place, N>& place) noexcept {
    for (int k = 0; k < N; ++k) {
      if (!is_locked(body.locked, k)) body.state.place[k] = place[k];
    }
    body.let_go();
    body.sleeps = false;
    body.quiet = 0;
  }

  /// Finds the sensors that fast bodies passed, or bodies that fast sensors passed, between the
  /// start and the end of this tick.
  template <class Threads>
  constexpr void find_passes(Bodies& bodies, const Contacts& before, const S& margin,
                             const typename F::Lever& reach, const Threads& threads) {
    const auto now = found_.contacts.size();
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      if (!is_fast(bodies[i])) continue;
      const auto ball = inner_ball_of(bodies[i]);
      for (std::uint32_t j = 0; j < bodies.size(); ++j) {
        if (can_collide(bodies, i, j)) meet_on_way(bodies, i, j, ball, S(0), true);
      }
    }
    if (passes_.size() == 0) return;
    std::sort(&passes_[0], &passes_[0] + passes_.size());
    // What touches at the end is left to the next tick, which finds these contacts again.
    pairs_.clear();
    for (std::size_t k = 0; k < passes_.size(); ++k) {
      if (k == 0 || passes_[k].pair != passes_[k - 1].pair) pairs_.push_back(passes_[k].pair);
    }
    place(bodies, threads);
    hold_back(bodies);
    touch(bodies, before, margin, reach, 0, pairs_.size(), found_);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < passes_.size(); ++k) {
      if (!touches(bodies, now, passes_[k])) passes_[kept++] = passes_[k];
    }
    passes_.resize(kept);
    found_.contacts.resize(now);
  }
  constexpr void add_pass(const Bodies& bodies, const ContactKey& key) {
    if (passes_.size() == passes_room || touches(bodies, 0, key)) return;
    for (std::size_t k = 0; k < passes_.size(); ++k) {
      if (passes_[k] == key) return;  // both are fast
    }
    passes_.push_back(key);
  }
  /// Whether a pair touches in one of the contacts from `first` on.
  constexpr bool touches(const Bodies& bodies, std::size_t first, const ContactKey& key) const {
    for (std::size_t k = first; k < found_.contacts.size(); ++k) {
      const auto& contact = found_.contacts[k];
      if (contact.touches && touching(bodies, contact) == key) return true;
    }
    return false;
  }
  /// The identity in events of a pair of parts, as `touching` gives it.
  static constexpr ContactKey event_key(const Bodies& bodies, const BodyPair& pair,
                                        std::uint32_t part_a, std::uint32_t part_b) noexcept {
    if (compound_of<S, N>(bodies[pair.a].shape) == nullptr) {
      return {pair, static_cast<std::uint16_t>(part_b)};
    }
    return {pair, static_cast<std::uint16_t>(part_a), part_b};
  }

  /// Calls f with the shape of a part, as one of the types that the world names.
  template <class F2>
  static constexpr void visit_part(const BodyPart<S, N>& part, const F2& f) {
    part.shape().visit([&]<class Shape>(const Shape& shape) {
      if constexpr (Among<Shape, Parts...>) f(shape);
    });
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
    const auto add = [&](const BodyPair& pair) {
      const Body &a = bodies[pair.a], &b = bodies[pair.b];
      if (meet(a, b) && (a.can_move() || b.can_move()) && !group_.keeps_apart(pair) &&
          pairs_.size() < pair_room) {
        pairs_.push_back(pair);
      }
    };
    if constexpr (is_growing) {
      order_entries(swept_, unordered_entries_, lane_);
      sweep(&swept_[0], swept_.size(), members_, lane_, add);
      if (pairs_.size() > 32) {
        order_pairs(pairs_, unordered_pairs_, lane_, bodies.size());
        return;
      }
    } else {
      order_entries(swept_);
      sweep(&swept_[0], swept_.size(), lane_, add);
    }
    if (pairs_.size() != 0) std::sort(&pairs_[0], &pairs_[0] + pairs_.size());
  }

  /// The contacts of this tick, in order of their bodies, with the impulses of the last one. On
  /// several threads each block of pairs has its own list, and the lists are concatenated in order.
  template <class Threads>
  constexpr void touch(const Bodies& bodies, const Contacts& before, const S& reach,
                       const typename F::Lever& margin, const Threads& threads) {
    found_.contacts.clear();
    found_.manifolds.clear();
    if constexpr (Threads::are_many && is_growing) {
      searches_.resize((pairs_.size() + pairs_a_call - 1) / pairs_a_call);
      threads.each(0, searches_.size(), 1, [&](std::size_t k) {
        auto mine = std::move(searches_[k]);
        mine.contacts.clear();
        mine.manifolds.clear();
        const auto begin = k * pairs_a_call;
        touch(bodies, before, reach, margin, begin, (std::min)(begin + pairs_a_call, pairs_.size()),
              mine);
        searches_[k] = std::move(mine);
      });
      for (const auto& part : searches_) {
        for (std::size_t i = 0; i < part.contacts.size(); ++i) {
          if (found_.contacts.size() == contacts_room) return;
          found_.contacts.push_back(part.contacts[i]);
          found_.manifolds.push_back(part.manifolds[i]);
        }
      }
    } else {
      touch(bodies, before, reach, margin, 0, pairs_.size(), found_);
    }
  }

  /// The contacts of the pairs from `begin` to before `end`.
  constexpr void touch(const Bodies& bodies, const Contacts& before, const S& least_reach,
                       const typename F::Lever& least_margin, std::size_t begin, std::size_t end,
                       Search& out) const {
    std::size_t old = 0;
    if (begin != 0) {
      old = static_cast<std::size_t>(
          std::partition_point(
              before.data(), before.data() + before.size(),
              [&](const ContactState& contact) { return pair_of(contact) < pairs_[begin]; }) -
          before.data());
    }
    for (std::size_t p = begin; p < end && !out.is_full(); ++p) {
      const BodyPair pair = pairs_[p];
      while (old < before.size() && pair_of(before[old]) < pair) ++old;
      auto slack = typename F::Lever() + typename F::Lever();
      if (are_held_) slack = slacks_[pair.a] + slacks_[pair.b];
      touch_pair(bodies, {pair.a, held()[pair.a], held()[pair.b]}, pair, slack, before, old,
                 least_reach, least_margin, out);
    }
  }

  /// The contacts of a pair of bodies whose supports are in `held`. `before` has the contacts of the
  /// last tick; those of this pair begin at `old`.
  template <class Slack, class Out>
  static constexpr void touch_pair(const Bodies& bodies, const PairSupports& held,
                                   const BodyPair& pair, const Slack& slack, const Contacts& before,
                                   std::size_t old, S reach, typename F::Lever margin, Out& out) {
    if (slack != 0) {
      reach = wider(reach, slack);
      margin = saturate_to<typename F::Lever>(margin + slack);
    }
    bodies[pair.a].shape.visit([&]<class A>(const A& first) {
      bodies[pair.b].shape.visit([&]<class B>(const B& second) {
        if constexpr (is_surface_body<A> && is_surface_body<B>) {
          return;  // none of them can move
        } else if constexpr (is_compound_body<A> || is_compound_body<B>) {
          touch_parts(bodies, pair, held, first, second, before, old, reach, margin, out);
        } else if constexpr (is_surface_body<A>) {
          touch_terrain(bodies, {pair}, held, first,
                        Placed<B>{second, held[pair.b], bodies[pair.b].reach}, true, before, old,
                        reach, margin, out);
        } else if constexpr (is_surface_body<B>) {
          touch_terrain(bodies, {pair}, held, second,
                        Placed<A>{first, held[pair.a], bodies[pair.a].reach}, false, before, old,
                        reach, margin, out);
        } else {
          const auto& a = held[pair.a];
          const auto& b = held[pair.b];
          const auto offset = offset_between(a, b);
          if constexpr (Round<A> && Round<B>) {
            const auto &reach_a = bodies[pair.a].reach, &reach_b = bodies[pair.b].reach;
            if (centers_are_apart(reach_a, reach_b, offset, margin)) return;
          }
          RelativePose<S, N> pose;
          if constexpr (std::is_same_v<B, Sphere<S, N>>) {
            pose.translation = relative_place(a, offset);  // a ball has no axes
          } else {
            if (is_surely_beyond(a, offset, first, second, margin)) return;
            pose = relative_pose(a, b, offset);
          }
          const bool known = old < before.size() && pair_of(before[old]) == pair;
          add_contact(bodies, {pair}, {manifold(first, second, pose, margin), offset},
                      known ? &before[old] : nullptr, out);
        }
      });
    });
  }

  /// The margin plus the slack, rounded up.
  template <class Slack>
  static constexpr S wider(const S& margin, const Slack& slack) noexcept {
    if constexpr (is_fixed<S>) {
      return saturate_to<S>(margin + slack + half(next_up(S(0))));
    } else {
      return margin + slack;
    }
  }

  /// A shape in the world: a whole body, or a part of a compound.
  template <class Shape>
  struct Placed {
    const Shape& shape;
    const Support<S, N>& support;
    const BodyExtent<S, N>& reach;
    const RelativePose<S, N>* in_body = nullptr;  // the frame of a part in that of its body
    std::uint32_t part = 0;
  };

  /// Calls f for each part of a compound in order, or once for a body with a single shape.
  template <class Shape, class Visit>
  static constexpr void for_each_placed(const Bodies& bodies, std::uint32_t body,
                                        const PairSupports& held, const Shape& shape,
                                        const Visit& f) {
    if constexpr (is_compound_body<Shape>) {
      if (shape.asset == nullptr) return;
      const auto parts = shape.asset->parts();
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const auto pose = pose_in(*shape.asset, parts[k]);
        const auto at = part_at(Standing<S, N>{held[body].place, held[body].axes}, pose);
        Support<S, N> support;
        support.place = at.place;
        support.axes = at.axes;
        visit_part(parts[k], [&]<class Part>(const Part& part) {
          f(Placed<Part>{part, support, parts[k].reach(), &pose, static_cast<std::uint32_t>(k)});
        });
      }
    } else {
      f(Placed<Shape>{shape, held[body], bodies[body].reach});
    }
  }

  /// The contacts of two bodies, at least one of which is a compound.
  template <class A, class B, class Out>
  static constexpr void touch_parts(const Bodies& bodies, const BodyPair& pair,
                                    const PairSupports& held, const A& first, const B& second,
                                    const Contacts& before, std::size_t old, const S& reach,
                                    const typename F::Lever& margin, Out& out) {
    const auto known = [&](const ContactKey& key) {
      while (old < before.size() && key_of(before[old]) < key) ++old;
      return old < before.size() && key_of(before[old]) == key ? &before[old] : nullptr;
    };
    const auto numbered = [&](std::uint32_t part) {
      return ContactKey{pair, static_cast<std::uint16_t>(part)};
    };
    if constexpr (is_surface_body<A>) {
      for_each_placed(bodies, pair.b, held, second, [&](const auto& b) {
        const auto key = numbered(b.part);
        known(key);
        touch_terrain(bodies, key, held, first, b, true, before, old, reach, margin, out);
      });
    } else if constexpr (is_surface_body<B>) {
      for_each_placed(bodies, pair.a, held, first, [&](const auto& a) {
        const auto key = numbered(a.part);
        known(key);
        touch_terrain(bodies, key, held, second, a, false, before, old, reach, margin, out);
      });
    } else {
      const auto offset = offset_between(held[pair.a], held[pair.b]);
      for_each_placed(bodies, pair.a, held, first, [&](const auto& a) {
        const auto box_a = bounds_of<S, N>(a.support.place, a.support.axes, a.reach, reach);
        for_each_placed(bodies, pair.b, held, second, [&](const auto& b) {
          if (out.is_full()) return;
          const auto box_b = bounds_of<S, N>(b.support.place, b.support.axes, b.reach, reach);
          if (!meet(box_a, box_b)) return;
          const auto pose =
              relative_pose(a.support, b.support, offset_between(a.support, b.support));
          auto found = manifold(a.shape, b.shape, pose, margin);
          if (found.count == 0) return;
          auto key = numbered(is_compound_body<A> ? a.part : b.part);
          if constexpr (is_compound_body<A>) {
            found = in_body(*a.in_body, found);
            key.part = b.part;
          }
          add_contact(bodies, key, {found, offset}, known(key), out);
        });
      });
    }
  }
  static constexpr bool meet(const BodyBox<S, N>& a, const BodyBox<S, N>& b) noexcept {
    for (int k = 0; k < N; ++k) {
      if (a.most[k] < b.least[k] || b.most[k] < a.least[k]) return false;
    }
    return true;
  }

  /// The contacts of a surface, which is the first or the second of the pair, and a solid. `before`
  /// has the contacts of the last tick; those of these bodies are at `old` or later.
  template <class Terrain, class Solid, class Out>
  static constexpr void touch_terrain(const Bodies& bodies, ContactKey key,
                                      const PairSupports& held, const Terrain& terrain,
                                      const Placed<Solid>& solid, bool is_first,
                                      const Contacts& before, std::size_t old, const S& reach,
                                      const typename F::Lever& margin, Out& out) {
    const auto& ground = held[is_first ? key.pair.a : key.pair.b];
    const auto& support = solid.support;
    const auto pose = relative_pose(ground, support, offset_between(ground, support));
    const auto offset = offset_between(held[key.pair.a], held[key.pair.b]);
    const auto back = relative_pose(held[key.pair.a], held[key.pair.b], offset);
    FacetContacts<decltype(out.facets), S> contacts(out.facets, Out::room);
    contacts.find(terrain, solid.shape, pose, solid.reach, reach, margin);
    std::size_t end = old;
    while (end < before.size() && pair_of(before[end]) == key.pair &&
           before[end].member == key.member) {
      ++end;
    }
    for (std::size_t i = 0; i < out.facets.size() && !out.is_full(); ++i) {
      const auto& found = out.facets[i].manifold;
      if (found.count == 0) continue;
      const auto last = contacts.last_of(i, before, old, end);
      key.part = out.facets[i].part.index;
      add_contact(bodies, key, {is_first ? found : swapped(back, found), offset},
                  last < end ? &before[last] : nullptr, out);
    }
  }

  template <class Out>
  static constexpr void add_contact(const Bodies& bodies, const ContactKey& key, const Found& found,
                                    const ContactState* before, Out& out) {
    if (found.manifold.count == 0) return;
    auto contact = continued(key, found.manifold, before);
    if (is_sensed(bodies, contact)) contact = sensed(key, found.manifold);
    out.contacts.push_back(contact);
    out.manifolds.push_back(found);
  }

  /// Whether one of two bodies is a sensor, so that neither is pushed.
  static constexpr bool is_sensed(const Bodies& bodies, std::uint32_t a, std::uint32_t b) noexcept {
    return bodies[a].is_sensor || bodies[b].is_sensor;
  }
  /// The same for a contact, whose parts may be sensors.
  static constexpr bool is_sensed(const Bodies& bodies, const ContactState& contact) noexcept {
    if (is_sensed(bodies, contact.a, contact.b)) return true;
    if constexpr (has_compounds) {
      const auto [a, b] = parts_of(bodies, contact);
      return (a != nullptr && a->options().is_sensor) || (b != nullptr && b->options().is_sensor);
    } else {
      return false;
    }
  }
  /// The parts that touch; nullptr for bodies that are not compounds.
  static constexpr std::array<const BodyPart<S, N>*, 2> parts_of(
      const Bodies& bodies, const ContactState& contact) noexcept {
    const auto* a = compound_of<S, N>(bodies[contact.a].shape);
    const auto* b = compound_of<S, N>(bodies[contact.b].shape);
    return {a == nullptr ? nullptr : &a->parts()[contact.member],
            b == nullptr ? nullptr : &b->parts()[a == nullptr ? contact.member : contact.part]};
  }
  /// A contact with a sensor: it records only whether they overlap.
  static constexpr ContactState sensed(const ContactKey& key,
                                       const Manifold<S, N>& manifold) noexcept {
    auto contact = continued(key, manifold, nullptr);
    for (std::size_t i = 0; i < contact.count; ++i) {
      contact.touches = contact.touches || manifold.points[i].separation <= 0;
    }
    return contact;
  }

  static constexpr ContactState continued(const ContactKey& key, const Manifold<S, N>& manifold,
                                          const ContactState* before) noexcept {
    ContactState contact;
    contact.a = key.pair.a;
    contact.b = key.pair.b;
    contact.member = key.member;
    contact.part = key.part;
    contact.count = static_cast<std::uint8_t>(manifold.count);
    for (std::size_t i = 0; i < contact.count; ++i) {
      contact.feature[i] = manifold.points[i].feature;
    }
    if (before == nullptr) return contact;
    contact.touches = before->touches;
    contact.friction = before->friction;
    if constexpr (has_round) contact.rolling = before->rolling;
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
    for (std::size_t i = 0; i < found_.contacts.size(); ++i) {
      const auto a = found_.contacts[i].a, b = found_.contacts[i].b;
      if (!is_sensed(bodies, found_.contacts[i])) f(a, b);
    }
  }

  /// Wakes islands: one is awake if one of its bodies is, or touches a moving kinematic body.
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

  /// Assigns a colour to each awake contact: the greatest, up to 47 for two moving bodies and up to
  /// 62 for others, that no earlier contact of its bodies has, or the last colour if there is none.
  /// So contacts with bodies that cannot move are solved last, and no later contact of the pass
  /// disturbs them. Except for the last colour, contacts of a colour share no body that can move, so
  /// those that seem idle can come last in their colour. Returns where in `ready_` each colour ends.
  constexpr ColourEnds order(const Bodies& bodies) {
    used_.clear();
    used_.resize(bodies.size());
    colour_.resize(found_.contacts.size());
    ColourEnds start{}, idle_start{};
    for (std::size_t i = 0; i < found_.contacts.size(); ++i) {
      const auto& contact = found_.contacts[i];
      const bool moves_a = is_awake(bodies[contact.a]), moves_b = is_awake(bodies[contact.b]);
      if ((!moves_a && !moves_b) || is_sensed(bodies, contact)) {
        colour_[i] = asleep;
        continue;
      }
      const auto taken = (moves_a ? used_[contact.a] : 0) | (moves_b ? used_[contact.b] : 0);
      const int first = (moves_a && moves_b ? pair_colours : colours - 1) - 1;
      const int free = first - std::countl_one(taken << (colours - 1 - first));
      const int colour = free < 0 ? colours - 1 : free;
      colour_[i] = static_cast<std::uint8_t>(colour);
      if (moves_a) used_[contact.a] |= std::uint64_t{1} << colour;
      if (moves_b) used_[contact.b] |= std::uint64_t{1} << colour;
      if (colour < colours - 1 && seems_idle(i)) {
        colour_[i] |= idle;
        ++idle_start[static_cast<std::size_t>(colour) + 1];
      } else {
        ++start[static_cast<std::size_t>(colour) + 1];
      }
    }
    for (std::size_t c = 0; c < colours; ++c) {
      const auto busy_end = start[c] + start[c + 1];
      start[c + 1] = busy_end + idle_start[c + 1];
      idle_start[c] = busy_end;
    }
    busy_ends_ = idle_start;
    ready_.resize(start[colours]);  // filled when contacts are prepared
    rows_.resize(start[colours]);
    for (std::size_t i = 0; i < found_.contacts.size(); ++i) {
      if (colour_[i] == asleep) continue;
      const std::size_t colour = colour_[i] & (colours - 1);
      auto& ready = ready_[(colour_[i] & idle) != 0 ? idle_start[colour]++ : start[colour]++];
      ready.contact = static_cast<std::uint32_t>(i);
      ready.a = found_.contacts[i].a;
      ready.b = found_.contacts[i].b;
      ready.was_pushed = {};
    }
    for (std::size_t c = 0; c < colours; ++c) start[c] = idle_start[c];
    return start;
  }
  /// Whether a contact probably stays idle in this tick. A wrong guess costs only time.
  constexpr bool seems_idle(std::size_t i) const noexcept {
    if constexpr (has_groups) {
      if (!are_grouped_) return false;
      using Speed = typename F::Speed;
      const auto& contact = found_.contacts[i];
      const auto& [manifold, offset] = found_.manifolds[i];
      for (const auto& impulse : contact.pressure) {
        if (impulse != 0) return false;
      }
      for (const auto& impulse : contact.friction) {
        if (impulse != 0) return false;
      }
      auto least = manifold.points[0].separation;
      for (std::size_t k = 1; k < contact.count; ++k) {
        least = (min)(least, manifold.points[k].separation);
      }
      if (least <= 0) return false;
      const auto n = out_of_axes<S, N>(held()[contact.a].axes, manifold.normal);
      const auto &a = moving_[contact.a], &b = moving_[contact.b];
      const auto along = [&](const auto& of_a, const auto& of_b) {
        return nearest_to<Speed>(narrow_dot<62>(n, of_b - of_a));
      };
      const auto gap = saturate_to<Speed>(least) + along(a.shift, b.shift);
      const auto way = along(a.velocity, b.velocity);
      return gap > 0 && gap + ((way + way) + (way + way)) > 0;
    } else {
      return false;
    }
  }

  /// Calls f for each awake contact in order of colours, in parallel for those of one colour.
  template <class Threads, class Visit>
  constexpr void for_each_ready(const ColourEnds& ends, const Threads& threads, const Visit& f) {
    const auto visit = [&](std::size_t i) { f(ready_[i], rows_[i]); };
    std::size_t first = 0;
    if constexpr (Threads::are_many) {
      for (std::size_t c = 0; c + 1 < colours; ++c) {
        threads.each(first, ends[c], contacts_a_call, visit);
        first = ends[c];
      }
    }
    OneThread().each(first, ready_.size(), 1, visit);
  }

  /// Groups the contacts of each colour except the last, without their rows. Contacts that seem idle
  /// have their own groups.
  constexpr void group_all(const ColourEnds& ends) requires(has_groups) {
    const auto groups_of = [](std::uint32_t size) { return (size + 3) / 4; };
    std::uint32_t count = 0, idle_count = 0;
    for (std::size_t c = 0; c + 1 < colours; ++c) {
      const auto idle_groups = groups_of(ends[c] - busy_ends_[c]);
      count += groups_of(busy_ends_[c] - (c == 0 ? 0 : ends[c - 1])) + idle_groups;
      idle_count += idle_groups;
      group_ends_[c] = count;
    }
    groups_.resize(count);
    idle_.resize(idle_count);
    std::size_t g = 0;
    std::uint32_t idle_group = 0;
    const auto group = [&](std::uint32_t begin, std::uint32_t end, bool are_idle) {
      for (auto i = begin; i < end; i += 4) {
        groups_[g].first = i;
        groups_[g].size = static_cast<std::uint8_t>((std::min)(end - i, std::uint32_t{4}));
        groups_[g].is_idle = are_idle;
        groups_[g++].idle = are_idle ? idle_group++ : 0;
      }
    };
    for (std::size_t c = 0; c + 1 < colours; ++c) {
      group(c == 0 ? 0 : ends[c - 1], busy_ends_[c], false);
      group(busy_ends_[c], ends[c], true);
    }
  }
  /// Bounds the gaps of a group that seems idle, or prepares it if it is not.
  constexpr void prepare_idle(const Bodies& bodies, ContactGroup<S>& group) requires(has_groups) {
    auto& bounds = idle_[group.idle];
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      auto& contact = ready_[group.first + (k < group.size ? k : 0)];
      const auto& [manifold, offset] = found_.manifolds[contact.contact];
      contact.count = 0;  // for the end of the step
      bounds.a[k] = contact.a;
      bounds.b[k] = contact.b;
      place_idle(bounds, k, manifold, held()[contact.a], held()[contact.b], offset);
    }
    if (!stay_idle<FastLongLanes, S>(bounds, moving_.data())) end_idleness(bodies, group);
  }
  /// Prepares a group that was idle. In a step, its gaps are measured next.
  constexpr void end_idleness(const Bodies& bodies, ContactGroup<S>& group) requires(has_groups) {
    group.is_idle = false;
    prepare_group(bodies, group);
  }
  /// Prepares the contacts of a group: at once, or one by one if a number must be clamped.
  constexpr void prepare_group(const Bodies& bodies, ContactGroup<S>& group) requires(has_groups) {
    FourContacts<S> from;
    auto* ready = &ready_[group.first];
    auto* rows = &rows_[group.first];
    bool is_free = true, bounces = false;
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      auto& contact = ready[k < group.size ? k : 0];
      const auto& found = found_.manifolds[contact.contact];
      from.manifold[k] = &found.manifold;
      from.offset[k] = &found.offset;
      if (k >= group.size) continue;
      const auto [share_a, share_b] = mass_shares<S>(bodies[contact.a], bodies[contact.b]);
      from.share_a[k] = share_a;
      from.share_b[k] = share_b;
      contact.count = static_cast<std::uint8_t>(found.manifold.count);
      contact.is_wall = share_a == 0 || share_b == 0;
      contact.pushed = {share_a != 0, share_b != 0};
      set_surface(bodies, contact);
      bounces = bounces || contact.bounce != 0;
      is_free = is_free && held()[contact.a].locked == 0 && held()[contact.b].locked == 0;
    }
    if (is_free && prepare_four<FastLongLanes, S>(group, from, held().data(), ready)) {
      gather_impulses(group, ready, found_.contacts.data());
      if (bounces) spread_rows(group, ready, rows);
    } else {
      for (std::size_t k = 0; k < group.size; ++k) prepare_one(bodies, group.first + k);
      gather(group, ready, rows, found_.contacts.data());
    }
    for (std::size_t k = 0; bounces && k < group.size; ++k) note_closing(bodies, ready[k], rows[k]);
  }
  template <class Threads>
  constexpr void scatter_all(const Threads& threads) {
    if constexpr (has_groups) {
      if (!are_grouped_) return;
      threads.each(0, groups_.size(), groups_a_call, [&](std::size_t k) {
        if (groups_[k].is_idle) return;
        scatter(groups_[k], &ready_[groups_[k].first], found_.contacts.data());
      });
    }
  }

  /// What a pass does with idle groups: one that only applies impulses leaves them alone, any other
  /// first checks that they stay idle.
  enum class OfIdle : std::uint8_t { skipped, checked };

  /// Solves awake contacts in order of colours: `together` solves a group, `alone` a single
  /// contact, and each contact of a group that `together` refuses.
  template <OfIdle Idle, class Threads, class Together, class Alone>
  constexpr void solve_each(const Bodies& bodies, const ColourEnds& ends, const Threads& threads,
                            const Together& together, const Alone& alone) {
    if constexpr (has_groups) {
      if (are_grouped_) {
        const bool exceed_cache = groups_.size() * sizeof(groups_[0]) > groups_in_cache;
        const auto visit = [&](std::size_t g) {
          auto& group = groups_[g];
          if (exceed_cache && g + 2 < groups_.size()) prefetch(&groups_[g + 2], sizeof(group));
          if (group.is_idle) {
            if (Idle == OfIdle::skipped) return;
            if (stay_idle<FastLongLanes, S>(idle_[group.idle], moving_.data())) return;
            end_idleness(bodies, group);
            measure_group(group);
          }
          solve_group(group, together, alone);
        };
        std::size_t first = 0;
        if constexpr (Threads::are_many) {
          for (const auto end : group_ends_) {
            threads.each(first, end, groups_a_call, visit);
            first = end;
          }
        }
        OneThread().each(first, groups_.size(), 1, visit);
        OneThread().each(ends[colours - 2], ready_.size(), 1,
                         [&](std::size_t i) { alone(ready_[i], rows_[i]); });
        return;
      }
    }
    for_each_ready(ends, threads, alone);
  }
  template <class Together, class Alone>
  constexpr void solve_group(ContactGroup<S>& group, const Together& together,
                             const Alone& alone) requires(has_groups) {
    if (group.are_even) {
      GroupSolver<FastLongLanes, S, true> solver(group, moving_.data());
      if (together(solver)) return;
    } else {
      GroupSolver<FastLongLanes, S> solver(group, moving_.data());
      if (together(solver)) return;
    }
    auto* ready = &ready_[group.first];
    auto* rows = &rows_[group.first];
    spread_rows(group, ready, rows);
    scatter(group, ready, found_.contacts.data());
    for (std::size_t k = 0; k < group.size; ++k) alone(ready[k], rows[k]);
    gather_impulses(group, ready, found_.contacts.data());
  }

  static constexpr bool resist_rolling(const Bodies& bodies) noexcept {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (resists_rolling(bodies[i])) return true;
    }
    return false;
  }

  template <class Threads>
  constexpr void prepare_all(const Bodies& bodies, const ColourEnds& ends, const Threads& threads) {
    std::size_t first = 0;
    if constexpr (has_groups) {
      if (are_grouped_) {
        group_all(ends);
        threads.each(0, groups_.size(), groups_a_call, [&](std::size_t k) {
          auto& group = groups_[k];
          group.is_idle ? prepare_idle(bodies, group) : prepare_group(bodies, group);
        });
        first = ends[colours - 2];
      }
    }
    threads.each(first, ready_.size(), contacts_a_call, [&](std::size_t i) {
      set_surface(bodies, ready_[i]);
      prepare_one(bodies, i);
      note_closing(bodies, ready_[i], rows_[i]);
    });
  }
  /// The rows of a contact.
  constexpr void prepare_one(const Bodies& bodies, std::size_t i) {
    auto& ready = ready_[i];
    const Body &a = bodies[ready.a], &b = bodies[ready.b];
    const auto& found = found_.manifolds[ready.contact];
    const auto [share_a, share_b] = mass_shares<S>(a, b);
    prepare(ready, rows_[i], found.manifold, held()[ready.a], held()[ready.b], found.offset,
            share_a, share_b);
    if (has_round && rolling_.size() != 0) {
      const auto limit = rolling_limit<S, N>(a, b, found_.contacts[ready.contact]);
      if (limit.is_any()) {
        rolling_[i] = prepare_rolling<S, N>(limit, share_of<S, N>(held()[ready.a].spread, share_a),
                                            share_of<S, N>(held()[ready.b].spread, share_b));
        rows_[i].rolling = &rolling_[i];
      }
    }
  }
  /// Friction and restitution of a contact.
  constexpr void set_surface(const Bodies& bodies, Ready& ready) const noexcept {
    using Ratio = typename F::Ratio;
    const Body &a = bodies[ready.a], &b = bodies[ready.b];
    auto friction = std::array{a.friction, b.friction};
    auto restitution = std::array{a.restitution, b.restitution};
    if constexpr (has_compounds) {
      const auto parts = parts_of(bodies, found_.contacts[ready.contact]);
      for (std::size_t k = 0; k < 2; ++k) {
        if (parts[k] == nullptr) continue;
        friction[k] = parts[k]->options().friction;
        restitution[k] = parts[k]->options().restitution;
      }
    }
    if (is_fixed<S> && friction[0] == friction[1] && friction[0] >= 0) {
      ready.grip = saturate_to<Ratio>(friction[0]);  // from a finer grid
    } else {
      ready.grip = sqrt_floor<Ratio>(friction[0] * friction[1]);
    }
    ready.bounce = saturate_to<Ratio>((max)(restitution[0], restitution[1]));
  }
  /// The supports of contacts: where held bodies are held. Worlds that process four contacts at once
  /// keep them for the whole tick; others replace them by the bodies' own poses in `let_go`.
  [[nodiscard]] constexpr const auto& held() const noexcept {
    if constexpr (has_groups) {
      return held_;
    } else {
      return supports_;
    }
  }
  /// Finds all slacks, and sets these supports to the poses at which held bodies are held.
  constexpr void hold_back(const Bodies& bodies) {
    if constexpr (has_groups) {
      held_ = supports_;
      hold_back(bodies, held_);
    } else {
      hold_back(bodies, supports_);
    }
  }
  template <class Supports>
  constexpr void hold_back(const Bodies& bodies, Supports& held) {
    if (!are_held_) return;
    slacks_.resize(bodies.size());
    leans_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      leans_[i] = {};
      if (bodies[i].is_held()) leans_[i] = detail::hold_back(held[i], bodies[i]);
      slacks_[i] = slack_of(bodies[i], leans_[i]);
    }
  }
  /// Sets them to the current poses.
  constexpr void let_go(const Bodies& bodies) noexcept {
    if constexpr (!has_groups) {
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].is_held()) detail::let_go(supports_[i], bodies[i]);
      }
    }
  }
  /// The gaps of contacts whose bodies have moved since they were held.
  template <class Threads>
  constexpr void measure_gaps(const Bodies& bodies, const ColourEnds& ends,
                              const Threads& threads) {
    solve_each<OfIdle::skipped>(
        bodies, ends, threads, [](auto& solver) { return solver.measure_gaps(); },
        [&](Ready& ready, const Rows& rows) { measure_one(ready, rows); });
  }
  constexpr void measure_one(Ready& ready, const Rows& rows) const noexcept {
    detail::measure_gaps(ready, rows, moving_[ready.a], moving_[ready.b]);
  }
  constexpr void measure_group(ContactGroup<S>& group) requires(has_groups) {
    solve_group(
        group, [](auto& solver) { return solver.measure_gaps(); },
        [&](Ready& ready, const Rows& rows) { measure_one(ready, rows); });
  }
  /// Records the rates of a contact that bounces, at the start of the tick.
  constexpr void note_closing(const Bodies& bodies, const Ready& ready, Rows& rows) const noexcept {
    if (ready.bounce == 0) return;
    const auto a = motion_of(bodies[ready.a]), b = motion_of(bodies[ready.b]);
    for (std::size_t k = 0; k < ready.count; ++k) {
      rows.closing[k] = rate_along<S, N>(rows.normal.along, rows.pressure[k], a.velocity, a.spin,
                                         b.velocity, b.spin);
    }
  }

  /// Turns bodies by their spins, half-way or to their new orientation, and carries the spins of
  /// those that tumble, four at once where this machine has vectors.
  template <int Halvings>
  struct Turner {
    struct Nothing {};
    struct Fours {
      std::size_t size = 0;
      Quad<std::uint32_t> waiting{};
      FourTurns<S> turns{};
    };
    Tick& tick;
    Bodies& bodies;
    std::conditional_t<has_groups, Fours, Nothing> fours{};

    constexpr void add(std::size_t i) {
      if constexpr (has_groups) {
        if (runs_vectors()) {
          fours.waiting[fours.size++] = static_cast<std::uint32_t>(i);
          if (fours.size == long_lane_count) turn();
          return;
        }
      }
      turned_to(i, turned<S, N, Halvings>(bodies[i].state.orientation, tick.moving_[i].spin));
    }
    constexpr void flush() {
      if constexpr (has_groups) {
        if (fours.size != 0) turn();
        if (fours.turns.size != 0) carry_on();
      }
    }

   private:
    /// Continues once a body's new orientation is known.
    constexpr void turned_to(std::size_t i, const auto& orientation) {
      Body& body = bodies[i];
      if constexpr (Halvings == 0) body.state.orientation = orientation;
      if constexpr (N == 3) {
        if (!tumbles(body)) return;
        auto &axes = tick.supports_[i].axes, &half_way = tick.half_way_[i];
        const auto& from = Halvings == 0 ? half_way : axes;
        auto& to = Halvings == 0 ? axes : half_way;
        if constexpr (has_groups) {
          if (runs_vectors()) {
            fours.turns.add(static_cast<std::uint32_t>(i), orientation, body.inertia, from, to);
            if (fours.turns.size == long_lane_count) carry_on();
            return;
          }
        }
        carry(body, tick.moving_[i], orientation, from, to);
      }
    }
    constexpr void turn() {
      Quad<const BodyState<S, N>*> states{};
      Quad<Vec<typename F::Ratio, 4>> result{};
      for (std::size_t k = fours.size; k < long_lane_count; ++k)
        fours.waiting[k] = fours.waiting[0];
      for (std::size_t k = 0; k < long_lane_count; ++k) states[k] = &bodies[fours.waiting[k]].state;
      const bool is_done =
          turn_four<FastLongLanes, Halvings, S>(states, tick.moving_.data(), fours.waiting, result);
      for (std::size_t k = 0; k < fours.size; ++k) {
        const auto i = fours.waiting[k];
        turned_to(
            i, is_done ? result[k]
                       : turned<S, N, Halvings>(bodies[i].state.orientation, tick.moving_[i].spin));
      }
      fours.size = 0;
    }
    constexpr void carry_on() {
      const bool is_done = carry_four<FastLongLanes>(fours.turns, tick.moving_.data());
      for (std::size_t k = 0; k < fours.turns.size; ++k) {
        const auto i = fours.turns.body[k];
        auto& moving = tick.moving_[i];
        if (is_done) {
          lock<S, N>(bodies[i].locked, moving.velocity, moving.spin);
        } else {
          carry(bodies[i], moving, fours.turns.orientation[k], *fours.turns.from[k],
                *fours.turns.to[k]);
        }
      }
      fours.turns.size = 0;
    }
  };

  template <class Threads>
  constexpr void substep(std::size_t index, Bodies& bodies, Joints& joints, const Pace<S, N>& pace,
                         const ColourEnds& ends, const Threads& threads) {
    each_block(bodies, threads, [&](std::size_t begin, std::size_t end) {
      Turner<1> turner{*this, bodies};
      for (std::size_t i = begin; i < end; ++i) {
        if (!is_awake(bodies[i])) continue;
        accelerate(bodies[i], moving_[i], pace);
        if (tumbles(bodies[i])) turner.add(i);
      }
      turner.flush();
    });
    group_.warm_start(joints, moving_, supports_);
    solve_each<OfIdle::skipped>(
        bodies, ends, threads, [](auto& solver) { return solver.warm_start(); },
        [&](const Ready& ready, const Rows& rows) {
          const auto& contact = found_.contacts[ready.contact];
          warm_start(ready, rows, contact, moving_[ready.a], moving_[ready.b]);
          if constexpr (has_round) {
            warm_start_rolling(ready, rows, contact, moving_[ready.a], moving_[ready.b]);
          }
        });
    group_.template solve_all<Pass::biased>(joints, moving_, supports_);
    solve_each<OfIdle::checked>(
        bodies, ends, threads,
        [&](auto& solver) { return solver.template solve<Pass::biased>(pace.push, index); },
        [&](Ready& ready, const Rows& rows) {
          solve_pressure<Pass::biased>(ready, rows, found_.contacts[ready.contact],
                                       moving_[ready.a], moving_[ready.b], pace.push, index);
        });
    each_block(bodies, threads, [&](std::size_t begin, std::size_t end) {
      Turner<0> turner{*this, bodies};
      for (std::size_t i = begin; i < end; ++i) {
        if (!is_awake(bodies[i]) && !is_driven(bodies[i])) continue;
        move(bodies[i], moving_[i]);
        turner.add(i);
      }
      turner.flush();
    });
    group_.follow(joints, bodies, supports_);
    group_.template solve_all<Pass::relaxed>(joints, moving_, supports_);
    solve_each<OfIdle::checked>(
        bodies, ends, threads,
        [&](auto& solver) { return solver.template solve<Pass::relaxed>(pace.push, index); },
        [&](Ready& ready, const Rows& rows) {
          auto& contact = found_.contacts[ready.contact];
          solve_pressure<Pass::relaxed>(ready, rows, contact, moving_[ready.a], moving_[ready.b],
                                        pace.push, index);
          if constexpr (has_round) {
            solve_rolling(ready, rows, contact, moving_[ready.a], moving_[ready.b]);
          }
          solve_friction(ready, rows, contact, moving_[ready.a], moving_[ready.b]);
        });
  }

  /// Writes velocities back, and lets quiet islands sleep.
  constexpr void finish(Bodies& bodies, const Pace<S, N>& pace) {
    for (std::size_t i = 0; i < ready_.size(); ++i) {
      const auto& ready = ready_[i];
      bool touches = false;
      for (std::size_t k = 0; k < ready.count; ++k) {
        const auto& gap = are_held_ ? ready.gap_now[k] : ready.gap[k];
        touches = touches || ready.was_pushed[k] || gap <= 0;
      }
      found_.contacts[ready.contact].touches = touches;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) awake_[i] = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Body& body = bodies[i];
      if (!is_awake(body)) continue;
      body.state.velocity = moving_[i].velocity;
      body.state.spin = moving_[i].spin;
      if (are_held_) {
        if (used_[i] != 0) {
          note_hold(body, moving_[i], pace);
        } else {
          body.let_go();  // nothing touches it
        }
      }
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

  /// Whether no body moves on its own.
  static constexpr bool stands_still(const Bodies& bodies) noexcept {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (is_awake(bodies[i]) || is_driven(bodies[i])) return false;
    }
    return true;
  }
  /// Whether the contacts are those of the last tick.
  constexpr bool have_stayed(const Contacts& before) const noexcept {
    if (before.size() != found_.contacts.size()) return false;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (!(before[i] == found_.contacts[i])) return false;
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

  /// The velocities of a body at the start of the tick.
  static constexpr Moving<S, N> motion_of(const Body& body) noexcept {
    Moving<S, N> moving;
    if (body.generation == 0 || body.motion == BodyMotion::fixed) return moving;
    moving.velocity = body.state.velocity;
    moving.spin = body.state.spin;
    return moving;
  }
  static constexpr bool is_awake(const Body& body) noexcept {
    return body.generation != 0 && body.can_move() && !body.sleeps;
  }
  /// Whether a body is kinematic and moves.
  static constexpr bool is_driven(const Body& body) noexcept {
    return body.generation != 0 && body.motion == BodyMotion::kinematic &&
           !(body.state.velocity == Vec<typename F::Speed, N>() &&
             body.state.spin == Axial<typename F::Spin, N>());
  }
  constexpr std::uint32_t island(std::size_t body) noexcept {
    return islands_.of(static_cast<std::uint32_t>(body));
  }

  static constexpr std::uint8_t asleep = 0xff;
  static constexpr std::uint8_t idle = colours;  // added to a colour
  static constexpr std::size_t pair_room = 4 * contacts_room;

  // The work of one call on a thread: some microseconds, so that waiting for other threads costs
  // less.
  static constexpr std::size_t bodies_a_call = 64;
  static constexpr std::size_t pairs_a_call = 32;
  static constexpr std::size_t contacts_a_call = 32;
  static constexpr std::size_t groups_a_call = 8;
  // Bytes of groups that stay in a usual second cache from pass to pass, so that a prefetch would only
  // take time.
  static constexpr std::size_t groups_in_cache = 1 << 20;

  List<Support<S, N>, bodies_room> supports_;
  List<Support<S, N>, 0> held_;               // for worlds that process four contacts at once
  List<Standing<S, N>, bodies_room> starts_;  // empty without a fast body
  List<ContactKey, passes_room> passes_;
  List<typename F::Lever, bodies_room> slacks_;          // of bodies, if they may be held
  List<Axial<typename F::Spin, N>, bodies_room> leans_;  // how far these have turned since
  List<Moving<S, N>, bodies_room> moving_;
  List<Axes<S, N>, bodies_room> half_way_;  // the axes at the middle of the substep
  List<SweepEntry<S, N>, bodies_room> swept_;
  List<std::uint32_t, bodies_room> lane_;
  List<BodyPair, pair_room> pairs_;
  List<SweepEntry<S, N>, 0> unordered_entries_;  // for growing worlds
  List<SweepEntry<S, N>, 0> members_;            // for growing worlds: of strips
  List<BodyPair, 0> unordered_pairs_;            // for growing worlds
  Search found_;
  List<Search, 0> searches_;  // for growing worlds, on several threads
  List<Ready, contacts_room> ready_;
  List<Rows, contacts_room> rows_;  // of grouped contacts: unset, until they are needed
  List<Rolling<S, N>, has_round ? contacts_room : 0> rolling_;  // empty if no body resists it
  List<std::conditional_t<is_fixed<S> && N == 3, ContactGroup<S>, char>, 0>
      groups_;  // for growing worlds, on machines with long lanes
  List<std::conditional_t<is_fixed<S> && N == 3, IdleGroup<S>, char>, 0> idle_;
  std::array<std::uint32_t, colours - 1> group_ends_{};
  ColourEnds busy_ends_{};  // where in each colour the contacts begin that seem idle
  bool are_grouped_ = false;
  bool are_held_ = false;  // whether bodies that move little are held
  List<std::uint8_t, contacts_room> colour_;
  List<std::uint64_t, bodies_room> used_;
  List<std::uint8_t, bodies_room> awake_;
  Islands<List<std::uint32_t, bodies_room>> islands_;
  Group group_;
};

}  // namespace detent::detail

// All headers that use them are included above.
#undef DETENT_BEGIN_LONG_LANES
#undef DETENT_END_LONG_LANES
