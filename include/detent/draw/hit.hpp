// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "detent/draw/flat.hpp"
#include "detent/query/cast/hit.hpp"
#include "detent/query/contact/contact.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/shape/bounding_box.hpp"
#include "detent/shape/bounding_sphere.hpp"

namespace detent {

namespace detail {

/// A sink that draws to another one, translated by a vector: each point is rounded once more.
template <class Sink, Scalar S, int N>
class MovedSink {
 public:
  constexpr MovedSink(Sink& sink, const Vec<S, N>& by) noexcept : sink_(sink), by_(by) {}

  constexpr void line(const Vec<S, N>& a, const Vec<S, N>& b, const Colour& colour) {
    sink_.line(moved(a), moved(b), colour);
  }
  constexpr void triangle(const Vec<S, N>& a, const Vec<S, N>& b, const Vec<S, N>& c,
                          const Colour& colour) {
    sink_.triangle(moved(a), moved(b), moved(c), colour);
  }

 private:
  [[nodiscard]] constexpr Vec<S, N> moved(const Vec<S, N>& point) const noexcept {
    return nearest_to<S>(point + by_);
  }

  Sink& sink_;
  Vec<S, N> by_;
};

}  // namespace detail

/// Draws a point as a cross: one line per axis, `size` long on both sides.
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const Vec<S, N>& point, const Colour& colour, const S& size) {
  for (int i = 0; i < N; ++i) {
    const auto arm = Direction<S, N>::along(i) * size;
    sink.line(nearest_to<S>(point - arm), nearest_to<S>(point + arm), colour);
  }
}

/// Draws a surface point as a cross, and the normal there, 4 times `size` long.
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const Vec<S, N>& point, const Direction<S, N>& normal,
                    const Colour& colour, const S& size) {
  draw(sink, point, colour, size);
  sink.line(point, nearest_to<S>(point + normal * size * 4), colour);
}

/// Draws the point where a ray or a moving shape touches: a cross and the normal.
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const RayHit<S, N>& hit, const Colour& colour, const S& size) {
  draw(sink, hit.point, hit.normal, colour, size);
}
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const CastHit<S, N>& hit, const Colour& colour, const S& size) {
  draw(sink, hit.point, hit.normal, colour, size);
}

/// Draws the points of a contact as crosses, with the normal at each.
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const Contact<S, N>& contact, const Colour& colour, const S& size) {
  for (std::size_t i = 0; i < contact.count; ++i) {
    draw(sink, contact.points[i].point, contact.normal, colour, size);
  }
}

/// Draws a moving shape at its start and where it touches, after `distance`, and its path, the line
/// between the centers of its boxes there. An empty shape draws nothing.
///
/// exact: the shape at the end is that at the start, each point moved by direction * distance, which
///        is rounded to nearest first                             (tests/draw/hit.test.cpp)
template <class Sink, class Shape, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw_sweep(Sink& sink, const Shape& shape, const Direction<S, N>& direction,
                          const S& distance, const Colour& colour) {
  const auto box = bounding_box(shape);
  if (is_empty(box)) return;
  const auto by = nearest_to<S>(direction * distance);
  detail::MovedSink<Sink, S, N> there(sink, by);
  const auto middle = detail::middle(box);
  draw(sink, shape, colour);
  draw(there, shape, colour);
  sink.line(middle, nearest_to<S>(middle + by), colour);
}

}  // namespace detent
