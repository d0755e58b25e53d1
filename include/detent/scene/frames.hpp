// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/cull/list.hpp"
#include "detent/cull/tree.hpp"
#include "detent/scene/object.hpp"
#include "detent/shape/moved.hpp"

namespace detent::detail {

/// The effect of the last change to a scene's frames on one frame.
enum class Placement : std::uint8_t { as_it_was, moved, unknown };

/// A coordinate system, with its transforms to its parent and to the world.
template <Scalar S, int N>
struct Frame {
  Transform<S, N> local;
  Transform<S, N> world;
  std::uint32_t generation = 0;  // 0 for an unused index
  std::uint32_t parent = nowhere;
  std::uint32_t below = nowhere;  // the next frame on the way down, in spread()
  Placement placement = Placement::as_it_was;
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

  /// The id of the frame with this index; `FrameId{}`, the world, for `nowhere`.
  [[nodiscard]] constexpr FrameId id(std::uint32_t i) const noexcept {
    return i == nowhere ? FrameId{} : FrameId{i, frames_[i].generation};
  }

  /// The lowest free index, with this generation, or nothing when there is no room.
  [[nodiscard]] constexpr std::optional<FrameId> next_id(std::uint32_t generation) noexcept {
    while (is_frame(first_free_)) ++first_free_;
    if (first_free_ >= Storage::frame_capacity) return std::nullopt;
    return FrameId{first_free_, generation};
  }

  constexpr void put(const FrameId& id, const Transform<S, N>& transform, std::uint32_t parent) {
    if (id.index >= frames_.size()) frames_.resize(id.index + std::size_t{1});
    frames_[id.index] = {transform, transform, id.generation, parent, nowhere, {}};
    if (parent != nowhere) place(frames_[id.index]);
  }

  /// Moves a frame and everything below it.
  constexpr void move(std::uint32_t i, const Transform<S, N>& transform) noexcept {
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      frames_[k].placement =
          frames_[k].parent == nowhere ? Placement::as_it_was : Placement::unknown;
    }
    Frame<S, N>& frame = frames_[i];
    frame.local = transform;
    frame.world = transform;
    if (frame.parent != nowhere) place(frame);
    frame.placement = Placement::moved;
    spread();
  }

  /// Removes all frames. Then `set` adds frames in any order, and `place_all` computes their world
  /// transforms.
  constexpr void clear() noexcept {
    frames_.clear();
    first_free_ = 0;
  }
  constexpr void set(const FrameId& id, const Transform<S, N>& transform, std::uint32_t parent) {
    if (id.index >= frames_.size()) frames_.resize(id.index + std::size_t{1});
    frames_[id.index] = {transform,     transform,
                         id.generation, parent,
                         nowhere,       parent == nowhere ? Placement::moved : Placement::unknown};
  }
  constexpr void place_all() noexcept { spread(); }

  [[nodiscard]] constexpr bool has_moved(std::uint32_t i) const noexcept {
    return frames_[i].placement == Placement::moved;
  }

  [[nodiscard]] constexpr bool has_children(std::uint32_t i) const noexcept {
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      if (frames_[k].generation != 0 && frames_[k].parent == i) return true;
    }
    return false;
  }
  constexpr void remove(std::uint32_t i) noexcept {
    frames_[i] = Frame<S, N>();
    first_free_ = (std::min)(first_free_, i);
  }

 private:
  constexpr void place(Frame<S, N>& frame) noexcept {
    frame.world = compose(frames_[frame.parent].world, frame.local);
  }

  /// Recomputes the world transforms below moved frames, in linear time for any order of frames:
  /// climbs from each to the next ancestor whose placement is known, and places the frames in
  /// between on the way back.
  constexpr void spread() noexcept {
    for (std::uint32_t k = 0; k < frames_.size(); ++k) {
      std::uint32_t at = k, below = nowhere;
      while (frames_[at].placement == Placement::unknown) {
        frames_[at].below = below;
        below = at;
        at = frames_[at].parent;
      }
      for (const auto placement = frames_[at].placement; below != nowhere;) {
        Frame<S, N>& frame = frames_[below];
        if (placement == Placement::moved) place(frame);
        frame.placement = placement;
        below = frame.below;
      }
    }
  }

  typename Storage::template List<Frame<S, N>, Storage::frame_capacity> frames_;
  std::uint32_t first_free_ = 0;  // no lower index is free
};

}  // namespace detent::detail
