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

/// Families of questions about random hulls of every kind. question(kind, setting, artist, hull)
/// draws the rest; `low` to `high` percent of the general ones hit.
template <class Exam, Scalar S, int N, class Question>
void draw_hulls(Exam& exam, Draw<S, N>& draw, long count, int low, int high,
                const Question& question) {
  const auto family = [&](const char* name, Kind kind, int percent, int least, int most) {
    exam.family(name, count * percent / 100, least, most, [&] {
      const auto setting = draw_setting(draw, kind, 1);
      Artist<S, N> artist(draw, setting);
      ConvexHull<S, N> hull;
      draw_shape(artist, hull);
      return question(kind, setting, artist, hull);
    });
  };
  family("random", Kind::general, 40, low, high);
  family("lattice", Kind::lattice, 25, 10, 90);
  family("tiny", Kind::tiny, 10, 10, 90);
  family("extreme", Kind::extreme, 15, 1, 80);
  family("degenerate", Kind::degenerate, 10, 5, 90);
}

}  // namespace detent::oracle
