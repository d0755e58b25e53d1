// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <optional>

#include "detent/query/raycast/hit.hpp"
#include "detent/scene/object.hpp"

namespace detent {

/// An object that a query found. Ordered by distance, then by id.
template <Scalar S>
struct Found {
  S distance{};
  ObjectId id;

  [[nodiscard]] friend constexpr auto operator<=>(const Found&, const Found&) noexcept = default;
};

/// Where a ray or a moving shape first touches an object: distance, point and normal are those of
/// `raycast_hit(ray, shape)` or `cast(moving, direction, distance, shape)`. Ordered by distance, then
/// by id.
template <Scalar S, int N>
struct ObjectHit {
  S distance{};
  ObjectId id;
  Vec<S, N> point;
  Direction<S, N> normal;
  std::optional<std::uint32_t> triangle{};  // its index, for meshes and height fields

  [[nodiscard]] friend constexpr bool operator==(const ObjectHit&,
                                                 const ObjectHit&) noexcept = default;
  [[nodiscard]] friend constexpr bool operator<(const ObjectHit& a, const ObjectHit& b) noexcept {
    return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
  }
};

/// Two overlapping objects, the lower id first. Ordered by first id, then by second.
struct Overlap {
  ObjectId first;
  ObjectId second;

  [[nodiscard]] friend constexpr auto operator<=>(const Overlap&,
                                                  const Overlap&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S>
constexpr void append(D& digest, const Found<S>& found) noexcept {
  digest.add(found.distance, found.id);
}

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const ObjectHit<S, N>& hit) noexcept {
  digest.add(hit.distance, hit.id, hit.point, hit.normal, hit.triangle);
}

/// Appends to a digest: the fields in order.
template <class D>
constexpr void append(D& digest, const Overlap& overlap) noexcept {
  digest.add(overlap.first, overlap.second);
}

}  // namespace detent
