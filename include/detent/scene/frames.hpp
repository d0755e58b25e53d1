// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/scene/list.hpp"
#include "detent/scene/object.hpp"
#include "detent/scene/tree.hpp"
#include "detent/shape/moved.hpp"

namespace detent::detail {

/// A coordinate system: how it lies in its parent's, and in the world.
template <Scalar S, int N>
struct Frame {
  Transform<S, N> local;
  Transform<S, N> world;
  std::uint32_t generation = 0;  // 0 where there is none
  std::uint32_t parent = nowhere;
  bool has_moved = false;  // since the last move
};

/// The frames of a scene, by index. A parent is older than its children and outlives them, so
/// generations rise along every branch.
template <class Storage, Scalar S, int N>
class Frames {
 public:
  [[nodiscard]] constexpr std::size_t end() const noexcept { return frames_.size(); }
  [[nodiscard]] constexpr const Frame<S, N>& operator[](std::size_t i) const noexcept {
    return frames_[i];
  }
  [[nodiscard]] constexpr bool is_frame(std::size_t i) const noexcept {
    return i < frames_.size() && frames_[i].generation != 0;
  }
  [[nodiscard]] constexpr bool is_frame(const FrameId& id) const noexcept {
    return is_frame(id.index) && frames_[id.index].generation == id.generation;
  }

  [[nodiscard]] constexpr std::optional<FrameId> next_id(std::uint32_t generation) const noexcept {
    std::uint32_t i = 0;
    while (is_frame(i)) ++i;
    if (i >= Storage::frame_capacity) return std::nullopt;
    return FrameId{i, generation};
  }

  constexpr void put(const FrameId& id, const Transform<S, N>& transform, std::uint32_t parent) {
    if (id.index >= frames_.size()) frames_.resize(id.index + std::size_t{1});
    frames_[id.index] = {transform, transform, id.generation, parent, false};
    if (parent != nowhere) place(frames_[id.index]);
  }

  /// Moves a frame and with it all below it.
  constexpr void move(std::uint32_t i, const Transform<S, N>& transform) noexcept {
    for (std::size_t k = 0; k < frames_.size(); ++k) frames_[k].has_moved = false;
    frames_[i].local = transform;
    frames_[i].world = transform;
    if (frames_[i].parent != nowhere) place(frames_[i]);
    frames_[i].has_moved = true;
    spread();
  }

  /// Forgets all frames; `set` then lists them anew, in any order, and `place_all` places them.
  constexpr void clear() noexcept {
    while (frames_.size() > 0) frames_.pop_back();
  }
  constexpr void set(const FrameId& id, const Transform<S, N>& transform, std::uint32_t parent) {
    if (id.index >= frames_.size()) frames_.resize(id.index + std::size_t{1});
    frames_[id.index] = {transform, transform, id.generation, parent, parent == nowhere};
  }
  constexpr void place_all() noexcept { spread(); }

  [[nodiscard]] constexpr bool has_moved(std::uint32_t i) const noexcept {
    return frames_[i].has_moved;
  }

  [[nodiscard]] constexpr bool has_children(std::uint32_t i) const noexcept {
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      if (frames_[k].generation != 0 && frames_[k].parent == i) return true;
    }
    return false;
  }
  constexpr void remove(std::uint32_t i) noexcept { frames_[i] = Frame<S, N>(); }

 private:
  constexpr void place(Frame<S, N>& frame) noexcept {
    frame.world = compose(frames_[frame.parent].world, frame.local);
  }

  /// Places what is below frames that have moved; each round reaches one generation further down.
  constexpr void spread() noexcept {
    for (bool is_done = false; !is_done;) {
      is_done = true;
      for (std::size_t k = 0; k < frames_.size(); ++k) {
        auto& frame = frames_[k];
        if (frame.has_moved || frame.parent == nowhere || !frames_[frame.parent].has_moved) {
          continue;
        }
        place(frame);
        frame.has_moved = true;
        is_done = false;
      }
    }
  }

  typename Storage::template List<Frame<S, N>, Storage::frame_capacity> frames_;
};

}  // namespace detent::detail
