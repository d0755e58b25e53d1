// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/formats.hpp"

namespace detent::detail {

/// The pose of body b in the frame of body a. All later decisions about the pair are exact for
/// these numbers.
template <Scalar S, int N>
struct RelativePose {
  using Ratio = typename Formats<S>::Ratio;
  using Lever = typename Formats<S>::Lever;

  std::array<Vec<Ratio, N>, std::size_t{N}> axes{};  // axis i of b; each component rounded once
  Vec<Lever, N> translation{};                       // the center of b; clamped to Lever's range
};

/// One point at which two bodies touch or nearly touch.
template <Scalar S, int N>
struct ManifoldPoint {
  Vec<typename Formats<S>::Lever, N> point{};  // in the frame of a, midway between both surfaces
  typename Formats<S>::Gap separation{};       // negative where they overlap
  std::uint32_t feature = 0;                   // names the features; unique within a manifold
};

/// The manifold of two bodies that touch or nearly touch. The order of points is canonical: it
/// depends only on the shapes and their relative pose.
template <Scalar S, int N>
struct Manifold {
  static constexpr int capacity = N == 2 ? 2 : 4;

  Vec<typename Formats<S>::Ratio, N> normal{};  // a unit vector in the frame of a, from a to b
  std::array<ManifoldPoint<S, N>, std::size_t{capacity}> points{};
  int count = 0;  // 0: the bodies are apart
};

}  // namespace detent::detail
