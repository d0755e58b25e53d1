// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "detent/shape/hull.hpp"
#include "oracle/draw_shape.hpp"

/// Random convex hulls.
namespace detent::oracle {

inline constexpr std::size_t most_corners = 8;

/// Storage for the points of a hull, valid until four more hulls have been drawn.
template <Scalar S, int N>
std::span<Vec<S, N>> room_for_hull(std::size_t count) {
  static std::array<std::array<Vec<S, N>, 3 * most_corners>, 4> rooms;
  static std::size_t next = 0;
  return std::span(rooms[next++ % rooms.size()]).first(count);
}

/// One to eight points, some duplicated; sometimes none for degenerate shapes.
template <Scalar S, int N>
void draw_shape(Artist<S, N>& artist, ConvexHull<S, N>& hull) {
  auto& random = artist.random;
  const auto corners = artist.template corners<most_corners>();
  auto count = static_cast<std::size_t>(random.between(1, most_corners));
  if (artist.is(Kind::general) && count < N + 1) count = N + 1;
  if (artist.is(Kind::degenerate) && random.one_in(12)) count = 0;
  const auto points = room_for_hull<S, N>(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = random.one_in(12) ? corners[random.below(count)] : corners[i];
  }
  hull = {points};
}

/// `count` points near the surface of a ball, most of them corners, so that the solver needs many
/// steps.
template <Scalar S, int N>
ConvexHull<S, N> round_hull(Draw<S, N>& draw, const Raw<N>& center, std::int64_t radius,
                            std::size_t count) {
  const auto points = room_for_hull<S, N>(count);
  for (auto& point : points) {
    point = Draw<S, N>::vec(Draw<S, N>::moved(center, draw.any_direction(), radius));
  }
  return {points};
}

}  // namespace detent::oracle
