// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "outlines.hpp"
#include "workers.hpp"

namespace detent::cli {

/// A moving capsule, or a ball if its ends are equal. The numbers are whole multiples of 1/65536,
/// except for the direction, which may have any length.
struct Throw {
  std::array<double, 3> a;
  std::array<double, 3> b;
  double radius;
  std::array<double, 3> way;
  double max_distance;
  Colour colour{};
};

/// The first contact of each throw, computed by the library's `cast` in one scalar.
struct CastReport {
  /// The distance of each; nothing for a miss.
  std::vector<std::optional<double>> distances;
  /// The digest of all distances.
  std::uint64_t digest = 0;
  /// If they are drawn: the bodies at their ends, as meshes.
  std::vector<ShapeModel> bodies;
  /// Their starts and paths.
  std::vector<Outline> lines;
  /// The points and normals where they touch.
  std::vector<Outline> marks;
};

template <Scalar S>
[[nodiscard]] CastReport cast_throws(const Scene& scene, const Move& move,
                                     const std::vector<Throw>& throws, bool are_drawn,
                                     const Workers& workers);

/// A shape of the scene that a body overlaps, and how to separate them: the body moves by `push`,
/// which is `depth` long.
struct Overlap {
  std::size_t body;
  std::size_t shape;
  double depth;
  std::array<double, 3> push;
};

/// What bodies overlap at their starts, computed by the library's `contact` in one scalar.
struct ContactReport {
  /// In the order of bodies, then of shapes.
  std::vector<Overlap> overlaps;
  /// The digest of all contacts.
  std::uint64_t digest = 0;
  /// If they are drawn: the bodies; and each point with its depth and an arrow along the normal.
  std::vector<Outline> lines;
  std::vector<Outline> marks;
};

template <Scalar S>
[[nodiscard]] ContactReport contacts_of(const Scene& scene, const Move& move,
                                        const std::vector<Throw>& bodies, bool are_drawn,
                                        const Workers& workers);

/// A ball that rolls over the ground to other balls, 1/1024 above it, and a capsule that walks to a
/// house.
[[nodiscard]] std::vector<Throw> shown_throws();

/// `count` throws from a seeded generator, all over the arena; half of them stay 1/1024 above the
/// ground.
[[nodiscard]] std::vector<Throw> random_throws(int count);

}  // namespace detent::cli
