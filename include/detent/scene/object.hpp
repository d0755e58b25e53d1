// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>

#include "detent/number/require_cxx20.hpp"

namespace detent {

namespace detail {

template <class Tag>
struct Id {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;

  [[nodiscard]] friend constexpr auto operator<=>(const Id&, const Id&) noexcept = default;
};

template <class D, class Tag>
constexpr void append(D& digest, const Id<Tag>& id) noexcept {
  digest.add(id.index, id.generation);
}

}  // namespace detail

/// The id of an object of a scene. No object added later gets the same id; only the index is free
/// again once the object is removed. Ids are ordered by index. A default id refers to no object.
using ObjectId = detail::Id<struct ObjectTag>;

/// The id of a frame of a scene: a coordinate system that objects and other frames move with. A
/// default id refers to the world.
using FrameId = detail::Id<struct FrameTag>;

/// Ids that no object or frame ever has, for `value_or` where an addition may fail.
inline constexpr ObjectId no_object{};
inline constexpr FrameId no_frame{0xffffffffu, 0};

/// Whether an object is part of the match, which is saved and restored, or of the level: fixed
/// objects never move during a match and are the same for all players from the start.
enum class Motion : std::uint8_t { moving, fixed };

/// The properties that a scene stores with the shape of an object.
struct Traits {
  std::uint32_t layers = 1;  // any bits; filters define their meaning
  std::uint64_t user = 0;    // any word; saved, never read
  Motion motion = Motion::moving;
  FrameId frame{};  // the frame that a moving object's shape is in and moves with

  [[nodiscard]] friend constexpr bool operator==(const Traits&, const Traits&) noexcept = default;
};

/// The properties of an object that a filter sees.
struct ObjectInfo {
  ObjectId id;
  std::uint32_t layers;
  std::uint64_t user;
  Motion motion;
};

/// A predicate: whether an object counts.
template <class F>
concept ObjectFilter = std::predicate<const F&, const ObjectInfo&>;

/// A predicate: whether two objects count as a pair.
template <class F>
concept PairFilter = std::predicate<const F&, const ObjectInfo&, const ObjectInfo&>;

/// The filter that accepts everything.
struct Everything {
  [[nodiscard]] constexpr bool operator()(const ObjectInfo&) const noexcept { return true; }
  [[nodiscard]] constexpr bool operator()(const ObjectInfo&, const ObjectInfo&) const noexcept {
    return true;
  }
};

/// The filter that accepts objects in any of these layers.
struct InLayers {
  std::uint32_t mask;
  [[nodiscard]] constexpr bool operator()(const ObjectInfo& object) const noexcept {
    return (object.layers & mask) != 0;
  }
};

}  // namespace detent
