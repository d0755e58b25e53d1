// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "verify/draw/shapes.hpp"

namespace detent::verify {

/// The parts of a compound: spheres, then triangles, often few or none of either.
template <Scalar S, int N>
struct CompoundParts {
  std::array<Sphere<S, N>, 2> spheres{};
  std::array<Triangle<S, N>, 2> triangles{};
  std::uint8_t sphere_count = 0;
  std::uint8_t triangle_count = 0;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const CompoundParts<S, N>& parts) noexcept {
  digest.add(parts.sphere_count, parts.triangle_count);
  for (std::size_t i = 0; i < parts.sphere_count; ++i) digest.add(parts.spheres[i]);
  for (std::size_t i = 0; i < parts.triangle_count; ++i) digest.add(parts.triangles[i]);
}

/// Draws parts at one spot and others near it. The next shape is at the spot of the last part.
template <Scalar S, int N>
constexpr CompoundParts<S, N> compound_parts(ShapeScene<S, N>& scene) noexcept {
  CompoundParts<S, N> parts;
  auto& random = scene.random;
  const auto next_spot = [&] {
    if (random.coin()) scene.wander();
    if (random.coin()) scene.turn();
  };
  parts.sphere_count = static_cast<std::uint8_t>(random.between(0, 2));
  parts.triangle_count = static_cast<std::uint8_t>(random.between(0, 2));
  for (std::size_t i = 0; i < parts.sphere_count; ++i) {
    next_spot();
    parts.spheres[i] = scene.sphere();
  }
  for (std::size_t i = 0; i < parts.triangle_count; ++i) {
    next_spot();
    parts.triangles[i] = scene.triangle();
  }
  return parts;
}

}  // namespace detent::verify
