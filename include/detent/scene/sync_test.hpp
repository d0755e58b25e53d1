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

/// A frame that had a different result when it was simulated again.
struct Desync {
  std::uint64_t frame;             // from 0; the first that differs
  std::optional<ObjectId> object;  // the scene object that the field belongs to, if any
  FieldName field;                 // the first that differs or is in only one result, such as
      // `scene object 3:17 (sphere) center.y`, `velocity[1].x` or `score`
};

/// Finds what would break a rollback, without a second player: after every frame it goes back by a
/// window of frames, simulates them again with the same inputs, and compares each with its first
/// result.
///
/// State that is neither in the world nor in the inputs, such as a global variable, a clock or an
/// order of addresses, shows as a `Desync`. So does a frame that changes a fixed object of a scene,
/// because snapshots do not restore that.
///
///     SyncTest<World, Input> test(8);
///     if (const auto desync = test.step(world, input, simulate)) ...
///
/// `SyncTest<World, Input, 8> test;` stores its window inside itself: with a `BoundedScene` nothing
/// allocates. World and input then need default constructors.
///
/// A world is a scene, or a type of your own that lists its fields: see `RollbackWorld`.
///
/// (tests/scene/sync_test.test.cpp, tests/examples/sync_world.cpp)
template <RollbackWorld World, std::copyable Input, std::size_t Window = 0>
class SyncTest {
 public:
  /// A test that goes back by `window` frames, at least one.
  explicit SyncTest(std::size_t window) requires(Window == 0)
      : window_((std::max)(window, std::size_t{1})) {}
  SyncTest() requires(Window != 0) = default;

  /// Simulates a frame by simulate(world, input), then the last frames again. Nothing else may
  /// change the world between two steps.
  ///
  /// result: nothing when all frames came out the same, and `world` is the result of the frame;
  ///         otherwise `world` is as it was when it diverged
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
  Moments moments_{};          // of the last frames, at frame modulo the window
  std::optional<World> last_;  // the world after the last frame
};

}  // namespace detent
