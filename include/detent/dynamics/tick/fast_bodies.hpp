// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/fast.hpp"
#include "detent/dynamics/tick/contact_parts.hpp"

namespace detent::detail {

/// Fast bodies on their paths through a tick: what stops them, and the sensors that they pass.
template <class Types>
class FastBodies {
  using S = typename Types::S;
  static constexpr int N = Types::N;
  using F = typename Types::F;
  using Body = typename Types::Body;
  using Bodies = typename Types::Bodies;
  using Contacts = typename Types::Contacts;
  using Group = typename Types::Group;
  using Parts = ContactParts<Types>;

 public:
  /// Records the poses of bodies at the start of a tick, if one of them is fast; whether one is.
  template <class Supports>
  constexpr bool start(const Bodies& bodies, const Supports& supports) {
    starts_.clear();
    passes_.clear();
    bool has_fast = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) has_fast = has_fast || is_fast(bodies[i]);
    if (!has_fast) return false;
    for (std::size_t i = 0; i < supports.size(); ++i) {
      starts_.push_back({supports[i].place, supports[i].axes});
    }
    return true;
  }

  /// Stops fast bodies on their paths through this tick, for the other bodies in the order of their
  /// ranks. The last stop counts, so fixed bodies come last.
  constexpr void stop_all(Bodies& bodies, const Group& joints, const S& margin) {
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      if (!is_fast(bodies[i])) continue;
      const auto ball = inner_ball_of(bodies[i]);
      for (int rank = 0; rank < 4; ++rank) {
        for (std::uint32_t j = 0; j < bodies.size(); ++j) {
          if (can_collide(bodies, joints, i, j) && rank_of(bodies[j]) == rank) {
            meet_on_way(bodies, i, j, ball, margin, nullptr);
          }
        }
      }
    }
  }

  /// Finds the sensors that fast bodies passed, or bodies that fast sensors passed, between the
  /// start and the end of this tick, and that do not touch in these contacts.
  constexpr void find_passes(Bodies& bodies, const Group& joints, const Contacts& contacts) {
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      if (!is_fast(bodies[i])) continue;
      const auto ball = inner_ball_of(bodies[i]);
      for (std::uint32_t j = 0; j < bodies.size(); ++j) {
        if (can_collide(bodies, joints, i, j)) meet_on_way(bodies, i, j, ball, S(0), &contacts);
      }
    }
    if (passes_.size() != 0) std::sort(&passes_[0], &passes_[0] + passes_.size());
  }
  /// The pairs of bodies of these passes, in order.
  template <class Pairs>
  constexpr void list_pairs(Pairs& pairs) const {
    pairs.clear();
    for (std::size_t k = 0; k < passes_.size(); ++k) {
      if (k == 0 || passes_[k].pair != passes_[k - 1].pair) pairs.push_back(passes_[k].pair);
    }
  }
  /// Removes the passes of what touches in the contacts from `first` on.
  constexpr void remove_touching(const Bodies& bodies, const Contacts& contacts,
                                 std::size_t first) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < passes_.size(); ++k) {
      if (!touches(bodies, contacts, first, passes_[k])) passes_[kept++] = passes_[k];
    }
    passes_.resize(kept);
  }
  [[nodiscard]] constexpr const auto& passes() const noexcept { return passes_; }

 private:
  static constexpr bool is_fast(const Body& body) noexcept {
    return body.is_fast && body.generation != 0 && body.can_move();
  }
  /// Whether `other` is another body that can touch a body that can move.
  static constexpr bool can_collide(const Bodies& bodies, const Group& joints, std::uint32_t body,
                                    std::uint32_t other) {
    return other != body && bodies[other].generation != 0 &&
           layers_meet(bodies[body], bodies[other]) &&
           !joints.keeps_apart({(std::min)(body, other), (std::max)(body, other)});
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
          Types::visit_part(parts[k], [&](const auto& solid) {
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
  /// Stops a fast body before the shapes of another one on its path through this tick; or, given
  /// contacts, finds the sensors among them that do not touch in these.
  constexpr void meet_on_way(Bodies& bodies, std::uint32_t fast, std::uint32_t index,
                             const InnerBall& ball, const S& margin, const Contacts* contacts) {
    const bool passes = contacts != nullptr;
    Body& body = bodies[fast];
    const Body& other = bodies[index];
    const bool are_sensed = Parts::is_sensed(bodies, fast, index);
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
        add_pass(bodies, *contacts,
                 fast < index ? Parts::touching(bodies, {fast, index}, ball.part, part)
                              : Parts::touching(bodies, {index, fast}, part, ball.part));
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
          Types::visit_part(parts[k], [&](const auto& solid) {
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

  constexpr void add_pass(const Bodies& bodies, const Contacts& contacts, const ContactKey& key) {
    if (passes_.size() == Types::passes_room || touches(bodies, contacts, 0, key)) return;
    for (std::size_t k = 0; k < passes_.size(); ++k) {
      if (passes_[k] == key) return;  // both are fast
    }
    passes_.push_back(key);
  }
  /// Whether a pair touches in one of the contacts from `first` on.
  static constexpr bool touches(const Bodies& bodies, const Contacts& contacts, std::size_t first,
                                const ContactKey& key) {
    for (std::size_t k = first; k < contacts.size(); ++k) {
      if (contacts[k].touches && Parts::touching(bodies, contacts[k]) == key) return true;
    }
    return false;
  }

  template <class T, std::size_t Room>
  using List = typename Types::template List<T, Room>;

  List<Standing<S, N>, Types::bodies_room> starts_;  // empty without a fast body
  List<ContactKey, Types::passes_room> passes_;
};

}  // namespace detent::detail
