// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/pairs.hpp"
#include "detent/dynamics/tick/types.hpp"

namespace detent::detail {

/// The pairs of bodies that are close enough to touch.
template <class Types>
class BroadPhase {
  using S = typename Types::S;
  static constexpr int N = Types::N;
  using Body = typename Types::Body;

 public:
  /// Finds the pairs of bodies whose bounds, grown by the margin, overlap, and that can push each
  /// other; those of joints may be kept apart. They are in order.
  template <class Supports>
  constexpr void find(const typename Types::Bodies& bodies, const Supports& supports,
                      const typename Types::Group& joints, const S& margin) {
    swept_.clear();
    pairs_.clear();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].generation == 0) continue;
      swept_.push_back(
          {bounds_of<S, N>(supports[i].place, supports[i].axes, bodies[i].reach, margin),
           static_cast<std::uint32_t>(i)});
    }
    if (swept_.size() == 0) return;
    const auto add = [&](const BodyPair& pair) {
      const Body &a = bodies[pair.a], &b = bodies[pair.b];
      if (layers_meet(a, b) && (a.can_move() || b.can_move()) && !joints.keeps_apart(pair) &&
          pairs_.size() < pair_room) {
        pairs_.push_back(pair);
      }
    };
    if constexpr (Types::is_growing) {
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

  [[nodiscard]] constexpr const auto& pairs() const noexcept { return pairs_; }
  /// To put other pairs in their place.
  [[nodiscard]] constexpr auto& pairs() noexcept { return pairs_; }

 private:
  static constexpr std::size_t pair_room = 4 * Types::contacts_room;
  template <class T, std::size_t Room>
  using List = typename Types::template List<T, Room>;

  List<SweepEntry<S, N>, Types::bodies_room> swept_;
  List<std::uint32_t, Types::bodies_room> lane_;
  List<BodyPair, pair_room> pairs_;
  List<SweepEntry<S, N>, 0> unordered_entries_;  // for growing worlds
  List<SweepEntry<S, N>, 0> members_;            // for growing worlds: of strips
  List<BodyPair, 0> unordered_pairs_;            // for growing worlds
};

}  // namespace detent::detail
