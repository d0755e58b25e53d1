// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "detent/scene/snapshot.hpp"

namespace detent {

/// Where a frame came out otherwise when it was simulated again.
struct Desync {
  std::uint64_t frame;             // from 0, the first one that did
  std::optional<ObjectId> object;  // of the moving ones that parted, the first by id; nothing if
                                   // only frames of reference or the next generation did
};

/// Looks for what a rollback would break, without a second player: after every frame it goes back
/// `window` frames, simulates them again with the same inputs, and compares each with what it was.
///
/// What is not in the scene and not in the inputs, such as a global variable, a clock or an order
/// of addresses, shows as a `Desync`. So does a fixed object that changes.
///
///     SyncTest<Scene<q16_16, 3, Sphere>, Input> test(8);
///     if (const auto desync = test.step(scene, input, simulate)) ...
///
/// A scene whose moving objects are of meshes needs a view of these, as `restore` does:
/// `SyncTest<World, Input, std::span<const MeshAsset<q16_16>>> test(8, meshes)`.
///
/// (tests/scene/sync_test.test.cpp, tests/examples/rollback.cpp)
template <class Scene, class Input, class Meshes = detail::NoMeshes>
class SyncTest {
 public:
  explicit SyncTest(std::size_t window, const Meshes& meshes = {})
      : meshes_(meshes), window_(std::max<std::size_t>(window, 1)) {}

  /// Simulates a frame, simulate(scene, input), and the last ones anew.
  ///
  /// result: nothing when all came out as before; `scene` is then what the frame made of it, else
  ///         what it was when it parted
  template <class Simulate>
  [[nodiscard]] std::optional<Desync> step(Scene& scene, const Input& input,
                                           const Simulate& simulate) {
    if (frames_.size() == window_) frames_.erase(frames_.begin());
    frames_.push_back({snapshot(scene), {}, input});
    simulate(scene, input);
    frames_.back().after = snapshot(scene);
    ++count_;
    const auto oldest = count_ - frames_.size();
    if (restore(scene, frames_.front().before, meshes_) != Restored::yes) return Desync{oldest, {}};
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      simulate(scene, frames_[i].input);
      if (snapshot(scene) != frames_[i].after) {
        return Desync{oldest + i, first_difference(scene, frames_[i].after)};
      }
    }
    return std::nullopt;
  }

 private:
  using Bytes = decltype(snapshot(std::declval<const Scene&>()));
  struct Frame {
    Bytes before;
    Bytes after;
    Input input;
  };

  /// The first object that is not as the snapshot has it.
  std::optional<ObjectId> first_difference(const Scene& scene, const Bytes& bytes) const {
    Scene other = scene;
    if (restore(other, bytes, meshes_) != Restored::yes) return std::nullopt;
<<<<<<< HEAD
    const auto end = (std::max)(scene.store().end(), other.store().end());
=======
    const auto end =
        std::max(detail::SceneAccess::store(scene).end(), detail::SceneAccess::store(other).end());
>>>>>>> f44daee (scene: hits, getters of frames and local shapes, a usable moved-from scene)
    for (std::size_t i = 0; i < end; ++i) {
      const auto id = [i](const Scene& s) {
        const auto& store = detail::SceneAccess::store(s);
        return store.is_object(i) ? store.info(i).id : ObjectId{};
      };
      const auto here = id(scene), there = id(other);
      if (here != there) return here == ObjectId{} ? there : here;
      if (digest_of(scene, here) != digest_of(other, there)) return here;
    }
    return std::nullopt;
  }

  Meshes meshes_;
  std::size_t window_;
  std::uint64_t count_ = 0;
  std::vector<Frame> frames_;  // the last ones, the oldest first
};

}  // namespace detent
