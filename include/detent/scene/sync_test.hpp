// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/scene/difference.hpp"
#if __STDC_HOSTED__
#include <vector>
#endif

namespace detent {

/// Where a frame came out otherwise when it was simulated again.
struct Desync {
  std::uint64_t frame;             // from 0, the first one that did
  std::optional<ObjectId> object;  // that the field belongs to, if it is one of a scene's objects
  FieldName field;                 // the first that differs, or that is there only once, such as
      // `scene object 3:17 (sphere) center.y`, `velocity[1].x` or `score`
};

/// Looks for what a rollback would break, without a second player: after every frame it goes back
/// as many frames as its window has, simulates them again with the same inputs, and compares each
/// with what it was.
///
/// What is not in the world and not in the inputs, such as a global variable, a clock or an order
/// of addresses, shows as a `Desync`. So does a frame that changes a fixed object of a scene, for
/// snapshots do not bring that back.
///
///     SyncTest<World, Input> test(8);
///     if (const auto desync = test.step(world, input, simulate)) ...
///
/// `SyncTest<World, Input, 8> test;` keeps its window inside itself: with a `BoundedScene` nothing
/// allocates. World and input then have default constructors.
///
/// A world is a scene, or any type of the caller's that says what its fields are: `RollbackWorld`.
///
/// (tests/scene/sync_test.test.cpp, tests/examples/sync_world.cpp)
template <RollbackWorld World, std::copyable Input, std::size_t Window = 0>
class SyncTest {
 public:
  explicit SyncTest(std::size_t window) requires(Window == 0)
      : window_((std::max)(window, std::size_t{1})) {}
  SyncTest() requires(Window != 0) = default;

  /// Simulates a frame, simulate(world, input), and the last ones again. Nothing else may change
  /// the world between two steps.
  ///
  /// result: nothing when all came out as before; `world` is then what the frame made of it, else
  ///         what it was when it parted
  template <class Simulate>
  [[nodiscard]] std::optional<Desync> step(World& world, const Input& input,
                                           const Simulate& simulate) {
    const auto frame = count_++;
    keep(frame, world, input);
    simulate(world, input);
    if (detail::WorldDigest(world).fixed() != detail::WorldDigest(at(frame).before).fixed()) {
      return desync(frame, at(frame).before, world, detail::Fields::of_fixed_objects);
    }
    last_ = world;
    const auto oldest = count_ - std::min<std::uint64_t>(count_, window_);
    world = at(oldest).before;
    for (auto i = oldest; i < count_; ++i) {
      simulate(world, at(i).input);
      const World& was = i == frame ? *last_ : at(i + 1).before;
      if (detail::WorldDigest(world).all() != detail::WorldDigest(was).all()) {
        return desync(i, was, world, detail::Fields::all);
      }
    }
    return std::nullopt;
  }

 private:
  struct Moment {
    World before;
    Input input;
  };

  void keep(std::uint64_t frame, const World& world, const Input& input) {
    if constexpr (Window == 0) {
      if (moments_.size() < window_) return moments_.push_back({world, input});
    }
    at(frame).before = world;
    at(frame).input = input;
  }
  Moment& at(std::uint64_t frame) { return moments_[static_cast<std::size_t>(frame % window_)]; }

  static Desync desync(std::uint64_t frame, const World& was, const World& is,
                       detail::Fields which) {
    const auto place = detail::first_difference(was, is, which);
    if (!place) return {frame, {}, {}};
    return {frame, place->object ? std::optional(place->object->id) : std::nullopt, place->name};
  }

#if __STDC_HOSTED__
  using Moments = std::conditional_t<Window == 0, std::vector<Moment>, std::array<Moment, Window>>;
#else
  using Moments = std::array<Moment, Window>;
#endif

  std::size_t window_ = Window;
  std::uint64_t count_ = 0;
  Moments moments_{};          // the last ones, by frame modulo the window
  std::optional<World> last_;  // what the last frame made of the world
};

}  // namespace detent
