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

/// The name of an object of a scene. Nothing that a scene adds later has the same name; the index
/// alone is free again once the object is removed. Names are ordered by index. A default one names
/// nothing.
using ObjectId = detail::Id<struct ObjectTag>;

/// The name of a frame of a scene: a coordinate system that objects and other frames move with. A
/// default one names the world.
using FrameId = detail::Id<struct FrameTag>;

/// Names that nothing ever has, for `value_or` where an addition may fail.
inline constexpr ObjectId no_object{};
inline constexpr FrameId no_frame{0xffffffffu, 0};

/// Whether an object is part of the match, which is saved and restored, or of the place where it
/// happens: those never move while it lasts, and are the same for everybody from the beginning.
enum class Motion : std::uint8_t { moving, fixed };

/// What a scene keeps beside the shape of an object.
struct Traits {
  std::uint32_t layers = 1;  // any bits: what they mean is up to filters
  std::uint64_t user = 0;    // any word: it is saved, and never read
  Motion motion = Motion::moving;
  FrameId frame{};  // what a moving object's shape is given in, and moves with

  [[nodiscard]] friend constexpr bool operator==(const Traits&, const Traits&) noexcept = default;
};

/// What a filter sees of an object.
struct ObjectInfo {
  ObjectId id;
  std::uint32_t layers;
  std::uint64_t user;
  Motion motion;
};

/// Says of an object whether it counts.
template <class F>
concept ObjectFilter = std::predicate<const F&, const ObjectInfo&>;

/// Says of two objects whether they count as a pair.
template <class F>
concept PairFilter = std::predicate<const F&, const ObjectInfo&, const ObjectInfo&>;

/// The filter that lets everything through.
struct Everything {
  [[nodiscard]] constexpr bool operator()(const ObjectInfo&) const noexcept { return true; }
  [[nodiscard]] constexpr bool operator()(const ObjectInfo&, const ObjectInfo&) const noexcept {
    return true;
  }
};

/// The filter that lets through what is in any of these layers.
struct InLayers {
  std::uint32_t mask;
  [[nodiscard]] constexpr bool operator()(const ObjectInfo& object) const noexcept {
    return (object.layers & mask) != 0;
  }
};

}  // namespace detent
